// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/numpy.h>

#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "core/scene/clean.h"
#include "core/scene/read/load.h"
#include "core/session/start_settings.h"
#include "python/convert.h"
#include "python/script_session.h"

namespace sightline {

namespace py = pybind11;

namespace {

void warn(const std::string& line) {
    if (PyErr_WarnEx(PyExc_UserWarning, line.c_str(), 1) != 0) throw py::error_already_set();
}

/// As --set takes it.
std::string setting_text(const py::handle& value) {
    if (value.is(py::handle(Py_True))) return "on";
    if (value.is(py::handle(Py_False))) return "off";
    return py::str(value).cast<std::string>();
}

std::shared_ptr<const ScriptKey> script_of(const py::handle& heuristic) {
    if (!py::isinstance<ScriptKey>(heuristic))
        return py::type::of<ScriptKey>()(heuristic).template cast<std::shared_ptr<ScriptKey>>();
    return heuristic.cast<std::shared_ptr<ScriptKey>>();
}

template <int D>
void add_method(ScriptMethods<D>& methods, const std::shared_ptr<const ScriptKey>& script) {
    for (const auto& known : methods.scripts)
        if (known == script) return;
    for (const Method<D>& method : methods.table)
        if (method.is_called(script->id))
            throw InputError("there is a method " + script->id + " already: give the heuristic another id");
    methods.scripts.push_back(script);
    methods.table.push_back(script_method<D>(script));
}

ViewSpec<2> view_of_array(const Scene<2>& scene) { return default_view(scene.primitives); }
ViewSpec<3> view_of_array(const Scene<3>& scene) { return default_view(scene.primitives, scene.up_axis); }

template <int D>
Scene<D> scene_of_array(const py::object& object) {
    const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(object);
    if (!array) throw py::error_already_set();
    if (array.ndim() != 3 || array.shape(1) != D || array.shape(2) != D)
        throw InputError(std::string("an array of ") +
                         (D == 2 ? "segments has the shape (n, 2, 2)" : "triangles has the shape (n, 3, 3)"));
    Scene<D> scene;
    scene.id = "array";
    scene.title = "an array of a script";
    scene.source = "array";
    scene.primitives.resize(static_cast<std::size_t>(array.shape(0)));
    const double* from = array.data();
    for (Primitive<D>& primitive : scene.primitives)
        for (Vec<D>& point : primitive)
            for (int i = 0; i < D; ++i) point[i] = *from++;
    clean(scene, Recentre::yes, "array");
    scene.start_view = view_of_array(scene);
    return scene;
}

template <int D>
Vec<D> point_of(const py::object& object, const Vec<D>& origin) {
    std::array<double, D> numbers;
    try {
        numbers = object.cast<std::array<double, D>>();
    } catch (const py::cast_error&) {
        throw InputError("a point has " + std::to_string(D) + " numbers: this is " +
                         py::repr(object).cast<std::string>());
    }
    Vec<D> point;
    for (int i = 0; i < D; ++i) point[i] = numbers[static_cast<std::size_t>(i)] - origin[i];
    return point;
}

template <int D>
void apply(Settings& settings, const py::kwargs& given) {
    for (const auto& [name, value] : given)
        apply_setting(settings, py::str(name).cast<std::string>() + "=" + setting_text(value));
    if (settings.automatic == Switch::on)
        throw InputError("auto=on is for the viewers: a script names its method, cells and budget");
}

}  // namespace

template <int D>
Session<D>& ScriptSession<D>::moving() {
    if (broken)
        throw WorkError("a function of this session's heuristic failed inside step " +
                        std::to_string(session.position()) + ": mend it and open the scene again");
    return session;
}

template <int D>
ViewSpec<D> view_in_script(ViewSpec<D> view, const Scene<D>& scene, const py::object& eye, const py::object& look_at,
                           const py::object& fov) {
    if (!eye.is_none()) view.eye = point_of<D>(eye, scene.origin);
    if (!look_at.is_none()) view.look_at = point_of<D>(look_at, scene.origin);
    if (!fov.is_none()) view.fov = fov.cast<double>();
    return view;
}

template <int D>
ScriptSession<D> open_in_script(const py::object& scene, const py::object& eye, const py::object& look_at,
                                const py::object& fov, const py::object& method, const py::object& budget,
                                const py::object& preset, const py::list& heuristics, const py::kwargs& given) {
    const bool named = py::isinstance<py::str>(scene) || py::hasattr(scene, "__fspath__");
    const std::string name = named ? py::str(scene).cast<std::string>() : "";
    auto methods = std::make_shared<ScriptMethods<D>>();
    const auto known = method_table<D>();
    methods->table.assign(known.begin(), known.end());
    for (const py::handle heuristic : heuristics) add_method(*methods, script_of(heuristic));

    Settings settings = catalogue_settings<D>(name);
    if (!preset.is_none()) apply_preset(settings, preset.cast<std::string>());
    if (py::isinstance<py::str>(method)) {
        settings.method = method.cast<std::string>();
    } else if (!method.is_none()) {
        const auto script = script_of(method);
        add_method(*methods, script);
        settings.method = script->id;
    }
    if (!budget.is_none()) settings.budget = parse_budget(setting_text(budget));
    apply<D>(settings, given);

    const Stopwatch reading;
    auto loaded = std::make_shared<const Scene<D>>(
        named ? load_scene<D>(name, {.two_sided = settings.two_sided == Switch::on}) : scene_of_array<D>(scene));
    const double read_ms = reading.milliseconds();
    for (const std::string& warning : loaded->warnings) warn(warning);
    if (const Dropped& d = loaded->dropped; d.total() > 0)
        warn(loaded->id + ": dropped " + std::to_string(d.degenerate) +
             (D == 2 ? " of zero length, " : " of zero area, ") + std::to_string(d.duplicate) + " duplicates, " +
             std::to_string(d.not_finite) + " not finite: the others are numbered anew");
    ViewSpec<D> view;
    view.look_at.x = 1;
    if (loaded->start_view) view = *loaded->start_view;
    view = view_in_script<D>(view, *loaded, eye, look_at, fov);
    std::span<const Method<D>> table = methods->table;
    ScriptSession<D> opened{std::move(methods), Session<D>(loaded, view, settings, table)};
    opened.session.times().read = read_ms;
    return opened;
}

template <int D>
void change_in_script(ScriptSession<D>& self, const py::kwargs& given) {
    Settings settings = self.session.settings();
    apply<D>(settings, given);
    if (difference(self.session.settings(), settings) == Invalidates::scene)
        throw InputError("two_sided decides how the scene is read: give it when you open the scene");
    guarded(self, [&](Session<D>& session) { return session.change(settings); });
}

#define SIGHTLINE_INSTANTIATE(D)                                                                               \
    template struct ScriptSession<D>;                                                                          \
    template ViewSpec<D> view_in_script<D>(ViewSpec<D>, const Scene<D>&, const py::object&, const py::object&, \
                                           const py::object&);                                                 \
    template ScriptSession<D> open_in_script<D>(const py::object&, const py::object&, const py::object&,       \
                                                const py::object&, const py::object&, const py::object&,       \
                                                const py::object&, const py::list&, const py::kwargs&);        \
    template void change_in_script<D>(ScriptSession<D>&, const py::kwargs&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
