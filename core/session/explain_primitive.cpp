// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/explain_primitive.h"

#include <algorithm>

#include "core/base/number.h"
#include "core/session/explain.h"
#include "core/session/explain_box.h"
#include "core/session/missed.h"

namespace sightline {

namespace {

/// Those that hide most; the rest as a number.
std::string hider_words(const std::vector<Hider>& hiders, const char* kind) {
    constexpr std::size_t most = 4;
    const std::size_t told = std::min(hiders.size(), most);
    std::string text = std::string(kind) + (hiders.size() == 1 ? " " : "s ");
    for (std::size_t i = 0; i < told; ++i)
        text += (i == 0                   ? ""
                 : i + 1 == hiders.size() ? " and "
                                          : ", ") +
                std::to_string(hiders[i].primitive) + " (" + percent_text(hiders[i].share) + ")";
    if (hiders.size() > told) text += " and " + std::to_string(hiders.size() - told) + " more";
    return text;
}

/// From where to where it is seen.
std::string seen_words(const Session<2>& session, const PrimitiveSight& sight) {
    const auto point = [&](const Vec<2>& p) {
        const Vec<2> at = p + session.scene().origin;
        return short_number(at.x, 5) + "," + short_number(at.y, 5);
    };
    std::string text = percent_text(sight.share) + " of its angle";
    for (std::size_t i = 0; i < sight.pieces.size() && i < 3; ++i)
        text += (i == 0 ? ", from " : " and from ") + point(sight.pieces[i].from) + " to " + point(sight.pieces[i].to);
    if (sight.pieces.size() > 3) text += " and " + std::to_string(sight.pieces.size() - 3) + " more stretches";
    return text;
}
std::string seen_words(const Session<3>&, const PrimitiveSight& sight) {
    const auto& b = sight.seen_box;
    return std::to_string(sight.seen_pixels) + " of the " + std::to_string(sight.pixels) + " pixels that it covers, " +
           range_words(b[0], b[1], "column") + ", " + range_words(b[2], b[3], "row");
}

}  // namespace

template <int D>
PrimitiveExplanation explain_primitive(const Session<D>& session, std::uint32_t primitive) {
    PrimitiveExplanation e;
    e.primitive = primitive;
    e.visible = session.reference().visible[primitive] != 0;
    e.sight = sight_of(session.scene(), session.problem().view, session.reference(), primitive);
    const CellComplex<D>& cells = session.cells();
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        const auto held = cells.primitives_of(cell);
        if (std::find(held.begin(), held.end(), primitive) != held.end()) e.cells.push_back(cell);
    }
    const std::vector<std::uint32_t> projected_at = steps_of_projection(session);
    std::stable_sort(e.cells.begin(), e.cells.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto order = [&](std::uint32_t cell) {
            const CellState state = session.mark(cell).state;
            return state == CellState::projected ? 0 : state == CellState::enqueued ? 1 : 2;
        };
        if (order(a) != order(b)) return order(a) < order(b);
        if (order(a) == 0) return projected_at[a] < projected_at[b];
        return order(a) == 1 && comes_before(session.mark(a), session.mark(b));
    });
    const Session<D> end = copy_at(session, session.recorded());
    const auto met = end.met();
    for (std::uint32_t i = 0; i < met.size(); ++i) {
        if (met[i].primitive() != primitive) continue;
        e.culled = met[i].culled();
        const auto& steps = end.timeline().steps;
        const auto step =
            std::find_if(steps.begin(), steps.end(), [i](const Step& s) { return s.after.touched_count > i; });
        e.met_at = static_cast<std::uint32_t>(step - steps.begin()) + 1;
    }
    return e;
}

template <int D>
std::string sight_sentence(const Session<D>& session, const PrimitiveExplanation& e) {
    const char* const kind = D == 2 ? "segment" : "triangle";
    std::string text = primitive_name(session.scene(), e.primitive);
    text[0] = D == 2 ? 'S' : 'T';
    switch (e.sight.unseen) {
        case Unseen::outside:
            return text + " lies outside the view.";
        case Unseen::turned_away:
            return text + " is hidden: it faces away from the eye.";
        case Unseen::edge_on:
            return text + " is hidden: it lies on a line through the eye.";
        case Unseen::no_pixel:
            return text + " is hidden: it covers no pixel centre.";
        case Unseen::no:
            break;
    }
    if (!e.visible) return text + " is hidden by " + hider_words(e.sight.hiders, kind) + ".";
    text += " is visible: " + seen_words(session, e.sight);
    if (!e.sight.hiders.empty()) text += "; the rest is hidden by " + hider_words(e.sight.hiders, kind);
    return text + ".";
}

std::string met_sentence(const PrimitiveExplanation& e, std::uint32_t position) {
    if (e.met_at == 0) return "No recorded step reaches it.";
    const std::string step = "Step " + std::to_string(e.met_at);
    const bool done = e.met_at <= position;
    if (e.culled) return step + (done ? " found it outside the view." : " will find it outside the view.");
    return step + (done ? " rendered it." : " will render it.");
}

namespace {

/// Of a primitive of a projected cell.
template <int D>
std::string left_words(const Session<D>& session, std::uint32_t primitive, std::uint32_t cell) {
    const auto& waiting_key = session.method().waiting_key;
    const auto key = waiting_key && session.counters().partial_cell != cell
                         ? waiting_key(session.problem(), cell, session.mark(cell).key, primitive)
                         : std::nullopt;
    if (!key) return "; the budget ended in it";
    const bool ended = session.finished() && session.counters().spent >= session.problem().budget;
    return "; it waits since then, with a key of about " + short_number(*key) +
           (ended ? ", and the budget ended before its turn" : "");
}

}  // namespace

template <int D>
std::string put_off_sentence(const Session<D>& session, const PrimitiveExplanation& e) {
    if (e.met_at > 0) return "";
    if (session.traversal().postpones())
        if (const Verdict waits = session.traversal().why_not(primitive_item(e.primitive)))
            return "By itself " + waits.sentence + ".";
    if (e.cells.empty() || !session.method().orders_cells()) return "";
    const CellExplanation cell = explain_cell(session, e.cells.front());
    std::string text = "Cell " + std::to_string(cell.cell);
    if (e.cells.size() > 1) text += ", the first of the " + std::to_string(e.cells.size()) + " cells that hold it,";
    if (cell.projected_at > 0)
        return text + " is projected in step " + std::to_string(cell.projected_at) +
               left_words(session, e.primitive, cell.cell) + ".";
    if (!cell.verdict) return "";
    text += cell.rank > 0 ? " is number " + std::to_string(cell.rank) + " in the front, held back by: "
                          : " is not in the front: ";
    return text + cell.verdict.sentence + ".";
}

template <int D>
std::string place_words(const Session<D>& session, std::uint32_t cell) {
    const Mark mark = session.mark(cell);
    if (mark.state != CellState::enqueued) return std::string(cell_state_words[static_cast<std::size_t>(mark.state)]);
    return "number " + std::to_string(rank_in_front(session, cell)) + " in the front";
}

template <int D>
std::vector<std::string> rows(const Session<D>& session, const PrimitiveExplanation& e) {
    std::vector<std::string> text{sight_sentence(session, e), met_sentence(e, session.position())};
    const std::size_t count = e.cells.size(), told = std::min(count, most_cells_told);
    if (const std::uint32_t box = box_around(session, e.primitive); box != none) {
        text.push_back("  It lies in " + box_sentence(session, box) + ".");
        if (const Verdict verdict = session.traversal().why_not(primitive_item(e.primitive)))
            text.push_back("  By itself " + verdict.sentence + ".");
        return text;
    }
    if (session.traversal().rooms_seen() || session.method().pops == Kind::object) {  // cells decide nothing
        const Item item = primitive_item(e.primitive);
        for (const Verdict& verdict : {session.traversal().why_not(item), session.traversal().why_drawn(item)})
            if (verdict) {
                std::string sentence = verdict.sentence;
                sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
                text.push_back("  " + sentence + ".");
            }
        return text;
    }
    if (count == 0) text.push_back("No cell holds it.");
    if (const std::string why = put_off_sentence(session, e); !why.empty()) text.push_back(why);
    for (std::size_t i = 0; i < told; ++i)
        text.push_back("  " + item_name(cell_item(e.cells[i])) + " holds it: " + place_words(session, e.cells[i]));
    if (count > told) text.push_back("  " + std::to_string(count - told) + " more cells hold it");
    return text;
}

#define SIGHTLINE_INSTANTIATE(D)                                                              \
    template PrimitiveExplanation explain_primitive<D>(const Session<D>&, std::uint32_t);     \
    template std::string sight_sentence<D>(const Session<D>&, const PrimitiveExplanation&);   \
    template std::string put_off_sentence<D>(const Session<D>&, const PrimitiveExplanation&); \
    template std::string place_words<D>(const Session<D>&, std::uint32_t);                    \
    template std::vector<std::string> rows<D>(const Session<D>&, const PrimitiveExplanation&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
