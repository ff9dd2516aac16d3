// Scenes, cells and views at random for cPLP, with an image to decide on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/builders.h"
#include "core/truth/software_ids.h"
#include "tests/run/run_support.h"
#include "tests/scene/random_scene.h"
#include "tests/space/random_cells.h"

namespace sightline::test {

template <int D>
struct CplpCase {
    Scene<D> scene;
    CellComplex<D> cells;
    Settings settings;
    View<D> view;
    ImageSize size = D == 2 ? ImageSize{512, 0} : ImageSize{80, 60};

    /// Of a variant of cPLP.
    Problem<D> problem(const char* text = "cplp") const {
        Services services;
        services.image = size;
        const Variant<D> variant = make_variant<D>(method_table<D>(), text, settings.parameters);
        return make_problem(variant.method, variant.parameters, scene, cells, view,
                            settings.budget.primitives(scene.primitives.size()), services);
    }
};

template <int D>
CplpCase<D> random_cplp_case(Random& random) {
    CplpCase<D> made;
    made.settings = random_settings(random);
    made.settings.budget = {Budget::Kind::primitives, static_cast<double>(random.below(40))};
    if constexpr (D == 2) {
        made.scene = random_scene(random, random.below(100));
        made.view = make_view(random_view(random));
    } else {
        made.scene.primitives = random_triangles(random, random.below(80));
        made.settings.jitter = 0.02;
        made.settings.border = Border::inflated;
        made.settings.error_bound = random.uniform(0.1, 0.5);
        const double reach = random.below(3) == 0 ? 1.5 : 0;
        const auto point = [&](double low, double high) {
            return Vec<3>(random.uniform(low, high), random.uniform(low, high), random.uniform(low, high));
        };
        made.view = make_view(ViewSpec<3>{point(-reach, 1 + reach), point(0.2, 0.8), random.uniform(20, 120)}, 4.0 / 3);
    }
    made.cells = build_cells(made.scene, made.settings);
    return made;
}

inline IdImage exact_ids(const CplpCase<2>& c) { return item_row(c.scene, c.view, c.size); }
inline IdImage exact_ids(const CplpCase<3>& c) { return draw_ids_in_software(c.scene, c.view, c.size, 1).front(); }

}  // namespace sightline::test
