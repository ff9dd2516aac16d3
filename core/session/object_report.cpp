// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/object_report.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/raster/occlusion_image.h"
#include "core/run/drawn_levels.h"

namespace sightline {

namespace {

template <int D>
std::vector<BoxSight> looks_of_boxes(const Session<D>& session, const Objects& objects) {
    const Problem<D>& problem = session.problem();
    std::vector<Box<D>> boxes(objects.names.size());
    for (std::uint32_t p = 0; p < objects.of.size(); ++p)
        for (const Vec<D>& corner : problem.primitives()[p]) boxes[objects.of[p]].add(corner);
    OcclusionImage<D> image;
    image.begin(session.scene(), problem.view, image_size<D>(session.settings().reference_size));
    std::vector<std::uint32_t> all;
    for (std::uint32_t p = 0; p < objects.of.size(); ++p)
        if (shows(problem, p)) all.push_back(p);
    std::vector<std::uint8_t> won(all.size());
    image.draw(all, won);
    image.refresh();
    std::vector<BoxSight> looks;
    for (const Box<D>& box : boxes) looks.push_back(image.look(box));
    return looks;
}

}  // namespace

template <int D>
std::vector<ObjectReport> object_reports(const Session<D>& session) {
    const Objects& objects = session.objects();
    const Reference& reference = session.reference();
    const std::vector<std::uint32_t>& pixels = reference.pixels;
    const std::vector<std::uint8_t> rendered = found_mask(session.traversal());
    const std::vector<BoxSight> looks = looks_of_boxes(session, objects);
    std::vector<ObjectReport> reports(objects.names.size());
    for (std::uint32_t object = 0; object < reports.size(); ++object) {
        reports[object].object = object;
        reports[object].box = looks[object];
    }
    for (std::uint32_t p = 0; p < objects.of.size(); ++p) {
        ObjectReport& report = reports[objects.of[p]];
        ++report.primitives;
        report.visible += reference.visible[p];
        report.rendered += rendered[p];
        report.missed += reference.visible[p] && !rendered[p];
        report.pixels += pixels[p];
        report.wrong += rendered[p] ? 0 : pixels[p];
    }
    for (std::uint32_t step = 1; step <= session.position(); ++step)
        for_rendered(session.timeline().met_in(step, session.met()), [&](std::uint32_t p) {
            ObjectReport& report = reports[objects.of[p]];
            if (report.first_step == 0) report.first_step = step;
            report.last_step = step;
        });
    return reports;
}

template <int D>
std::string verdict_words(const ObjectReport& report) {
    constexpr std::string_view kind = D == 2 ? "segment" : "triangle";
    if (report.missed > 0)
        return "missed: " + std::to_string(report.missed) + " of " +
               counted(report.visible, "visible " + std::string(kind));
    if (report.visible > 0) {
        const std::uint32_t vain = report.rendered - report.visible;
        return "visible and drawn" + (vain > 0 ? ", " + counted(vain, kind) + " in vain" : "");
    }
    if (report.rendered > 0) return "hidden, " + counted(report.rendered, kind) + " drawn in vain";
    return report.box == BoxSight::outside ? "outside the view" : "hidden and not drawn";
}

void sort_by_fault(std::vector<ObjectReport>& reports) {
    std::stable_sort(reports.begin(), reports.end(), [](const ObjectReport& a, const ObjectReport& b) {
        const auto vain = [](const ObjectReport& r) { return r.rendered + r.missed - r.visible; };
        if (a.wrong != b.wrong) return a.wrong > b.wrong;
        if (a.missed != b.missed) return a.missed > b.missed;
        return vain(a) > vain(b);
    });
}

#define SIGHTLINE_INSTANTIATE(D)                                             \
    template std::vector<ObjectReport> object_reports<D>(const Session<D>&); \
    template std::string verdict_words<D>(const ObjectReport&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
