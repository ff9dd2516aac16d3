// How methods look in charts: a colour per variant, dashes and rings on the leaves of a tree of either kind.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "lab/measure/study.h"
#include "lab/report/chart.h"

namespace sightline::lab {

/// Colours in the order in which variants come up, one chart long.
class MethodLooks {
public:
    /// An empty series of the variant's name, colour and look.
    Series series(const MethodChoice& method) {
        const auto [at, is_new] = index_.try_emplace(method.variant, index_.size());
        Series s;
        s.name = method_text(method);
        s.colour = series_colour(at->second);
        s.look = method.tessellation != Tessellation::delaunay ? Series::Look::dashed_and_rings
                                                               : Series::Look::line_and_dots;
        return s;
    }

private:
    std::map<std::string, std::size_t> index_;
};

/// The same without dots.
inline Series::Look line_of(const MethodChoice& method) {
    return method.tessellation != Tessellation::delaunay ? Series::Look::dashed : Series::Look::line;
}

}  // namespace sightline::lab
