// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/comparison.h"

#include <algorithm>

#include "core/base/number.h"
#include "core/session/explain.h"
#include "core/session/lanes.h"

namespace sightline {

namespace {

std::string steps_words(std::uint32_t steps) { return std::to_string(steps) + (steps == 1 ? " step" : " steps"); }

/// The primitives that a recorded step rendered, in order.
template <int D>
std::vector<std::uint32_t> rendered_in(const Session<D>& session, std::uint32_t step) {
    return rendered_ids(session.timeline().met_in(step, session.traversal().drawn().all()));
}

/// What one side does in a step. `theirs` is the cell that the other side pops, none where cell ids do not compare.
template <int D>
std::string what_it_does(const Session<D>& session, const std::string& name, std::uint32_t step, std::uint32_t theirs,
                         int digits) {
    if (step > session.recorded()) return name + " is recorded for " + steps_words(session.recorded()) + " only";
    const std::uint32_t cell = id_of(session.timeline().steps[step - 1].item, Kind::cell);
    if (cell == none) {
        const auto primitives = rendered_in(session, step);
        return name + " renders " + std::to_string(primitives.size()) +
               (primitives.size() == 1 ? " primitive" : " primitives") +
               (primitives.empty() ? "" : ", first " + std::to_string(primitives.front()));
    }
    const Session<D> before = copy_at(session, step - 1);
    std::string text =
        name + " projects cell " + std::to_string(cell) + " with key " + short_number(before.mark(cell).key, digits);
    if (theirs == none || theirs == cell) return text;
    const Mark mark = before.mark(theirs);
    text += " (its cell " + std::to_string(theirs) + ": " +
            std::string(cell_state_words[static_cast<std::size_t>(mark.state)]);
    if (mark.state == CellState::enqueued || mark.state == CellState::projected)
        text += ", key " + short_number(mark.key, digits);
    return text + ")";
}

/// The digits that tell the keys of a side's popped cell and of the other side's apart.
template <int D>
int digits_apart(const Session<D>& session, std::uint32_t step, std::uint32_t theirs) {
    if (step > session.recorded()) return 3;
    const std::uint32_t cell = id_of(session.timeline().steps[step - 1].item, Kind::cell);
    if (cell == none || theirs == none) return 3;
    const Session<D> before = copy_at(session, step - 1);
    const Mark mark = before.mark(theirs);
    return mark.state == CellState::enqueued ? separating_digits(before.mark(cell).key, mark.key) : 3;
}

/// Of the steps that both have recorded.
template <int D>
std::optional<std::uint32_t> difference_in_common(const Session<D>& a, const Session<D>& b) {
    const bool by_cells = a.method().orders_cells() && b.method().orders_cells() && same_cells(a, b);
    const std::uint32_t common = std::min(a.recorded(), b.recorded());
    for (std::uint32_t step = 1; step <= common; ++step) {
        const bool same = by_cells ? a.timeline().steps[step - 1].item == b.timeline().steps[step - 1].item
                                   : rendered_in(a, step) == rendered_in(b, step);
        if (!same) return step;
    }
    return std::nullopt;
}

}  // namespace

template <int D>
bool same_cells(const Session<D>& a, const Session<D>& b) {
    const CellComplex<D>&x = a.cells(), &y = b.cells();
    if (&x == &y) return true;  // a copy
    return x.kind == y.kind && x.points == y.points && x.cell_points == y.cell_points &&
           x.facet_points == y.facet_points && x.cell_facet_begin == y.cell_facet_begin &&
           std::equal(x.half_facets.begin(), x.half_facets.end(), y.half_facets.begin(), y.half_facets.end(),
                      [](const HalfFacet& f, const HalfFacet& g) {
                          return f.neighbour == g.neighbour && f.facet_side == g.facet_side;
                      });
}

template <int D>
std::vector<Differs> cell_differences(const Session<D>& here, const Session<D>& there) {
    std::vector<Differs> differences;
    if (!goes_through_cells(here) || !goes_through_cells(there) || !same_cells(here, there)) return differences;
    differences.reserve(here.cells().cell_count());
    for (std::uint32_t cell = 0; cell < here.cells().cell_count(); ++cell) {
        const bool ours = here.mark(cell).state == CellState::projected;
        const bool theirs = there.mark(cell).state == CellState::projected;
        differences.push_back(ours == theirs ? Differs::no : ours ? Differs::only_here : Differs::only_there);
    }
    return differences;
}

template <int D>
std::optional<std::uint32_t> first_difference(const Session<D>& a, const Session<D>& b) {
    if (const auto step = difference_in_common(a, b)) return step;
    if (a.recorded() != b.recorded()) return std::min(a.recorded(), b.recorded()) + 1;
    return std::nullopt;
}

template <int D>
std::string so_far_sentence(const Session<D>& a, const Session<D>& b) {
    if (const auto step = difference_in_common(a, b)) return difference_sentence(a, b, *step);
    const std::uint32_t common = std::min(a.recorded(), b.recorded());
    if (common == 0) return "No step to compare yet.";
    return "Both agree in the first " + steps_words(common) + ".";
}

template <int D>
void follow(const Session<D>& lead, Session<D>& other, Align align) {
    if (align == Align::step) {
        other.seek(lead.position());
        return;
    }
    const std::uint32_t wanted = lead.counters().drawn();
    other.seek(step_of_rendered(other, wanted));
    while (other.counters().drawn() < wanted)
        if (other.step() != Stop::none) return;
}

template <int D>
std::string align_sentence(const Session<D>& lead, const Session<D>& other, Align align) {
    if (align == Align::rendered)
        return "aligned by drawn: " + std::to_string(lead.counters().drawn()) + " against " +
               std::to_string(other.counters().drawn());
    if (lead.position() == other.position()) return "aligned by step: both have made " + steps_words(lead.position());
    return "aligned by step: " + std::to_string(lead.position()) + " against " + std::to_string(other.position()) +
           (other.position() < lead.position() ? ", where the right one ends" : "");
}

template <int D>
std::string difference_sentence(const Session<D>& a, const Session<D>& b, std::uint32_t step) {
    const bool comparable = same_cells(a, b);
    const auto popped = [&](const Session<D>& session) {
        return comparable && step <= session.recorded() ? id_of(session.timeline().steps[step - 1].item, Kind::cell)
                                                        : none;
    };
    const std::uint32_t left = popped(a), right = popped(b);
    const int digits = std::max(digits_apart(a, step, right), digits_apart(b, step, left));
    return "Step " + std::to_string(step) + ": " + what_it_does(a, "left", step, right, digits) + "; " +
           what_it_does(b, "right", step, left, digits) + ".";
}

#define SIGHTLINE_INSTANTIATE(D)                                                                     \
    template bool same_cells<D>(const Session<D>&, const Session<D>&);                               \
    template std::vector<Differs> cell_differences<D>(const Session<D>&, const Session<D>&);         \
    template std::string so_far_sentence<D>(const Session<D>&, const Session<D>&);                   \
    template std::string align_sentence<D>(const Session<D>&, const Session<D>&, Align);             \
    template std::optional<std::uint32_t> first_difference<D>(const Session<D>&, const Session<D>&); \
    template void follow<D>(const Session<D>&, Session<D>&, Align);                                  \
    template std::string difference_sentence<D>(const Session<D>&, const Session<D>&, std::uint32_t);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
