// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/trig.h"
#include "core/measure/frame_change.h"
#include "core/session/settings_table.h"
#include "core/truth/item_buffer.h"
#include "core/truth/software_ids.h"
#include "lab/gallery/gallery_functions.h"

namespace sightline::lab {

namespace {

/// The exact image of a scene: ids, 0-based; in 2D of one row.
IdImage ids_of(const Scene<2>& scene, const View<2>& view, const ImageSize& asked, const DrawIds&) {
    const int width = image_size<2>(asked).width;
    return {width, 1, item_buffer(scene.primitives, view, width).ids};
}
IdImage ids_of(const Scene<3>& scene, const View<3>& view, const ImageSize& asked, const DrawIds& draw_ids) {
    return draw_ids(scene, view, image_size<3>(asked), 1).front();
}

template <int D>
IdImage ids_of(const Probe<D>& p, const ViewSpec<D>& view) {
    return ids_of(p.at.scene(), p.at.view(view, p.settings), p.settings.reference_size,
                  drawing_of(p.settings.reference, p.at.draw_ids()));
}

std::vector<std::uint8_t> shown_primitives(const IdImage& image, std::size_t count) {
    std::vector<std::uint8_t> mask(count);
    for (const std::uint32_t id : image.ids)
        if (id != none) mask[id] = 1;
    return mask;
}

/// From the eye through a pixel's centre; any length.
Vec<2> ray(const View<2>& view, const IdImage& image, int x, int) {
    // Pixel 0 is at the right border (item_buffer.h); the corners lie at one distance from the eye.
    const double t = (x + 0.5) / image.width;
    return view.corners[0] + (view.corners[1] - view.corners[0]) * t - view.eye;
}
Vec<3> ray(const View<3>& view, const IdImage& image, int x, int y) {
    return pixel_centre(view, {image.width, image.height}, x, y) - view.eye;
}

constexpr double no_hit = std::numeric_limits<double>::infinity();

/// Distance along the ray in its lengths to the line or plane of a primitive.
double along(const Primitive<2>& s, const Vec<2>& eye, const Vec<2>& d) {
    const Vec<2> e = s[1] - s[0], from = s[0] - eye;
    const double turn = d.x * e.y - d.y * e.x;
    return turn == 0 ? no_hit : (from.x * e.y - from.y * e.x) / turn;
}
double along(const Primitive<3>& t, const Vec<3>& eye, const Vec<3>& d) {
    const Vec<3> n = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double facing = glm::dot(n, d);
    return facing == 0 ? no_hit : glm::dot(n, t[0] - eye) / facing;
}

/// The nearest triangle on the ray, by distance (Moeller and Trumbore 1997).
double first_hit(const Scene<3>& scene, const View<3>& view, const Vec<3>& d) {
    double nearest = no_hit;
    for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
        const Primitive<3>& t = scene.primitives[i];
        const Vec<3> u = t[1] - t[0], v = t[2] - t[0], p = glm::cross(d, v);
        const double det = glm::dot(u, p);
        const bool both = !scene.two_sided.empty() && scene.two_sided[i];
        if (det == 0 || (det < 0 && !both)) continue;
        const Vec<3> from = view.eye - t[0];
        const double a = glm::dot(from, p) / det;
        if (a < 0 || a > 1) continue;
        const Vec<3> q = glm::cross(from, u);
        const double b = glm::dot(d, q) / det, distance = glm::dot(v, q) / det;
        if (b < 0 || a + b > 1 || distance <= 0) continue;
        nearest = std::min(nearest, distance);
    }
    return nearest;
}

/// Equal but for what depth buffers and floats lose.
bool near(double a, double b) { return a == b || std::abs(a - b) <= 1e-4 * std::min(std::abs(a), std::abs(b)); }

}  // namespace

template <int D>
double lost_by_pixels(const Probe<D>& p) {
    const std::size_t count = p.at.scene().primitives.size();
    const std::vector<std::uint8_t> seen = shown_primitives(ids_of(p, p.view), count);
    std::vector<std::uint8_t> visible;
    if constexpr (D == 2) {
        visible = exact_visible_set(p.at.scene().primitives, p.at.view(p.view, p.settings)).visible;
    } else {
        Probe<D> fine = p;
        const ImageSize size = image_size<D>(p.settings.reference_size);
        fine.settings.reference_size = {4 * size.width, 4 * size.height};
        visible = shown_primitives(ids_of(fine, p.view), count);
    }
    double all = 0, lost = 0;
    for (std::size_t i = 0; i < count; ++i) {
        all += visible[i];
        lost += visible[i] && !seen[i];
    }
    return lost / all;
}

template <int D>
double churn(const Probe<D>& p) {
    const Vec<D> d = p.view.look_at - p.view.eye;
    const double flat = std::sqrt(d.x * d.x + d.y * d.y);
    const SinCos half = sincos_degrees(p.view.fov / 2);
    const ImageSize size = image_size<D>(p.settings.reference_size);
    // fov is horizontal in 2D and vertical in 3D.
    const double pixel = 2 * std::sqrt(glm::dot(d, d)) * half.sin / half.cos / (D == 2 ? size.width : size.height);
    ViewSpec<D> beside = p.view;
    for (Vec<D>* point : {&beside.eye, &beside.look_at}) {
        point->x += 0.3 * pixel * d.y / flat;
        point->y -= 0.3 * pixel * d.x / flat;
    }
    const std::size_t count = p.at.scene().primitives.size();
    return 1 - jaccard(shown_primitives(ids_of(p, p.view), count), shown_primitives(ids_of(p, beside), count));
}

namespace {

/// The image of the scene with its primitives in reverse order, in the ids of the scene.
template <int D>
IdImage reverse_image(const Probe<D>& p) {
    Scene<D> scene = p.at.scene();
    std::reverse(scene.primitives.begin(), scene.primitives.end());
    std::reverse(scene.two_sided.begin(), scene.two_sided.end());
    IdImage image = ids_of(scene, p.at.view(p.view, p.settings), p.settings.reference_size,
                           drawing_of(p.settings.reference, p.at.draw_ids()));
    for (std::uint32_t& id : image.ids)
        if (id != none) id = static_cast<std::uint32_t>(scene.primitives.size()) - 1 - id;
    return image;
}

}  // namespace

template <int D>
double churn_in_reverse(const Probe<D>& p) {
    const std::size_t count = p.at.scene().primitives.size();
    return 1 - jaccard(shown_primitives(ids_of(p, p.view), count), shown_primitives(reverse_image(p), count));
}

template <int D>
double unexplained_in_reverse(const Probe<D>& p) {
    const IdImage a = ids_of(p, p.view), b = reverse_image(p);
    const View<D> view = p.at.view(p.view, p.settings);
    double wrong = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            if (a.at(x, y) == b.at(x, y)) continue;
            if (a.at(x, y) == none || b.at(x, y) == none) {
                ++wrong;
                continue;
            }
            const Vec<D> d = ray(view, a, x, y);
            wrong += !near(along(p.at.scene().primitives[a.at(x, y)], view.eye, d),
                           along(p.at.scene().primitives[b.at(x, y)], view.eye, d));
        }
    return wrong / static_cast<double>(a.ids.size());
}

template <int D>
double wrong_against_rays(const Probe<D>& p) {
    const IdImage image = ids_of(p, p.view);
    const View<D> view = p.at.view(p.view, p.settings);
    double tried = 0, wrong = 0;
    for (std::size_t i = 0; i < image.ids.size(); i += 11) {
        const int x = static_cast<int>(i) % image.width, y = static_cast<int>(i) / image.width;
        const Vec<D> d = ray(view, image, x, y);
        double nearest = no_hit;
        if constexpr (D == 2) {
            for (const Primitive<2>& s : p.at.scene().primitives) {
                const Vec<2> a = s[0] - view.eye, b = s[1] - view.eye;
                const double t = along(s, view.eye, d);
                if (t > 0 && (d.x * a.y - d.y * a.x) * (d.x * b.y - d.y * b.x) <= 0) nearest = std::min(nearest, t);
            }
        } else {
            nearest = first_hit(p.at.scene(), view, d);
        }
        const std::uint32_t id = image.ids[i];
        ++tried;
        wrong += !near(id == none ? no_hit : along(p.at.scene().primitives[id], view.eye, d), nearest);
    }
    return wrong / tried;
}

#define SIGHTLINE_INSTANTIATE(D)                                \
    template double lost_by_pixels<D>(const Probe<D>&);         \
    template double churn<D>(const Probe<D>&);                  \
    template double churn_in_reverse<D>(const Probe<D>&);       \
    template double unexplained_in_reverse<D>(const Probe<D>&); \
    template double wrong_against_rays<D>(const Probe<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline::lab
