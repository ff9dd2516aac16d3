// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/clean.h"

#include <cmath>
#include <unordered_set>

#include "core/error.h"
#include "core/geometry/predicates.h"
#include "core/number.h"
#include "core/scene/text.h"

namespace sightline {

namespace {

bool is_degenerate(const Primitive<2>& p) { return p[0] == p[1]; }

/// Collinear in all three axis projections, which is exactly collinear (or worse).
bool is_degenerate(const Primitive<3>& p) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (orient(Vec<2>(p[0][i], p[0][j]), Vec<2>(p[1][i], p[1][j]), Vec<2>(p[2][i], p[2][j])) != 0) return false;
    }
    return true;
}

template <int D>
bool less(const Vec<D>& a, const Vec<D>& b) {
    for (int i = 0; i < D; ++i)
        if (a[i] != b[i]) return a[i] < b[i];
    return false;
}

/// The same points in one order, with one zero: equal for primitives that cover the same set.
template <int D>
Primitive<D> unordered(Primitive<D> p) {
    for (Vec<D>& v : p)
        for (int i = 0; i < D; ++i) v[i] += 0.0;  // -0 becomes +0
    std::sort(p.begin(), p.end(), less<D>);
    return p;
}

struct HashPoints {
    template <std::size_t N, typename V>
    std::size_t operator()(const std::array<V, N>& p) const {
        Hash hash;
        for (const V& v : p)
            for (int i = 0; i < V::length(); ++i) hash.add(v[i]);
        return hash.value();
    }
};

template <int D>
const char* noun() {
    return D == 2 ? "segment " : "triangle ";
}

/// A number near `centre` with few bits, so that origins are short to print.
double origin_for(double centre, double longest_side) {
    if (std::abs(centre) <= 4 * longest_side) return 0;
    int exponent = 0;
    std::frexp(longest_side, &exponent);
    const double quantum = std::ldexp(1.0, exponent - 1);
    const double steps = centre / quantum;
    // From 2^52 steps on every double is a whole number of steps.
    return std::abs(steps) < 0x1p52 ? std::floor(steps + 0.5) * quantum : centre;
}

}  // namespace

template <int D>
void clean(Scene<D>& scene, Recentre recentre, const std::string& name) {
    std::unordered_set<Primitive<D>, HashPoints> seen;
    seen.reserve(scene.primitives.size());
    std::size_t kept = 0;
    for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
        const Primitive<D> p = scene.primitives[k];
        bool finite = true;
        for (const Vec<D>& v : p) finite = finite && is_finite(v);
        if (!finite) {
            ++scene.dropped.not_finite;
            continue;
        }
        for (const Vec<D>& v : p)
            for (int i = 0; i < D; ++i)
                if (std::abs(v[i]) > largest_coordinate)
                    throw input_error(name, noun<D>() + std::to_string(k),
                                      "coordinate " + number_text(v[i]) + " is too large (limit 1e150)");
        if (is_degenerate(p)) {
            ++scene.dropped.degenerate;
            continue;
        }
        if (!seen.insert(unordered<D>(p)).second) {
            ++scene.dropped.duplicate;
            continue;
        }
        scene.primitives[kept++] = p;
    }
    scene.primitives.resize(kept);
    if (kept == 0) {
        scene.warnings.push_back("the scene is empty: 0 primitives");
        return;
    }

    const Box<D> box = bounds<D>(scene.primitives);
    const double side = box.longest_side();
    if (side < 1 / largest_coordinate)
        throw input_error(name, "", "the scene is " + number_text(side) + " units wide, too small (limit 1e-150)");
    if (recentre == Recentre::no) return;
    Vec<D> shift{};
    for (int i = 0; i < D; ++i) shift[i] = origin_for(box.centre()[i], side);
    for (Primitive<D>& p : scene.primitives)
        for (Vec<D>& v : p) v -= shift;
    scene.origin += shift;
    if (scene.start_view) {
        scene.start_view->eye -= shift;
        scene.start_view->look_at -= shift;
    }
}

template void clean<2>(Scene<2>&, Recentre, const std::string&);
template void clean<3>(Scene<3>&, Recentre, const std::string&);

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
