// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/remaining.h"

#include <algorithm>
#include <cmath>

namespace sightline::lab {

namespace {

std::string duration(double seconds) {
    const auto whole = static_cast<long>(std::lround(seconds));
    if (whole < 60) return std::to_string(whole) + " s";
    return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

}  // namespace

void Remaining::done(double parts) {
    left_ -= parts;
    done_ += parts;
}

std::string Remaining::text_after(double seconds) const {
    if (done_ <= 0) return {};
    return ", about " + duration(seconds / done_ * std::max(left_, 0.0)) + " left";
}

}  // namespace sightline::lab
