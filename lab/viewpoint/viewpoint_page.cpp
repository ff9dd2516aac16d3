// What a walk by viewpoint found, as a page of documentation.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "lab/report/page.h"
#include "lab/report/papers_tables.h"
#include "lab/viewpoint/viewpoint_report.h"

namespace sightline::lab {

namespace {

namespace fs = std::filesystem;

TextTable claims_table(const ViewpointResults& results) {
    TextTable table{{"they", "we", ""}, {}};
    for (const Claim& claim : viewpoint_claims(results)) {
        std::string ours;
        for (const Regime& regime : claim.regimes) ours += (ours.empty() ? "" : "; ") + regime_text(claim, regime);
        table.rows.push_back({claim.text + " (" + claim.source + "; " + claim.test + ")", ours, verdict_text(claim)});
    }
    return table;
}

std::vector<std::string> walk_row(const ViewpointScene& scene, const std::string& name,
                                  const std::function<const FrameTime&(const WalkFrame&)>& of) {
    const ViewpointWalk& walk = scene.walk;
    double ms = 0, cull = 0, drawn = 0, wrong = 0, worst = 0;
    const double n = static_cast<double>(walk.frames.size());
    for (const WalkFrame& frame : walk.frames) {
        const FrameTime& time = of(frame);
        ms += time.ms() / n;
        cull += time.cull_ms / n;
        drawn += time.drawn / n;
        wrong += time.wrong / n;
        worst = std::max(worst, time.ms());
    }
    std::vector<std::string> row{name, number(ms), number(cull)};
    for (const EyePlace where : {EyePlace::inside, EyePlace::street, EyePlace::above})
        row.push_back(number(walk.mean_at(where, [&](const WalkFrame& frame) { return of(frame).ms(); })));
    row.insert(row.end(), {number(worst), short_number(drawn), per_cent(wrong)});
    return row;
}

TextTable walk_table(const ViewpointScene& scene) {
    TextTable table{{"technique", "mean, ms", "of it culling", "in rooms", "on the ground", "above the roofs", "worst",
                     "drawn", "wrong pixels %"},
                    {}};
    table.rows.push_back(
        walk_row(scene, "everything", [](const WalkFrame& f) -> const FrameTime& { return f.everything; }));
    for (std::size_t i = 0; i < scene.options().size(); ++i)
        table.rows.push_back(walk_row(scene, scene.options()[i].text,
                                      [i](const WalkFrame& f) -> const FrameTime& { return f.alone[i]; }));
    table.rows.push_back(
        walk_row(scene, "by viewpoint", [](const WalkFrame& f) -> const FrameTime& { return f.adaptive; }));
    table.rows.push_back(walk_row(scene, "the best of each frame, with hindsight",
                                  [](const WalkFrame& f) -> const FrameTime& { return f.alone[f.best()]; }));
    return table;
}

TextTable fits_table(const ViewpointScene& scene) {
    TextTable table{{"reading", "vertex, ns", "pixel, ns", "r² of drawing", "r² of whole frames"}, {}};
    for (const Calibration& fitted : scene.fits)
        table.rows.push_back({std::string(word(fitted.reading)), number(fitted.cost.vertex_ns),
                              number(fitted.cost.pixel_ns), number(fitted.r2_draw), number(fitted.r2)});
    return table;
}

TextTable sizes_table(const ViewpointScene& scene) {
    TextTable table{
        {"intervals", "entries", "worked out in, s", "file, KiB", "of the scene %", "regions merged", "entries merged"},
        {}};
    for (const TableSize& size : scene.sizes)
        table.rows.push_back({std::to_string(size.azimuths) + " × " + std::to_string(size.elevations) + " + 2",
                              std::to_string(size.merged.entries), number(size.seconds),
                              number(static_cast<double>(size.file_bytes) / 1024),
                              per_cent(static_cast<double>(size.file_bytes) / static_cast<double>(scene.scene_bytes)),
                              std::to_string(size.merged.merged_regions), std::to_string(size.merged.merged_entries)});
    return table;
}

/// Writes the SVG alone.
std::string chart_on_page(const Chart& chart, const fs::path& images, const std::string& stem, const std::string& words,
                          const ChartFormat& format) {
    write_chart(chart, images / stem, format);
    for (const char* const other : {".gp", ".png", ".pdf"}) fs::remove(images / (stem + other));
    return "![" + words + "](images/" + stem + ".svg)\n\n";
}

std::string part_of(const ViewpointScene& scene, const fs::path& images, const ChartFormat& format) {
    const ViewpointTable<3>& table = *scene.table;
    const std::string stem = file_stem("results-viewpoint-" + scene.scene + "-" + scene.path);
    std::string text =
        "## " + scene.scene + ", path " + scene.path + "\n\n" + counted(scene.primitives, "triangle") + ", " +
        counted(scene.walk.frames.size(), "frame") + "; " + counted(table.regions().count(), "region") + " × " +
        counted(table.directions().count(), "interval") + ". A look-up takes " + short_number(scene.walk.look_up_ns) +
        " ns; the choice changed " + counted(scene.walk.switches, "time") + ".";
    if (scene.fill.seconds > 0)
        text +=
            " All " + std::to_string(table.size()) + " entries were worked out in " + short_number(scene.fill.seconds) +
            " s; as a file they take " +
            short_number(100.0 * static_cast<double>(scene.fill.file_bytes) / static_cast<double>(scene.scene_bytes)) +
            " % of the scene's primitives.";
    text += "\n\n" + markdown(walk_table(scene)) + "\n" +
            chart_on_page(walk_chart(scene), images, stem, "Time of each frame, by technique and by viewpoint", format);
    if (!scene.fits.empty())
        text += "The cost model, fitted in both readings:\n\n" + markdown(fits_table(scene)) + "\n";
    if (!scene.sizes.empty())
        text += "Tables with more and more intervals (azimuths × elevations, and a cap at each pole):\n\n" +
                markdown(sizes_table(scene)) + "\n" +
                chart_on_page(table_sizes_chart(scene), images, stem + "-sizes", "Bytes of the table by its intervals",
                              format);
    return text;
}

}  // namespace

void write_viewpoint_page(const ViewpointResults& results, const std::string& command, const fs::path& file,
                          const ChartFormat& format) {
    const Conditions& c = results.conditions;
    const fs::path images = file.parent_path() / "images";
    fs::create_directories(images);
    std::string text =
        "# Choice by viewpoint\n\nMade by\n\n```sh\n" + command + "\n```\n\n" + c.machine + "; " + c.build + "; " +
        c.renderer + "; " + c.date + ". " + image_size_text(results.image) + ", no budget, median of " +
        std::to_string(results.repeats) +
        ", techniques one after the other in every frame. Milliseconds are culling, upload and drawing, "
        "without those of an empty frame. Wrong pixels are held against the image of everything; where "
        "levels stand in, by objects. [Measuring](measuring.md#choice-by-viewpoint) says what each number "
        "is.\n\nThe paper measured a Pentium III with a GeForce 256, and its model is not to be had: "
        "shapes are compared, not figures.\n\n" +
        markdown(claims_table(results)) + "\n";
    for (const ViewpointScene& scene : results.scenes) text += part_of(scene, images, format);
    while (text.ends_with("\n\n")) text.pop_back();
    write_file(file, text);
}

}  // namespace sightline::lab
