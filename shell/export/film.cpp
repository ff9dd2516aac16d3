// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/export/film.h"

#include <map>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/output_file.h"
#include "core/draw/compose.h"
#include "core/session/state_file.h"
#include "shell/desk/compare.h"
#include "shell/desk/moves.h"
#include "shell/export/encode.h"
#include "shell/export/export.h"

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

/// Brings both sessions to a picture of the film: beyond the left run's end the right one goes on alone.
template <int D>
void go_to(Session<D>& left, Session<D>* right, Align align, std::uint32_t number) {
    left.seek(number);
    if (!right) return;
    follow(left, *right, align);
    if (number > left.position()) right->seek(right->position() + (number - left.position()));
}

/// The last picture of steps that there is.
template <int D>
std::uint32_t last_step(const Workbench<D>& bench) {
    Session<D> left = at_the_end(bench.session);
    if (!bench.other) return left.position();
    Session<D> right = at_the_end(bench.other->session);
    const std::uint32_t end = right.position();
    go_to<D>(left, &right, bench.other->align, left.position());
    return left.position() + (end - right.position());
}

/// The film with an end that there is. Throws InputError for one that cannot be.
template <int D>
FilmSpec checked(const Workbench<D>& bench, FilmSpec film) {
    const std::size_t frames = bench.flight.path.frames.size();
    if (film.path && frames == 0) throw InputError("there is no path: name one, or record it");
    if (film.first > film.last)
        throw InputError("from " + std::to_string(film.first) + " to " + std::to_string(film.last) +
                         ": the first comes after the last");
    const std::uint32_t end = film.path ? static_cast<std::uint32_t>(frames) - 1 : last_step(bench);
    const std::string what = film.path ? "the path ends at frame " : "the run ends at step ";
    if (film.first > end) throw InputError(std::to_string(film.first) + ": " + what + std::to_string(end));
    if (film.last > end && film.last != film_to_end) bench.say(what + std::to_string(end) + ", and so does the film");
    film.last = std::min(film.last, end);
    const std::string range =
        (film.path ? "frames " : "steps ") + std::to_string(film.first) + "-" + std::to_string(film.last);
    if (film.last - film.first >= most_frames)
        throw InputError(range + ": a film has at most " + std::to_string(most_frames));
    if (!(film.frames_per_second >= 0.1 && film.frames_per_second <= 100))
        throw InputError("the speed of a film is from 0.1fps to 100fps");
    return film;
}

/// The sessions of the bench, which walk from picture to picture.
template <int D>
class Walker {
public:
    Walker(const Workbench<D>& bench, const FilmSpec& film) : film_(film) {
        if (bench.other) align_ = bench.other->align;
        if (film.path) frames_ = bench.flight.path.frames;
        panels_.push_back({bench.session, ""});
        if (bench.other) panels_.push_back({bench.other->session, ""});
        if (bench.other) titles_ = side_titles(bench);
    }

    /// Picture i, from 0; valid until the next one.
    std::span<const PanelSource<D>> at(std::size_t i) {
        const std::uint32_t number = film_.first + static_cast<std::uint32_t>(i);
        if (now_ != number) film_.path ? fly(number) : step(number);
        now_ = number;
        for (std::size_t side = 0; side < panels_.size(); ++side) {
            PanelSource<D>& panel = panels_[side];
            panel.title =
                film_.path ? "frame " + std::to_string(number) : "step " + std::to_string(panel.session.position());
            if (panels_.size() == 1) continue;
            panel.title += ", " + side_head(panel.session, titles_[side]).text();
            panel.differences = cell_differences(panel.session, panels_[1 - side].session);
        }
        return panels_;
    }

    /// The state file of the picture that was asked for last.
    std::string state(const FigureSpec& figure) const {
        if (panels_.size() == 1) return state_json<D>(panels_[0].session, figure);
        return state_json<D>(panels_[0].session, figure, &panels_[1].session, align_);
    }

private:
    void step(std::uint32_t number) {
        go_to(panels_[0].session, panels_.size() > 1 ? &panels_[1].session : nullptr, align_, number);
    }

    /// Where milliseconds ended a frame, they end it again at the same step.
    void fly(std::uint32_t frame) {
        const bool known = stops_.contains(frame);
        std::array<std::uint32_t, 2>& stops = stops_[frame];
        for (std::size_t side = 0; side < panels_.size(); ++side) {
            Session<D>& session = panels_[side].session;
            session.set_culling_view(frames_[frame]);
            if (known) session.set_time_stop(stops[side]);
            session.run();
            stops[side] = session.time_stop();
        }
    }

    FilmSpec film_;
    Align align_ = Align::step;
    std::vector<ViewSpec<D>> frames_;  ///< of the path
    std::vector<PanelSource<D>> panels_;
    std::array<std::string, 2> titles_;
    std::map<std::uint32_t, std::array<std::uint32_t, 2>> stops_;
    std::optional<std::uint32_t> now_;
};

/// The state of the first picture, which any state file's reader opens, with what the film is.
template <int D>
std::string sidecar(const Workbench<D>& bench, const FilmSpec& film) {
    Walker<D> walker(bench, film);
    walker.at(0);
    auto json = nlohmann::ordered_json::parse(walker.state(bench.figure));
    json["film"] = {{"first", film.first}, {"last", film.last}, {"frames_per_second", film.frames_per_second}};
    if (film.path) json["film"]["path"] = bench.flight.path.id;
    return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string numbered(const fs::path& file, std::size_t number) {
    std::string digits = std::to_string(number);
    digits.insert(0, 4 - std::min<std::size_t>(4, digits.size()), '0');
    return (file.parent_path() / (file.stem().string() + "-" + digits + file.extension().string())).string();
}

/// Of what is shown on a screen, where no size in pixels is asked for.
FigureSize size_of_video(FigureSize size) {
    if (size.width_px > 0) return size;
    size.width_px = 1280;
    size.height_px = 720;
    size.font_pt = 15;
    return size;
}

/// Folder/frame-0001.png and so on.
template <int D>
void draw_pictures(Workbench<D>& bench, const Film& film, const FigureSize& size, const fs::path& folder) {
    const auto name = [&](std::size_t i) {
        if (i > 0 && i % frames_per_word == 0)
            bench.say(std::to_string(i) + " of " + std::to_string(film.plan.size()) + " pictures are drawn");
        return fs::path(numbered(folder / "frame.png", i + 1));
    };
    write_figure_frames(film.plan, film.page, size, name, bench.graphics.draw_solid);
}

/// FILE-0001.png and so on, when all are drawn; takes back those that were not there before when one fails.
template <int D>
void write_pictures(Workbench<D>& bench, const Film& film, const FigureSize& size, const fs::path& file) {
    const std::size_t count = film.plan.size();
    for (const std::size_t number : {std::size_t{1}, count}) const OutputFile can_be_written(numbered(file, number));
    const TemporaryFolder folder(file.has_parent_path() ? file.parent_path() : ".");
    draw_pictures(bench, film, size, folder.path());
    std::vector<fs::path> written;
    std::error_code error;
    try {
        for (std::size_t number = 1; number <= count; ++number) {
            const fs::path path = numbered(file, number), drawn = numbered(folder.path() / "frame.png", number);
            if (!fs::exists(path, error)) written.push_back(path);
            if (fs::is_symlink(path, error)) {  // is followed, which a new name does not do
                write_file(path, read_file(drawn));
                continue;
            }
            fs::rename(drawn, path, error);
            if (error) throw WorkError("cannot write " + path.string() + ": " + error.message());
        }
    } catch (...) {
        for (const fs::path& made : written) fs::remove(made, error);
        throw;
    }
}

}  // namespace

template <int D>
void write_film(Workbench<D>& bench, const FilmSpec& asked) {
    const std::string ending = ending_of(asked.file);
    const FilmSpec film = checked(bench, asked);
    OutputFile beside(film.file + ".json");
    beside.write(sidecar(bench, film));  // a disk that has no room for it keeps the old film
    const std::size_t count = film.last - film.first + 1;
    const auto walker = std::make_shared<Walker<D>>(bench, film);
    const Film made = make_film<D>(count, [walker](std::size_t i) { return walker->at(i); });
    if (ending == ".pdf") {
        write_figure_pages(made.plan, made.page, figure_size(bench.figure), film.file, bench.graphics.draw_solid);
    } else if (ending == ".png") {
        write_pictures(bench, made, figure_size(bench.figure), film.file);
    } else {
        const TemporaryFolder folder;
        draw_pictures(bench, made, size_of_video(figure_size(bench.figure)), folder.path());
        const std::string whole = "film" + ending;
        encode_film(folder.path(), "frame-%04d.png", film.frames_per_second, made.plan.front().background, whole);
        write_file(film.file, read_file(folder.path() / whole));
    }
    beside.commit();
    bench.say("wrote " + film.file + ", " + std::to_string(count) + (film.path ? " frames, and " : " steps, and ") +
              film.file + ".json");
}

template void write_film<2>(Workbench<2>&, const FilmSpec&);
template void write_film<3>(Workbench<3>&, const FilmSpec&);

}  // namespace sightline
