// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/pixel_history.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/geometry/hit_triangle.h"

namespace sightline {

namespace {

/// The recorded step that renders each primitive; 0: none does.
std::vector<std::uint32_t> steps_of_rendering(const Session<3>& session) {
    const Session<3> end = copy_at(session, session.recorded());
    std::vector<std::uint32_t> steps(session.scene().primitives.size());
    for (std::uint32_t step = 1; step <= end.position(); ++step)
        for_rendered(end.timeline().met_in(step, end.met()), [&](std::uint32_t p) { steps[p] = step; });
    return steps;
}

}  // namespace

PixelHistory pixel_history(const Session<3>& session, int x, int y) {
    const IdImage& image = session.reference().image;
    if (x < 0 || y < 0 || x >= image.width || y >= image.height)
        throw InputError("there is no pixel " + std::to_string(x) + "," + std::to_string(y) + ": the image has " +
                         std::to_string(image.width) + " x " + std::to_string(image.height));
    PixelHistory history{x, y, image.at(x, y), none, {}};
    const Problem<3>& problem = session.problem();
    const Vec<3> eye = problem.view.eye, along = pixel_centre(problem.view, {image.width, image.height}, x, y) - eye;
    const double length = std::sqrt(glm::dot(along, along));
    const std::vector<std::uint32_t> steps = steps_of_rendering(session);
    for (std::uint32_t p = 0; p < problem.primitives().size(); ++p) {
        const auto& [a, b, c] = problem.primitives()[p];
        const auto t = hit_triangle(eye, along, a, b, c);
        if (t && turns_a_seen_side(problem, p)) history.layers.push_back({p, *t * length, steps[p]});
    }
    std::stable_sort(history.layers.begin(), history.layers.end(),
                     [](const PixelLayer& a, const PixelLayer& b) { return a.distance < b.distance; });
    // At an edge the image's rule may give the pixel to a triangle that the ray just misses, or just hits.
    const auto owner = std::find_if(history.layers.begin(), history.layers.end(),
                                    [&](const PixelLayer& layer) { return layer.primitive == history.should_own; });
    if (owner != history.layers.end())
        std::rotate(history.layers.begin(), owner, owner + 1);
    else if (history.should_own != none)
        history.layers.insert(history.layers.begin(),
                              {history.should_own, history.layers.empty() ? 0 : history.layers.front().distance,
                               steps[history.should_own]});
    for (const PixelLayer& layer : history.layers)
        if (history.owns == none && layer.met_at > 0 && layer.met_at <= session.position())
            history.owns = layer.primitive;
    const auto distance = [&](std::uint32_t primitive) {
        const auto layer = std::find_if(history.layers.begin(), history.layers.end(),
                                        [&](const PixelLayer& each) { return each.primitive == primitive; });
        return layer == history.layers.end() ? -1 : layer->distance;
    };
    const double should = distance(history.should_own), is = distance(history.owns);
    history.tie = history.should_own != history.owns && should > 0 && is > 0 &&
                  std::abs(should - is) <= 0x1p-20 * std::max(should, is);
    return history;
}

}  // namespace sightline
