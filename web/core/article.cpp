// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/core/article.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/number.h"
#include "core/draw/shown_boxes.h"
#include "core/session/explain.h"
#include "shell/desk/measure_trade_off.h"
#include "shell/desk/work_out.h"
#include "web/core/article_rays.h"
#include "web/core/picture.h"

namespace sightline {

namespace {

using Json = nlohmann::ordered_json;
using Marks = std::vector<std::uint8_t>;  ///< per segment

std::string spelled(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

const Session<2>* plane_of(const Page& page) { return page.plane ? &page.plane->bench.session : nullptr; }

Marks in_view_marks(const Session<2>& s) {
    const std::vector<Primitive<2>>& primitives = s.scene().primitives;
    Marks marks(primitives.size());
    for (std::size_t i = 0; i < primitives.size(); ++i) marks[i] = in_view(s.problem().view, primitives[i]);
    return marks;
}

/// Of what lies in the view, what the run has drawn or not, and what is visible or not.
Marks marks_of(const Session<2>& s, bool visible, bool drawn) {
    const Marks& seen = s.reference().visible;
    Marks marks = rendered_mask(s.met(), seen.size());
    for (std::size_t i = 0; i < marks.size(); ++i) marks[i] = (marks[i] != 0) == drawn && (seen[i] != 0) == visible;
    return marks;
}

/// The places that are sets of segments.
std::optional<Marks> segment_marks(const Session<2>& s, const std::string& name) {
    if (name == "segments") return Marks(s.scene().primitives.size(), 1);
    if (name == "in_view") return in_view_marks(s);
    if (name == "visible") return s.reference().visible;
    if (name == "drawn") return rendered_mask(s.met(), s.scene().primitives.size());
    if (name == "found") return marks_of(s, true, true);
    if (name == "missed") return marks_of(s, true, false);
    if (name == "wasted") return marks_of(s, false, true);
    if (name == "hidden") {
        Marks marks = in_view_marks(s);
        for (std::size_t i = 0; i < marks.size(); ++i) marks[i] = marks[i] && !s.reference().visible[i];
        return marks;
    }
    return std::nullopt;
}

/// What the next step takes, where it is recorded.
std::uint32_t next_cell(const Session<2>& s) {
    return s.position() < s.recorded() ? id_of(s.timeline().steps[s.position()].item, Kind::cell) : none;
}

/// The places that are sets of cells.
std::optional<std::vector<std::uint32_t>> cells_named(const Session<2>& s, const std::string& name) {
    const auto one = [](std::uint32_t cell) {
        return cell == none ? std::vector<std::uint32_t>{} : std::vector<std::uint32_t>{cell};
    };
    if (name == "cell") return one(last_cell(s));
    if (name == "next") return one(next_cell(s));
    if (name == "seed") return one(seed_cell(s));
    if (name == "runner_up")
        return one(s.position() > 0 && last_cell(s) != none ? explain_step(s, s.position()).runner_up : none);
    if (name == "fullest") {
        std::uint32_t best = none;
        for (std::uint32_t c = 0; c < s.cells().cell_count(); ++c)
            if (best == none || s.cells().count(c) > s.cells().count(best)) best = c;
        return one(best);
    }
    const bool front = name == "front", projected = name == "projected";
    if (!front && !projected) return std::nullopt;
    std::vector<std::uint32_t> cells;
    if (!s.method().needs.cells) return cells;
    for (std::uint32_t c = 0; c < s.cells().cell_count(); ++c) {
        const CellState state = s.mark(c).state;
        if (state == (front ? CellState::enqueued : CellState::projected)) cells.push_back(c);
    }
    return cells;
}

/// JSON of numbers with their words.
class Told {
public:
    void add(const char* name, double value) { json_[name] = {{"value", value}, {"text", short_number(value, 4)}}; }
    void count(const char* name, std::size_t value) {
        json_[name] = {{"value", value}, {"text", std::to_string(value)}};
    }
    void share(const char* name, double value) { json_[name] = {{"value", value}, {"text", percent_text(value)}}; }
    void words(const char* name, const std::string& text) { json_[name] = {{"text", text}}; }
    Json json_ = Json::object();
};

void add_step(const Session<2>& s, Told& to) {
    to.count("step", s.position());
    to.count("steps", s.recorded());
    if (s.method().id == "coorg-teller" && s.position() > 0) to.count("changed", s.position() - 1);
    if (s.method().needs.cells) {
        to.count("cells", s.cells().cell_count());
        to.count("front", cells_named(s, "front")->size());
        to.count("projected", cells_named(s, "projected")->size());
        const std::uint32_t fullest = cells_named(s, "fullest")->front();
        if (fullest != none) to.count("fullest", s.cells().count(fullest));
    }
    if (const std::uint32_t next = next_cell(s); next != none) to.count("next", next);
    if (const std::uint32_t seed = seed_cell(s); seed != none) to.count("seed", seed);
    if (const BoxTree<2>* boxes = s.traversal().boxes()) to.count("boxes", boxes->nodes.size());
    if (s.position() == 0 || last_cell(s) == none) return;
    const StepExplanation step = explain_step(s, s.position());
    to.count("cell", step.cell);
    to.words("key", short_number(step.key, step.digits));
    to.count("step_drawn", step.rendered);
    to.count("step_visible", step.visible);
    to.share("cell_share", step.visible_share);
    if (step.runner_up == none) return;
    to.count("runner_up", step.runner_up);
    to.words("runner_up_key", short_number(step.runner_up_key, step.digits));
}

Json numbers_of(const Workbench<2>& bench, const std::string& asked) {
    const auto is_asked = [&](const char* name) { return asked.find(name) != std::string::npos; };
    const Session<2>& s = bench.session;
    const std::vector<Primitive<2>>& primitives = s.scene().primitives;
    Told to;
    const auto count = [&](const char* name) {
        const Marks marks = *segment_marks(s, name);
        to.count(name, static_cast<std::size_t>(std::count_if(marks.begin(), marks.end(), [](auto m) { return m; })));
    };
    for (const char* name : {"segments", "in_view", "hidden", "visible", "drawn", "found", "missed", "wasted"})
        count(name);
    const std::size_t visible = s.reference().count, drawn = s.counters().drawn();
    if (!primitives.empty()) {
        const auto all = static_cast<double>(primitives.size());
        to.share("visible_share", static_cast<double>(visible) / all);
        to.share("drawn_share", static_cast<double>(drawn) / all);
    }
    if (const auto value = coverage(s.reference(), s.visible_rendered())) to.share("coverage", *value);
    if (drawn > 0 && visible > 0) to.add("per_visible", static_cast<double>(drawn) / static_cast<double>(visible));
    to.share("wrong", s.wrong_pixels());
    const std::uint32_t budget = s.problem().budget;
    if (budget < primitives.size()) to.count("budget", budget);
    to.words("method", s.settings().method);
    to.words("guarantee", s.guarantee());
    add_step(s, to);
    if (const auto zero = zero_key_share(s.traversal())) to.share("zero_keys", *zero);
    to.count("tests", s.traversal().tests());
    to.count("rooms", s.scene().rooms.all.size());
    if (is_asked("inversions")) to.count("inversions", s.inversions().size());
    if (is_asked("crossed") || is_asked("deepest")) {
        const Crossed crossed = crossed_by_rays(s, 256);
        to.add("crossed", crossed.mean(crossed.all));
        to.add("crossed_drawn", crossed.mean(crossed.drawn));
        to.count("deepest", crossed.deepest());
    }
    if (const auto fact = s.traversal().viewpoint(); fact && fact->done != none) {
        to.words("technique", fact->techniques[fact->done].name);
        to.words("region", fact->region);
    }
    if (const std::uint32_t node = s.selected_node != none ? s.selected_node : last_node(s); node != none) {
        const Item box{node, Kind::node};
        const Verdict hidden = s.traversal().why_not(box), seen = s.traversal().why_drawn(box);
        to.count("node", node);
        if (const Verdict& why = seen ? seen : hidden) to.words("verdict", why.sentence);
    }
    Json json = std::move(to.json_);
    const ViewSpec<2>& view = s.culling_view();
    json["view"] = {{"eye", {view.eye.x, view.eye.y}}, {"look", {view.look_at.x, view.look_at.y}}, {"fov", view.fov}};
    return json;
}

using Lines = std::vector<LightLine<2>>;

LightLine<2> border_of(const Session<2>& s, std::uint32_t cell) {
    LightLine<2> line{{}, true};
    for (const std::uint32_t p : s.cells().corners_of(cell)) line.points.push_back(s.cells().points[p]);
    return line;
}

/// "cell 3", "segment 3", "node 3": what one thing is.
Lines place_of_one(const Session<2>& s, const std::string& kind, std::uint32_t id) {
    Lines lines;
    if (kind == "cell" && id < s.cells().cell_count()) lines.push_back(border_of(s, id));
    if (kind == "segment" && id < s.scene().primitives.size()) {
        const Primitive<2>& segment = s.scene().primitives[id];
        lines.push_back({{segment[0], segment[1]}});
    }
    const BoxTree<2>* const tree = s.traversal().boxes();
    if (kind == "node" && tree && id < tree->nodes.size()) {
        const Box<2>& box = tree->nodes[id].box;
        lines.push_back({{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, true});
    }
    return lines;
}

Lines place_named(const Session<2>& s, const std::string& name) {
    const std::size_t blank = name.find(' ');
    if (blank != std::string::npos && name.compare(0, blank, "ray") == 0) return ray_lines(s, name.substr(blank + 1));
    if (blank != std::string::npos)
        if (const auto id = parse_whole(name.substr(blank + 1))) return place_of_one(s, name.substr(0, blank), *id);
    if (name == "wrong") return wrong_lines(s);
    if (name == "deepest") return deepest_lines(s);
    if (name == "node") return place_of_one(s, "node", s.selected_node != none ? s.selected_node : last_node(s));
    Lines lines;
    if (name == "visible") {  // the parts that are seen, not the whole segments
        for (const VisiblePiece& piece : s.reference().pieces) lines.push_back({{piece.from, piece.to}});
        return lines;
    }
    if (const auto marks = segment_marks(s, name))
        for (std::size_t i = 0; i < marks->size(); ++i)
            if ((*marks)[i]) {
                const Primitive<2>& segment = s.scene().primitives[i];
                lines.push_back({{segment[0], segment[1]}});
            }
    if (const auto cells = cells_named(s, name))
        for (const std::uint32_t cell : *cells) lines.push_back(border_of(s, cell));
    return lines;
}

}  // namespace

std::string numbers_json(Page& page, const std::string& asked) {
    return page.plane ? spelled(numbers_of(page.plane->bench, asked)) : "{}";
}

std::string place_json(Page& page, const std::string& name) {
    Json json = Json::array();
    if (const Session<2>* const session = plane_of(page))
        for (const LightLine<2>& line : place_named(*session, name)) {
            Json points = Json::array();
            for (const Vec<2>& p : line.points) points.push_back({p.x, p.y});
            json.push_back({{"points", points}, {"closed", line.closed}, {"arrow", line.arrow}});
        }
    return spelled(json);
}

std::string names_json(Page& page, const Vec<2>& at, double reach) {
    const Session<2>* const session = plane_of(page);
    if (!session) return "{}";
    Json json = Json::parse(under_json(page, at, reach));
    json["names"] = Json::array();
    if (json.contains("primitive"))
        for (const char* name : {"wasted", "missed", "found", "hidden", "visible", "drawn", "in_view", "segments"})
            if ((*segment_marks(*session, name))[json["primitive"].get<std::uint32_t>()]) json["names"].push_back(name);
    if (json.contains("cell"))
        for (const char* name : {"cell", "next", "runner_up", "seed", "front", "projected"}) {
            const auto cells = *cells_named(*session, name);
            if (std::find(cells.begin(), cells.end(), json["cell"].get<std::uint32_t>()) != cells.end())
                json["names"].push_back(name);
        }
    return spelled(json);
}

std::string crossed_json(Page& page, int columns) {
    const Session<2>* const session = plane_of(page);
    if (!session) return "{}";
    const Crossed crossed = crossed_by_rays(*session, std::clamp(columns, 1, 4096));
    return spelled({{"all", crossed.all}, {"drawn", crossed.drawn}});
}

std::string dots_json(Page& page) {
    if (!page.plane) return "{}";
    const Workbench<2>& bench = page.plane->bench;
    const TradeOffStudy<2>& study = bench.trade_off.study;
    Json json{{"done", study.done()}, {"total", study.total()}, {"dots", Json::array()}};
    const auto looks = trade_off_looks(bench);
    for (const TradeOffDot& dot : study.dots()) {
        const double ms = study.value(dot, Measure::traverse_ms);
        if (std::isnan(ms)) continue;
        const Variant<2>& variant = study.task().variants[dot.variant];
        const double wrong = study.value(dot, Measure::wrong), drawn = study.value(dot, Measure::rendered);
        json["dots"].push_back(
            {{"method", variant.text},
             {"budget", budget_text(dot.budget)},
             {"ms", ms},
             {"msText", short_number(ms)},
             {"drawn", drawn},
             {"wrong", wrong},
             {"wrongText", percent_text(wrong)},
             {"promise",
              variant.method.promise_with(variant.parameters) == Misses::may ? "approximate" : "conservative"},
             {"colour", hex_colour(looks[dot.variant].colour)}});
    }
    return spelled(json);
}

bool work_out(Page& page, double milliseconds) {
    if (!page.plane) return false;
    Workbench<2>& bench = page.plane->bench;
    bench.attended = true;
    ++page.revision;
    return advance_work_out(bench, milliseconds);
}

void forget_past(Page& page) {
    page.said.clear();
    with_bench(page, [](auto& on) { on.bench.history = {}; });
}

}  // namespace sightline
