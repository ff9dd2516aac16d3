// Objects, as engines cull them: what is missed and what is drawn in vain of each, and what its box says.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/session/headline.h"
#include "shell/desk/faults.h"
#include "shell/panels/panel_table.h"

namespace sightline {

namespace {

constexpr std::size_t most_objects = 100;
constexpr std::array<std::string_view, 3> box_words{"its box is outside the view", "its box is hidden",
                                                    "its box is seen"};

/// What whole objects would cost: those whose box is seen, all of each.
std::string whole_objects(const std::vector<ObjectReport>& objects) {
    std::size_t drawn = 0, primitives = 0;
    for (const ObjectReport& object : objects)
        if (object.box == BoxSight::seen) {
            ++drawn;
            primitives += object.primitives;
        }
    return "culled whole, by their boxes against the exact depth: " + counted(drawn, "object") + " drawn, " +
           counted(primitives, "primitive");
}

}  // namespace

template <int D>
std::vector<Row> object_rows(const Workbench<D>& bench) {
    if (bench.session.flying()) return {{"Flying", Tone::heading}, {"press F to freeze a frame and look into it"}};
    if (!tells_truth(bench.session)) return {{"What is visible is hidden: Shift+H tells it", Tone::faint}};
    const Faults* const found = faults(bench);
    if (!found || !found->objects) return {{"Objects", Tone::heading}, {"measured when nothing moves", Tone::faint}};
    const std::vector<ObjectReport>& objects = *found->objects;
    const Objects& names = bench.session.objects();
    std::vector<Row> rows{
        {counted(objects.size(), bench.session.scene().objects.empty() ? "part" : "object") + " at the end of the run",
         Tone::heading}};
    if (bench.session.scene().objects.empty())
        rows.push_back({"the scene names none: these are the parts that hang together", Tone::faint});
    std::uint32_t rendered = 0;
    for (const ObjectReport& object : objects) rendered += object.rendered;
    rows.push_back({"this run: " + counted(rendered, "primitive") + " drawn"});
    rows.push_back({whole_objects(objects), Tone::faint});
    rows.push_back({"Most wrong pixels first", Tone::heading});
    for (std::size_t i = 0; i < std::min(objects.size(), most_objects); ++i) {
        const ObjectReport& object = objects[i];
        std::string text = names.names[object.object] + ": " + verdict_words<D>(object);
        if (object.wrong > 0) text += ", " + counted(object.wrong, "wrong pixel");
        Row& row = rows.emplace_back(Row{std::move(text)});
        row.tone = object.missed > 0 ? Tone::bad : object.visible > 0 ? Tone::good : Tone::faint;
        row.command = "select object:#" + std::to_string(object.object) + "; show why";
        row.indent = 1;
        row.tip = counted(object.primitives, "primitive") + ", " + std::to_string(object.visible) + " visible, " +
                  std::to_string(object.rendered) + " drawn" +
                  (object.first_step > 0
                       ? " in steps " + std::to_string(object.first_step) + " to " + std::to_string(object.last_step)
                       : "") +
                  ", " + counted(object.pixels, "pixel") + "; " +
                  std::string(box_words[static_cast<std::size_t>(object.box)]);
    }
    if (objects.size() > most_objects)
        rows.push_back({std::to_string(objects.size() - most_objects) + " more", Tone::faint});
    return rows;
}

template std::vector<Row> object_rows<2>(const Workbench<2>&);
template std::vector<Row> object_rows<3>(const Workbench<3>&);

}  // namespace sightline
