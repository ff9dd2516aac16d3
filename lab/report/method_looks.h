// How methods look in the lab's charts and tables: as everywhere (core/draw/variant_look.h), with open markers on the
// leaves of a tree of either kind.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lab/measure/study.h"
#include "lab/report/chart.h"

namespace sightline::lab {

/// Of lines that are no method's: bounds, exact sets.
inline constexpr std::array guide_dash{3.0f, 3.0f};

/// Of methods that are shown together; others look as they do alone.
class MethodLooks {
public:
    explicit MethodLooks(const std::vector<MethodChoice>& methods);
    /// Of anything that points to something with a method.
    template <typename Pointers>
    static MethodLooks of(const Pointers& rows) {
        std::vector<MethodChoice> methods;
        for (const auto& row : rows) methods.push_back(row->method);
        return MethodLooks(methods);
    }

    VariantLook look(const MethodChoice& method) const;
    /// An empty series of the method's name and look.
    Series series(const MethodChoice& method) const;
    /// Its name as a cell of a table, its look before it.
    std::string cell(const MethodChoice& method) const;

private:
    std::vector<std::string> variants_;
    std::vector<VariantLook> looks_;
};

/// A piece of line with its marker, as HTML beside a name.
std::string swatch(const VariantLook& look);

}  // namespace sightline::lab
