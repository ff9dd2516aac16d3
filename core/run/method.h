// A row of the method table, and variants: a method with parameters of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/run/run.h"

namespace sightline {

/// What a method asks of its problem.
struct Needs {
    bool cells = true;
    bool boxes = false;        ///< Problem::boxes()
    bool visible_set = false;  ///< Services::visible_set
    bool image = false;        ///< Services::image
    bool history = false;      ///< the frame before decides
    bool last_frame = false;   ///< it tells what changed since the frame before, which decides nothing

    bool keeps_lane() const { return history || last_frame; }
};

/// Rows are made once; all views outlive them.
template <int D>
struct Method {
    std::string_view id;
    std::string_view title;
    std::string_view sentence;  ///< one sentence for the help
    std::function<std::unique_ptr<Run<D>>(const Problem<D>&)> start;
    Kind pops = Kind::cell;
    /// Makes what all frames of a scene share; not while a frame is timed.
    std::function<void(const Problem<D>&)> prepare{};
    Needs needs{};
    Misses promise = Misses::may;  ///< of a run that came to its end, unless the parameters take it back
    std::function<bool(const Parameters&)> takes_back{};
    /// Whether a budget in primitives is a fair question; false: measured without one.
    bool budgeted = true;
    /// A budget selects a prefix of one order, and a larger one goes on where it ended; false: it changes the order.
    bool prefixes = true;
    bool compared = true;       ///< stands in studies and charts that name no methods
    bool draws_levels = false;  ///< its runs may have stand_ins()
    std::vector<const ParameterRow*> parameters{};
    std::vector<std::string_view> aliases{};
    /// Of a method that lets primitives of a projected cell, which has that key, wait for their turn: about the key
    /// that a primitive waits with; nothing: the cell does not let it wait.
    std::function<std::optional<double>(const Problem<D>&, std::uint32_t cell, double key, std::uint32_t primitive)>
        waiting_key{};

    Misses promise_with(const Parameters& parameters) const {
        return takes_back && takes_back(parameters) ? Misses::may : promise;
    }
    bool orders_cells() const { return pops == Kind::cell; }
    bool is_called(std::string_view name) const {
        return name == id || std::find(aliases.begin(), aliases.end(), name) != aliases.end();
    }
    /// nullptr when it has none of that name.
    const ParameterRow* parameter(std::string_view name) const {
        for (const ParameterRow* row : parameters)
            if (row->name == name) return row;
        return nullptr;
    }
};

/// The row of that id or alias in a table; throws InputError that lists the ids.
template <int D>
const Method<D>& find_method(std::span<const Method<D>> table, std::string_view id);

/// "published on_reenqueue=min": an id and assignments. Values may be quoted: `cplp first="layers"`.
struct VariantText {
    std::string id;
    std::vector<std::pair<std::string, std::string>> assignments;
    bool operator==(const VariantText&) const = default;

    /// As it is written; values in quotes where they need them.
    std::string text() const;
};
/// Throws InputError that says what is wrong.
VariantText read_variant(std::string_view text);

/// Variants separated by semicolons, or by commas where there is no semicolon; neither counts inside quotes or
/// parentheses.
std::vector<std::string> split_variants(std::string_view text);

/// The method of a variant; its assignments are set in `parameters`. Throws InputError for a method or a parameter
/// that does not exist, and for values that cannot be.
template <int D>
const Method<D>& find_variant(std::span<const Method<D>> table, const VariantText& variant, Parameters& parameters);

/// A method with all its parameters, and how it is written.
template <int D>
struct Variant {
    Method<D> method;
    Parameters parameters;
    std::string text;
};

/// A variant over parameters that hold for all. Throws as find_variant.
template <int D>
Variant<D> make_variant(std::span<const Method<D>> table, std::string_view text, const Parameters& base = {}) {
    const VariantText variant = read_variant(text);
    Parameters parameters = base;
    const Method<D>& method = find_variant<D>(table, variant, parameters);
    return {method, std::move(parameters), variant.text()};
}

/// A method with those of the parameters that it has; written with those that are not what they are in `base`.
template <int D>
Variant<D> variant_of(const Method<D>& method, const Parameters& parameters, const Parameters& base = {});

/// What a run of the method is given. Of services and history it gets what it needs; scene and cells outlive the run.
template <int D>
Problem<D> make_problem(const Method<D>& method, const Parameters& parameters, const Scene<D>& scene,
                        const CellComplex<D>& cells, const View<D>& view, std::uint32_t budget = none,
                        const Services& services = {}, std::shared_ptr<const FrameHistory> history = nullptr) {
    if (method.needs.boxes) cells.boxes->of(scene);  // not while a frame is timed
    Problem<D> problem{&scene,
                       &cells,
                       view,
                       budget,
                       parameters,
                       method.needs.keeps_lane() ? std::move(history) : nullptr,
                       method.needs.visible_set || method.needs.image ? services : Services{}};
    if (method.prepare) method.prepare(problem);
    return problem;
}

/// What can be said of a run's guarantee: "approximate", "conservative", "conservative at this resolution", or
/// "conservative, cut short by the budget".
template <int D>
std::string guarantee_words(const Method<D>& method, const Run<D>& run);

}  // namespace sightline
