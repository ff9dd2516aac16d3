// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/cplp/cplp.h"

#include "core/base/error.h"
#include "core/methods/cells/cell_base.h"

namespace sightline {

namespace {

std::string check_first(const ParameterRow&, std::string_view text) { return read_variant(text).text(); }

}  // namespace

const ParameterRow& cplp_first_row() {
    static const ParameterRow row =
        text_row("first", "published", "a method of cells, or a variant of one", "gem, cPLP",
                 "the method that spends the budget before the rounds", check_first);
    return row;
}

template <int D>
Method<D> cplp_method(std::vector<Method<D>> firsts, std::vector<const ParameterRow*> parameters) {
    Method<D> method{
        "cplp", "cPLP", "PLP to its budget, then rounds until nothing visible is missing (the gem)",
        [firsts = std::move(firsts)](const Problem<D>& problem) {
            Problem<D> inner = problem;
            const VariantText first = read_variant(problem.parameters.text(cplp_first_row()));
            const Method<D>& chosen = find_variant<D>(firsts, first, inner.parameters);
            std::unique_ptr<Run<D>> run = chosen.start(inner);
            auto* const cells = dynamic_cast<CellBase<D>*>(run.get());
            if (!cells) throw InputError("first=" + first.text() + " orders no cells");
            cells->complete_in_rounds(problem.parameters.template choice<Draws>(draws_row()) == Draws::winners);
            return run;
        }};
    method.needs.image = true;
    method.promise = Misses::none_at_this_resolution;
    method.prefixes = false;
    method.parameters = std::move(parameters);
    method.parameters.insert(method.parameters.begin(), {&cplp_first_row(), &draws_row()});
    return method;
}

template Method<2> cplp_method<2>(std::vector<Method<2>>, std::vector<const ParameterRow*>);
template Method<3> cplp_method<3>(std::vector<Method<3>>, std::vector<const ParameterRow*>);

}  // namespace sightline
