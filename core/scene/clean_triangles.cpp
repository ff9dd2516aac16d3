// Cleaning of triangle soups: made for tens of millions of triangles.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>

#include "core/base/float_value.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/geometry/predicates.h"
#include "core/scene/clean.h"

namespace sightline {

namespace {

using Triangles = std::vector<Primitive<3>>;

constexpr std::string_view step = "cleaning the triangles";
constexpr std::size_t block = std::size_t{1} << 18;  ///< triangles between two words of progress

bool all_finite(const Primitive<3>& t) { return is_finite(t[0]) && is_finite(t[1]) && is_finite(t[2]); }

/// To a normal float; no -0.
double rounded(double value) { return std::abs(value) < 0x1p-126 ? 0 : float_value(value); }

/// Exactly collinear, or worse: collinear in all three axis projections.
bool is_degenerate(const Primitive<3>& t) {
    // The cross product's terms with the error bound of orient(); most triangles pass at once.
    const Vec<3> u = t[1] - t[0], v = t[2] - t[0];
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const double left = u[i] * v[j], right = u[j] * v[i];
        const double size = std::abs(left) + std::abs(right);
        if (size > 1e-280 && std::abs(left - right) > 4e-16 * size) return false;
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (orient(Vec<2>(t[0][i], t[0][j]), Vec<2>(t[1][i], t[1][j]), Vec<2>(t[2][i], t[2][j])) != 0) return false;
    }
    return true;
}

/// The same for the same corners in the same cyclic order.
std::uint64_t cyclic_hash(const Primitive<3>& t) {
    std::uint64_t sum = 0;
    std::array<std::uint64_t, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
        Hash hash;
        for (int i = 0; i < 3; ++i) hash.add(t[k][i]);
        corner[k] = hash.value();
    }
    for (std::size_t k = 0; k < 3; ++k) {  // the ordered pairs tell the two windings apart
        Hash hash;
        hash.add(corner[k]);
        hash.add(corner[(k + 1) % 3]);
        sum += hash.value();
    }
    return sum;
}

bool same_cycle(const Primitive<3>& a, const Primitive<3>& b) {
    for (std::size_t k = 0; k < 3; ++k)
        if (a[0] == b[k] && a[1] == b[(k + 1) % 3] && a[2] == b[(k + 2) % 3]) return true;
    return false;
}

Box<3> finite_bounds(const Triangles& triangles, const std::string& name, const Progress& progress) {
    Box<3> box;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        if (k % block == 0)
            report(progress, step, 0.2 * static_cast<double>(k) / static_cast<double>(triangles.size()));
        if (!all_finite(triangles[k])) continue;
        for (const Vec<3>& v : triangles[k]) {
            for (int i = 0; i < 3; ++i)
                if (std::abs(v[i]) > largest_triangle_coordinate)
                    throw input_error(name, "triangle " + std::to_string(k),
                                      "coordinate " + number_text(v[i]) + " is too large (limit 1e18)");
            box.add(v);
        }
    }
    return box;
}

/// Moves and rounds every triangle and drops those that have no area.
void round_all(Scene<3>& scene, const Vec<3>& shift, const Progress& progress) {
    Triangles& triangles = scene.primitives;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        if (k % block == 0)
            report(progress, step, 0.2 + 0.3 * static_cast<double>(k) / static_cast<double>(triangles.size()));
        if (!all_finite(triangles[k])) {
            ++scene.dropped.not_finite;
            continue;
        }
        Primitive<3> t;
        for (std::size_t c = 0; c < 3; ++c)
            for (int i = 0; i < 3; ++i) t[c][i] = rounded(triangles[k][c][i] - shift[i]);
        if (is_degenerate(t)) {
            ++scene.dropped.degenerate;
            continue;
        }
        copy_facts(scene, k, scene, kept);
        triangles[kept++] = t;
    }
    resize_primitives(scene, kept);
}

/// Open addressing: a slot holds half of a hash and one more than the index of a triangle that stays; 0 is free.
class Seen {
public:
    explicit Seen(std::size_t triangles) {
        std::size_t size = 16;
        while (size * 3 < triangles * 4) size *= 2;
        slots_.resize(size);
    }
    void prefetch(std::uint64_t hash) const { __builtin_prefetch(&slots_[home(hash)]); }

    /// The earlier triangle that equals `t`, or `index`, which then counts as seen.
    std::size_t find_or_add(std::uint64_t hash, const Primitive<3>& t, std::size_t index, const Triangles& kept) {
        const auto half = static_cast<std::uint32_t>(hash >> 32);
        for (std::size_t at = home(hash);; at = (at + 1) % slots_.size()) {
            Slot& slot = slots_[at];
            if (slot.index == 0) {
                slot = {half, static_cast<std::uint32_t>(index + 1)};
                return index;
            }
            if (slot.half == half && same_cycle(t, kept[slot.index - 1])) return slot.index - 1;
        }
    }

private:
    struct Slot {
        std::uint32_t half = 0, index = 0;
    };
    std::size_t home(std::uint64_t hash) const { return hash & (slots_.size() - 1); }
    std::vector<Slot> slots_;
};

void drop_duplicates(Scene<3>& scene, const Progress& progress) {
    Triangles& triangles = scene.primitives;
    Seen seen(triangles.size());
    constexpr std::size_t ahead = 16;  // slots are fetched that early: the table is larger than any cache
    std::array<std::uint64_t, ahead> hashes{};
    std::size_t kept = 0;
    for (std::size_t k = 0; k < triangles.size() + ahead; ++k) {
        if (k % block == 0)
            report(progress, step, 0.5 + 0.5 * static_cast<double>(k) / static_cast<double>(triangles.size() + ahead));
        if (k >= ahead) {
            const std::size_t from = k - ahead;
            const Primitive<3> t = triangles[from];
            const std::size_t same = seen.find_or_add(hashes[from % ahead], t, kept, triangles);
            if (same != kept) {
                ++scene.dropped.duplicate;
                if (!scene.two_sided.empty()) scene.two_sided[same] |= scene.two_sided[from];
            } else {
                copy_facts(scene, from, scene, kept);
                triangles[kept++] = t;
            }
        }
        if (k < triangles.size()) {
            hashes[k % ahead] = cyclic_hash(triangles[k]);
            seen.prefetch(hashes[k % ahead]);
        }
    }
    resize_primitives(scene, kept);
}

}  // namespace

void clean(Scene<3>& scene, Recentre recentre, const std::string& name, const Progress& progress) {
    if (scene.primitives.size() >= 0xffffffffu)
        throw input_error(name, "", std::to_string(scene.primitives.size()) + " triangles are too many (limit 4e9)");
    const Box<3> box = finite_bounds(scene.primitives, name, progress);
    const double side = box.longest_side();
    Vec<3> shift{};
    if (recentre == Recentre::yes && !box.empty())
        for (int i = 0; i < 3; ++i) shift[i] = origin_for(box.centre()[i], side);
    round_all(scene, shift, progress);
    drop_duplicates(scene, progress);
    const bool any = std::find(scene.two_sided.begin(), scene.two_sided.end(), 1) != scene.two_sided.end();
    if (!any) scene.two_sided = {};
    tidy(scene.objects);
    report(progress, step, 1);
    if (scene.primitives.empty()) {
        scene.warnings.push_back("the scene is empty: 0 primitives");
        return;
    }
    const double rounded_side = bounds<3>(scene.primitives).longest_side();
    if (rounded_side < 1 / largest_triangle_coordinate)
        throw input_error(name, "",
                          "the scene is " + number_text(rounded_side) + " units wide, too small (limit 1e-18)");
    scene.origin += shift;
    if (scene.start_view) {
        scene.start_view->eye -= shift;
        scene.start_view->look_at -= shift;
    }
    for (FlightPath<3>& path : scene.paths)
        for (ViewSpec<3>& view : path.frames) {
            view.eye -= shift;
            view.look_at -= shift;
        }
}

}  // namespace sightline
