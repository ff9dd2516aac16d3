// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/gallery/gallery_pictures.h"

#include "core/base/file.h"
#include "core/base/number.h"
#include "core/draw/insets.h"
#include "core/measure/metrics.h"
#include "lab/report/session_figure.h"
#include "lab/report/wrong_pictures.h"
#include "shell/figure/cairo_surface.h"
#include "shell/figure/png.h"

namespace sightline::lab {

namespace {

namespace fs = std::filesystem;

constexpr double screen_dpi = 96;

/// Where the run ended, and what it has by then.
template <int D>
std::string end_text(const Session<D>& end, Stop stop) {
    return "Step " + std::to_string(end.position()) +
           (stop == Stop::budget ? ", the budget is spent: " : ", the end: ") +
           std::to_string(end.counters().rendered_count) + " rendered";
}

GalleryPicture step_picture(const Session<2>& step, const fs::path& stem, LabGraphics&) {
    const fs::path file = stem.string() + "-step.svg";
    return {file, write_session_figure(step, file, {})};
}
GalleryPicture step_picture(const Session<3>& step, const fs::path& stem, LabGraphics& graphics) {
    const fs::path file = stem.string() + "-step.png";
    return {file, write_session_figure(step, file, graphics.draw_solid())};
}

GalleryPicture end_picture(Session<2> end, Stop stop, const fs::path& stem, LabGraphics&) {
    Settings settings = end.settings();
    settings.legend = Legend::off;  // it stands below the other picture
    end.change(settings);
    GalleryPicture picture{stem.string() + "-end.svg", end_text(end, stop) + "."};
    write_session_figure(end, picture.file, {});
    if (const auto share = coverage(end.reference(), end.visible_rendered()))
        picture.caption += " Coverage ε = " + short_number(*share) + ".";
    return picture;
}
GalleryPicture end_picture(const Session<3>& end, Stop stop, const fs::path& stem, LabGraphics& graphics) {
    const fs::path file = stem.string() + "-end.png";
    const Pixels pixels = wrong_in_red(image_so_far(end), end.reference().image, end.wrong_mask(), graphics);
    write_file(file, encode_png(image_of(pixels).get(), screen_dpi));
    const double wrong = end.wrong_pixels();
    return {file,
            end_text(end, stop) + ". Red: visible but missed, " + short_number(100 * wrong) + " % of the pixels."};
}

}  // namespace

template <int D>
std::vector<GalleryPicture> draw_gallery_pictures(const Session<D>& session, const fs::path& folder,
                                                  const std::string& stem, LabGraphics& graphics) {
    fs::create_directories(folder);
    Session<D> step = session;
    Settings settings = step.settings();
    settings.inset = Inset::exact;  // red is what the second picture has
    step.change(settings);
    step.notes.clear();  // the page says the same beside the picture
    Session<D> end = step;
    end.selected_cell = none;
    const Stop stop = end.run();
    std::vector<GalleryPicture> pictures{step_picture(step, folder / stem, graphics)};
    if (D == 3 || end.position() > step.position()) pictures.push_back(end_picture(end, stop, folder / stem, graphics));
    return pictures;
}

template std::vector<GalleryPicture> draw_gallery_pictures<2>(const Session<2>&, const fs::path&, const std::string&,
                                                              LabGraphics&);
template std::vector<GalleryPicture> draw_gallery_pictures<3>(const Session<3>&, const fs::path&, const std::string&,
                                                              LabGraphics&);

}  // namespace sightline::lab
