// What a run says of itself: terms of a key, what a step looked at, lines of code, fields of items, shapes to draw.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/vec.h"
#include "core/raster/tile_grid.h"
#include "core/run/step.h"

namespace sightline {

/// What a finished run can still miss. Of this run, now: one that a budget cut short says `may`.
enum class Misses : std::uint8_t { may, none_at_this_resolution, none };

/// One number that went into a key.
struct Term {
    std::string_view name;  ///< as files have it
    double value = 0;
    std::string words = {};  ///< in place of the number: "yes"; empty where the number says it
};

/// What a part of a key's sum speaks of in the picture.
enum class KeyAbout : std::uint8_t {
    nothing,    ///< signs and results
    content,    ///< of the cell that the key comes from
    angle,      ///< of the facet between the two cells and the ray to it
    handed_on,  ///< the key of the cell that the key comes from
    own,        ///< the cell itself
    star,       ///< the ray from the eye to the cell's centre, which should pass through the facet
    count,
};

/// A piece of a sum: "0.87", the angle.
struct KeyPart {
    std::string text;
    KeyAbout about = KeyAbout::nothing;
    std::string_view name = {};  ///< in a word or two; empty for signs
};

/// A key and where it comes from. Numbers have as many digits as were asked for.
struct KeyExplanation {
    double key = 0;
    bool tested = false;           ///< whether a penalty is due
    bool penalised = false;        ///< it is
    std::vector<KeyPart> parts{};  ///< of the sum
    std::string penalty;           ///< of a penalised key: "× 2 (not star-shaped) = 0.72"
    std::string tip;               ///< what the numbers of the sum are, in one line
    std::string weightiest;        ///< what makes the key as high as it is: "the penalty (+0.36): …"
    std::vector<Term> terms;

    /// "ρ = 0.143 + 0.87 · 0.25 = 0.36"
    std::string sum() const {
        std::string all;
        for (const KeyPart& part : parts) all += part.text;
        return all;
    }
    std::string formula() const { return penalised ? sum() + ", " + penalty : sum(); }
};

/// Why an item stands where it does.
struct Verdict {
    std::string_view reason = {};  ///< one word, for files: "outside-view"
    std::string sentence = {};     ///< without its full stop
    Item about = {};               ///< the item that the sentence speaks of, besides its own

    explicit operator bool() const { return !sentence.empty(); }
};

/// What a step did to a thing that it looked at.
enum class Effect : std::uint8_t { left_alone, changed, kept };

/// One thing that a step looked at.
struct Considered {
    Item from;  ///< what the step popped
    Item item;  ///< of kind none at the border
    Item via;   ///< e.g. the facet
    std::uint8_t rule = 0;
    std::string_view words;  ///< of the rule: "re-enqueued"
    Effect effect = Effect::left_alone;
    Mark before;                        ///< the item's before the step
    std::optional<KeyExplanation> key;  ///< where one was computed
};

/// A line of what a method does.
struct CodeLine {
    std::string text;
    int indent = 0;
    bool lit = false;    ///< where the run stands; exactly one line is
    std::string values;  ///< "cell 12, key 0.25"; empty where the line has none yet
    std::string source;  ///< "TVCG fig. 4, line 3"; empty where it is ours
};

/// Where in its last step a run is shown: between two steps, or at one of the step's substeps.
struct CodePlace {
    const Step* step = nullptr;  ///< the last one; nullptr at the start
    std::uint32_t number = 0;    ///< of the step
    std::span<const Change> changes{};
    std::uint32_t rendered = 0;              ///< primitives that the step rendered
    std::optional<std::uint32_t> substep{};  ///< none: between two steps

    bool in_step() const { return step && substep; }
};

/// A part of the reference's image, of a method that reads images by tiles.
struct ReadTile {
    Tile tile;
    bool read = false;  ///< by the last step that reads; not, where a tile shows nothing any more
};

/// An occluder of a method that chooses some.
struct OccluderFact {
    std::vector<std::uint32_t> primitives;
    double area_angle = 0;  ///< Coorg and Teller 1996, section 3.3
    bool actual = false;    ///< hides something for this eye; not: large enough, but others are larger
};

/// An occluder that was tested against a box.
struct TestedOccluder {
    std::vector<std::uint32_t> primitives;
    std::uint8_t region = 1;  ///< of Coorg and Teller's figure 4a, that the eye lies in: 1, 2 or 3
    bool hides = false;       ///< the box, alone or with the others that do
    bool handed_on = false;   ///< to the boxes in it: it may hide a part
};

/// From where an occluder is large enough to be one.
template <int D>
struct OccluderRegion {
    std::vector<std::vector<Vec<D>>> outlines;  ///< closed; 3D: of sections through its normal
    Box<D> box;                                 ///< around all of it
};

/// What a plane asks of the eye: supporting, the eye and the box lie so that this edge lets nothing of the box be seen;
/// separating, that it may hide a part; own: the box lies beyond the occluder's plane.
enum class PlaneKind : std::uint8_t { own, supporting, separating };
inline constexpr auto plane_kind_words = std::to_array<std::string_view>({"own", "supporting", "separating"});

/// A plane (2D: a line) between an occluder and a box, and what it says of the eye (Coorg and Teller, figure 4a).
template <int D>
struct TestedPlane {
    PlaneKind kind = PlaneKind::own;
    std::uint32_t edge = 0;          ///< of the occluder, from 0; of its own plane: which of them
    std::array<Vec<D>, D> points{};  ///< 3D: the edge, then the corner of the box; 2D: end point and corner; own: of it
    bool satisfied = false;
    double distance = 0;  ///< of the eye; positive where it is satisfied. own: of the box's nearest corner
};

/// A technique that a method by viewpoint may choose, and what it is expected to cost here.
struct TechniqueFact {
    std::string name;  ///< as a variant is written
    double cull_ms = 0, draw_ms = 0;
    double drawn = 0;  ///< primitives
    double ms() const { return cull_ms + draw_ms; }
};

/// One decision on the way to a technique, and what the frame would cost after it.
struct Decision {
    std::string sentence;
    double ms = 0;
};

/// A region of eyes, and what is chosen in it for the directions of the eye at hand.
template <int D>
struct RegionFact {
    Box<D> box;                      ///< of a room: around it
    std::uint32_t technique = none;  ///< none: not worked out so far
    bool room = false;
};

/// An interval of directions, and what is chosen in it in the region of the eye at hand.
struct DirectionFact {
    std::array<double, 2> azimuth{}, elevation{};  ///< degrees: from and to
    std::uint32_t technique = none;                ///< none: not worked out so far
};

/// What a method that chooses by viewpoint knows of where the eye stands and looks.
template <int D>
struct ViewpointFact {
    std::string region, interval;  ///< in words
    std::vector<TechniqueFact> techniques;
    std::uint32_t chosen = none;  ///< by the entry
    std::uint32_t done = none;    ///< what the run does: the one before, where changing does not pay
    std::vector<Decision> decisions;
    std::vector<RegionFact<D>> map;
    std::vector<DirectionFact> rose;
    std::uint32_t region_here = none, interval_here = none;  ///< places in map and rose
    std::vector<std::uint32_t> occluders;                    ///< primitives: candidates of the entry
    std::size_t known = 0, entries = 0;                      ///< of the table
};

}  // namespace sightline
