// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/cplp/cplp.h"

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/methods/cells/cell_base.h"
#include "core/run/budget.h"

namespace sightline {

namespace {

std::string check_first(const ParameterRow&, std::string_view text) { return read_variant(text).text(); }

/// Throws InputError that lists those which may come first.
template <int D>
void check_among(const std::vector<Method<D>>& firsts, const std::string& id) {
    std::string known;
    for (const Method<D>& method : firsts) {
        if (method.is_called(id)) return;
        known += (known.empty() ? "" : ", ") + std::string(method.id);
    }
    throw InputError("'" + excerpt(id) +
                     "' cannot be completed: rounds of cPLP go on from methods that render whole cells: " + known);
}

std::string check_total(const ParameterRow&, std::string_view text) {
    const Budget total = parse_budget(text);
    if (total.kind == Budget::Kind::milliseconds)
        throw InputError("a time does not do here: say primitives or a share");
    return budget_text(total);
}

template <int D>
RoundForm form_of(const Problem<D>& problem) {
    const Parameters& parameters = problem.parameters;
    RoundForm form;
    form.test = parameters.choice<FrontTest>(cplp_test_row());
    form.listing = parameters.choice<Listing>(cplp_listing_row());
    form.tiles = parameters.choice<Switch>(cplp_tiles_row()) == Switch::on;
    form.only_winners = parameters.choice<Draws>(draws_row()) == Draws::winners;
    form.total = parse_budget(parameters.text(cplp_total_row())).primitives(problem.primitives().size());
    return form;
}

}  // namespace

const ParameterRow& cplp_first_row() {
    static const ParameterRow row =
        text_row("first", "published", "a method of cells, or a variant of one", "gem, cPLP",
                 "the method that spends the budget before the rounds", check_first);
    return row;
}

const ParameterRow& cplp_test_row() {
    static const ParameterRow row =
        choice_row("test", FrontTest::query, "gem, find_visible_front",
                   "how rounds test the front: each cell by itself, or all in one image of ids");
    return row;
}

const ParameterRow& cplp_listing_row() {
    static const ParameterRow row =
        choice_row("listing", Listing::mended, "gem, find_visible_front",
                   "with test=item: the gem's listing with its faults mended, or as it is printed, which loses cells");
    return row;
}

const ParameterRow& cplp_tiles_row() {
    static const ParameterRow row = choice_row("tiles", Switch::on, "gem, ImageTileSet",
                                               "with test=item: tiles in which no id shows are read no more");
    return row;
}

const ParameterRow& cplp_total_row() {
    static const ParameterRow row =
        text_row("total", "unlimited", "primitives, a share such as 5%, or unlimited", "TVCG 6",
                 "what the first method and the rounds together may spend", check_total);
    return row;
}

template <int D>
Method<D> cplp_method(std::vector<Method<D>> firsts, std::vector<const ParameterRow*> parameters) {
    Method<D> method{"cplp", "cPLP", "PLP to its budget, then rounds until nothing visible is missing (the gem)",
                     [firsts = std::move(firsts)](const Problem<D>& problem) {
                         Problem<D> inner = problem;
                         const VariantText first = read_variant(problem.parameters.text(cplp_first_row()));
                         check_among<D>(firsts, first.id);
                         const Method<D>& chosen = find_variant<D>(firsts, first, inner.parameters);
                         std::unique_ptr<Run<D>> run = chosen.start(inner);
                         auto* const cells = dynamic_cast<CellBase<D>*>(run.get());
                         if (!cells) throw InputError("first=" + first.text() + " orders no cells");
                         cells->complete_in_rounds(form_of(problem));
                         return run;
                     }};
    method.needs.image = true;
    method.promise = Misses::none_at_this_resolution;
    method.takes_back = [](const Parameters& parameters) {
        return parameters.choice<FrontTest>(cplp_test_row()) == FrontTest::item &&
               parameters.choice<Listing>(cplp_listing_row()) == Listing::printed;
    };
    method.prefixes = false;
    method.parameters = std::move(parameters);
    method.parameters.insert(method.parameters.begin(), {&cplp_first_row(), &cplp_test_row(), &cplp_listing_row(),
                                                         &cplp_tiles_row(), &cplp_total_row(), &draws_row()});
    return method;
}

template Method<2> cplp_method<2>(std::vector<Method<2>>, std::vector<const ParameterRow*>);
template Method<3> cplp_method<3>(std::vector<Method<3>>, std::vector<const ParameterRow*>);

}  // namespace sightline
