// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/key_chart.h"

#include <algorithm>

#include "core/base/number.h"
#include "core/measure/frame_numbers.h"
#include "core/measure/rank_correlation.h"
#include "core/truth/software_ids.h"
#include "core/truth/truth.h"
#include "lab/measure/measure_path.h"
#include "lab/report/method_looks.h"

namespace sightline::lab {

namespace {

constexpr std::size_t most_dots = 4000;

}  // namespace

Chart key_chart(const std::string& heading, const KeysAndShares& popped, const Series& look) {
    const double r = rank_correlation(popped.keys, popped.shares);
    Chart chart;
    chart.title = heading + ": rank correlation " + (r == r ? short_number(r) : "none") + " over " +
                  std::to_string(popped.keys.size()) + " cells";
    chart.x = "key of the cell when it was popped";
    chart.y = "visible share of the cell, %";
    Series dots = look;
    dots.name.clear();
    dots.shown = Series::Shown::markers;
    const std::size_t stride = (popped.keys.size() + most_dots - 1) / most_dots;
    for (std::size_t i = 0; i < popped.keys.size(); i += stride)
        dots.points.push_back({popped.keys[i], 100 * popped.shares[i]});
    chart.series.push_back(std::move(dots));
    return chart;
}

template <int D>
std::vector<NamedChart> key_charts(const LabScene<D>& lab, const Group& group, const DrawIds& draw_ids) {
    std::vector<NamedChart> charts;
    std::vector<const Row*> rows;  // each method's with the largest budget
    for (const Row* const row : group.rows) {
        const Method<D>* const method = method_of<D>(lab.tables, row->method);
        if (!method || !method->orders_cells() || row->values.empty()) continue;
        const auto same =
            std::find_if(rows.begin(), rows.end(), [&](const Row* other) { return other->method == row->method; });
        if (same == rows.end())
            rows.push_back(row);
        else if (row->values.front()[Measure::budget] > (*same)->values.front()[Measure::budget])
            *same = row;
    }
    const MethodLooks looks = MethodLooks::of(group.rows);
    const std::size_t frame = lab.views.size() / 2;
    for (const Row* const row : rows) {
        if (frame >= row->values.size()) continue;
        const CellComplex<D>* const cells = &lab.on(row->method.tessellation);
        const Truth truth =
            std::move(make_truths<D>(*lab.scene, {&cells, 1}, lab.views[frame], lab.settings.reference_size,
                                     drawing_of(lab.settings.reference, draw_ids), false)
                          .front());
        const Variant<D> variant = lab.variant_for(row->method);
        Problem<D> problem =
            make_problem(variant.method, variant.parameters, *lab.scene, *cells, lab.views[frame], none,
                         known_services(std::make_shared<std::vector<std::uint8_t>>(truth.reference.visible),
                                        lab.settings.reference_size));
        problem.budget = static_cast<std::uint32_t>(row->values[frame][Measure::budget]);
        problem.history = frame_history<D>(variant.method, problem, lab.before[frame]);
        const WholeRun run = whole_run<D>(variant.method, problem, truth.reference, false);
        const KeysAndShares popped = keys_and_shares(run, truth.reference, cut_at(run, problem.budget).steps);
        if (popped.keys.size() < 3) continue;
        const std::string name = method_text(row->method);
        charts.push_back({group.scene, group.path, file_stem(group.scene + "-" + group.path + "-keys-" + name),
                          "Does a low key mean that much is seen? A dot for each popped cell, those of the frame in "
                          "the middle; a correlation of -1 would be a key that knows.",
                          key_chart(group.scene + ", path " + group.path + ", frame " +
                                        std::to_string(row->frames[frame]) + ", " + name + " " + row->budget,
                                    popped, looks.series(row->method))});
    }
    return charts;
}

template std::vector<NamedChart> key_charts<2>(const LabScene<2>&, const Group&, const DrawIds&);
template std::vector<NamedChart> key_charts<3>(const LabScene<3>&, const Group&, const DrawIds&);

}  // namespace sightline::lab
