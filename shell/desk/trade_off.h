// The trade-off of speed and accuracy of what is on the bench, as far as it is measured.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/measure/trade_off.h"
#include "core/scene/flight_path.h"
#include "core/truth/reference_by.h"

namespace sightline {

template <int D>
struct TradeOff {
    Measure shown = Measure::wrong;  ///< against time: wrong or coverage
    bool stopped = false;            ///< by a person, or by an error
    std::string word{};              ///< why it began anew or ended; empty: nothing to say
    TradeOffStudy<D> study{};
    ReferenceBy reference{};           ///< what it is measured against
    Parameters base{};                 ///< what all methods share: the session's when it began
    std::vector<std::string> added{};  ///< variants that are measured beside the methods of the table
    std::string path{};                ///< what it goes along, for people
    std::vector<ViewSpec<D>> views{};  ///< the same as they are written down
    double spent_ms = 0;               ///< on what is measured, the frames of the window between slices included
    std::optional<Stopwatch> since{};  ///< the last slice
};

}  // namespace sightline
