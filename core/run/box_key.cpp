// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/box_key.h"

#include <algorithm>
#include <cmath>

#include "core/base/number.h"

namespace sightline {

KeyExplanation explain_box_key(double squared_distance, std::optional<double> largest, int digits) {
    const double distance = std::sqrt(squared_distance);
    KeyExplanation e;
    e.key = largest ? squared_distance / std::sqrt(std::max(*largest, 1e-300)) : squared_distance;
    e.parts = {{largest ? "key = distance² / √size = " : "key = distance² = "},
               {short_number(distance, digits) + "²", KeyAbout::nothing, "distance"}};
    e.terms = {{"distance", distance, {}}};
    e.tip = "the squared distance from the eye to the box";
    e.weightiest = "its distance, " + short_number(distance, digits);
    if (largest) {
        e.parts.insert(e.parts.end(), {{" / √"}, {short_number(*largest, digits), KeyAbout::nothing, "size"}});
        e.terms.push_back({"size", *largest, {}});
        e.tip += ", over the square root of the size of the largest primitive in it";
    }
    e.parts.push_back({" = " + short_number(e.key, digits)});
    e.terms.push_back({"key", e.key, {}});
    return e;
}

}  // namespace sightline
