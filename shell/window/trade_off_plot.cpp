// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/trade_off_plot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/number.h"

namespace sightline {

namespace {

/// The largest of 1, 2 and 5 times a power of ten that is not above `value`.
double round_below(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    return power * (value >= 5 * power ? 5 : value >= 2 * power ? 2 : 1);
}

double next_round(double value) { return round_below(value * 2.6); }

}  // namespace

template <int D>
TradeOffPlot trade_off_plot(const Workbench<D>& bench, const Area& area) {
    const TradeOffStudy<D>& study = bench.trade_off.study;
    const Measure measure = bench.trade_off.shown;
    TradeOffPlot plot;
    plot.area = area;
    std::vector<Trade> trades;
    double least = 0, most = 0, highest = 0;
    for (std::size_t i = 0; i < study.dots().size(); ++i) {
        const Trade trade{study.value(study.dots()[i], Measure::total_ms), 100 * study.value(study.dots()[i], measure)};
        if (!(trade.ms > 0) || std::isnan(trade.value)) continue;
        least = trades.empty() ? trade.ms : std::min(least, trade.ms);
        most = std::max(most, trade.ms);
        highest = std::max(highest, trade.value);
        trades.push_back(trade);
        plot.dots.push_back({i, {}});
    }
    if (trades.empty()) return plot;
    const double from = std::log(least / 1.3), to = std::log(most * 1.3);
    const double top = measure == Measure::coverage ? 104 : std::max(highest * 1.06, 0.01);
    const auto x = [&](double ms) { return area.x + area.w * static_cast<float>((std::log(ms) - from) / (to - from)); };
    const double under = 0.05 * top;  // dots on the axis stand inside
    const auto y = [&](double share) { return area.y + area.h * static_cast<float>((top - share) / (top + under)); };
    for (std::size_t i = 0; i < trades.size(); ++i) plot.dots[i].at = {x(trades[i].ms), y(trades[i].value)};
    const auto place = [&](const TradeOffPlot::Dot& dot) {
        const TradeOffDot& of = study.dots()[dot.index];
        return std::pair(of.variant, of.budget.primitives(study.task().scene->primitives.size()));
    };
    std::stable_sort(plot.dots.begin(), plot.dots.end(),
                     [&](const auto& a, const auto& b) { return place(a) < place(b); });
    // 1, 2, 5, 10, or where that would be too many, powers of ten only.
    const bool decades = most / least > 300;
    for (double ms = round_below(least / 1.3); ms <= most * 1.3; ms = decades ? ms * 10 : next_round(ms)) {
        if (decades) ms = std::pow(10, std::floor(std::log10(ms) + 1e-9));
        if (ms >= least / 1.3) plot.times.push_back({x(ms), short_number(ms)});
    }
    const double step = round_below(top / 4);
    for (int i = 0; i * step <= top; ++i) plot.shares.push_back({y(i * step), short_number(i * step)});
    return plot;
}

const TradeOffPlot::Dot* dot_at(const TradeOffPlot& plot, const ImVec2& mouse, float reach) {
    const TradeOffPlot::Dot* found = nullptr;
    float nearest = reach * reach;
    for (const TradeOffPlot::Dot& dot : plot.dots) {
        const float dx = dot.at.x - mouse.x, dy = dot.at.y - mouse.y, distance = dx * dx + dy * dy;
        if (distance > nearest) continue;
        nearest = distance;
        found = &dot;
    }
    return found;
}

template TradeOffPlot trade_off_plot<2>(const Workbench<2>&, const Area&);
template TradeOffPlot trade_off_plot<3>(const Workbench<3>&, const Area&);

}  // namespace sightline
