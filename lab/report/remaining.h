// How long a long run still takes, out of how long its parts took so far.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/stopwatch.h"

namespace sightline::lab {

class Remaining {
public:
    /// So many parts in all, each taken to last as long as the others.
    explicit Remaining(double parts) : left_(parts) {}

    /// So many more are finished, fractions too.
    void done(double parts);
    /// The same, but they were kept from an earlier run and took no time.
    void kept(double parts) { left_ -= parts; }
    /// ", about 3 min 20 s left"; empty until something was done.
    std::string text() const { return text_after(stopwatch_.milliseconds() / 1000); }
    /// The same after this many seconds.
    std::string text_after(double seconds) const;

private:
    double left_, done_ = 0;
    Stopwatch stopwatch_;
};

}  // namespace sightline::lab
