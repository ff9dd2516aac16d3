// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/drag2d.h"

#include "core/base/error.h"
#include "core/draw/notes.h"
#include "shell/desk/change.h"
#include "shell/desk/edit.h"
#include "shell/desk/moved.h"
#include "shell/desk/moves.h"
#include "shell/desk/undo.h"
#include "shell/desk/zoom.h"

namespace sightline {

namespace {

const std::string gesture = "drag";

bool is_frozen(Handle handle) {
    return handle == Handle::frozen_eye || handle == Handle::frozen_look || handle == Handle::frozen_opening;
}

void drag_view(Workbench<2>& bench, const Drag& drag, const Vec<2>& to) {
    const bool frozen = is_frozen(drag.handle);
    const Session<2>& before = drag.before.session;
    const ViewSpec<2>& start = frozen ? before.culling_view() : before.display_view();
    const ViewSpec<2>& now = frozen ? bench.session.culling_view() : bench.session.display_view();
    const ViewSpec<2> view = dragged_view(start, drag.handle, drag.from, to);
    if (view == now) return;
    frozen ? change_culling_view(bench, view, gesture) : change_view(bench, view, gesture);
}

void drag_segment(Workbench<2>& bench, const Drag& drag, const Vec<2>& to, float unit) {
    const std::uint32_t index = drag.segment;
    const Primitive<2>& start = drag.before.session.scene().primitives[index];
    Primitive<2> segment = start;
    const Vec<2> end = snapped_to_end(bench.session, drag.camera, to, unit, index);
    if (drag.handle == Handle::segment_start) segment[0] = end;
    if (drag.handle == Handle::segment_end) segment[1] = end;
    if (drag.handle == Handle::segment)
        for (Vec<2>& p : segment) p += to - drag.from;
    if (segment != bench.session.scene().primitives[index]) move_segment(bench, index, segment, gesture);
    bench.session.selected_primitive = index;
}

void draw_segment(Workbench<2>& bench, const Drag& drag, const Vec<2>& to, float unit) {
    const Session<2>& before = drag.before.session;
    const auto index = static_cast<std::uint32_t>(before.scene().primitives.size());
    const Primitive<2> segment{snapped_to_end(before, drag.camera, drag.from, unit),
                               snapped_to_end(before, drag.camera, to, unit)};
    if (bench.session.scene().primitives.size() == index)
        add_segment(bench, segment, gesture);
    else if (segment != bench.session.scene().primitives[index])
        move_segment(bench, index, segment, gesture);
}

void drag_note(Workbench<2>& bench, const Drag& drag, const Vec<2>& to, float unit) {
    const Session<2>& before = drag.before.session;
    Note<2> note = before.notes[drag.note];
    const bool callout = note.kind == Note<2>::Kind::callout;
    if (drag.handle == Handle::note_text && !callout) {
        note.offset_pt += (to - drag.from) * (drag.camera.scale() / (4.0 / 3 * unit));
    } else {
        note.point = anchor_point(before, note) + to - drag.from;
        note.anchor = Note<2>::Anchor::point;
        if (const std::uint32_t cell = centre_near(before, drag.camera, note.point, unit); cell != none) {
            note.anchor = Note<2>::Anchor::cell;
            note.index = cell;
        }
    }
    remember(bench, gesture);
    bench.session.notes[drag.note] = note;
    moved(bench);
}

}  // namespace

void drag_to(Workbench<2>& bench, const Drag& drag, const ImVec2& mouse, float unit) {
    const Vec<2> to = drag.camera.to_scene(mouse);
    try {
        if (drag.kind == DragKind::pan) return centre_on(bench, drag.camera.world.centre() + drag.from - to, gesture);
        if (drag.kind == DragKind::draw_segment) {
            draw_segment(bench, drag, to, unit);
            hold(bench, drag.camera.world, gesture);
        } else if (drag.kind == DragKind::cut_gap) {
            cut_gap(bench, drag.before.session.shared_scene(), drag.segment, drag.from, to, gesture);
            hold(bench, drag.camera.world, gesture);
        } else if (drag.handle == Handle::note_text || drag.handle == Handle::note_anchor) {
            return drag_note(bench, drag, to, unit);
        } else if (drag.handle == Handle::segment || drag.handle == Handle::segment_start ||
                   drag.handle == Handle::segment_end) {
            drag_segment(bench, drag, to, unit);
            hold(bench, drag.camera.world, gesture);
        } else {
            drag_view(bench, drag, to);
        }
    } catch (const InputError&) {
        return;  // no length yet, or the same as another one: the last good place stays
    }
    // A shorter run on the way must not lose the step.
    const std::uint32_t step = drag.before.session.position();
    if (bench.session.position() != step) go_to_step(bench, step);
}

std::optional<Vec<2>> snap_point(const Workbench<2>& bench, const Drag& drag, const ImVec2& mouse, float unit) {
    std::uint32_t but = none;
    if (drag.kind == DragKind::cut_gap) return std::nullopt;
    if (drag.kind == DragKind::draw_segment) {
        but = static_cast<std::uint32_t>(drag.before.session.scene().primitives.size());
    } else {
        if (drag.handle != Handle::segment_start && drag.handle != Handle::segment_end) return std::nullopt;
        but = drag.segment;
    }
    const Vec<2> at = drag.camera.to_scene(mouse), end = snapped_to_end(bench.session, drag.camera, at, unit, but);
    return end == at ? std::nullopt : std::optional(end);
}

}  // namespace sightline
