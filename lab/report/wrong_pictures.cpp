// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/wrong_pictures.h"

#include <algorithm>
#include <limits>

#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/quote.h"
#include "core/base/text.h"
#include "core/measure/drawn_image.h"
#include "core/measure/frame_clock.h"
#include "core/run/drawn_levels.h"
#include "core/session/session.h"
#include "core/session/settings_table.h"
#include "core/truth/software_ids.h"
#include "core/truth/truth.h"
#include "lab/report/session_figure.h"
#include "shell/figure/cairo_surface.h"
#include "shell/figure/png.h"

namespace sightline::lab {

namespace {

constexpr double screen_dpi = 96;

template <int D>
std::string point_text(const Vec<D>& p, const Vec<D>& origin) {
    std::string text;
    for (int i = 0; i < D; ++i) text += (i > 0 ? "," : "") + number_text(p[i] + origin[i]);
    return text;
}

Settings settings_of(const LabScene<2>& lab, const Row& row) {
    Settings settings = lab.settings_for(row.method);
    settings.budget = parse_budget(row.budget);
    return settings;
}

void write_picture(const LabScene<2>& lab, const Row& row, std::size_t frame, const std::filesystem::path& file,
                   LabGraphics&) {
    Session<2> session(lab.scene, lab.specs[frame], settings_of(lab, row), lab.tables.in_2d, {});
    session.run();
    write_session_figure(session, file, {});
}

void write_picture(const LabScene<3>& lab, const Row& row, std::size_t frame, const std::filesystem::path& file,
                   LabGraphics& graphics) {
    const Variant<3> variant = lab.variant_for(row.method);
    const DrawIds draw_ids = drawing_of(lab.settings.reference, graphics.draw_ids());
    const std::unique_ptr<Run<3>> run = variant.method.start(
        make_problem(variant.method, variant.parameters, *lab.scene, lab.on(row.method.tessellation), lab.views[frame],
                     static_cast<std::uint32_t>(row.values[frame][Measure::budget]),
                     exact_services(*lab.scene, lab.views[frame], lab.settings.reference_size, draw_ids)));
    run->run(none);

    SolidList list;
    list.camera = lab.views[frame];
    list.styles = {{"rendered", {200, 200, 205}}};
    list.scene = drawn_scene(*run, lab.scene);
    drawn_ids(*run, list.triangles);
    list.runs = {{0, 0, static_cast<std::uint32_t>(list.triangles.size())}};
    const ImageSize size = image_size<3>(lab.settings.reference_size);
    Reference exact;
    exact.image = std::move(draw_ids(*lab.scene, lab.views[frame], size, 1).front());
    const std::vector<std::uint8_t> wrong = wrong_mask(exact, *run, draw_ids);
    write_file(file, encode_png(image_of(wrong_in_red(list, exact.image, wrong, graphics)).get(), screen_dpi));
}

}  // namespace

Pixels wrong_in_red(const SolidList& rendered, const IdImage& exact, std::span<const std::uint8_t> wrong,
                    LabGraphics& graphics) {
    Pixels pixels = graphics.draw_solid()(rendered, exact.width, exact.height, 1);
    for (std::size_t i = 0; i < wrong.size(); ++i)
        if (wrong[i]) pixels.colours[i] = {220, 30, 30};
    return pixels;
}

template <int D>
FramePicture draw_frame(const LabScene<D>& lab, const Study& study, const Row& row, std::size_t frame,
                        const std::filesystem::path& file, LabGraphics& graphics) {
    // Results may come from anybody.
    if (frame >= row.values.size() || frame >= lab.specs.size())
        throw InputError(one_line(row.scene) + ": the results have other frames than path " + one_line(row.path));
    const double budget = row.values[frame][Measure::budget];
    if (!(budget >= 0 && budget <= std::numeric_limits<std::uint32_t>::max()))
        throw InputError(one_line(row.scene) + ": the results have a budget that is not a number of primitives");
    const ViewSpec<D>& view = lab.specs[frame];
    FramePicture drawn{
        row.scene, row.path, method_text(row.method), row.budget, row.frames[frame], row.values[frame][Measure::wrong],
        file,      {}};
    write_picture(lab, row, frame, file, graphics);
    drawn.command = "./run viewer" + std::to_string(D) + "d " + shell_quoted(parse_scene(row.scene).name) +
                    " --eye=" + point_text<D>(view.eye, lab.scene->origin) +
                    " --look-at=" + point_text<D>(view.look_at, lab.scene->origin) + " --fov " + number_text(view.fov) +
                    " --method " + shell_quoted(row.method.variant) + " --budget " + shell_quoted(row.budget);
    if (row.method.tessellation != Tessellation::delaunay)
        drawn.command += " --set tessellation=" + std::string(word(row.method.tessellation));
    if (study.size != ImageSize{})
        drawn.command += " --set reference_size=" + setting_row("reference_size").get(lab.settings);
    for (const std::string& setting : study.settings) drawn.command += " --set " + shell_quoted(setting);
    return drawn;
}

template FramePicture draw_frame<2>(const LabScene<2>&, const Study&, const Row&, std::size_t,
                                    const std::filesystem::path&, LabGraphics&);
template FramePicture draw_frame<3>(const LabScene<3>&, const Study&, const Row&, std::size_t,
                                    const std::filesystem::path&, LabGraphics&);

}  // namespace sightline::lab
