// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/bench/history.h"

#include "shell/bench/change.h"

namespace sightline {

namespace {

template <int D>
Snapshot<D> snapshot(const Session<D>& session) {
    return {session.shared_scene(), session.settings(), session.culling_view(), session.display_view(),
            session.frozen(),       session.notes,      session.bookmarks,      session.selected_primitive};
}

template <int D>
void bring_back(Workbench<D>& bench, const Snapshot<D>& to) {
    Session<D>& session = bench.session;
    if (session.shared_scene() != to.scene) {
        session.set_scene(to.scene);
        session.selected_primitive = to.selected_primitive;
    }
    session.change(to.settings);
    session.unfreeze();
    if (session.culling_view() != to.culling_view) session.set_view(to.culling_view);
    if (to.frozen) {
        session.freeze();
        session.set_view(to.display_view);
    }
    session.notes = to.notes;
    session.bookmarks = to.bookmarks;
    bench.selected_note = none;
    traversal_changed(bench);
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
    History<D>& history = bench.history;
    if (history.past.empty()) return false;
    history.future.push_back(snapshot(bench.session));
    bring_back(bench, history.past.back());
    history.past.pop_back();
    history.gesture.clear();
    return true;
}

template <int D>
bool redo(Workbench<D>& bench) {
    History<D>& history = bench.history;
    if (history.future.empty()) return false;
    history.past.push_back(snapshot(bench.session));
    bring_back(bench, history.future.back());
    history.future.pop_back();
    history.gesture.clear();
    return true;
}

template void remember<2>(Workbench<2>&, const std::string&);
template bool undo<2>(Workbench<2>&);
template bool redo<2>(Workbench<2>&);

}  // namespace sightline
