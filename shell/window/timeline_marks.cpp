// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/timeline_marks.h"

#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "shell/desk/compare.h"

namespace sightline {

static_assert(mark_looks.size() == static_cast<std::size_t>(MarkKind::count));

template <int D>
std::vector<TimelineMark> timeline_marks(const Workbench<D>& bench, const std::vector<Marker>& found) {
    std::vector<TimelineMark> marks;
    for (const Marker& marker : found) {
        if (marker.kind == Marker::Kind::penalty) marks.push_back({marker.step, MarkKind::penalty, marker.label});
        if (marker.kind == Marker::Kind::mis_ranked) marks.push_back({marker.step, MarkKind::mis_ranked, marker.label});
        if (marker.kind == Marker::Kind::unreached) marks.push_back({marker.step, MarkKind::unreached, marker.label});
        if (marker.kind == Marker::Kind::first_wrong)
            marks.push_back({marker.step, MarkKind::first_wrong, marker.label});
        if (marker.kind == Marker::Kind::pop) marks.push_back({marker.step, MarkKind::pop, marker.label});
    }
    for (const std::uint32_t step : bench.marked) marks.push_back({step, MarkKind::matched, ""});
    for (const Breakpoint& breakpoint : bench.session.breakpoints) {
        const std::string_view condition = breakpoint.condition;
        if (!condition.starts_with("step:")) continue;
        if (const auto step = parse_whole(condition.substr(5)))
            marks.push_back({*step, MarkKind::breakpoint, breakpoint.on ? "" : "off"});
    }
    for (const Bookmark& bookmark : bench.session.bookmarks)
        marks.push_back({bookmark.step, MarkKind::bookmark, bookmark.label});
    if (bench.other)
        if (const std::uint32_t step = first_difference(bench).step; step != none)
            marks.push_back({step, MarkKind::difference, ""});
    std::erase_if(marks, [&](const TimelineMark& mark) { return mark.step > bench.session.recorded(); });
    std::stable_sort(marks.begin(), marks.end(), [](const TimelineMark& a, const TimelineMark& b) {
        return a.kind != b.kind ? a.kind < b.kind : a.step < b.step;
    });
    return marks;
}

std::vector<MarkGroup> mark_groups(const StepAxis& axis, const std::vector<TimelineMark>& marks, float size,
                                   float stroke) {
    std::vector<MarkGroup> groups;
    const auto stretch = [&](float x) { return std::floor((x - axis.x) / stroke); };
    for (std::uint32_t i = 0; i < marks.size(); ++i) {
        const float x = middle_of_step(axis, marks[i].step);
        if (x < axis.x - 0.5f || x > axis.x + axis.w + 0.5f) continue;
        MarkGroup* const before = groups.empty() || groups.back().kind != marks[i].kind ? nullptr : &groups.back();
        if (before && stretch(before->x) == stretch(x)) {
            ++before->count;
            continue;
        }
        const bool crowded = before && x - before->x < size;
        if (crowded) before->crowded = true;
        groups.push_back({marks[i].kind, x, i, 1, crowded});
    }
    return groups;
}

template std::vector<TimelineMark> timeline_marks<2>(const Workbench<2>&, const std::vector<Marker>&);
template std::vector<TimelineMark> timeline_marks<3>(const Workbench<3>&, const std::vector<Marker>&);

}  // namespace sightline
