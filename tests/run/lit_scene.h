// A random soup of primitives with cells and a view, for methods that order by light.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method_table.h"
#include "core/scene/scene_view.h"
#include "tests/run/run_support.h"
#include "tests/scene/random_scene.h"

namespace sightline::test {

inline Scene<2> lit_soup(Random& random, Vec<2>) { return random_scene(random, 5 + random.below(60)); }
inline Scene<3> lit_soup(Random& random, Vec<3>) { return random_scene_3d(random, 5 + random.below(40)); }

enum class Eyes : std::uint8_t { near, far_too };

template <int D>
struct LitScene {
    Scene<D> scene;
    Settings settings;
    CellComplex<D> cells;
    View<D> view;

    LitScene(Random& random, std::string_view method, double least_error_bound = 0.1, Eyes eyes = Eyes::near)
        : scene(lit_soup(random, Vec<D>(0))) {
        settings.method = method;
        settings.tessellation = static_cast<Tessellation>(random.below(3));
        settings.error_bound = random.uniform(least_error_bound, 0.4);
        cells = build_cells(scene, settings);
        ViewSpec<D> spec;
        const bool far = eyes == Eyes::far_too && random.below(4) == 0;
        for (int i = 0; i < D; ++i) spec.eye[i] = far ? random.uniform(-20, 20) : random.uniform(-0.5, 1.5);
        spec.look_at = Vec<D>(0.5);
        view = scene_view(spec, scene, settings.reference_size);
    }
    Problem<D> problem() const { return problem_of(scene, cells, view, settings); }
    const Method<D>& method() const { return find_method<D>(method_table<D>(), settings.method); }
};

}  // namespace sightline::test
