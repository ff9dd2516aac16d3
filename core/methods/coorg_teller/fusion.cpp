// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/coorg_teller/fusion.h"

#include <algorithm>

namespace sightline {

namespace {

/// Which way the eye turns from p to q, left +1; and how far it is from where it would turn the other way: from the
/// line through both.
class Turns {
public:
    Turns(const Vec<2>& eye, double& slack) : eye_(eye), slack_(slack) {}
    int operator()(const Vec<2>& p, const Vec<2>& q) {
        const int turn = orient(eye_, p, q);
        if (p == q) return turn;  // 0, wherever the eye is
        const Vec<2> u = p - eye_, v = q - eye_, between = q - p;
        const double sure = std::abs(cross(u, v)) - 0x1p-48 * (std::abs(u.x * v.y) + std::abs(u.y * v.x));
        slack_ = std::min(slack_, sure > 0 ? sure / std::sqrt(glm::dot(between, between)) : 0);
        return turn;
    }

private:
    const Vec<2>& eye_;
    double& slack_;
};

}  // namespace

std::vector<std::uint32_t> fused_set(std::span<const Shadow<2>> shadows, std::span<const Partial> partial,
                                     std::span<const Vec<2>> corners, const Vec<2>& eye, double& slack) {
    Turns turns(eye, slack);
    Vec<2> right = corners[0], left = corners[0];  // of the box, as the eye sees it
    for (const Vec<2>& corner : corners) {
        if (turns(right, corner) < 0) right = corner;
        if (turns(left, corner) > 0) left = corner;
    }
    // With the eye inside there is no such corner.
    const bool is_outside = std::all_of(corners.begin(), corners.end(), [&](const Vec<2>& corner) {
        return turns(right, corner) >= 0 && turns(corner, left) >= 0;
    });
    if (!is_outside || (turns(right, left) == 0 && glm::dot(right - eye, left - eye) <= 0)) {
        slack = 0;
        return {};
    }
    struct Ends {
        Vec<2> right, left;
        std::uint32_t index;
    };
    std::vector<Ends> ends;
    for (std::uint32_t i = 0; i < partial.size(); ++i) {
        if (!partial[i].beyond) continue;
        const auto& sides = shadows[partial[i].shadow].sides;
        if (sides.size() != 2) continue;
        const bool first_is_left = sides[0].reversed;
        ends.push_back({sides[first_is_left ? 1 : 0].a, sides[first_is_left ? 0 : 1].a, i});
    }
    std::vector<std::uint32_t> chain;
    Vec<2> reached = right;
    const auto holds = [&](const Ends& e, const Vec<2>& p) { return turns(e.right, p) >= 0 && turns(p, e.left) >= 0; };
    while (true) {
        const Ends* best = nullptr;
        for (const Ends& e : ends)
            if (holds(e, reached) && (!best || turns(best->left, e.left) > 0)) best = &e;
        if (!best || turns(reached, best->left) <= 0) {
            // Nothing goes on from here: all is covered where the box is seen as one ray.
            if (best && turns(reached, left) == 0) {
                chain.push_back(best->index);
                return chain;
            }
            return {};
        }
        chain.push_back(best->index);
        if (turns(reached, left) >= 0 && turns(left, best->left) >= 0) return chain;
        reached = best->left;
    }
}

}  // namespace sightline
