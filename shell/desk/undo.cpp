// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/undo.h"

#include "shell/desk/moved.h"

namespace sightline {

namespace {

template <int D>
Snapshot<D> snapshot(const Session<D>& session) {
    return {session.shared_scene(), session.settings(), session.culling_view(), session.display_view(),
            session.frozen_part(),  session.notes,      session.bookmarks,      session.selected_primitive};
}

template <int D>
void bring_back(Workbench<D>& bench, const Snapshot<D>& to) {
    Session<D>& session = bench.session;
    if (session.shared_scene() != to.scene) {
        session.set_scene(to.scene);
        session.selected_primitive = to.selected_primitive;
    }
    session.change(to.settings);
    set_views(session, to.culling_view, to.display_view, to.frozen);
    session.notes = to.notes;
    session.bookmarks = to.bookmarks;
    bench.selected_note = none;
    traversal_changed(bench);
}

/// Brings the last entry of `from` back; what was there until now goes to `to`. False when there is none.
template <int D>
bool exchange(Workbench<D>& bench, std::vector<Snapshot<D>>& from, std::vector<Snapshot<D>>& to) {
    if (from.empty()) return false;
    to.push_back(snapshot(bench.session));
    bring_back(bench, from.back());
    from.pop_back();
    end_gesture(bench);
    return true;
}

}  // namespace

template <int D>
void remember(Workbench<D>& bench, const std::string& gesture) {
    History<D>& history = bench.history;
    history.future.clear();
    if (!gesture.empty() && gesture == history.gesture) return;
    if (history.past.size() == history_limit) history.past.erase(history.past.begin());
    history.past.push_back(snapshot(bench.session));
    history.gesture = gesture;
}

template <int D>
bool undo(Workbench<D>& bench) {
    return exchange(bench, bench.history.past, bench.history.future);
}

template <int D>
bool redo(Workbench<D>& bench) {
    return exchange(bench, bench.history.future, bench.history.past);
}

template void remember<2>(Workbench<2>&, const std::string&);
template void remember<3>(Workbench<3>&, const std::string&);
template bool undo<2>(Workbench<2>&);
template bool undo<3>(Workbench<3>&);
template bool redo<2>(Workbench<2>&);
template bool redo<3>(Workbench<3>&);

}  // namespace sightline
