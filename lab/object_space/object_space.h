// The four tables of Coorg and Teller (1996), measured on scenes of ours, and what a frame costs beside view culling.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/measure/frame_clock.h"
#include "core/methods/method_table.h"
#include "core/truth/id_image.h"

namespace sightline::lab {

/// A scene of one seed; times of everything below are milliseconds.
struct SeededScene {
    std::string name;
    std::uint64_t seed = 0;
    std::shared_ptr<const Scene<3>> scene;
};

/// What is made before the first frame (table 1), each time the median of the repeats.
struct Construction {
    std::string tree;
    std::size_t primitives = 0, polygons = 0, references = 0, boxes = 0;
    double polygons_ms = 0, tree_ms = 0, regions_ms = 0, first_frame_ms = 0;
};

/// What a frame costs, the mean over the frames of a path; times: of each frame's median.
struct WalkCost {
    std::size_t frames = 0;
    double occluders_ms = 0;  ///< choosing occluders, making their shadows, emptying what the last frame left
    double visible_ms = 0;    ///< down the tree; with listing what is drawn
    double occluders = 0;     ///< potential ones, at most as many as the method has
    double boxes = 0, kept = 0, tested = 0, products = 0, changed = 0, drawn = 0;

    double cull_ms() const { return occluders_ms + visible_ms; }
    /// Boxes tested per occluder ("Rel").
    double tested_each() const { return occluders > 0 ? tested / occluders : 0; }
};

/// What an all-round view misses of the exact visible set of six item buffers; summed over the frames.
struct Culled {
    std::size_t invisible = 0;      ///< polygons of which no pixel is seen
    std::size_t culled = 0;         ///< of those, by occluders: with their boxes, or alone (leaves=polygons)
    std::size_t not_drawn = 0;      ///< of those, not drawn: the back faces in the drawn boxes as well
    std::size_t facing = 0;         ///< invisible ones that turn a side to the eye that is seen
    std::size_t culled_facing = 0;  ///< of those, not drawn
    std::size_t invisible_primitives = 0, culled_primitives = 0;
    std::size_t missed = 0;         ///< primitives that are seen and were not drawn; must be 0
    std::size_t missed_pixels = 0;  ///< of the six images

    void operator+=(const Culled& other);
    double share() const { return share_of(culled, invisible); }
    double not_drawn_share() const { return share_of(not_drawn, invisible); }
    double facing_share() const { return share_of(culled_facing, facing); }
    double primitive_share() const { return share_of(culled_primitives, invisible_primitives); }

private:
    static double share_of(std::size_t part, std::size_t all);
};

/// Table 2: a method along a path, seen all round.
struct AllRound {
    std::string method;
    WalkCost cost;
    Culled culled;
};

/// Table 3: one speed.
struct AtSpeed {
    std::uint32_t speed = 1;  ///< every so many frames of the path
    WalkCost keeping, fresh;  ///< coherence=on and off
};

/// Table 4: so many threads, with nothing kept.
struct WithWorkers {
    int workers = 1;
    WalkCost cost;
};

/// A frame in a view as people have it, drawn.
struct InView {
    std::string method;
    WalkCost cost;
    double draw_ms = 0;  ///< with upload; 0: there was no OpenGL
    WalkCost all_round;  ///< the same where nothing is switched off
};

struct ObjectSpaceOptions {
    MethodTables tables{};
    std::string walk = "walk", line = "line";
    std::size_t frames = 0;  ///< of the walk, spread evenly for what is exact; 0: all
    int repeats = 3;
    ImageSize face{512, 512};  ///< of each of the six item buffers
    ImageSize image{1024, 768};
    std::vector<std::uint32_t> speeds{1, 2, 4, 8, 16};
    std::vector<int> workers{1, 2, 4};
    std::string parallel = "coorg-teller occluder_count=128 coherence=off";
};

Construction measure_construction(const SeededScene& scene, const std::string& tree, const ObjectSpaceOptions&);

/// Methods that cull in object space, side by side: each frame is timed with all of them before the next.
std::vector<AllRound> measure_all_round(const SeededScene& scene, const std::vector<std::string>& methods,
                                        const DrawIds& draw_ids, const ObjectSpaceOptions& options);

std::vector<AtSpeed> measure_speeds(const SeededScene& scene, const std::string& method,
                                    const ObjectSpaceOptions& options);

std::vector<WithWorkers> measure_workers(const SeededScene& scene, const ObjectSpaceOptions& options);

/// The first method is what others are held against; any method may stand here.
std::vector<InView> measure_in_view(const SeededScene& scene, const std::vector<std::string>& methods,
                                    const TimeDrawing& time_drawing, const ObjectSpaceOptions& options);

}  // namespace sightline::lab
