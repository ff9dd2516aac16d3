// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wrong_pictures.h"

#include <algorithm>

#include "core/file.h"
#include "core/measure/wrong_region.h"
#include "core/number.h"
#include "core/settings/settings_table.h"
#include "lab/chart.h"
#include "lab/lab_scene.h"
#include "lab/study_charts.h"
#include "shell/figure/cairo_surface.h"
#include "shell/figure/png.h"

namespace sightline::lab {

namespace {

constexpr double screen_dpi = 96;

std::string point_text(const Vec<3>& p, const Vec<3>& origin) {
    const Vec<3> q = p + origin;
    return number_text(q.x) + "," + number_text(q.y) + "," + number_text(q.z);
}

/// The row in the middle of a method's budgets.
std::vector<const Row*> middle_rows(const Group& group) {
    std::vector<const Row*> chosen;
    for (std::size_t i = 0; i < group.rows.size();) {
        std::size_t end = i;
        while (end < group.rows.size() && group.rows[end]->method == group.rows[i]->method) ++end;
        if (group.rows[i]->approximate) chosen.push_back(group.rows[i + (end - i) / 2]);
        i = end;
    }
    return chosen;
}

/// What a budget renders, and red where it should render something else.
Pixels picture(const LabScene<3>& lab, const Row& row, std::size_t frame, LabGraphics& graphics) {
    const MethodChoice& choice = row.method;
    Frame<3> f = make_frame<3>(lab.scene->primitives, lab.on(choice.tessellation), lab.views[frame],
                               lab.settings_for(choice), lab.scene->two_sided);
    f.budget = static_cast<std::uint32_t>(row.values[frame][Measure::budget]);
    const Method<3>& method = find_method<3>(method_table<3>(), choice.id);
    State<3> state;
    method.start(f, state);
    method.run(f, state, none);

    SolidList list;
    list.camera = lab.views[frame];
    list.styles = {{"rendered", {200, 200, 205}}};
    list.scene = lab.scene;
    for (const std::uint32_t entry : std::span(state.touched).first(state.touched_count))
        if (!(entry & State<3>::culled_bit)) list.triangles.push_back(entry);
    list.runs = {{0, 0, static_cast<std::uint32_t>(list.triangles.size())}};
    const ImageSize size = image_size<3>(lab.settings.reference_size);
    return missed_in_red(list, graphics.draw_ids()(*lab.scene, lab.views[frame], size, 1).front(), graphics);
}

}  // namespace

Pixels missed_in_red(const SolidList& rendered, const IdImage& exact, LabGraphics& graphics) {
    Pixels pixels = graphics.draw_solid()(rendered, exact.width, exact.height, 1);
    std::vector<std::uint8_t> mask(rendered.scene->primitives.size());
    for (const std::uint32_t id : rendered.triangles) mask[id] = 1;
    const std::vector<std::uint8_t> wrong = wrong_mask(exact, mask);
    for (std::size_t i = 0; i < wrong.size(); ++i)
        if (wrong[i]) pixels.colours[i] = {220, 30, 30};
    return pixels;
}

FramePicture draw_frame(const LabScene<3>& lab, const Study& study, const Row& row, std::size_t frame,
                        const std::filesystem::path& file, LabGraphics& graphics) {
    const ViewSpec<3>& view = lab.specs[frame];
    FramePicture drawn{
        row.scene, row.path, method_text(row.method), row.budget, row.frames[frame], row.values[frame][Measure::wrong],
        file,      {}};
    write_file(file, encode_png(image_of(picture(lab, row, frame, graphics)).get(), screen_dpi));
    drawn.command = "./run viewer3d " + parse_scene(row.scene).name + " --eye " +
                    point_text(view.eye, lab.scene->origin) + " --look-at " +
                    point_text(view.look_at, lab.scene->origin) + " --fov " + number_text(view.fov) + " --method " +
                    row.method.id + " --budget " + row.budget;
    if (row.method.tessellation == Tessellation::tree) drawn.command += " --set tessellation=tree";
    for (const std::string& setting : study.settings) drawn.command += " --set " + setting;
    return drawn;
}

std::vector<FramePicture> draw_worst_frames(const Results& results, const Study& study,
                                            const std::filesystem::path& folder, LabGraphics& graphics) {
    std::vector<FramePicture> drawn;
    std::filesystem::create_directories(folder);
    for (const Group& group : groups(results)) {
        if (parse_scene(group.scene).dimension != 3) continue;
        const LabScene<3> lab = load_lab_scene<3>(group.scene, group.path, study);
        for (const Row* row : middle_rows(group)) {
            const std::string stem = file_stem(group.scene + "-" + group.path + "-" + method_text(row->method));
            drawn.push_back(
                draw_frame(lab, study, *row, worst_frame(*row, Measure::wrong), folder / (stem + ".png"), graphics));
        }
    }
    return drawn;
}

}  // namespace sightline::lab
