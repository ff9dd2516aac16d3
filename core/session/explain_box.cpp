// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/explain_box.h"

#include <algorithm>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/space/box_tree.h"

namespace sightline {

template <int D>
std::uint32_t box_around(const Session<D>& session, std::uint32_t primitive) {
    if (session.method().pops != Kind::node) return none;
    const BoxTree<D>& tree = *session.traversal().boxes();
    const auto place = static_cast<std::uint32_t>(std::find(tree.primitives.begin(), tree.primitives.end(), primitive) -
                                                  tree.primitives.begin());
    std::uint32_t found = 0;
    while (tree.nodes[found].first_child != none) {
        const std::uint32_t next = tree.child_at(found, place);
        if (session.traversal().mark(Item{next, Kind::node}).state == CellState::clean) break;
        found = next;
    }
    return found;
}

namespace {

/// What became of it.
template <int D>
std::string fate_words(const Session<D>& session, const Item& item, const std::vector<std::uint32_t>& primitives) {
    if (const Verdict verdict = session.traversal().why_not(item)) return verdict.sentence;
    if (session.traversal().mark(item).state == CellState::enqueued) return "it waits in the front";
    const Drawn& drawn = session.traversal().drawn();
    const auto rendered =
        std::count_if(primitives.begin(), primitives.end(), [&](std::uint32_t p) { return drawn.has(p); });
    const std::string what = primitives.size() == 1 ? std::string(rendered == 1 ? "the one is" : "the one is not")
                             : rendered == 1        ? "1 of them is"
                                                    : std::to_string(rendered) + " of them are";
    if (const Verdict verdict = session.traversal().why_drawn(item))
        return verdict.sentence + "; " + what + " rendered";
    return "it may be seen, and " + what + " rendered";
}

}  // namespace

template <int D>
std::string box_sentence(const Session<D>& session, std::uint32_t node) {
    const Item item{node, Kind::node};
    const auto held = session.traversal().boxes()->primitives_of(node);
    std::vector<std::uint32_t> primitives(held.begin(), held.end());  // one may stand in several leaves
    std::sort(primitives.begin(), primitives.end());
    primitives.erase(std::unique(primitives.begin(), primitives.end()), primitives.end());
    std::string text = item_name(item) + ", " + counted(primitives.size(), D == 2 ? "segment" : "triangle") + ": ";
    text += fate_words(session, item, primitives);
    const Mark mark = session.traversal().mark(item);
    if (mark.state == CellState::clean) return text;
    if (const auto key = session.traversal().key_terms(item, 3)) return text + "; " + key->sum();
    return mark.state == CellState::enqueued ? text + ", key " + short_number(mark.key) : text;
}

#define SIGHTLINE_INSTANTIATE(D)                                                      \
    template std::uint32_t box_around<D>(const Session<D>&, std::uint32_t primitive); \
    template std::string box_sentence<D>(const Session<D>&, std::uint32_t node);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
