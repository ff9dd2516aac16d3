// What charts on the page show: the trade-off of speed and accuracy, as far as it is measured.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "shell/desk/measure_trade_off.h"
#include "web/core/json_text.h"
#include "web/core/look.h"

namespace sightline {

namespace {

/// A browser's clock shows no less to a page.
constexpr double clock_ms = 0.1;

constexpr auto chart_marker_words =
    std::to_array<std::string_view>({"circle", "square", "triangle", "diamond", "triangle_down", "pentagon"});
static_assert(chart_marker_words.size() == marker_count);

template <int D>
void put_trade_off(JsonText& json, const Workbench<D>& bench) {
    const TradeOffStudy<D>& study = bench.trade_off.study;
    if (!study.task().scene) return;
    const bool coverage = bench.trade_off.shown == Measure::coverage;
    json.member("time", trade_off_time_text(bench) + ", in this browser");
    json.member("share", coverage ? "coverage, %" : "wrong pixels, %");
    const std::vector<VariantLook> looks = trade_off_looks(bench);
    const std::vector<std::size_t> best = pareto_dots(bench);
    json.name("dots").array();
    for (std::size_t i = 0; i < study.dots().size(); ++i) {
        const TradeOffDot& dot = study.dots()[i];
        const double told = study.value(dot, Measure::total_ms), share = study.value(dot, bench.trade_off.shown);
        if (!std::isfinite(told) || std::isnan(share)) continue;
        const double ms = std::max(told, clock_ms / 2);
        const VariantLook& look = looks[dot.variant];
        json.object()
            .member("ms", ms)
            .member("share", 100 * share)
            .member("variant", study.task().variants[dot.variant].text)
            .member("budget", budget_text(dot.budget))
            .member("primitives", dot.budget.primitives(study.task().scene->primitives.size()))
            .member("colour", hex_colour(look.colour))
            .member("marker", chart_marker_words[static_cast<std::size_t>(look.marker)])
            .member("filled", look.filled)
            .member("best", std::find(best.begin(), best.end(), i) != best.end())
            .member("now", is_current(bench, dot))
            .member("command", trade_off_command(bench, dot))
            .end_object();
    }
    json.end_array();
}

}  // namespace

std::string trade_off_json(Page& page) {
    JsonText json;
    json.object();
    with_bench(page, [&](auto& on) { put_trade_off(json, on.bench); });
    return json.end_object().take();
}

}  // namespace sightline
