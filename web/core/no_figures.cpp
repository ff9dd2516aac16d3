// Without cairo and ffmpeg: the page writes its own picture as SVG and PNG, and puts hand-outs into itself.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/file.h"
#include "shell/export/export.h"
#include "shell/export/film.h"
#include "shell/export/handout.h"

namespace sightline {

template <int D>
void set_figure_size(Workbench<D>&, const std::string&) {
    throw InputError("the picture of a page has the size that it has on the screen");
}

template <int D>
void write_shot(Workbench<D>&, const std::string&) {
    throw InputError("a page copies its picture with the buttons SVG and PNG");
}

template <int D>
void write_film(Workbench<D>&, const FilmSpec&) {
    throw InputError("a page writes no films: the programs for the desk do");
}

template <int D>
void write_page(Workbench<D>& bench, const std::string& file) {
    write_file(file, handout_text(bench));
    bench.say(file + " is in the downloads: any browser opens it, and shows this");
}

#define SIGHTLINE_INSTANTIATE(D)                                         \
    template void set_figure_size<D>(Workbench<D>&, const std::string&); \
    template void write_shot<D>(Workbench<D>&, const std::string&);      \
    template void write_page<D>(Workbench<D>&, const std::string&);      \
    template void write_film<D>(Workbench<D>&, const FilmSpec&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
