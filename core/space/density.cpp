// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/density.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace sightline {

template <int D>
Density density(const CellComplex<D>& cells) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    Density found{unknown, unknown, unknown, unknown, {}};
    std::vector<std::uint32_t> counts;
    double sum = 0, squares = 0;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        const std::uint32_t count = cells.count(cell);
        const auto place = static_cast<std::size_t>(std::bit_width(count));
        if (place >= found.histogram.size()) found.histogram.resize(place + 1);
        ++found.histogram[place];
        if (count == 0) continue;
        counts.push_back(count);
        sum += count;
    }
    if (cells.cell_count() == 0) return found;
    const auto n = static_cast<double>(counts.size());
    found.empty = 1 - n / cells.cell_count();
    if (counts.empty()) return found;
    found.mean = sum / n;
    for (const std::uint32_t count : counts) squares += (count - found.mean) * (count - found.mean);
    found.deviation = std::sqrt(squares / n) / found.mean;
    std::sort(counts.begin(), counts.end());
    const std::size_t half = counts.size() / 2;
    found.median = counts.size() % 2 == 1 ? counts[half] : (double{1} * counts[half - 1] + counts[half]) / 2;
    return found;
}

template Density density<2>(const CellComplex<2>&);
template Density density<3>(const CellComplex<3>&);

}  // namespace sightline
