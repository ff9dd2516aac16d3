// A session as a script holds it: with the methods that the script brought along.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

#include "core/session/session.h"
#include "python/script_heuristic.h"

namespace sightline {

/// The methods that a session of a script knows: those of the table and its own.
template <int D>
struct ScriptMethods {
    std::vector<std::shared_ptr<const ScriptKey>> scripts;
    std::vector<Method<D>> table;
};

template <int D>
struct ScriptSession {
    std::shared_ptr<const ScriptMethods<D>> methods;
    Session<D> session;
    Stop last_stop = Stop::steps;
    bool broken = false;  ///< a function of the script failed inside a step

    /// Throws WorkError for a broken session: half a step has been made.
    Session<D>& moving();
};

/// Opens what `scene` is: a name that load_scene takes, or an array of primitives. Throws InputError.
template <int D>
ScriptSession<D> open_in_script(const pybind11::object& scene, const pybind11::object& eye,
                                const pybind11::object& look_at, const pybind11::object& fov,
                                const pybind11::object& method, const pybind11::object& budget,
                                const pybind11::object& preset, const pybind11::list& heuristics,
                                const pybind11::kwargs& settings);

/// Another view; what is None stays. In the file's coordinates.
template <int D>
ViewSpec<D> view_in_script(ViewSpec<D> view, const Scene<D>& scene, const pybind11::object& eye,
                           const pybind11::object& look_at, const pybind11::object& fov);

/// Of `settings`: name=value, numbers and True and False too.
template <int D>
void change_in_script(ScriptSession<D>& self, const pybind11::kwargs& settings);

/// Calls `move`, which goes forward or back: an error in a function of the script then breaks the session.
template <int D, typename Move>
auto guarded(ScriptSession<D>& self, Move move) {
    Session<D>& session = self.moving();
    try {
        return move(session);
    } catch (const pybind11::error_already_set&) {
        self.broken = true;
        throw;
    } catch (const pybind11::builtin_exception&) {
        self.broken = true;
        throw;
    }
}

/// Classes Session2d and Session3d, Cells2d and Cells3d.
template <int D>
void bind_session(pybind11::module_& module);
/// What a session has measured and why: parts of bind_session.
template <int D>
void bind_results(pybind11::class_<ScriptSession<D>>& session);

}  // namespace sightline
