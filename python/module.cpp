// The Python module `sightline`: docs/python.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/run/step.h"
#include "python/convert.h"
#include "python/script_session.h"

namespace sightline {

namespace {

template <typename Words>
std::vector<std::string> texts(const Words& words) {
    return {words.begin(), words.end()};
}

}  // namespace

PYBIND11_MODULE(sightline, module) {
    namespace py = pybind11;
    module.doc() = "Occlusion culling that can be stepped, explained and measured: docs/python.md.";
    py::register_exception<InputError>(module, "InputError", PyExc_ValueError).attr("__doc__") =
        "Input that cannot be used, or wrong usage: says what, where and why.";
    py::register_exception<WorkError>(module, "WorkError", PyExc_RuntimeError).attr("__doc__") =
        "Something failed while working.";
    module.attr("cell_states") = texts(cell_state_words);
    module.attr("none") = none;
    module.attr("kinds") = texts(kind_words);
    bind_heuristics(module);
    bind_session<2>(module);
    bind_session<3>(module);
}

}  // namespace sightline
