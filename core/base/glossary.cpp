// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/glossary.h"

#include <array>
#include <cctype>

#include "core/base/quote.h"

namespace sightline {

std::span<const GlossaryEntry> glossary() {
    static constexpr auto table = std::to_array<GlossaryEntry>({
        {"scene", "What is looked at: a list of primitives in no particular order.", "TVCG 1"},
        {"primitive", "A line segment in 2D, a triangle in 3D.", "TVCG 1"},
        {"tessellation", "Space cut into convex cells that do not overlap.", "TVCG 3.1"},
        {"cell", "One convex piece of the tessellation; it holds the primitives that meet it.", "TVCG 3.1"},
        {"facet", "What two neighbouring cells share: an edge in 2D, a polygon in 3D.", "TVCG 3.2"},
        {"eye", "The point that one looks from.", "TVCG 3"},
        {"view", "The eye and the cone that it sees; all methods and measures use the same one.", "TVCG 4.2"},
        {"culling view", "The view that decides what is rendered.", "TVCG 4"},
        {"display view", "The view of the picture: another one than the culling view while that is frozen.", "TVCG 4"},
        {"freeze", "Keep the culling view where it is while the display view moves.", "TVCG 4"},
        {"method", "One way to choose what to render, and in which order.", "here"},
        {"variant", "A method with parameters of its own: published on_reenqueue=min.", "here"},
        {"run", "One execution of a method on a scene, from its start to the end of the budget.", "here"},
        {"step", "What a run does at once: it takes one item, mostly a cell, and deals with it.", "TVCG 4"},
        {"front", "The queue of cells that may be projected next, the lowest key first.", "TVCG 4.1"},
        {"enqueue", "Put a cell into the front.", "TVCG fig. 4"},
        {"re-enqueue", "Give a cell that is in the front already a new key.", "TVCG fig. 4, line 10"},
        {"project", "Take a cell from the front and render its primitives.", "TVCG fig. 4, line 3"},
        {"clean", "State of a cell that the run has not touched.", "gem"},
        {"enqueued", "State of a cell that waits in the front.", "gem"},
        {"projected", "State of a cell whose primitives are rendered.", "gem"},
        {"unseen", "State of a cell that was reached and lies outside the view.", "gem"},
        {"seed cell", "The cell that holds the eye, or the nearest one: where a run starts.", "TVCG 4.2"},
        {"stamp", "When a cell came into the front; of two equal keys the older stamp goes first.", "TVCG 4.2"},
        {"budget", "How many primitives, or how much time, a frame may spend.", "TVCG 4.1"},
        {"key", "The number that decides the order in the front.", "TVCG 4.1"},
        {"solidity ρ", "The key of the published method: how much is likely to stand between the eye and a cell.",
         "TVCG 3.1"},
        {"|A|", "How many primitives meet cell A.", "TVCG fig. 5"},
        {"ρ_max", "The most primitives in one cell of the tessellation.", "TVCG fig. 5"},
        {"content", "|A| / ρ_max of the cell before: what the ray has just crossed.", "TVCG fig. 5, line 1"},
        {"angle", "v · n of the facet: 1 where the ray goes straight through it, 0 where it grazes it.",
         "TVCG fig. 5, line 1"},
        {"handed on", "The solidity of the cell before; times the angle it is added to the content.",
         "TVCG fig. 5, line 1"},
        {"star-shaped",
         "Said of a step to a cell when the ray from the eye to its centre passes through the shared "
         "facet.",
         "TVCG 3.2"},
        {"penalty", "What the key pays when the step is not star-shaped.", "TVCG fig. 5, line 3"},
        {"layer", "How many facets a cell is from the seed cell; the key of the layer method.", "gem"},
        {"approximate", "May miss visible primitives.", "TVCG 1"},
        {"conservative",
         "Never misses a visible primitive, at the resolution that is named beside it; not so where a "
         "budget ended the run.",
         "TVCG 1"},
        {"reference", "What is really visible, which methods are measured against.", "TVCG 3"},
        {"item buffer", "An image that holds the number of the nearest primitive at each pixel.", "TVCG 4.4"},
        {"visible set V", "The primitives that the eye sees.", "TVCG 3"},
        {"T_k", "The primitives that a method renders with budget k.", "TVCG 3"},
        {"coverage ε_k", "The share of the visible primitives that is rendered: |V ∩ T_k| / |V|.", "TVCG 3"},
        {"oracle", "The best coverage that any order could have with this budget.", "here"},
        {"cell oracle", "The best coverage of an order of whole cells.", "here"},
        {"wrong pixels", "The share of pixels that show another primitive than the exact image.", "TVCG 3"},
        {"visible share", "How much of what is visible lies inside a cell, by angle in 2D and by pixels in 3D.",
         "here"},
        {"layering number ζ",
         "How many primitives a ray crosses before it comes to this one, plus 1, at best; 1 means "
         "visible.",
         "TVCG 3"},
        {"inversion", "A hidden cell with primitives was projected while a visible one had to wait.", "here"},
        {"mis-ranked", "An inversion whose visible cell was in the front, with a higher key.", "here"},
        {"unreached", "An inversion whose visible cell was not in the front yet.", "here"},
        {"pop", "Share of what is visible in two frames that only one of them renders.", "here"},
        {"flip", "Share of the pixels that are wrong in only one of two frames.", "here"},
        {"trade-off", "The chart of time against accuracy.", "here"},
        {"Pareto points", "The points of a trade-off that no other beats in both time and accuracy.", "here"},
        {"what-if", "A run with one parameter changed, to see when a cell or a primitive would have come.", "here"},
        {"substep", "A part of a step: taking the cell, rendering it, looking across each facet.", "here"},
        {"frame", "One view of a flight path.", "TVCG 4"},
        {"lane of frames", "The views before this frame, for methods that remember.", "here"},
    });
    return table;
}

const GlossaryEntry* find_term(std::string_view term) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    for (const GlossaryEntry& entry : glossary()) {
        bool same = entry.term.size() == term.size();
        for (std::size_t i = 0; same && i < term.size(); ++i) same = lower(entry.term[i]) == lower(term[i]);
        if (same) return &entry;
    }
    return nullptr;
}

std::string glossary_markdown() {
    std::string text = "| term | what it means | where it is defined |\n|---|---|---|\n";
    for (const GlossaryEntry& entry : glossary())
        text += "| " + markdown_escaped(entry.term) + " | " + markdown_escaped(entry.sentence) + " | " +
                (entry.source == "here" ? "Sightline" : markdown_escaped(entry.source)) + " |\n";
    return text;
}

}  // namespace sightline
