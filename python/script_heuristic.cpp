// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/script_heuristic.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/methods/cells/facet_geometry.h"
#include "python/convert.h"

namespace sightline {

namespace py = pybind11;

template <int D>
const Problem<D>& AskedFacet<D>::open() const {
    if (!problem) throw std::runtime_error("a facet can be asked only while the function that got it runs");
    return *problem;
}

template <int D>
double AskedFacet<D>::term(FormulaTerm term) {
    const Problem<D>& of = open();
    if (term == FormulaTerm::hops && !terms->has_hops()) terms.emplace(of, true);
    const auto i = static_cast<std::size_t>(term);
    asked |= 1u << i;
    return values[i] = terms->value(term, of, a, key_a, half);
}

template <int D>
ScriptHeuristic<D>::ScriptHeuristic(std::shared_ptr<const ScriptKey> script)
    : seed_key(script->seed_key),
      script_(std::move(script)),
      facet_(std::make_shared<AskedFacet<D>>()),
      argument_(py::cast(facet_)) {}

template <int D>
ScriptHeuristic<D>::ScriptHeuristic(const ScriptHeuristic& other) : ScriptHeuristic(other.script_) {
    on_reenqueue = other.on_reenqueue;
    facet_->terms = other.facet_->terms;
}

template <int D>
void ScriptHeuristic<D>::begin(const Problem<D>& problem) {
    on_reenqueue = problem.parameters.template choice<OnReenqueue>(on_reenqueue_row());
    facet_->terms.emplace(problem, false);
}

template <int D>
Key ScriptHeuristic<D>::key(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half) const {
    AskedFacet<D>& facet = *facet_;
    facet.problem = &problem;
    facet.a = a;
    facet.key_a = key_a;
    facet.half = half;
    facet.asked = 0;
    const struct Closed {
        AskedFacet<D>& facet;
        ~Closed() { facet.problem = nullptr; }
    } closed{facet};
    const py::object said = script_->key(argument_);
    Key key = 0;
    try {
        if (py::isinstance<py::tuple>(said)) {
            const auto [value, penalty] = said.cast<std::pair<double, bool>>();
            key = {value, penalty};
        } else {
            key = said.cast<double>();
        }
    } catch (const py::cast_error&) {
        throw py::type_error("the key of " + script_->id +
                             " must be a number, or (number, whether it has a penalty): " + "it is " +
                             py::repr(said).cast<std::string>());
    }
    if (std::isnan(key.value))
        throw py::value_error("the key of " + script_->id + " for cell " + std::to_string(half.neighbour) +
                              ", reached from cell " + std::to_string(a) + ", is not a number: keys need an order");
    return key;
}

template <int D>
KeyExplanation ScriptHeuristic<D>::explain(const Problem<D>& problem, std::uint32_t a, double key_a,
                                           const HalfFacet& half, int digits) const {
    const Key key = this->key(problem, a, key_a, half);
    KeyExplanation e;
    e.key = key.value;
    e.parts = {{"key = " + script_->id + "(facet) = " + short_number(e.key, digits)}};
    e.tip = "what the function of the script returned, and the terms that it read";
    e.weightiest = "its key, " + short_number(e.key, digits);
    for (std::size_t i = 0; i < formula_term_words.size(); ++i) {
        if (!(facet_->asked >> i & 1)) continue;
        const double value = facet_->values[i];
        e.terms.push_back({formula_term_words[i], value, {}});
        e.parts.push_back({e.parts.size() == 1 ? " (" : ", "});
        e.parts.push_back({std::string(formula_term_words[i]) + " " + short_number(value, digits),
                           about_of(static_cast<FormulaTerm>(i)), formula_term_words[i]});
    }
    if (e.parts.size() > 1) e.parts.push_back({")"});
    e.terms.push_back({"key", e.key, {}});
    return e;
}

template <int D>
void ScriptHeuristic<D>::add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int) const {
    lines.push_back({"key(n, c): what the script's " + script_->id + "(facet) returns", 0, false, {}, {}});
    if (explained) lines.back().values = explained->sum();
}

template <int D>
Method<D> script_method(const std::shared_ptr<const ScriptKey>& script) {
    Method<D> method{script->id, script->title, script->sentence,
                     [script](const Problem<D>& problem) -> std::unique_ptr<Run<D>> {
                         return std::make_unique<CellRun<D, ScriptHeuristic<D>>>(problem, ScriptHeuristic<D>(script));
                     }};
    method.parameters = cell_parameter_rows(formula_term_rows());
    return method;
}

namespace {

template <int D>
Vec<D> centroid_of(const AskedFacet<D>& facet) {
    return facet_geometry(*facet.open().cells, facet.half).centroid + facet.open().scene->origin;
}

template <int D>
void bind_facet(py::module_& module, const char* name) {
    using Facet = AskedFacet<D>;
    py::class_<Facet, std::shared_ptr<Facet>> facet(
        module, name,
        "What a heuristic is asked about: the facet from a cell just projected to the one that gets a key");
    for (std::size_t i = 0; i < formula_term_words.size(); ++i)
        facet.def_property_readonly(
            std::string(formula_term_words[i]).c_str(),
            [i](Facet& self) { return self.term(static_cast<FormulaTerm>(i)); },
            std::string(formula_term_help()[i]).c_str());
    facet
        .def_property_readonly(
            "cell", [](const Facet& self) { return self.open(), self.a; }, "the cell just projected")
        .def_property_readonly(
            "neighbour", [](const Facet& self) { return self.open(), self.half.neighbour; },
            "the cell that gets the key")
        .def_property_readonly(
            "facet", [](const Facet& self) { return self.open(), self.half.facet(); }, "the number of the facet")
        .def_property_readonly(
            "centroid", [](const Facet& self) { return point_tuple<D>(centroid_of(self)); }, "of the facet")
        .def_property_readonly(
            "normal",
            [](const Facet& self) {
                const Vec<D> n = facet_geometry(*self.open().cells, self.half).normal;
                const double length = std::sqrt(glm::dot(n, n));
                return point_tuple<D>(length > 0 ? n / length : n);
            },
            "of the facet, towards the cell that gets the key; its length is 1")
        .def_property_readonly(
            "centre",
            [](const Facet& self) {
                const Problem<D>& problem = self.open();
                return point_tuple<D>(problem.cells->centre(self.half.neighbour) + problem.scene->origin);
            },
            "of the cell that gets the key")
        .def_property_readonly(
            "eye", [](const Facet& self) { return point_tuple<D>(self.open().view.eye + self.open().scene->origin); },
            "where the view is from");
}

/// That of a function is its name; "script" where it has none.
std::string id_of_function(const py::function& function) {
    const auto name = py::str(py::getattr(function, "__name__", py::str("script"))).cast<std::string>();
    return name == "<lambda>" ? "script" : name;
}

/// Ids go into variants: "crowd on_reenqueue=min".
std::string checked_id(const std::string& id) {
    const bool plain = !id.empty() && std::all_of(id.begin(), id.end(), [](unsigned char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
    if (!plain)
        throw InputError("the id of a heuristic has letters, digits, _ and - only: give another than '" + id + "'");
    return id;
}

}  // namespace

void bind_heuristics(py::module_& module) {
    bind_facet<2>(module, "Facet2d");
    bind_facet<3>(module, "Facet3d");
    py::class_<ScriptKey, std::shared_ptr<ScriptKey>>(
        module, "Heuristic",
        "A method that orders cells by a function: key(facet) returns the key of facet.neighbour when facet.cell has "
        "just been projected, the lowest comes first. A key may be (number, True): it carries a penalty.")
        .def(py::init([](py::function key, std::optional<std::string> id, double seed_key, std::string title) {
                 ScriptKey script;
                 script.id = checked_id(id ? *id : id_of_function(key));
                 if (std::isnan(seed_key)) throw InputError("seed_key is not a number");
                 script.key = std::move(key);
                 script.seed_key = seed_key;
                 script.title = title.empty() ? script.id : std::move(title);
                 script.sentence = "cells by the function " + script.id + " of a script";
                 return std::make_shared<ScriptKey>(std::move(script));
             }),
             py::arg("key"), py::arg("id") = py::none(), py::arg("seed_key") = 0.0, py::arg("title") = "")
        .def_readonly("id", &ScriptKey::id, "as methods are called: method=\"ID on_reenqueue=min\"")
        .def_readonly("key", &ScriptKey::key)
        .def_readonly("seed_key", &ScriptKey::seed_key, "the key of the cell that holds the eye");
}

template struct AskedFacet<2>;
template struct AskedFacet<3>;
template class ScriptHeuristic<2>;
template class ScriptHeuristic<3>;
template Method<2> script_method<2>(const std::shared_ptr<const ScriptKey>&);
template Method<3> script_method<3>(const std::shared_ptr<const ScriptKey>&);

}  // namespace sightline
