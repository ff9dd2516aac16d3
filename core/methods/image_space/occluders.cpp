// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/image_space/occluders.h"

#include <algorithm>
#include <cmath>

namespace sightline {

namespace {

/// How much of the view a primitive takes, roughly: an angle in 2D, a solid angle in 3D; both up to a factor.
double area_angle(const Vec<2>& eye, const Primitive<2>& segment) {
    const Vec<2> along = segment[1] - segment[0], to = (segment[0] + segment[1]) * 0.5 - eye;
    const double squared = glm::dot(to, to);
    return std::abs(cross(along, to)) / squared;
}
double area_angle(const Vec<3>& eye, const Primitive<3>& triangle) {
    const Vec<3> area = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const Vec<3> to = (triangle[0] + triangle[1] + triangle[2]) / 3.0 - eye;
    const double squared = glm::dot(to, to);
    return std::abs(glm::dot(area, to)) / (squared * std::sqrt(squared));
}

template <int D>
std::vector<std::uint32_t> largest(const Problem<D>& problem, std::size_t count) {
    std::vector<std::pair<double, std::uint32_t>> sizes;
    for (std::uint32_t id = 0; id < problem.primitives().size(); ++id) {
        if (!shows(problem, id)) continue;
        const double size = area_angle(problem.view.eye, problem.primitives()[id]);
        if (std::isfinite(size)) sizes.emplace_back(-size, id);
    }
    count = std::min(count, sizes.size());
    std::partial_sort(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(count), sizes.end());
    std::vector<std::uint32_t> ids;
    for (std::size_t i = 0; i < count; ++i) ids.push_back(sizes[i].second);
    return ids;
}

}  // namespace

template <int D>
std::vector<std::uint32_t> occluders(const Problem<D>& problem, Occluders which,
                                     const std::function<std::unique_ptr<Run<D>>(const Problem<D>&)>& picker) {
    const double share = problem.parameters.number(occluder_share_row());
    const auto count = static_cast<std::uint32_t>(std::ceil(share * static_cast<double>(problem.primitives().size())));
    if (which == Occluders::largest) return largest(problem, count);
    std::vector<std::uint32_t> ids;
    if (which == Occluders::plp) {
        Problem<D> first = problem;
        first.budget = count;
        const std::unique_ptr<Run<D>> run = picker(first);
        run->run(none);
        rendered_ids(run->met(), ids);
    }
    if (which == Occluders::previous && problem.history)
        for (std::uint32_t id = 0; id < problem.history->visible.size(); ++id)
            if (problem.history->visible[id] && shows(problem, id)) ids.push_back(id);
    return ids;
}

#define SIGHTLINE_INSTANTIATE(D)                      \
    template std::vector<std::uint32_t> occluders<D>( \
        const Problem<D>&, Occluders, const std::function<std::unique_ptr<Run<D>>(const Problem<D>&)>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
