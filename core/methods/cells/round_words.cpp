// The rounds of cPLP in words: the lines of the gem, what became of a cell in the front.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/methods/cells/cell_base.h"

namespace sightline {

namespace {

/// The line of the gem's listing that decides about a cell in the front.
enum class RoundLine : std::uint8_t { draw, colour, test, read, drop, project };

struct RoundDecision {
    RoundLine line = RoundLine::test;
    std::string words;
};

/// `place`: of the cell in the front.
RoundDecision decision_of(const Change& change, std::uint32_t place, bool image_of_ids) {
    const std::string cell = item_name(change.item());
    const std::string other = change.via == none ? std::string() : item_name(cell_item(change.via));
    switch (Rule{change.rule}) {
        case Rule::tested_seen:
            return {RoundLine::test, image_of_ids ? cell + ": read" : cell + ": yes"};
        case Rule::tested_without:
            return {RoundLine::drop, cell + (other.empty() ? ": hidden so far" : ": " + other + " is nearer")};
        case Rule::tested_hidden:
            return {image_of_ids ? RoundLine::drop : RoundLine::test,
                    cell + (image_of_ids ? ": hidden, as no pixel has an id" : ": no, it stays hidden")};
        default:
            break;
    }
    if (change.via == none) return {RoundLine::drop, cell + ": hidden, it leaves the front"};
    if (change.via != change.id) return {RoundLine::draw, cell + ": lost, " + other + " was drawn over it"};
    const std::uint32_t read = as_printed_colour(place);
    if (read == place) return {RoundLine::read, cell + ": lost, it shows in tiles that are not read any more"};
    return {RoundLine::colour, cell + ": lost, number " + std::to_string(place + 1) + " is read as " +
                                   (read == none ? "background" : "number " + std::to_string(read + 1))};
}

/// "37 of 192 tiles"
std::string tiles_words(const std::vector<ReadTile>& tiles) {
    const auto read = std::count_if(tiles.begin(), tiles.end(), [](const ReadTile& tile) { return tile.read; });
    return std::to_string(read) + " of " + std::to_string(tiles.size()) + " tiles";
}

}  // namespace

/// The second phase, under the lines of the first.
template <int D>
void CellBase<D>::add_round_lines(std::vector<CodeLine>& lines, const CodePlace& at, bool in_round) const {
    const RoundForm& form = rounds_->form;
    const bool here = in_round || (!at.in_step() && in_rounds()), ids = form.test == FrontTest::item;
    if (here)
        for (CodeLine& line : lines) line.lit = false;
    const std::uint32_t substep = in_round ? *at.substep : 0, first_test = form.first_test_substep();
    std::optional<RoundDecision> decision;
    std::uint32_t tests = 0;
    for (const Change& change : in_round ? at.changes : std::span<const Change>{})
        if (is_test(change) && first_test + tests++ == substep) decision = decision_of(change, tests - 1, ids);
    if (in_round && substep >= first_test && !decision) decision = RoundDecision{RoundLine::project, {}};
    const auto add = [&](RoundLine which, std::string text, std::string_view source, bool also = false) {
        lines.push_back({std::move(text), 1, also || (decision && decision->line == which), {}, std::string(source)});
        if (lines.back().lit && decision) lines.back().values = decision->words;
    };

    lines.push_back(
        {ids ? "then, until no pixel shows a cell of the front:" : "then, until no cell of the front can be seen:",
         0,
         here && !in_round,
         {},
         "gem, conservative_finish"});
    if (form.printed()) lines.back().text = "then, until the front is empty:";
    if (lines.back().lit)
        lines.back().values = cut_short()  ? "the budget of both phases is spent"
                              : finished() ? "none can: nothing visible is left"
                                           : "round " + std::to_string(rounds_->done + 1) + " is next";
    if (lines.back().lit && finished() && form.printed())
        lines.back().values = "it is; what was lost on the way is missing";
    lines.push_back({"draw what is rendered into a depth image",
                     1,
                     in_round && substep < (ids ? 1u : 2u),
                     {},
                     "gem, find_visible_front"});
    if (!ids) {
        add(RoundLine::test, "for each cell of the front: does a pixel of it lie before that image?",
            "gem, find_visible_front");
    } else {
        add(RoundLine::draw,
            form.printed() ? "draw the front into an image of ids, in its order: depths are not written, the last wins"
                           : "draw the front into an image of ids: the nearest wins",
            "gem, find_visible_front: glDepthMask", in_round && substep == 1);
        if (form.printed())
            add(RoundLine::colour, "a cell's id is its number in the front, cut to one byte",
                "gem, find_visible_front: GLubyte g = j & 0x0000FF00");
        const bool reads = in_round && substep == 2;
        add(RoundLine::read, "read the ids, but for tiles that showed none before",
            "gem, find_visible_front: read_active", reads);
        if (reads) lines.back().values = tiles_words(tiles());
        add(RoundLine::test, "a cell whose id is read can be seen", "gem, find_visible_front: front_push");
        add(RoundLine::drop,
            form.printed() ? "a cell whose id is not read leaves the front, and is clean again"
                           : "a cell whose id is not read stays in the front",
            "gem, find_visible_front: NS_CLEAN");
    }
    add(RoundLine::project, "project those that can be seen, and add their neighbours", "gem, conservative_finish");
}

template <int D>
std::string CellBase<D>::popped_words(const Step& step) const {
    if (step.item.kind != Kind::round) return Run<D>::popped_words(step);
    std::string words = item_name(step.item);
    if (const auto bytes = bytes_read(step.item, false))
        words += ", " + short_number(*bytes / 1024) + " of " + short_number(*bytes_read(step.item, true) / 1024) +
                 " KiB of ids read";
    return words;
}

/// Of a clean cell.
template <int D>
Verdict CellBase<D>::why_lost(std::uint32_t cell) const {
    if (!rounds_) return {};
    const auto& lost = rounds_->lost;
    const auto last = std::find_if(lost.rbegin(), lost.rend(),
                                   [&](const auto& round_and_cell) { return round_and_cell.second == cell; });
    if (last == lost.rend()) return {};
    return {"lost", "round " + std::to_string(last->first) +
                        " took it out of the front, as it read its id at no pixel (listing=printed)"};
}

template <int D>
Verdict CellBase<D>::why_waiting(const Item& item) const {
    if (!rounds_ || item.kind != Kind::cell || !rounds_->hidden[item.id]) return {};
    Screen<D> screen;
    screen.show(this->problem_, this->met(), this->counters_.touched_count);
    const SeenPart sight = screen.part_of(this->problem_, item.id);
    return {"hidden", "it is hidden: its " + std::to_string(sight.pixels) +
                          (sight.pixels == 1 ? " pixel lies" : " pixels lie") + " behind " +
                          some_of(D == 2 ? "segment" : "triangle", sight.hidden_by, most_hiders)};
}

#define SIGHTLINE_INSTANTIATE(D)                                                                      \
    template void CellBase<D>::add_round_lines(std::vector<CodeLine>&, const CodePlace&, bool) const; \
    template std::string CellBase<D>::popped_words(const Step&) const;                                \
    template Verdict CellBase<D>::why_lost(std::uint32_t) const;                                      \
    template Verdict CellBase<D>::why_waiting(const Item&) const;
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
