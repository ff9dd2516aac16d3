// Looks at a scene from a region into an interval of directions: what each technique would cost there (DAS 3.1).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/methods/by_viewpoint/choice.h"
#include "core/methods/by_viewpoint/directions.h"
#include "core/methods/by_viewpoint/regions.h"
#include "core/run/drawing_cost.h"
#include "core/run/method.h"
#include "core/scene/ray_tree.h"

namespace sightline {

/// All that entries depend on. Scene and cells outlive it.
template <int D>
struct ViewpointProblem {
    const Scene<D>* scene = nullptr;
    const CellComplex<D>* cells = nullptr;
    ImageSize image;        ///< of depth images, and the aspect of views
    double fov = 60;        ///< of all views, as ViewSpec has it
    Parameters parameters;  ///< of by-viewpoint and of the techniques
    std::vector<Variant<D>> options;
    std::vector<CullTime> cull_times;  ///< of the options
    ChoiceSettings choice;
    RuleTechniques by_rule;
    DrawingCost cost;
    CostReading reading = CostReading::max_of_sums;
    std::uint32_t samples = 1;
    Regions<D> regions;
    Directions<D> directions;
    std::vector<std::uint32_t> leaf_of;  ///< per primitive: the node of the box tree that holds it
    std::optional<RayTree> rays{};       ///< 3D: to find out whether an eye stands inside of something
};

/// Owns the memory of runs: one a thread.
template <int D>
class Analyst {
public:
    explicit Analyst(const ViewpointProblem<D>& problem) : problem_(&problem), runs_(problem.options.size()) {}

    /// The views of an entry: random places of the region and directions of the interval, the same ones always, since
    /// the centre alone misses much. Eyes that would stand inside of something are moved, a few times.
    std::vector<ViewSpec<D>> views(std::uint32_t region, std::uint32_t interval) const;
    /// What the technique costs in one view, predicted from its steps and from what it draws.
    OptionCost cost(std::uint32_t option, const View<D>& view);
    /// The means over the views, and the occluders that the views have.
    EntryFacts facts(std::uint32_t region, std::uint32_t interval);

    /// What a run draws, as the cost model takes it apart: of each leaf of the box tree what is drawn of it, with the
    /// pixels of its box, and each level that stands in, with those of its object's.
    const std::vector<DrawnSize>& drawn_sizes(const Run<D>& run, const View<D>& view);

private:
    const ViewpointProblem<D>* problem_;
    std::vector<OwnRun<D>> runs_;
    std::vector<std::uint32_t> drawn_of_;  ///< scratch, per node: primitives drawn of it
    std::vector<std::uint32_t> leaves_;    ///< scratch: those that are not 0
    std::vector<DrawnSize> sizes_;
};

extern template class Analyst<2>;
extern template class Analyst<3>;

}  // namespace sightline
