// A heuristic whose key is a function of a script.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>

#include "core/methods/cells/cell_method.h"
#include "core/methods/formula/formula_terms.h"

namespace sightline {

/// What a person writes: sightline.Heuristic.
struct ScriptKey {
    pybind11::function key;
    std::string id;
    double seed_key = 0;
    std::string title, sentence;
};

/// What the function is told: the facet across which a cell gets its key. Good only while the function runs.
template <int D>
struct AskedFacet {
    const Problem<D>* problem = nullptr;
    std::optional<FormulaTerms<D>> terms;
    std::uint32_t a = none;
    double key_a = 0;
    HalfFacet half;
    std::uint32_t asked = 0;  ///< a bit per term that the function read
    std::array<double, static_cast<std::size_t>(FormulaTerm::count)> values{};  ///< of those

    /// Throws std::runtime_error when the function has returned.
    const Problem<D>& open() const;
    double term(FormulaTerm term);
};

template <int D>
class ScriptHeuristic {
public:
    double seed_key;
    OnReenqueue on_reenqueue = OnReenqueue::replace;

    explicit ScriptHeuristic(std::shared_ptr<const ScriptKey> script);
    /// A copy asks about its own problem.
    ScriptHeuristic(const ScriptHeuristic& other);
    ScriptHeuristic& operator=(const ScriptHeuristic&) = delete;

    void begin(const Problem<D>& problem);
    Key key(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half) const;
    KeyExplanation explain(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half,
                           int digits) const;
    void add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int digits) const;

private:
    std::shared_ptr<const ScriptKey> script_;
    std::shared_ptr<AskedFacet<D>> facet_;  ///< shared with the object that the function gets
    pybind11::object argument_;
};

/// Its row of the method table; the words in it are the script's, which must live as long.
template <int D>
Method<D> script_method(const std::shared_ptr<const ScriptKey>& script);

/// Classes Heuristic, Facet2d and Facet3d.
void bind_heuristics(pybind11::module_& module);

extern template class ScriptHeuristic<2>;
extern template class ScriptHeuristic<3>;

}  // namespace sightline
