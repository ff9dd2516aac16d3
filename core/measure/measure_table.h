// Every number that a frame is judged by, in one table: results, charts, comparisons and documentation follow it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

namespace sightline {

/// Of one frame, one method and one budget. The order is that of the columns of results.csv.
enum class Measure : std::uint8_t {
    budget,
    rendered,
    visible,
    coverage,
    coverage_px,
    oracle,
    cell_oracle,
    wrong,
    blob,
    k95,
    efficiency,
    emitted_over_visible,
    mis_ranked,
    unreached,
    zeta,
    fused,
    steps,
    zero_keys,
    key_rank,
    front,
    tested,
    rounds,
    pop,
    flip,
    visible_change,
    traverse_ms,
    upload_ms,
    draw_ms,
    total_ms,
    over_exact,
    traverse_error,
    upload_error,
    draw_error,
    total_error,
    count
};

inline constexpr std::size_t measure_count = static_cast<std::size_t>(Measure::count);

/// Wrong pixels are also counted by the distance from the eye of what the exact image shows there.
inline constexpr std::size_t distance_bins = 8;
using DistanceBins = std::array<double, distance_bins>;

/// A value per measure; NaN where there is none.
struct Values {
    std::array<double, measure_count> all;
    DistanceBins wrong_at, pixels_at;  ///< wrong pixels, and those that show something / all pixels (distance.h)
    Values() {
        constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
        all.fill(nothing);
        wrong_at.fill(nothing);
        pixels_at.fill(nothing);
    }
    double& operator[](Measure measure) { return all[static_cast<std::size_t>(measure)]; }
    double operator[](Measure measure) const { return all[static_cast<std::size_t>(measure)]; }
};

enum class Better : std::uint8_t { neither, higher, lower };

struct MeasureRow {
    Measure measure;
    std::string_view id;       ///< column and field
    std::string_view title;    ///< on axes and in tables
    std::string_view unit;     ///< "share" is of 1
    std::string_view formula;  ///< for people
    std::string_view source;
    Better better = Better::neither;
    bool is_time =
        false;  ///< or made of times: differs from run to run; summed up as the median over frames, others as the mean
    bool has_extreme = false;  ///< the worst frame has a column of its own: ID_min or ID_max
};

/// A row per measure, in their order.
std::span<const MeasureRow> measure_table();
const MeasureRow& measure_row(Measure measure);

/// The measure that says how far the repeats of a time lie apart; nothing for what is no time.
std::optional<Measure> error_of(Measure time);

}  // namespace sightline
