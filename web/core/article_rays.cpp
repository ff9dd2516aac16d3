// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/core/article_rays.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/draw/eye_strip.h"

namespace sightline {

namespace {

/// How far along `way` from the eye the segment lies, or infinity.
double distance_along(const Vec<2>& eye, const Vec<2>& way, const Primitive<2>& segment) {
    const Vec<2> side = segment[1] - segment[0], from = segment[0] - eye;
    const double across = way.x * side.y - way.y * side.x;
    if (across == 0) return INFINITY;
    const double along = (from.x * side.y - from.y * side.x) / across;
    const double share = (from.x * way.y - from.y * way.x) / across;
    return along > 0 && share >= 0 && share <= 1 ? along : INFINITY;
}

/// Beyond all that the scene holds.
double reach_of(const Session<2>& session) {
    Box<2> box = bounds<2>(session.scene().primitives);
    box.add(session.culling_view().eye);
    return std::hypot(box.extent().x, box.extent().y);
}

}  // namespace

double Crossed::mean(const std::vector<std::uint32_t>& counts) const {
    const double sum = std::accumulate(counts.begin(), counts.end(), 0.0);
    return counts.empty() ? 0 : sum / static_cast<double>(counts.size());
}

std::size_t Crossed::deepest() const { return all.empty() ? 0 : *std::max_element(all.begin(), all.end()); }

Crossed crossed_by_rays(const Session<2>& session, int rays) {
    const View<2>& view = session.problem().view;
    const std::vector<Primitive<2>>& primitives = session.scene().primitives;
    const auto drawn = rendered_mask(session.met(), primitives.size());
    Crossed crossed;
    for (int ray = 0; ray < rays; ++ray) {
        const Vec<2> way = through_pixel(view, rays, ray);
        std::uint32_t all = 0, of_drawn = 0;
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            if (distance_along(view.eye, way, primitives[i]) == INFINITY) continue;
            ++all;
            of_drawn += drawn[i];
        }
        crossed.all.push_back(all);
        crossed.drawn.push_back(of_drawn);
    }
    return crossed;
}

std::vector<LightLine<2>> ray_lines(const Session<2>& session, const std::string& through) {
    const std::size_t comma = through.find(',');
    const auto x = parse_number(through.substr(0, comma));
    const auto y = comma == std::string::npos ? std::nullopt : parse_number(through.substr(comma + 1));
    if (!x || !y) throw InputError("'" + through + "' is not X,Y");
    const Vec<2> eye = session.culling_view().eye;
    Vec<2> way = Vec<2>(*x, *y) - eye;
    const double length = std::hypot(way.x, way.y), reach = reach_of(session);
    std::vector<LightLine<2>> lines;
    if (!(length > 0)) return lines;
    way /= length;
    std::vector<double> met;
    for (const Primitive<2>& segment : session.scene().primitives)
        if (const double at = distance_along(eye, way, segment); at < INFINITY) met.push_back(at);
    std::sort(met.begin(), met.end());
    lines.push_back({{eye, eye + way * reach}, false, true});
    const Vec<2> side(-way.y, way.x);
    for (const double at : met) {
        const Vec<2> p = eye + way * at, s = side * (0.008 * reach);
        lines.push_back({{p - s, p + s}});
    }
    return lines;
}

std::vector<LightLine<2>> deepest_lines(const Session<2>& session) {
    constexpr int rays = 256;
    const Crossed crossed = crossed_by_rays(session, rays);
    const auto at = std::max_element(crossed.all.begin(), crossed.all.end()) - crossed.all.begin();
    const Vec<2> through =
        session.culling_view().eye + through_pixel(session.problem().view, rays, static_cast<int>(at));
    return ray_lines(session, number_text(through.x) + "," + number_text(through.y));
}

std::vector<LightLine<2>> wrong_lines(const Session<2>& session) {
    const EyeStrip strip = eye_strip(session);
    const View<2>& view = session.problem().view;
    const double reach = reach_of(session);
    std::vector<LightLine<2>> lines;
    for (const auto& [begin, end] : wrong_stretches(strip)) {
        std::vector<Vec<2>> points{view.eye};
        for (const int pixel : {begin, end - 1}) {
            const Vec<2> way = through_pixel(view, strip.pixels, pixel);
            points.push_back(view.eye + way * (reach / std::hypot(way.x, way.y)));
        }
        lines.push_back({std::move(points), true});
    }
    return lines;
}

}  // namespace sightline
