// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/formula.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace sightline {

double Formula::value(std::span<const double> values) const noexcept {
    double r[registers];  // set below as far as they are read
    double* put = std::copy(numbers_.begin(), numbers_.end(), r);
    for (const std::size_t name : used_) {
        assert(name < values.size());
        *put++ = values[name];
    }
    for (const Instruction& i : program_) {
        const double a = r[i.a], b = r[i.b], c = r[i.c];
        double& to = r[i.to];
        switch (i.op) {
            case Op::negate:
                to = -a;
                break;
            case Op::negation:
                to = a == 0;
                break;
            case Op::sqrt:
                to = std::sqrt(a);
                break;
            case Op::add:
                to = a + b;
                break;
            case Op::subtract:
                to = a - b;
                break;
            case Op::multiply:
                to = a * b;
                break;
            case Op::divide:
                to = a / b;
                break;
            case Op::min:
                to = b < a ? b : a;
                break;
            case Op::max:
                to = a < b ? b : a;
                break;
            case Op::less:
                to = a < b;
                break;
            case Op::less_equal:
                to = a <= b;
                break;
            case Op::greater:
                to = a > b;
                break;
            case Op::greater_equal:
                to = a >= b;
                break;
            case Op::equal:
                to = a == b;
                break;
            case Op::unequal:
                to = a != b;
                break;
            case Op::both:
                to = a != 0 && b != 0;
                break;
            case Op::either:
                to = a != 0 || b != 0;
                break;
            case Op::choose:
                to = a != 0 ? b : c;
                break;
        }
    }
    // The sign of a NaN depends on who computed it, the compiler or the processor.
    return r[result_] == r[result_] ? r[result_] : std::numeric_limits<double>::quiet_NaN();
}

bool Formula::holds(std::span<const double> values) const noexcept {
    const double result = value(values);
    return result == result && result != 0;
}

}  // namespace sightline
