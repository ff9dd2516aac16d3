// Small sessions in three dimensions whose exact images come from casting rays.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/session/session.h"
#include "core/truth/reference.h"
#include "tests/scene/random_scene.h"
#include "tests/space/random_cells.h"

namespace sightline::test {

/// Distance along the ray in lengths of `d`; infinite where it misses.
inline double hit_distance(const Primitive<3>& t, const Vec<3>& eye, const Vec<3>& d) {
    const Vec<3> n = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double share = glm::dot(n, t[0] - eye) / glm::dot(n, d);
    const Vec<3> p = eye + d * share;
    for (std::size_t i = 0; i < 3; ++i)
        if (glm::dot(n, glm::cross(t[(i + 1) % 3] - t[i], p - t[i])) < 0)
            return std::numeric_limits<double>::infinity();
    return share > 0 ? share : std::numeric_limits<double>::infinity();
}

/// A DrawIds of few pixels, whatever size is asked for.
inline std::vector<IdImage> cast_rays(const Scene<3>& scene, const View<3>& view, const ImageSize&, int layers) {
    const ImageSize size{40, 30};
    std::vector<IdImage> images(static_cast<std::size_t>(layers), {size.width, size.height, {}});
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Vec<3> d = pixel_centre(view, size, x, y) - view.eye;
            std::vector<std::pair<double, std::uint32_t>> hits;
            for (std::uint32_t p = 0; p < scene.primitives.size(); ++p)
                if (faces(view, scene.primitives[p]))
                    if (const double at = hit_distance(scene.primitives[p], view.eye, d); std::isfinite(at))
                        hits.emplace_back(at, p);
            std::sort(hits.begin(), hits.end());
            for (std::size_t layer = 0; layer < images.size(); ++layer)
                images[layer].ids.push_back(layer < hits.size() ? hits[layer].second : none);
        }
    return images;
}

/// What a session is made of.
struct Start3 {
    std::shared_ptr<const Scene<3>> scene;
    ViewSpec<3> view;
    Settings settings;

    Session<3> session() const { return {scene, view, settings, method_table<3>(), cast_rays}; }
};

inline Vec<3> random_point_3d(Random& random, double low, double high) {
    return {random.uniform(low, high), random.uniform(low, high), random.uniform(low, high)};
}

inline ViewSpec<3> random_view_3d(Random& random) {
    const double reach = random.below(3) == 0 ? 1.5 : 0;  // sometimes outside
    return {random_point_3d(random, -reach, 1 + reach), random_point_3d(random, 0.2, 0.8), random.uniform(20, 120)};
}

inline Start3 random_start_3d(Random& random, std::size_t most_triangles = 60) {
    Start3 start;
    Scene<3> scene;
    scene.primitives = random_triangles(random, random.below(most_triangles));
    start.scene = std::make_shared<const Scene<3>>(std::move(scene));
    start.view = random_view_3d(random);
    start.settings = random_settings(random);
    start.settings.jitter = 0.02;              // else cells without a volume
    start.settings.border = Border::inflated;  // else there may be no cell
    start.settings.error_bound = random.uniform(0.1, 0.5);
    start.settings.method = random.below(4) == 0 ? "layers" : "published";
    return start;
}

/// The picture settings of three dimensions at random.
inline void randomise_picture(Settings& s, Random& random) {
    for (DrawnAs* as : {&s.clean_as, &s.projected_as, &s.enqueued_as, &s.unseen_as})
        *as = static_cast<DrawnAs>(random.below(4));
    s.show_tessellation = static_cast<Switch>(random.below(2));
    s.show_visibility = static_cast<Switch>(random.below(2));
    s.triangles = static_cast<Triangles>(random.below(5));
    s.slice = random.below(2) ? static_cast<SliceAcross>(random.below(5)) : SliceAcross::off;
    s.slice_at = random.unit();
    s.only = random.below(2) ? static_cast<OnlyCells>(random.below(3)) : OnlyCells::all;
    s.around = static_cast<std::uint32_t>(random.below(4));
}

/// Some way into its run, frozen and mostly looked at by another eye.
inline Session<3> random_frozen_session(Random& random, const Start3& start) {
    Session<3> session = start.session();
    session.seek(static_cast<std::uint32_t>(random.below(40)));
    session.freeze();
    if (random.below(5) > 0) session.set_view(random_view_3d(random));
    if (random.below(2)) session.selected_cell = static_cast<std::uint32_t>(random.below(session.cells().cell_count()));
    if (random.below(2) && !session.scene().primitives.empty())
        session.selected_primitive = static_cast<std::uint32_t>(random.below(session.scene().primitives.size()));
    return session;
}

}  // namespace sightline::test
