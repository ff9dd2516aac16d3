// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/car.h"

#include <array>

namespace sightline {

namespace {

constexpr double length = 4.35, skin = 0.03;
constexpr double wheel_radius = 0.31, arch_radius = 0.4, axle_height = 0.32;
constexpr std::array axles = {0.85, 3.45};

/// Where the shape changes; edges of doors, windows and wheel arches are among them.
constexpr std::array stations = {0.0,  0.12, 0.4,  0.45, 0.58, 0.85, 1.12, 1.25, 1.3,  1.42, 1.95,
                                 2.05, 2.45, 2.55, 2.98, 3.05, 3.15, 3.45, 3.75, 3.85, 4.2,  length};

/// Points of half a section: 0 and 7 are in the middle below and above; 5 is the belt, 6 the edge of roof or hood.
constexpr int half_points = 8, loop_points = 2 * half_points - 2;

double between(std::span<const Vec<2>> curve, double x) {
    for (std::size_t i = 1; i < curve.size(); ++i)
        if (x <= curve[i].x)
            return curve[i - 1].y +
                   (curve[i].y - curve[i - 1].y) * (x - curve[i - 1].x) / (curve[i].x - curve[i - 1].x);
    return curve.back().y;
}

/// A point of the outer or the inner surface of the sheet; `v` counts round the section.
Vec<3> key_point(double x, int v, bool inner) {
    static constexpr Vec<2> belt[] = {{0, .58},    {.12, .68}, {.45, .76}, {1.3, .84},
                                      {1.42, .86}, {3.85, .9}, {4.2, .86}, {length, .74}};
    static constexpr Vec<2> edge[] = {{0, .61},     {.12, .72},   {.45, .82},   {1.3, .91},   {1.42, .93},
                                      {1.95, 1.33}, {2.05, 1.38}, {2.55, 1.41}, {3.15, 1.37}, {3.75, .99},
                                      {3.85, .97},  {4.2, .94},   {length, .8}};
    static constexpr Vec<2> half_width[] = {{0, .7},    {.12, .8},  {.45, .86},   {1.4, .88},
                                            {3.2, .88}, {4.2, .84}, {length, .74}};
    static constexpr Vec<2> half_roof[] = {{0, .56},   {.12, .68},  {.45, .72},  {1.42, .74}, {1.95, .62},
                                           {2.05, .6}, {3.15, .58}, {3.75, .68}, {4.2, .68},  {length, .58}};
    static constexpr Vec<2> floor[] = {{0, .3}, {.12, .22}, {4.2, .22}, {length, .34}};
    double arch = between(floor, x) + 0.02;
    for (const double axle : axles) {
        const double d2 = arch_radius * arch_radius - (x - axle) * (x - axle);
        if (d2 >= 0) arch = axle_height + std::sqrt(d2);
    }
    const double w = between(half_width, x), top = between(edge, x), sill = between(belt, x), low = between(floor, x);
    const std::array<Vec<2>, half_points> half = {{{0, low},
                                                   {0.55, low},
                                                   {0.57, arch},
                                                   {w - 0.01, arch},
                                                   {w, (arch + sill) / 2},
                                                   {0.98 * w, sill},
                                                   {between(half_roof, x), top},
                                                   {0, top + 0.04}}};
    const bool mirrored = v >= half_points;
    const std::size_t i = static_cast<std::size_t>(mirrored ? loop_points - v : v);
    Vec<2> p = half[i];
    if (inner) {
        p.x = p.x > 0 ? p.x - skin : 0;
        if (i <= 3) p.y += skin;
        if (i >= 6) p.y -= skin;
        x = std::clamp(x, skin, length - skin);
    }
    return {x, mirrored ? -p.x : p.x, p.y};
}

/// The body: a sheet round the car with an inner and an outer surface, and holes.
class Sheet {
public:
    Sheet(int detail, bool hood_open)
        : detail_(detail),
          along_(static_cast<int>(stations.size() - 1) * detail),
          around_(loop_points * detail),
          hood_open_(hood_open) {
        for (const bool inner : {false, true})
            for (int u = 0; u <= along_; ++u)
                for (int v = 0; v < around_; ++v) points_.push_back(interpolated(u, v, inner));
    }
    void add_to(Model& m, std::vector<CarPart>& parts) const {
        for (int u = 0; u < along_; ++u) {
            for (int v = 0; v < around_; ++v) {
                if (open(u, v)) continue;
                const std::array<std::array<int, 2>, 4> corners = {
                    {{u, v}, {u, v + 1}, {u + 1, v + 1}, {u + 1, v}}};  // counter-clockwise from outside
                const std::array<bool, 4> rim = {u > 0 && open(u - 1, v), open(u, (v + 1) % around_),
                                                 u + 1 < along_ && open(u + 1, v),
                                                 open(u, (v + around_ - 1) % around_)};
                std::array<Vec<3>, 4> outer, inner;
                for (std::size_t i = 0; i < 4; ++i) {
                    outer[i] = at(corners[i][0], corners[i][1], false);
                    inner[i] = at(corners[i][0], corners[i][1], true);
                }
                m.polygon(outer);
                m.polygon({inner[0], inner[3], inner[2], inner[1]});
                for (std::size_t i = 0; i < 4; ++i) {
                    const std::size_t next = (i + 1) % 4;
                    if (rim[i]) m.polygon({outer[next], outer[i], inner[i], inner[next]});
                }
            }
            parts.resize(m.triangles.size(), at(u, 0, false).x < length / 2 ? CarPart::front : CarPart::back);
        }
        for (const int u : {0, along_}) {
            for (int v = 0; v < around_; ++v)
                for (const bool inner : {false, true}) {
                    const Vec<3> a = at(u, v, inner), b = at(u, v + 1, inner), middle(a.x, 0, 0.5);
                    if ((u == 0) == inner)
                        m.triangle(a, b, middle);
                    else
                        m.triangle(b, a, middle);
                }
            parts.resize(m.triangles.size(), u == 0 ? CarPart::front : CarPart::back);
        }
    }

private:
    Vec<3> interpolated(int u, int v, bool inner) const {
        const double s = static_cast<double>(u % detail_) / detail_, t = static_cast<double>(v % detail_) / detail_;
        const std::size_t station = static_cast<std::size_t>(u / detail_);
        double x = stations[station];
        if (s > 0) x += s * (stations[station + 1] - x);
        const int key = v / detail_;
        const Vec<3> a = key_point(x, key, inner);
        return t > 0 ? a + t * (key_point(x, (key + 1) % loop_points, inner) - a) : a;
    }
    const Vec<3>& at(int u, int v, bool inner) const {
        return points_[static_cast<std::size_t>(((inner ? along_ + 1 : 0) + u) * around_ + v % around_)];
    }
    bool open(int u, int v) const {
        const double x = stations[static_cast<std::size_t>(u / detail_)];
        const int key = v / detail_;
        if (key == 5 || key == 8) return (x >= 2.05 && x < 2.45) || (x >= 2.55 && x < 2.98);
        if (key == 6 || key == 7)
            return (x >= 1.42 && x < 1.95) || (x >= 3.15 && x < 3.75) || (hood_open_ && x >= 0.4 && x < 1.25);
        return false;
    }

    int detail_, along_, around_;
    bool hood_open_;
    std::vector<Vec<3>> points_;
};

void wheel(Model& m, double x, double side, int detail) {
    static constexpr Vec<2> plain[] = {{0, 0}, {.2, 0}, {wheel_radius, .03}, {wheel_radius, .19}, {.2, .22}, {0, .22}};
    static constexpr Vec<2> round[] = {{0, .03},   {.04, .03}, {.06, .06}, {.17, .05}, {.19, 0},   {.24, -.01},
                                       {.29, .01}, {.31, .04}, {.31, .18}, {.29, .21}, {.24, .23}, {.19, .22},
                                       {.17, .17}, {.06, .16}, {.04, .19}, {0, .19}};
    const std::span<const Vec<2>> profile =
        detail > 1 ? std::span<const Vec<2>>(round) : std::span<const Vec<2>>(plain);
    const Vec<3> foot(x, side * 0.61, axle_height);
    m.turned_solid(foot, {0, side, 0}, profile, 8 + 4 * (detail - 1));
    if (detail == 1) return;
    for (int bolt = 0; bolt < 5; ++bolt) {
        const SinCos turn = sincos_degrees(72.0 * bolt);
        const Vec<3> at = foot + Vec<3>(0.1 * turn.cos, side * 0.15, 0.1 * turn.sin);
        m.rod(at, at + Vec<3>(0, side * 0.05, 0), 0.015, 6);
    }
}

void seats(Model& m) {
    for (const double y : {-0.38, 0.38}) {
        m.box({1.95, y - 0.24, 0.27}, {2.42, y + 0.24, 0.5});
        m.box({2.4, y - 0.24, 0.4}, {2.52, y + 0.24, 0.98});
        m.box({2.42, y - 0.12, 1}, {2.5, y + 0.12, 1.16});
    }
    m.box({2.75, -0.6, 0.27}, {3.2, 0.6, 0.55});
    m.box({3.18, -0.5, 0.45}, {3.3, 0.5, 1});
    m.box({1.34, -0.52, 0.27}, {1.38, 0.52, 0.84});  // the wall between engine and driver
    m.box({1.5, -0.65, 0.66}, {1.75, 0.65, 0.82});   // dashboard
    m.turned_solid({1.78, -0.38, 0.8}, {0.8, 0, 0.6}, {{0.15, 0}, {0.19, 0}, {0.19, 0.02}, {0.15, 0.02}, {0.15, 0}}, 8);
    m.rod({1.7, -0.38, 0.76}, {1.8, -0.38, 0.81}, 0.04, 5);
}

/// Where engines are: low and high corner.
constexpr Vec<3> bay_low(0.3, -0.46, 0.32), bay_high(1.26, 0.46, 0.7);

void engine_part(Model& m, Random& random, int detail) {
    const auto point = [&] {
        Vec<3> p;
        for (int i = 0; i < 3; ++i) p[i] = random.uniform(bay_low[i], bay_high[i]);
        return p;
    };
    Vec<3> axis(0, 0, 0);
    axis[static_cast<int>(random.below(3))] = 1;
    const Vec<3> at = point();
    switch (random.below(4)) {
        case 0: {  // a hose
            Vec<3> to = at, corner = at;
            for (int i = 0; i < 3; ++i) {
                corner[i] = std::clamp(at[i] + random.uniform(-0.15, 0.15), bay_low[i], bay_high[i]);
                to[i] = std::clamp(corner[i] + random.uniform(-0.15, 0.15), bay_low[i], bay_high[i]);
            }
            const int pieces = std::min(4 + detail, 16);
            m.bent_rod(at, corner, to, random.uniform(0.008, 0.02), pieces, std::min(5 + detail / 2, 12));
            return;
        }
        case 1: {  // a pulley with a groove
            const double r = random.uniform(0.02, 0.045);
            m.turned_solid(at, axis, {{0, 0}, {r, 0}, {r, .005}, {.8 * r, .01}, {r, .015}, {r, .02}, {0, .02}},
                           std::min(8 + detail, 24));
            return;
        }
        case 2: {  // bolts in a row
            const double spacing = random.uniform(0.015, 0.03);
            Vec<3> step(0, 0, 0);
            step[axis.x > 0 ? 1 : 0] = spacing;
            for (const double i : {0.0, 1.0, 2.0, 3.0}) m.rod(at + i * step, at + i * step + 0.012 * axis, 0.006, 6);
            return;
        }
        default: {  // cooling fins
            const double w = random.uniform(0.02, 0.05);
            for (int i = 0; i < 6; ++i) m.box(at + Vec<3>(0, 0, 0.008 * i), at + Vec<3>(w, 1.5 * w, 0.008 * i + 0.003));
        }
    }
}

void engine(Model& m, Random& random, int detail) {
    m.box({0.5, -0.2, 0.3}, {1.1, 0.2, 0.52});
    m.box({0.53, -0.14, 0.52}, {1.07, 0.14, 0.62});
    for (int i = 0; i < 4 && !m.full(); ++i) {
        const double x = 0.6 + 0.135 * i;
        m.turned_solid({x, 0, 0.62}, {0, 0, 1}, {{0.05, 0}, {0.05, 0.04}, {0.03, 0.07}, {0, 0.07}}, 8);
        m.bent_rod({x, 0.14, 0.57}, {x, 0.35, 0.6}, {x + 0.1, 0.4, 0.35}, 0.025, 4, 6);
    }
    m.box({0.22, -0.45, 0.32}, {0.26, 0.45, 0.64});  // radiator
    m.box({1.12, -0.44, 0.4}, {1.28, -0.2, 0.62});   // battery
    while (!m.full()) engine_part(m, random, detail);
}

}  // namespace

void car(Model& m, Random& random, int detail, bool hood_open, std::vector<CarPart>& parts) {
    Sheet(detail, hood_open).add_to(m, parts);
    for (const double x : axles)
        for (const double side : {-1.0, 1.0}) wheel(m, x, side, detail);
    seats(m);
    parts.resize(m.triangles.size(), CarPart::other);
    engine(m, random, detail);
    parts.resize(m.triangles.size(), CarPart::engine);
}

}  // namespace sightline
