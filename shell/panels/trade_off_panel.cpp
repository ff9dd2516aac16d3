// Speed against accuracy of every method at every budget; the window draws the chart over these lines.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/session/settings_table.h"
#include "shell/desk/measure_trade_off.h"
#include "shell/panels/panel_table.h"

namespace sightline {

namespace {

std::string per_cent(double share) { return std::isnan(share) ? "none" : short_number(100 * share) + " %"; }

}  // namespace

template <int D>
std::vector<Row> trade_off_rows(const Workbench<D>& bench) {
    const TradeOff<D>& trade_off = bench.trade_off;
    const TradeOffStudy<D>& study = trade_off.study;
    if (!study.task().scene)
        return {
            {"Speed against accuracy in this scene, measured while this panel is open; `trade-off finish` measures "
             "it all at once",
             Tone::faint}};
    std::vector<Row> rows{{study.task().scene->id + ", " + trade_off.path, Tone::heading}};
    Row progress{study.finished() ? "measured all " + std::to_string(study.total())
                                  : "measured: " + trade_off_progress_text(bench)};
    if (!study.finished()) {
        progress.command = trade_off.stopped ? "trade-off go" : "trade-off stop";
        progress.text += trade_off.stopped ? " (click to continue)" : " (click to stop)";
    }
    rows.push_back(std::move(progress));
    if (const std::string work = trade_off_work_text(bench); !work.empty()) rows.push_back({work, Tone::faint});
    if (!trade_off.word.empty()) rows.push_back({trade_off.word, Tone::lit});
    const std::vector<std::size_t> front = pareto_dots(bench);
    for (std::size_t i = 0; i < study.dots().size(); ++i) {
        const TradeOffDot& dot = study.dots()[i];
        const double ms = study.value(dot, Measure::total_ms);
        const Variant<D>& variant = study.task().variants[dot.variant];
        const bool is_best = std::find(front.begin(), front.end(), i) != front.end();
        Row row{variant.text + " " + budget_text(dot.budget) + ": "};
        row.text += std::isnan(ms) ? "…"
                                   : milliseconds_text(ms) + ", wrong " + per_cent(study.value(dot, Measure::wrong)) +
                                         ", coverage " + per_cent(study.value(dot, Measure::coverage));
        if (is_best) row.text += ", Pareto";
        const bool now = is_current(bench, dot);
        row.tone = now ? Tone::lit : is_best ? Tone::good : Tone::plain;
        if (now) row.text += " (now)";
        row.command = trade_off_command(bench, dot);
        row.tip =
            std::string(variant.method.sentence) +
            (variant.method.promise_with(variant.parameters) == Misses::may ? " [approximate]" : " [conservative]") +
            ". Click to set this method and budget.";
        rows.push_back(std::move(row));
    }
    const ImageSize reference = image_size<D>(study.task().reference_size);
    const std::string size = D == 2 ? std::to_string(reference.width) + " pixels" : image_size_text(reference);
    rows.push_back({"Time: " + trade_off_time_text(bench) +
                        (study.task().time_drawing ? ", off screen at " + size : "") +
                        ", median of 3 runs of this program; times differ from run to run. Accuracy: mean over " +
                        "frames against " + (D == 2 ? "an item buffer of " : "the item buffer ") + size + ".",
                    Tone::faint});
    rows.push_back({"measure again from the start", Tone::faint, "trade-off restart"});
    return rows;
}

template std::vector<Row> trade_off_rows<2>(const Workbench<2>&);
template std::vector<Row> trade_off_rows<3>(const Workbench<3>&);

}  // namespace sightline
