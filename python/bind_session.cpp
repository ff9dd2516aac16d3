// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/session/condition.h"
#include "python/convert.h"
#include "python/script_session.h"

namespace sightline {

namespace py = pybind11;

namespace {

std::string_view stop_text(Stop stop) { return stop_words[static_cast<std::size_t>(stop)]; }

/// In slices, so that Ctrl+C ends it between two steps. A budget in milliseconds needs one clock.
template <int D>
Stop run_in_script(ScriptSession<D>& self, std::optional<std::uint32_t> steps) {
    if (self.session.settings().budget.kind == Budget::Kind::milliseconds)
        return guarded(self, [&](Session<D>& session) { return session.run(steps.value_or(none)); });
    std::uint64_t left = steps.value_or(none);
    while (left > 0) {
        const auto slice = static_cast<std::uint32_t>(std::min<std::uint64_t>(left, 4096));
        const Stop stop = guarded(self, [&](Session<D>& session) { return session.run(slice); });
        if (stop != Stop::steps) return stop;
        left -= slice;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
    return Stop::steps;
}

template <int D>
py::dict settings_of(const Session<D>& session) {
    py::dict all;
    for (const SettingRow& row : settings_table())
        if (row.invalidates != Invalidates::picture && applies<D>(row, session.method()))
            all[py::str(std::string(row.name))] = row.get(session.settings());
    return all;
}

/// Frames in the file's coordinates, as look() takes them.
template <int D>
py::dict paths_of(const Scene<D>& scene) {
    py::dict paths;
    for (const FlightPath<D>& path : scene.paths) {
        py::list frames;
        for (const ViewSpec<D>& view : path.frames)
            frames.append(py::make_tuple(point_tuple<D>(view.eye + scene.origin),
                                         point_tuple<D>(view.look_at + scene.origin), view.fov));
        paths[py::str(path.id)] = frames;
    }
    return paths;
}

template <int D>
py::array_t<double> primitives_of_scene(const std::shared_ptr<const Scene<D>>& scene) {
    static_assert(sizeof(Primitive<D>) == D * D * sizeof(double));
    const auto count = static_cast<py::ssize_t>(scene->primitives.size());
    return view_of(reinterpret_cast<const double*>(scene->primitives.data()), {count, D, D}, scene);
}

/// What Python holds of cells.
template <int D>
struct ScriptCells {
    std::shared_ptr<const CellComplex<D>> cells;
};

template <int D, typename T>
py::array_t<T> row_of(const ScriptCells<D>& self, const std::vector<T>& values) {
    return view_of(values.data(), {static_cast<py::ssize_t>(values.size())}, self.cells);
}

template <int D>
void bind_cells(py::module_& module) {
    using Cells = ScriptCells<D>;
    py::class_<Cells>(module, D == 2 ? "Cells2d" : "Cells3d",
                      "Space cut into convex cells. Arrays are views of what the program uses: read only, no copies.")
        .def("__len__", [](const Cells& self) { return self.cells->cell_count(); })
        .def_property_readonly("kind",
                               [](const Cells& self) {
                                   return std::string(words<Tessellation>[static_cast<std::size_t>(self.cells->kind)]);
                               })
        .def_property_readonly(
            "rho_max", [](const Cells& self) { return self.cells->rho_max; }, "the most primitives in one cell")
        .def_property_readonly(
            "first", [](const Cells& self) { return row_of(self, self.cells->cell_primitive_begin); },
            "those of cell i are primitives[first[i]:first[i + 1]]")
        .def_property_readonly(
            "primitives", [](const Cells& self) { return row_of(self, self.cells->cell_primitives); },
            "the primitives of all cells, a row after the other")
        .def_property_readonly(
            "points",
            [](const Cells& self) {
                const auto& points = self.cells->points;
                return view_of(reinterpret_cast<const double*>(points.data()),
                               {static_cast<py::ssize_t>(points.size()), D}, self.cells);
            },
            "the corners of cells, less the scene's origin")
        .def_property_readonly(
            "corners",
            [](const Cells& self) {
                const py::ssize_t each = self.cells->has_boxes() ? 1 << D : D + 1;
                return view_of(self.cells->cell_points.data(),
                               {static_cast<py::ssize_t>(self.cells->cell_count()), each}, self.cells);
            },
            "per cell, rows of points")
        .def(
            "neighbours",
            [](const Cells& self, std::size_t cell) {
                if (cell >= self.cells->cell_count()) throw py::index_error("there is no cell " + std::to_string(cell));
                const auto facets = self.cells->facets_of(static_cast<std::uint32_t>(cell));
                py::list found;
                for (const HalfFacet& half : facets)
                    found.append(half.neighbour == none ? py::object(py::none())
                                                        : py::object(py::int_(half.neighbour)));
                return found;
            },
            py::arg("cell"), "across each facet; None at the border");
}

}  // namespace

template <int D>
void bind_session(py::module_& module) {
    using Self = ScriptSession<D>;
    bind_cells<D>(module);
    py::class_<Self> session(module, D == 2 ? "Session2d" : "Session3d",
                             "A scene, its cells, a view, settings and a run that goes forward and back.");
    session
        .def(
            "copy", [](const Self& self) { return Self(self); }, "a session of its own; scene and cells are shared")
        .def_property_readonly("name", [](const Self& self) { return self.session.scene().id; })
        .def_property_readonly("title", [](const Self& self) { return self.session.scene().title; })
        .def_property_readonly("seed", [](const Self& self) { return self.session.scene().seed; })
        .def_property_readonly(
            "origin", [](const Self& self) { return point_tuple<D>(self.session.scene().origin); },
            "what was subtracted from the file's coordinates; eye, look_at and paths are the file's")
        .def_property_readonly(
            "primitives", [](const Self& self) { return primitives_of_scene<D>(self.session.shared_scene()); },
            "their points: an array of shape (n, D, D), less the origin; a view, read only")
        .def_property_readonly(
            "objects", [](const Self& self) { return self.session.objects().names; }, "their names")
        .def_property_readonly(
            "object_of", [](const Self& self) { return array_of(self.session.objects().of); },
            "per primitive an index into objects")
        .def_property_readonly(
            "paths", [](const Self& self) { return paths_of(self.session.scene()); },
            "flights that come with the scene: lists of (eye, look_at, fov), as look() takes them")
        .def_property_readonly("cells", [](const Self& self) { return ScriptCells<D>{self.session.shared_cells()}; })
        .def_property_readonly(
            "settings", [](const Self& self) { return settings_of(self.session); },
            "name: value as text, of all that matters to the method")
        .def_property_readonly(
            "method",
            [](const Self& self) { return variant_of(self.session.method(), self.session.settings().parameters).text; })
        .def_property_readonly("methods",
                               [](const Self& self) {
                                   std::vector<std::string> ids;
                                   for (const Method<D>& method : self.methods->table) ids.emplace_back(method.id);
                                   return ids;
                               })
        .def_property_readonly(
            "view",
            [](const Self& self) {
                const ViewSpec<D>& view = self.session.culling_view();
                const Vec<D>& origin = self.session.scene().origin;
                return py::make_tuple(point_tuple<D>(view.eye + origin), point_tuple<D>(view.look_at + origin),
                                      view.fov);
            },
            "(eye, look_at, fov)");

    session
        .def(
            "run",
            [](Self& self, std::optional<std::uint32_t> steps) {
                return stop_text(self.last_stop = run_in_script(self, steps));
            },
            py::arg("steps") = py::none(), "forward to the budget or the end; says why it stopped")
        .def(
            "step",
            [](Self& self) {
                const Stop stop = guarded(self, [](Session<D>& s) { return s.step(); });
                self.last_stop = stop == Stop::none ? Stop::steps : stop;
                return stop == Stop::none;
            },
            "one step; False: there is none")
        .def(
            "back", [](Self& self) { return guarded(self, [](Session<D>& s) { return s.back(); }); },
            "one step back; False: it stands at the start")
        .def(
            "seek",
            [](Self& self, std::uint32_t step) {
                return stop_text(self.last_stop = guarded(self, [&](Session<D>& s) { return s.seek(step); }));
            },
            py::arg("step"))
        .def(
            "run_until",
            [](Self& self, const std::string& text) {
                const Condition<D> condition = condition_for(self.session, text);
                self.last_stop = guarded(self, [&](Session<D>& s) { return sightline::run_until(s, condition); });
                return stop_text(self.last_stop);
            },
            py::arg("condition"), "at least one step; 'breakpoint': the condition holds")
        .def(
            "look",
            [](Self& self, const py::object& eye, const py::object& look_at, const py::object& fov) {
                const ViewSpec<D> view =
                    view_in_script<D>(self.session.culling_view(), self.session.scene(), eye, look_at, fov);
                self.session.check(view);
                guarded(self, [&](Session<D>& s) {
                    s.seek(0);
                    s.set_view(view);
                });
            },
            py::arg("eye") = py::none(), py::arg("look_at") = py::none(), py::arg("fov") = py::none(),
            "from elsewhere, at step 0; what is not given stays")
        .def(
            "change", [](Self& self, const py::kwargs& given) { change_in_script(self, given); },
            "other settings, such as method=\"layers\", budget=\"5%\", error_bound=0.02; keeps the step where it can")
        .def_property_readonly(
            "position", [](const Self& self) { return self.session.position(); }, "steps made")
        .def_property_readonly("recorded", [](const Self& self) { return self.session.recorded(); })
        .def_property_readonly("finished", [](const Self& self) { return self.session.finished(); })
        .def_property_readonly(
            "state_hash", [](const Self& self) { return hash_text(self.session.hash()); },
            "of all that decides; equal to that of --stats where scene, settings and step are")
        .def("__repr__", [](const Self& self) {
            return "<sightline session: " + self.session.scene().id + ", " + std::string(self.session.method().id) +
                   ", step " + std::to_string(self.session.position()) + ">";
        });
    bind_results<D>(session);

    module.def(D == 2 ? "open_2d" : "open_3d", &open_in_script<D>, py::arg("scene"), py::kw_only(),
               py::arg("eye") = py::none(), py::arg("look_at") = py::none(), py::arg("fov") = py::none(),
               py::arg("method") = py::none(), py::arg("budget") = py::none(), py::arg("preset") = py::none(),
               py::arg("heuristics") = py::list(),
               "Opens a scene by any name that the viewer takes, or an array of primitives of shape (n, D, D).\n"
               "method: an id, a variant such as \"published on_reenqueue=min\", a Heuristic or a function.\n"
               "Further arguments are settings, as --set has them.");
}

template void bind_session<2>(py::module_&);
template void bind_session<3>(py::module_&);

}  // namespace sightline
