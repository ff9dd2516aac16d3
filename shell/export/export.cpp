// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/export/export.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/output_file.h"
#include "core/base/stopwatch.h"
#include "core/draw/compose.h"
#include "core/session/condition.h"
#include "shell/desk/compare.h"
#include "shell/figure/lay_out.h"

namespace sightline {

namespace {

/// A place in the timeline, as --panels takes it.
template <int D>
void go_to_place(Session<D>& session, const std::string& place) {
    if (place == "start") {
        session.seek(0);
        return;
    }
    if (place == "end") {
        session.run();
        return;
    }
    if (place.starts_with("step ")) {
        if (const auto step = parse_whole(std::string_view(place).substr(5))) {
            session.seek(*step);
            return;
        }
    } else if (place.starts_with("until ")) {
        const Condition<D> condition = condition_for(session, place.substr(6));
        session.seek(0);
        if (run_until(session, condition) != Stop::breakpoint)
            throw InputError("panel '" + place + "': the run ends before the condition holds");
        return;
    }
    throw InputError("panel '" + place + "': write start, end, step N or until CONDITION");
}

/// One panel; two, left and right, where there is a second session.
template <int D>
void add_panels(const Workbench<D>& bench, const Session<D>& session, bool with_step,
                std::vector<PanelSource<D>>& panels) {
    const auto step_of = [&](const Session<D>& shown) {
        return with_step ? "step " + std::to_string(shown.position()) : std::string();
    };
    if (!bench.other) {
        panels.push_back({session, step_of(session)});
        return;
    }
    Session<D> other = bench.other->session;
    if (session.position() != bench.session.position()) follow(session, other, bench.other->align);
    const auto titles = side_titles(bench);
    const auto add = [&](const Session<D>& here, const Session<D>& there, const std::string& side) {
        const std::string step = step_of(here), head = side_head(here, side).text();
        panels.push_back({here, step.empty() ? head : step + ", " + head, cell_differences(here, there)});
    };
    add(session, other, titles[0]);
    add(other, session, titles[1]);
}

/// The state file with what its figure does not show, for who reads it; opening it looks at the figure afresh.
std::string with_left_out(const std::string& state, const std::vector<std::string>& missing) {
    if (missing.empty()) return state;
    auto json = nlohmann::ordered_json::parse(state);
    json["figure"]["left_out"] = missing;
    return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

FigureSize figure_size(const FigureSpec& spec) {
    FigureSize size;
    size.font_pt = spec.font_pt;
    size.dpi = spec.dpi;
    size.columns = spec.columns;
    const std::string_view text = spec.size;
    if (text.ends_with("mm")) {
        const auto width = parse_number(text.substr(0, text.size() - 2));
        if (width && *width > 0) {
            size.width_mm = *width;
            return size;
        }
    } else if (const std::size_t x = text.find('x'); x != std::string_view::npos) {
        const auto width = parse_number(text.substr(0, x)), height = parse_number(text.substr(x + 1));
        if (width && height && *width >= 1 && *height >= 1 && *width <= 1e6 && *height <= 1e6) {
            size.width_px = static_cast<int>(*width);
            size.height_px = static_cast<int>(*height);
            return size;
        }
    }
    throw InputError("size '" + spec.size + "': write a width such as 84mm, or pixels such as 1280x720");
}

template <int D>
void set_figure_size(Workbench<D>& bench, const std::string& size) {
    FigureSpec spec = bench.figure;
    std::istringstream words(size);
    if (size.find_first_not_of(' ') == std::string::npos) spec.size.clear();  // and so it is refused
    for (std::string word; words >> word;) {
        const std::string what = word;
        const auto number = [&](std::string_view unit) {
            const auto value = parse_number(std::string_view(what).substr(0, what.size() - unit.size()));
            if (!value) throw InputError("size '" + what + "': not a number");
            return *value;
        };
        if (word.ends_with("dpi"))
            spec.dpi = number("dpi");
        else if (word.ends_with("pt"))
            spec.font_pt = number("pt");
        else
            spec.size = word;
    }
    check_size(figure_size(spec));
    bench.figure = std::move(spec);
}

template <int D>
Figure shot_figure(const Workbench<D>& bench) {
    std::vector<PanelSource<D>> panels;
    if (bench.figure.panels.empty()) add_panels(bench, bench.session, false, panels);
    for (const std::string& place : bench.figure.panels) {
        Session<D> session = bench.session;
        go_to_place(session, place);
        add_panels(bench, session, true, panels);
    }
    return make_figure(std::span<const PanelSource<D>>(panels));
}

template <int D>
void write_shot(Workbench<D>& bench, const std::string& file) {
    const Stopwatch drawing;
    const Figure figure = shot_figure(bench);
    const FigureSize size = figure_size(bench.figure);
    const std::vector<std::string> missing = left_out(figure, size);
    const std::string bytes = figure_bytes(figure, size, file, bench.graphics.draw_solid);
    // Both or neither: a disk without room for them, or a name too long for one, keeps what was there.
    OutputFile sidecar(file + ".json"), picture(file);
    sidecar.write(with_left_out(bench_state(bench), missing));
    picture.write(bytes);
    picture.commit();
    sidecar.commit();
    bench.session.times().draw += drawing.milliseconds();
    std::string said = "wrote " + file + " and " + file + ".json";
    for (const std::string& remark : missing) said += "; " + remark;
    bench.say(said);
}

#define SIGHTLINE_INSTANTIATE(D)                                         \
    template void set_figure_size<D>(Workbench<D>&, const std::string&); \
    template Figure shot_figure<D>(const Workbench<D>&);                 \
    template void write_shot<D>(Workbench<D>&, const std::string&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
