// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/chart_labels.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lab/report/chart_layout.h"

namespace sightline::lab {

namespace {

struct LabelBox {
    double left, right, below, above;
    double overlap(const LabelBox& other) const {
        const double x = std::min(right, other.right) - std::max(left, other.left),
                     y = std::min(above, other.above) - std::max(below, other.below);
        return x > 0 && y > 0 ? x * y : 0;
    }
};

LabelBox box_of(const LabelPlace& place, double width, double font) {
    const double left = place.side > 0 ? place.x : place.side < 0 ? place.x - width : place.x - width / 2;
    return {left, left + width, place.y - 0.5 * font, place.y + 0.5 * font};
}

}  // namespace

std::vector<LabelPlace> place_labels(const std::vector<ChartLabel>& labels,
                                     const std::vector<std::array<double, 2>>& points,
                                     const std::vector<std::array<double, 2>>& lines, double font) {
    const double near = 0.7 * font, far = 1.7 * font, marker = 0.35 * font;
    struct Offset {
        double x, y;
        int side;
    };
    const Offset offsets[] = {{0.6 * font, near, 1},    {0.6 * font, -near, 1}, {-0.6 * font, near, -1},
                              {-0.6 * font, -near, -1}, {0, 1.1 * font, 0},     {0, -1.1 * font, 0},
                              {0.8 * font, 0, 1},       {-0.8 * font, 0, -1},   {0.6 * font, far, 1},
                              {0.6 * font, -far, 1},    {-0.6 * font, far, -1}, {-0.6 * font, -far, -1}};
    std::vector<LabelPlace> places;
    std::vector<LabelBox> taken;
    for (const ChartLabel& label : labels) {
        LabelPlace best;
        for (std::size_t i = 0; i < places.size() && !best.shared; ++i)
            best.shared = labels[i].text == label.text && !places[i].shared &&
                          std::hypot(labels[i].x - label.x, labels[i].y - label.y) < 0.8 * font;
        if (best.shared) {
            places.push_back(best);
            continue;
        }
        const double width = 0.62 * font * static_cast<double>(characters_of(label.text));
        std::optional<double> least;
        for (const Offset& offset : offsets) {
            const LabelPlace place{label.x + offset.x, label.y + offset.y, offset.side};
            const LabelBox box = box_of(place, width, font);
            double covered = 0;
            for (const LabelBox& other : taken) covered += 3 * box.overlap(other);
            for (const auto& [x, y] : points)
                if (x != label.x || y != label.y)
                    covered += box.overlap({x - marker, x + marker, y - marker, y + marker});
            for (const auto& [x, y] : lines)
                covered += 0.3 * box.overlap({x - marker, x + marker, y - marker, y + marker});
            if (least && covered >= *least) continue;
            least = covered;
            best = place;
        }
        taken.push_back(box_of(best, width, font));
        places.push_back(best);
    }
    return places;
}

}  // namespace sightline::lab
