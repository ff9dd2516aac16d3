// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/gem_table.h"

#include <cmath>

#include "lab/report/claims.h"
#include "lab/report/page.h"

namespace sightline::lab {

Spread right_pixels(const Row& row) {
    std::vector<double> right;
    for (const Values& v : row.values)
        if (!std::isnan(v[Measure::wrong])) right.push_back(1 - v[Measure::wrong]);
    return spread(right);
}

TextTable gem_table(const Results& results) {
    TextTable table{{"scene, path", "method", "budget", "Hz", "of three in four", "right pixels %", "of three in four"},
                    {}};
    for (const Row& row : results.rows) {
        const char* const theirs = papers_name(row.scene);
        if (!theirs || std::string_view(theirs) != "PLANT" || part_of_path(row.path)) continue;
        if (row.method.id() != "layers" && row.method.id() != "cplp") continue;
        const Spread rate = hz(row), right = right_pixels(row);
        table.rows.push_back({row.scene + ", " + row.path, method_text(row.method), row.budget, number(rate.mean),
                              number(rate.lower_quartile), per_cent(right.mean), per_cent(right.lower_quartile)});
    }
    if (!table.rows.empty())
        table.rows.insert(table.rows.begin(),
                          {{"power plant (gem)", "PLP by layers", "1.08%", "10.1", "9.3", "96.3", "94.9"},
                           {"power plant (gem)", "cPLP", "1.08%", "2.1", "1.5", "–", "–"}});
    return table;
}

}  // namespace sightline::lab
