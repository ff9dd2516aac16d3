// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/moved.h"

#include <algorithm>

namespace sightline {

namespace {

/// What was played, found and marked in the run before means nothing in this one.
template <int D>
void forget_the_run_before(Workbench<D>& bench) {
    ++bench.run;
    bench.transport.playing = false;
    bench.marked.clear();
    bench.marked_by.clear();
}

/// Scene and view of the left side, what is frozen, noted and selected there; true when the traversal was made again.
template <int D>
bool take_over(const Session<D>& lead, Other<D>& other) {
    Session<D>& session = other.session;
    if (session.shared_scene() != other.lead_scene) return false;
    const bool new_scene = lead.shared_scene() != other.lead_scene;
    const bool new_view = lead.culling_view() != other.lead_view && lead.culling_view() != session.culling_view();
    if (new_scene) session.set_scene(lead.shared_scene());
    set_views(session, new_view ? lead.culling_view() : session.culling_view(), lead.display_view(),
              lead.frozen_part());
    session.notes = lead.notes;
    session.selected_primitive = lead.selected_primitive;
    session.selected_cell = lead.selected_cell;
    const bool same_boxes = session.traversal().boxes() && session.traversal().boxes() == lead.traversal().boxes();
    session.selected_node = same_boxes ? lead.selected_node : none;
    session.selected_plane = same_boxes ? lead.selected_plane : none;
    const auto at_cell = [](const Note<D>& note) { return note.anchor == Note<D>::Anchor::cell; };
    const bool any = session.selected_cell != none || std::any_of(session.notes.begin(), session.notes.end(), at_cell);
    if (any && !same_cells(lead, session)) {
        session.selected_cell = none;
        std::erase_if(session.notes, at_cell);
    }
    return new_scene || new_view;
}

}  // namespace

template <int D>
void moved(Workbench<D>& bench) {
    bench.substep.reset();
    take_along(bench);
}

template <int D>
void take_along(Workbench<D>& bench) {
    if (!bench.other) return;
    Other<D>& other = *bench.other;
    if (take_over(bench.session, other)) {
        ++bench.run;
        if (bench.record_ahead) record_whole_run(other.session);
    }
    other.lead_scene = bench.session.shared_scene();
    other.lead_view = bench.session.culling_view();
    follow(bench.session, other.session, other.align);
}

template <int D>
void traversal_changed(Workbench<D>& bench) {
    forget_the_run_before(bench);
    if (bench.hovered_cell != none && bench.hovered_cell >= bench.session.cells().cell_count())
        bench.hovered_cell = none;
    if (bench.record_ahead) {
        record_whole_run(bench.session);
        if (bench.other) record_whole_run(bench.other->session);
    }
    moved(bench);
}

template <int D>
void fly_on(Workbench<D>& bench, const ViewSpec<D>& view) {
    bench.flight.ahead.clear();
    bench.last_stop = bench.session.fly(view);
    if (bench.other) {
        bench.other->session.unfreeze();
        bench.other->session.fly(view);
        bench.other->lead_view = view;
    }
    bench.substep.reset();
    forget_the_run_before(bench);
}

template <int D>
void record_whole_run(Session<D>& session) {
    const std::uint32_t position = session.position();
    session.run();
    session.seek(position);
}

#define SIGHTLINE_INSTANTIATE(D)                                \
    template void moved<D>(Workbench<D>&);                      \
    template void take_along<D>(Workbench<D>&);                 \
    template void traversal_changed<D>(Workbench<D>&);          \
    template void fly_on<D>(Workbench<D>&, const ViewSpec<D>&); \
    template void record_whole_run<D>(Session<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
