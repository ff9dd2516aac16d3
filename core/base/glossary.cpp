// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/glossary.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/quote.h"

namespace sightline {

std::span<const GlossaryEntry> glossary() {
    static constexpr auto table = std::to_array<GlossaryEntry>({
        {"scene", "What is viewed: a list of primitives in no particular order.", "TVCG 1"},
        {"primitive", "A line segment in 2D, a triangle in 3D.", "TVCG 1"},
        {"tessellation", "Space cut into convex cells that do not overlap.", "TVCG 3.1"},
        {"cell", "One convex piece of the tessellation; it holds the primitives that meet it.", "TVCG 3.1"},
        {"facet", "What two neighbouring cells share: an edge in 2D, a polygon in 3D.", "TVCG 3.2"},
        {"eye", "The point from which the scene is viewed.", "TVCG 3"},
        {"view", "The eye and its view cone; all methods and measures use the same view.", "TVCG 4.2"},
        {"culling view", "The view that decides what is rendered.", "TVCG 4"},
        {"display view",
         "The view that the picture is drawn from; it can differ from the culling view while that is frozen.",
         "TVCG 4"},
        {"freeze", "Hold the culling view fixed while the display view moves.", "TVCG 4"},
        {"method", "One way to choose what to render, and in which order.", "here"},
        {"variant", "A method with parameter values: published on_reenqueue=min.", "here"},
        {"run", "One execution of a method on a scene, from its start to the end of the budget.", "here"},
        {"step", "One pop of a run: it takes one item, usually a cell, and processes it.", "TVCG 4"},
        {"front", "The queue of cells that may be projected next, the lowest key first.", "TVCG 4.1"},
        {"enqueue", "Put a cell into the front.", "TVCG fig. 4"},
        {"re-enqueue", "Give a new key to a cell that is already in the front.", "TVCG fig. 4, line 10"},
        {"project", "Take a cell from the front and render its primitives.", "TVCG fig. 4, line 3"},
        {"clean", "State of a cell that the run has not touched.", "gem"},
        {"enqueued", "State of a cell that waits in the front.", "gem"},
        {"projected", "State of a cell whose primitives are rendered.", "gem"},
        {"unseen", "State of a cell that was reached and lies outside the view.", "gem"},
        {"seed cell", "The cell that holds the eye, or the nearest one: where a run starts.", "TVCG 4.2"},
        {"stamp", "A serial number for each entry into the front; of two equal keys the older stamp goes first.",
         "TVCG 4.2"},
        {"budget", "How many primitives, or how much time, a frame may spend.", "TVCG 4.1"},
        {"key", "The number that decides the order in the front.", "TVCG 4.1"},
        {"solidity ρ", "The key of the published method: an estimate of how much stands between the eye and a cell.",
         "TVCG 3.1"},
        {"|A|", "How many primitives meet cell A.", "TVCG fig. 5"},
        {"ρ_max", "The most primitives in one cell of the tessellation.", "TVCG fig. 5"},
        {"content", "|A| / ρ_max of the cell before: what the ray has just crossed.", "TVCG fig. 5, line 1"},
        {"angle", "v · n of the facet: 1 where the ray is perpendicular to it, 0 where it grazes it.",
         "TVCG fig. 5, line 1"},
        {"handed on", "The solidity of the cell before; it is multiplied by the angle and added to the content.",
         "TVCG fig. 5, line 1"},
        {"star-shaped",
         "A cell is star-shaped from its neighbour when the ray from the eye to its centre passes through the "
         "facet that they share.",
         "TVCG 3.2"},
        {"penalty", "The factor or amount applied to the key of a cell that is not star-shaped.",
         "TVCG fig. 5, line 3"},
        {"layer", "The number of facets between a cell and the seed cell; the key of the method layers.", "gem"},
        {"round",
         "One pass of cPLP: it tests the cells of the front against what is drawn and projects those that can be seen.",
         "gem"},
        {"occluder", "A polygon, or a group of them, that is asked what it hides.", "CT 2"},
        {"occludee", "What may be hidden by an occluder: a box of the tree.", "CT 2"},
        {"supporting plane",
         "A plane through an edge of an occluder and a corner of a box, with both on one side; in 2D a line.",
         "CT 2.1"},
        {"separating plane",
         "A plane through an edge of an occluder and a corner of a box, with one on each side; in 2D a line.",
         "CT 2.1"},
        {"satisfied", "Said of such a plane when the eye lies on the occluder's side of it.", "CT 2.1"},
        {"region 1", "Where some separating plane is not satisfied: the occluder hides nothing of the box.",
         "CT fig. 4"},
        {"region 2", "Where all separating planes are satisfied, but not all supporting ones: a part may be hidden.",
         "CT fig. 4"},
        {"region 3", "Where all supporting planes are satisfied: the occluder hides all of the box.", "CT fig. 4"},
        {"TestOcclusion", "What a box is for all occluders that may hide a part of it: VISIBLE, PARTIAL or INVISIBLE.",
         "CT 2.1"},
        {"INVISIBLE", "State of a box that an occluder hides, or several together: it is dropped.", "CT 2.1"},
        {"PARTIAL",
         "State of a box of which an occluder may hide a part: it is opened, or drawn; where none may, it is VISIBLE.",
         "CT 2.1"},
        {"silhouette edge",
         "An edge at which what hides ends, as the eye sees it: one polygon has it, or two that lie on the same side "
         "of it.",
         "CT 2.1"},
        {"connected occluders", "Occluders that share edges; together they may hide what none hides alone.", "CT 2.1"},
        {"area-angle",
         "The area of a polygon, as the eye sees it turned, over its squared distance; in 2D its length over the "
         "distance.",
         "CT 3.3"},
        {"potential occluder", "A polygon whose area-angle at the eye is at least the threshold.", "CT 3.3"},
        {"actual occluder", "One of the k potential occluders with the largest area-angles: these hide.", "CT 3.3"},
        {"approximate", "May miss visible primitives.", "TVCG 1"},
        {"conservative",
         "Never misses a visible primitive, at the resolution stated beside it; a run that its budget cut "
         "short is not conservative.",
         "TVCG 1"},
        {"reference", "What is really visible; methods are measured against it.", "TVCG 3"},
        {"item buffer", "An image that holds the number of the nearest primitive at each pixel.", "TVCG 4.4"},
        {"visible set V", "The primitives that the eye sees.", "TVCG 3"},
        {"T_k", "The primitives that a method renders with budget k.", "TVCG 3"},
        {"coverage ε_k", "The share of the visible primitives that is rendered: |V ∩ T_k| / |V|.", "TVCG 3"},
        {"oracle", "The best coverage that any order could reach with this budget.", "here"},
        {"room", "A convex part of space, closed but at its portals; a scene marks it.", "DAS 3.1.2"},
        {"portal", "An opening between two rooms, or between a room and the outside.", "DAS 3.1.2"},
        {"region", "A box of a grid or a room: eyes in it share a row of the table of techniques.", "DAS fig. 2"},
        {"technique", "A method that a choice by viewpoint can fall on.", "DAS 2"},
        {"entry", "What is known of a region and an interval of directions: what each technique costs.", "DAS fig. 2"},
        {"level of detail", "A coarser shape that is drawn in place of an object.", "DAS 3.1.3"},
        {"cell oracle", "The coverage of whole cells taken in order of decreasing visible share.", "here"},
        {"wrong pixels", "The share of pixels that show a different primitive from the exact image.", "TVCG 3"},
        {"visible share", "The share of what is visible that lies inside a cell, by angle in 2D and by pixels in 3D.",
         "here"},
        {"layering number ζ",
         "One more than the fewest primitives that any ray crosses before it hits this one; 1 means "
         "visible.",
         "TVCG 3"},
        {"inversion", "A hidden, non-empty cell was projected while a visible one waited.", "here"},
        {"mis-ranked", "An inversion whose visible cell was in the front, with a higher key.", "here"},
        {"unreached", "An inversion whose visible cell was not in the front yet.", "here"},
        {"pop", "Of the primitives visible in two frames in a row, the share that only one of them renders.", "here"},
        {"flip", "Share of the pixels that are wrong in only one of two frames.", "here"},
        {"trade-off", "The chart of time against accuracy.", "here"},
        {"Pareto points", "The points of a trade-off that no other beats in both time and accuracy.", "here"},
        {"what-if", "A run with one parameter changed, to see when a cell or a primitive would have been reached.",
         "here"},
        {"substep", "A part of a step: taking the cell, rendering it, looking across each facet.", "here"},
        {"frame", "One view of a flight path.", "TVCG 4"},
        {"lane of frames", "The views before this frame, for methods that use earlier frames.", "here"},
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

TermSpot term_at(std::string_view text, std::size_t at) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    const auto is_letter = [&](std::size_t i) {
        return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_');
    };
    TermSpot best;
    for (const GlossaryEntry& entry : glossary()) {
        const std::size_t size = entry.term.size();
        for (std::size_t first = at + 1 - std::min(at + 1, size + 1); first <= at && first + size <= text.size();
             ++first) {
            bool same = first == 0 || !is_letter(first - 1);
            for (std::size_t i = 0; same && i < size; ++i) same = lower(text[first + i]) == lower(entry.term[i]);
            if (!same) continue;
            const std::size_t count = first + size < text.size() && text[first + size] == 's' ? size + 1 : size;
            if (!is_letter(first + count) && first + count > at && count > best.count) best = {first, count, &entry};
        }
    }
    return best;
}

std::string glossary_markdown() {
    std::string text = "| term | what it means | where it is defined |\n|---|---|---|\n";
    for (const GlossaryEntry& entry : glossary())
        text += "| " + markdown_escaped(entry.term) + " | " + markdown_escaped(entry.sentence) + " | " +
                (entry.source == "here" ? "Sightline" : markdown_escaped(entry.source)) + " |\n";
    return text;
}

}  // namespace sightline
