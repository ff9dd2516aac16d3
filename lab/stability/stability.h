// How much the rendered set changes for what should not matter.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/truth/id_image.h"
#include "lab/measure/lab_scene.h"
#include "lab/measure/results.h"

namespace sightline::lab {

/// What is done to a scene or its view before the method runs again.
enum class Disturbance : std::uint8_t {
    eye,      ///< eye and look-at moved by `amount` of the scene's longest side, in a random direction
    shuffle,  ///< primitives in another order
    scale,    ///< everything times `amount`
    offset,   ///< everything moved by `amount` along each axis
    jitter,   ///< another seed of the tessellation's jitter
    grazing,  ///< the eye `amount` degrees off the plane of the largest visible primitive; neighbours are compared
};
inline constexpr auto disturbance_words =
    std::to_array<std::string_view>({"eye", "shuffle", "scale", "offset", "jitter", "grazing"});

/// Like "2^-20", "0.1" or "1e-09".
std::string amount_text(double amount);

/// One disturbance of one amount, over frames and repetitions.
struct StabilityRow {
    std::string scene, path;
    MethodChoice method;
    std::string budget;
    Disturbance disturbance = Disturbance::eye;
    double amount = 0;
    std::size_t samples = 0;
    double jaccard = 1, jaccard_min = 1;  ///< of the rendered sets, undisturbed and disturbed: mean and least
    double coverage_change = 0;           ///< mean of |coverage - coverage'|; eye and grazing: each against its own V
    double coverage_spread = 0;           ///< standard deviation of coverage over the samples
    double visible_jaccard = 1;           ///< of the exact sets: what explains a change; 1 where V is the same
    bool equal = true;                    ///< the same primitives in the same order in every sample
    std::size_t not_finite = 0;           ///< keys that are NaN or infinite, in all samples
    std::vector<double> sweep{};          ///< grazing: coverage at each view, `amount` degrees apart, up to 1°
};

struct StabilityOptions {
    std::uint32_t repeats = 4;  ///< random directions, orders and seeds
    std::uint32_t frames = 2;   ///< of the path, spread evenly
    std::uint64_t seed = 1;
};

/// The rows of one disturbance of one amount, one per method and budget.
struct StabilityStage {
    std::string name;  ///< e.g. "eye moved by 1e-05"
    double share = 0;  ///< of the work on this scene and path
    std::vector<StabilityRow> rows;
};

/// What keeps finished stages and hears of them; each may be empty.
struct StabilityWatch {
    /// The rows of a stage that an earlier run finished.
    std::function<std::optional<std::vector<StabilityRow>>(const std::string& stage)> finished{};
    /// After each stage; false stops.
    std::function<bool(const StabilityStage& stage)> stage_done{};
};

/// Rows by method, disturbance and amount; those of finished stages where it was stopped. 2D and 3D; a primitive keeps
/// its identity through every disturbance. A stage does not depend on which others ran.
template <int D>
std::vector<StabilityRow> measure_stability(const LabScene<D>& lab, const Study& study, const StabilityOptions& options,
                                            const DrawIds& draw_ids, const StabilityWatch& watch = {});

}  // namespace sightline::lab
