// Visibility in 2D by looking in every elementary interval of directions, in exact arithmetic: slow and obvious.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/truth/visible_set.h"

namespace sightline::brute {

struct Result {
    std::vector<std::uint8_t> visible;
    std::vector<VisiblePiece> pieces;
    std::vector<std::uint32_t> layers;
    std::vector<std::optional<std::set<std::uint32_t>>> in_front;  ///< those that are in all directions that hit it
    std::size_t eye_on = 0;
};

template <typename T>
struct Vector {
    T x, y;
};

template <typename T>
T cross(const Vector<T>& a, const Vector<T>& b) {
    return a.x * b.y - a.y * b.x;
}

inline double to_double(__int128 value) { return static_cast<double>(value); }
inline double to_double(const CGAL::Exact_rational& value) { return CGAL::to_double(value); }

/// For T = __int128 coordinates are integers, at most 2^17 from the eye.
template <typename T>
Vector<T> relative(const Vec<2>& p, const Vec<2>& eye) {
    return {T(p.x) - T(eye.x), T(p.y) - T(eye.y)};
}

template <typename T>
struct Item {
    Vector<T> right, left;
    std::uint32_t id;
};

/// Directions between which nothing changes, in counter-clockwise order from the right border or +x. The last one is
/// the left border, or +x again.
template <typename T>
std::vector<Vector<T>> critical_directions(const std::vector<Item<T>>& items, const View<2>& view) {
    std::vector<Vector<T>> all{{T(1), T(0)}, {T(0), T(1)}, {T(-1), T(0)}, {T(0), T(-1)}};
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto& [a, b, id] = items[i];
        all.push_back(a);
        all.push_back(b);
        for (std::size_t j = 0; j < i; ++j) {
            const auto& [c, d, other] = items[j];
            const Vector<T> line{d.x - c.x, d.y - c.y};
            T weight_b = cross(line, {a.x - c.x, a.y - c.y}), weight_a = -cross(line, {b.x - c.x, b.y - c.y});
            if (weight_a + weight_b < 0) weight_a = -weight_a, weight_b = -weight_b;
            if (weight_a < 0 || weight_b < 0) continue;  // the line cd does not meet the segment ab
            const Vector<T> meet{a.x * weight_a + b.x * weight_b, a.y * weight_a + b.y * weight_b};
            if (meet.x != 0 || meet.y != 0) all.push_back(meet);
        }
    }
    Vector<T> right{T(1), T(0)}, left = right;
    if (!view.all_round) {
        right = relative<T>(view.corners[0], view.eye);
        left = relative<T>(view.corners[1], view.eye);
        all.push_back(right);
        all.push_back(left);
    }
    // Half turn counted from the right border: 0 for [0, 180), 1 for the rest.
    const auto half = [&](const Vector<T>& d) {
        const T side = cross(right, d);
        return side > 0 || (side == 0 && right.x * d.x + right.y * d.y > 0) ? 0 : 1;
    };
    const auto before = [&](const Vector<T>& d, const Vector<T>& e) {
        return half(d) != half(e) ? half(d) < half(e) : cross(d, e) > 0;
    };
    std::sort(all.begin(), all.end(), before);
    const auto same = [&](const Vector<T>& d, const Vector<T>& e) { return !before(d, e) && !before(e, d); };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    if (view.all_round)
        all.push_back(right);
    else
        all.erase(std::upper_bound(all.begin(), all.end(), left, before), all.end());
    return all;
}

template <typename T>
Result visibility(const std::vector<Primitive<2>>& primitives, const View<2>& view) {
    std::vector<Item<T>> items;
    Result result;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        Item<T> item{relative<T>(primitives[i][0], view.eye), relative<T>(primitives[i][1], view.eye),
                     static_cast<std::uint32_t>(i)};
        const T side = cross(item.right, item.left);
        if (side < 0) std::swap(item.right, item.left);
        if (side != 0) items.push_back(item);
        const T dot = item.right.x * item.left.x + item.right.y * item.left.y;
        if (side == 0 && dot <= 0 && primitives[i][0] != primitives[i][1]) ++result.eye_on;
    }
    result.visible.assign(primitives.size(), 0);
    result.layers.assign(primitives.size(), 0);
    result.in_front.resize(primitives.size());
    const std::vector<Vector<T>> directions = critical_directions(items, view);
    struct Hit {
        T above, below;  // distance along the ray, above / below
        const Item<T>* item;
    };
    std::vector<Hit> hits;
    const auto point = [&](const Item<T>& item, const Vector<T>& d) {
        const Vector<T> whole{item.left.x - item.right.x, item.left.y - item.right.y};
        const double distance = to_double(cross(item.right, item.left)) / to_double(cross(d, whole));
        return view.eye + Vec<2>(distance * to_double(d.x), distance * to_double(d.y));
    };
    std::uint32_t last = none;
    for (std::size_t k = 0; k + 1 < directions.size(); ++k) {
        // Neighbours are at most 90 degrees apart, so that their sum lies between them.
        const Vector<T> ray{directions[k].x + directions[k + 1].x, directions[k].y + directions[k + 1].y};
        hits.clear();
        for (const Item<T>& item : items)
            if (cross(item.right, ray) > 0 && cross(ray, item.left) > 0)
                hits.push_back({cross(item.right, item.left),
                                cross(ray, {item.left.x - item.right.x, item.left.y - item.right.y}), &item});
        std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
            const T left = a.above * b.below, right = b.above * a.below;
            return left != right ? left < right : a.item->id < b.item->id;
        });
        std::set<std::uint32_t> nearer;
        for (std::uint32_t rank = 1; rank <= hits.size(); ++rank) {
            auto& in_front = result.in_front[hits[rank - 1].item->id];
            if (!in_front) in_front = nearer;
            std::erase_if(*in_front, [&](std::uint32_t id) { return !nearer.contains(id); });
            nearer.insert(hits[rank - 1].item->id);
            std::uint32_t& layer = result.layers[hits[rank - 1].item->id];
            if (layer == 0 || rank < layer) layer = rank;
        }
        const std::uint32_t owner = hits.empty() ? none : hits[0].item->id;
        if (owner != none) {
            result.visible[owner] = 1;
            const Item<T>& item = *hits[0].item;
            if (owner != last) result.pieces.push_back({owner, point(item, directions[k]), {}});
            result.pieces.back().to = point(item, directions[k + 1]);
        }
        last = owner;
    }
    return result;
}

}  // namespace sightline::brute
