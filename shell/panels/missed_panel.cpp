// What the run misses: wrong regions and the primitives in them, the worst first; a click says why.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/session/headline.h"
#include "core/session/missed.h"
#include "shell/desk/faults.h"
#include "shell/panels/panel_table.h"

namespace sightline {

namespace {

constexpr std::size_t most_regions = 30, most_primitives = 30;

template <int D>
std::string counted_primitives(std::size_t count) {
    return counted(count, D == 2 ? "segment" : "triangle");
}

}  // namespace

template <int D>
std::vector<Row> missed_rows(const Workbench<D>& bench) {
    if (bench.session.flying()) return {{"Flying", Tone::heading}, {"press F to freeze a frame and look into it"}};
    if (!tells_truth(bench.session)) return {{"What is visible is hidden: Shift+H tells it", Tone::faint}};
    const Faults* const found = faults(bench);
    if (!found) return {{"Missed", Tone::heading}, {"measured when nothing moves", Tone::faint}};
    const Missed& missed = found->missed;
    if (missed.primitives.empty()) {
        const std::size_t levels = bench.session.traversal().stand_ins().size();
        if (levels == 0) return {{"Nothing is missed", Tone::heading}, {"the run renders all that is visible"}};
        return {{"No object is missed", Tone::heading},
                {counted(levels, "object") + (levels == 1 ? " is" : " are") + " drawn at a level of detail; " +
                 percent_text(missed.share()) + " of the pixels show another object than they should"}};
    }
    std::vector<Row> rows{{"Missed at the end of the run", Tone::heading}};
    rows.push_back({percent_text(missed.share()) + " of the pixels are wrong, in " +
                        counted(missed.regions.size(), "region") + "; " +
                        counted_primitives<D>(missed.primitives.size()) + " missed",
                    Tone::bad});
    if (!missed.regions.empty()) rows.push_back({"Wrong regions, largest first", Tone::heading});
    for (std::size_t i = 0; i < std::min(missed.regions.size(), most_regions); ++i) {
        const WrongRegion& region = missed.regions[i];
        std::string text = std::to_string(i + 1) + ": " + counted(region.pixels, "pixel") + ", " +
                           primitive_name(bench.session.scene(), region.primitives.front().primitive);
        if (region.primitives.size() > 1) text += " and " + std::to_string(region.primitives.size() - 1) + " more";
        Row& row = rows.emplace_back(Row{std::move(text)});
        row.command = "missed " + std::to_string(i + 1);
        row.tip =
            region_words<D>(region) + ". A click goes to the end of the run, selects it and says why it is missed.";
        row.indent = 1;
    }
    if (missed.regions.size() > most_regions)
        rows.push_back({counted(missed.regions.size() - most_regions, "smaller region"), Tone::faint});
    rows.push_back({D == 2 ? "Segments" : "Triangles", Tone::heading});
    for (std::size_t i = 0; i < std::min(missed.primitives.size(), most_primitives); ++i) {
        const PixelCount& one = missed.primitives[i];
        Row& row = rows.emplace_back(
            Row{primitive_name(bench.session.scene(), one.primitive) + ": " + counted(one.pixels, "pixel")});
        row.command = "run; select primitive:" + std::to_string(one.primitive) + "; show why";
        row.indent = 1;
    }
    if (missed.primitives.size() > most_primitives)
        rows.push_back({std::to_string(missed.primitives.size() - most_primitives) + " more", Tone::faint});
    return rows;
}

template std::vector<Row> missed_rows<2>(const Workbench<2>&);
template std::vector<Row> missed_rows<3>(const Workbench<3>&);

}  // namespace sightline
