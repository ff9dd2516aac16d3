// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/clean.h"

#include <cmath>
#include <unordered_set>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text.h"

namespace sightline {

namespace {

bool less(const Vec<2>& a, const Vec<2>& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// The same points in one order, with one zero: equal for segments that cover the same set.
Primitive<2> unordered(Primitive<2> p) {
    for (Vec<2>& v : p) v += 0.0;  // -0 becomes +0
    std::sort(p.begin(), p.end(), less);
    return p;
}

struct HashPoints {
    std::size_t operator()(const Primitive<2>& p) const {
        Hash hash;
        for (const Vec<2>& v : p)
            for (int i = 0; i < 2; ++i) hash.add(v[i]);
        return hash.value();
    }
};

}  // namespace

double origin_for(double centre, double longest_side) {
    if (std::abs(centre) <= 4 * longest_side) return 0;
    int exponent = 0;
    std::frexp(longest_side, &exponent);
    const double quantum = std::ldexp(1.0, exponent - 1);
    const double steps = centre / quantum;
    // From 2^52 steps on every double is a whole number of steps.
    return std::abs(steps) < 0x1p52 ? std::floor(steps + 0.5) * quantum : centre;
}

void clean(Scene<2>& scene, Recentre recentre, const std::string& name) {
    std::unordered_set<Primitive<2>, HashPoints> seen;
    seen.reserve(scene.primitives.size());
    std::size_t kept = 0;
    for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
        const Primitive<2> p = scene.primitives[k];
        if (!is_finite(p[0]) || !is_finite(p[1])) {
            ++scene.dropped.not_finite;
            continue;
        }
        for (const Vec<2>& v : p)
            for (int i = 0; i < 2; ++i)
                if (std::abs(v[i]) > largest_coordinate)
                    throw input_error(name, "segment " + std::to_string(k),
                                      "coordinate " + number_text(v[i]) + " is too large (limit 1e150)");
        if (p[0] == p[1]) {
            ++scene.dropped.degenerate;
            continue;
        }
        if (!seen.insert(unordered(p)).second) {
            ++scene.dropped.duplicate;
            continue;
        }
        copy_facts(scene, k, scene, kept);
        scene.primitives[kept++] = p;
    }
    resize_primitives(scene, kept);
    tidy(scene.objects);
    if (kept == 0) {
        scene.warnings.push_back("the scene is empty: 0 primitives");
        return;
    }

    const Box<2> box = bounds<2>(scene.primitives);
    const double side = box.longest_side();
    if (side < 1 / largest_coordinate)
        throw input_error(name, "", "the scene is " + number_text(side) + " units wide, too small (limit 1e-150)");
    if (recentre == Recentre::no) return;
    const Vec<2> shift(origin_for(box.centre().x, side), origin_for(box.centre().y, side));
    for (Primitive<2>& p : scene.primitives)
        for (Vec<2>& v : p) v -= shift;
    scene.origin += shift;
    if (scene.start_view) {
        scene.start_view->eye -= shift;
        scene.start_view->look_at -= shift;
    }
}

template <int D>
void check_view(const ViewSpec<D>& view, const std::string& name, const std::string& place) {
    for (int i = 0; i < D; ++i)
        if (!(std::abs(view.eye[i]) <= largest_coordinate && std::abs(view.look_at[i]) <= largest_coordinate))
            throw input_error(name, place, "eye and look_at must be numbers of at most 1e150");
    const Vec<D> direction = view.look_at - view.eye;
    double size = 0;
    for (int i = 0; i < D; ++i) size = std::max(size, std::abs(direction[i]));
    if (size < 1 / largest_coordinate) throw input_error(name, place, "look_at is the same point as eye");
    if (!(view.fov > 0 && view.fov < 180) && !(D == 2 && view.fov == 360))
        throw input_error(name, place,
                          "fov " + number_text(view.fov) + " is not between 0 and 180" + (D == 2 ? ", nor 360" : ""));
}

template void check_view<2>(const ViewSpec<2>&, const std::string&, const std::string&);
template void check_view<3>(const ViewSpec<3>&, const std::string&, const std::string&);

}  // namespace sightline
