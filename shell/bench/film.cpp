// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/bench/film.h"

#include <nlohmann/json.hpp>

#include "core/draw/compose.h"
#include "core/error.h"
#include "core/file.h"
#include "core/number.h"
#include "core/output_file.h"
#include "core/session/state_file.h"
#include "shell/bench/encode.h"
#include "shell/bench/export.h"
#include "shell/bench/moves.h"

namespace sightline {

namespace {

namespace fs = std::filesystem;

/// Frames between two words about how far it is.
constexpr std::size_t frames_per_word = 25;

std::string ending_of(const std::string& file) {
    std::string ending = fs::path(file).extension().string();
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
    if (ending != ".png" && ending != ".pdf" && ending != ".gif" && ending != ".mp4")
        throw InputError("cannot write " + file + " as a film; use .png, .pdf, .gif or .mp4");
    return ending;
}

template <int D>
void check(const Workbench<D>& bench, const FilmSpec& film) {
    const std::uint32_t end = whole_run(bench);
    const std::string steps = std::to_string(film.first) + "-" + std::to_string(film.last);
    if (film.first > film.last) throw InputError("steps " + steps + ": the first comes after the last");
    if (film.last > end) throw InputError("steps " + steps + ": the run ends at step " + std::to_string(end));
    if (film.last - film.first >= most_frames)
        throw InputError("steps " + steps + ": a film has at most " + std::to_string(most_frames) + " steps");
    if (!(film.frames_per_second >= 0.1 && film.frames_per_second <= 100))
        throw InputError("the speed of a film is from 0.1fps to 100fps");
}

template <int D>
std::vector<Figure> frames(const Session<D>& session, const FilmSpec& film) {
    PanelSource<D> walker{session, ""};
    return make_film<D>(film.last - film.first + 1, [&](std::size_t i) -> const PanelSource<D>& {
        const std::uint32_t step = film.first + static_cast<std::uint32_t>(i);
        walker.session.seek(step);
        walker.title = "step " + std::to_string(step);
        return walker;
    });
}

/// The state of the first step, which any state file's reader opens, with what the film is.
template <int D>
std::string sidecar(const Workbench<D>& bench, const FilmSpec& film) {
    Session<D> first = bench.session;
    first.seek(film.first);
    auto json = nlohmann::ordered_json::parse(state_json<D>(first, bench.figure));
    json["film"] = {{"first", film.first}, {"last", film.last}, {"frames_per_second", film.frames_per_second}};
    return json.dump(1) + "\n";
}

std::string numbered(const fs::path& file, std::size_t number) {
    std::string digits = std::to_string(number);
    digits.insert(0, 4 - std::min<std::size_t>(4, digits.size()), '0');
    return (file.parent_path() / (file.stem().string() + "-" + digits + file.extension().string())).string();
}

/// FILE-0001.png and so on; takes back those that were not there before when one fails.
template <int D>
void write_pictures(Workbench<D>& bench, std::span<const Figure> figures, const fs::path& file) {
    std::vector<fs::path> written;
    const auto name = [&](std::size_t i) {
        if (i > 0 && i % frames_per_word == 0)
            bench.say(std::to_string(i) + " of " + std::to_string(figures.size()) + " pictures are drawn");
        const fs::path path = numbered(file, i + 1);
        std::error_code error;
        if (!fs::exists(path, error)) written.push_back(path);
        return path;
    };
    try {
        write_figure_frames(figures, figure_size(bench.figure), name, bench.graphics.draw_solid);
    } catch (...) {
        std::error_code error;
        for (const fs::path& path : written) fs::remove(path, error);
        throw;
    }
}

}  // namespace

template <int D>
void write_film(Workbench<D>& bench, const FilmSpec& film) {
    const std::string ending = ending_of(film.file);
    check(bench, film);
    const std::vector<Figure> figures = frames(bench.session, film);
    OutputFile beside(film.file + ".json");
    beside.write(sidecar(bench, film));  // a disk that has no room for it keeps the old film
    if (ending == ".pdf") {
        write_figure_pages(figures, figure_size(bench.figure), film.file, bench.graphics.draw_solid);
    } else if (ending == ".png") {
        write_pictures(bench, figures, film.file);
    } else {
        const TemporaryFolder folder;
        write_pictures(bench, figures, folder.path() / "frame.png");
        const fs::path made = folder.path() / ("film" + ending);
        encode_film(folder.path() / "frame-%04d.png", film.frames_per_second, figures.front().background, made);
        write_file(film.file, read_file(made));
    }
    beside.commit();
    bench.say("wrote " + film.file + ", " + std::to_string(figures.size()) + " steps, and " + film.file + ".json");
}

template void write_film<2>(Workbench<2>&, const FilmSpec&);
template void write_film<3>(Workbench<3>&, const FilmSpec&);

}  // namespace sightline
