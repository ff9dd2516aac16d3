// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/remaining.h"

#include <algorithm>

#include "core/base/number.h"

namespace sightline::lab {

void Remaining::done(double parts) {
    left_ -= parts;
    done_ += parts;
}

std::string Remaining::text_after(double seconds) const {
    if (done_ <= 0) return {};
    return ", about " + duration_text(seconds / done_ * std::max(left_, 0.0)) + " left";
}

}  // namespace sightline::lab
