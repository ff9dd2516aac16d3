// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/core/picture.h"

#include <algorithm>
#include <cstddef>

#include "core/base/number.h"
#include "core/draw/eye_strip.h"
#include "core/draw/legend.h"
#include "core/draw/list_text.h"
#include "core/draw/notes.h"
#include "core/draw/palette.h"
#include "core/draw/picture.h"
#include "core/draw/picture_3d.h"
#include "core/draw/shown_world.h"
#include "shell/desk/compare.h"
#include "shell/desk/into.h"
#include "web/core/json_text.h"

namespace sightline {

namespace {

// The page reads shapes and points where they lie: web/page/core.ts has the same numbers.
static_assert(sizeof(Vec<2>) == 16);
static_assert(sizeof(SolidCorner) == 20 && offsetof(SolidCorner, colour) == 12 && offsetof(SolidCorner, lit) == 16);
static_assert(sizeof(Shape) == 24 && offsetof(Shape, kind) == 0 && offsetof(Shape, style) == 2 &&
              offsetof(Shape, first_point) == 4 && offsetof(Shape, point_count) == 8 && offsetof(Shape, size_pt) == 16);

constexpr auto shape_words = std::to_array<std::string_view>({"polygon", "polyline", "disc", "ring", "cross", "arrow"});
constexpr auto hatch_words =
    std::to_array<std::string_view>({"none", "diagonal", "back_diagonal", "cross", "horizontal", "dots"});
constexpr auto dash_words = std::to_array<std::string_view>({"solid", "dashed", "dotted"});

void put_style(JsonText& json, const Style& style) {
    json.object().member("name", style.name).member("width", style.width_pt);
    if (style.fill.a > 0) json.member("fill", colour_text(style.fill));
    if (style.stroke.a > 0) json.member("stroke", colour_text(style.stroke));
    if (style.hatch != Hatch::none && style.hatch_colour.a > 0)
        json.member("hatch", hatch_words[static_cast<std::size_t>(style.hatch)])
            .member("hatchColour", colour_text(style.hatch_colour));
    if (style.dash != Dash::solid) json.member("dash", dash_words[static_cast<std::size_t>(style.dash)]);
    json.end_object();
}

/// Where something lies in memory.
template <typename T>
std::uintptr_t place_of(const std::vector<T>& list) {
    return reinterpret_cast<std::uintptr_t>(list.data());
}

void put_list(JsonText& json, const DrawList& list) {
    json.object()
        .member("points", place_of(list.points))
        .member("pointCount", list.points.size())
        .member("shapes", place_of(list.shapes))
        .member("shapeCount", list.shapes.size())
        .name("styles")
        .array();
    for (const Style& style : list.styles) put_style(json, style);
    json.end_array().end_object();
}

/// The font's size in pixels, at scale 1 of a label.
constexpr double label_pixels = 13;

/// Labels with their places in pixels, y down, as the window stands them.
void put_labels(JsonText& json, const Page& page, Paper& paper, double width, double height, double unit) {
    const double scale = width / paper.world.extent().x;
    LabelGround ground;
    ground.frame = {{0, 0}, {width, height}};
    ground.pt = 4.0 / 3 * unit;
    ground.least_room = 4 * unit;
    ground.to_paper = [&](const Vec<2>& p) {
        return Vec<2>((p.x - paper.world.min.x) * scale, height - (p.y - paper.world.min.y) * scale);
    };
    const auto size_of = [&](const Label& label) { return label_pixels * unit * label.scale; };
    const auto radius_of = [&](const Label& label) {
        const double em = size_of(label);
        return label.disc ? std::max(0.75 * em, page.font.width(label.text) * em / 2 + 0.27 * em) : 0.0;
    };
    ground.size = [&](const Label& label, std::size_t form) -> std::optional<LabelSize> {
        if (form > 0) return std::nullopt;
        const double em = size_of(label), margin = label.halo.a > 0 ? 2 * unit : 1;
        return LabelSize{page.font.width(label.text) * em, 0.48 * em + margin, margin, radius_of(label)};
    };
    const std::vector<Label>& labels = paper.above.labels;
    json.array();
    for (const StandingLabel& standing : stand_labels(labels, ground, {}, &paper.labels)) {
        const Label& label = labels[standing.label];
        json.object()
            .member("text", label.text)
            .member("x", standing.box.centre().x)
            .member("y", standing.box.centre().y)
            .member("size", size_of(label))
            .member("colour", colour_text(label.colour));
        if (label.halo.a > 0) json.member("halo", colour_text(label.halo));
        if (label.disc) json.member("disc", colour_text(*label.disc)).member("radius", radius_of(label));
        if (label.leader || standing.leader) {
            const Vec<2> tip = standing.leader ? standing.tip : standing.anchor;
            if (!standing.box.contains(tip)) {
                const Vec<2> from = leader_start(standing.box, tip);
                json.name("leader").values(std::array{from.x, from.y, tip.x, tip.y});
            }
        }
        json.end_object();
    }
    json.end_array();
}

void put_legend(JsonText& json, std::vector<LegendRow> rows) {
    json.array();
    for (const LegendRow& row : short_legend(std::move(rows))) {
        json.object().member("swatch", shape_words[static_cast<std::size_t>(row.swatch)]).member("text", row.text);
        put_style(json.name("style"), row.style);
        json.end_object();
    }
    json.end_array();
}

std::vector<LegendRow> legend_of(const Session<2>& session, const Paper& paper) {
    const std::array<const DrawList*, 2> lists{&paper.below, &paper.above};
    return legend_rows(lists, session.settings(), key_title(session), current_notes(session));
}

void put_solid(JsonText& json, const Solid& solid) {
    json.object()
        .member("triangles", place_of(solid.triangles))
        .member("triangleCorners", solid.triangles.size())
        .member("opaque", solid.opaque)
        .member("edges", place_of(solid.edges))
        .member("edgeCorners", solid.edges.size());
    json.name("clip").values(solid.clip).name("forward").values(solid.forward).name("lamp").values(solid.lamp);
    json.member("background", colour_text(solid.background)).end_object();
}

/// What the lists of a pane are made of.
struct Made {
    std::optional<std::array<double, 2>> heat_range;
    std::vector<LegendRow> legend;
};

/// All that the borders of the cells depend on: no step changes them.
std::string still_words(const Session<2>& session, const Box<2>& world) {
    std::string words = std::to_string(reinterpret_cast<std::uintptr_t>(session.shared_cells().get()));
    for (const double number : {world.min.x, world.min.y, world.max.x, world.max.y}) words += " " + number_text(number);
    words += " " + std::to_string(session.cells().cell_count());
    words += " " + std::to_string(static_cast<int>(session.settings().palette));
    return words + (session.settings().show_tessellation == Switch::on ? " on" : " off");
}

Made make(Page& page, BenchOnPage<2>& on, const Session<2>& session, std::size_t side, double aspect) {
    Paper& paper = page.papers[side];
    paper.world = widened(page.hand ? page.hand->world : shown_world(on.bench.session), aspect);
    auto options = on.sides.options<PictureOptions>(side);
    options.world = paper.world;
    options.part = PicturePart::below;
    paper.below = make_picture(session, options);
    options.part = PicturePart::tessellation;
    const std::string still = still_words(session, paper.world);
    if (still != paper.still)
        paper.tessellation =
            session.settings().show_tessellation == Switch::on ? make_picture(session, options) : DrawList{};
    paper.still = still;
    options.part = PicturePart::above;
    std::optional<EyeStrip> strip;
    if (session.settings().show_eye == Switch::on) strip = eye_strip(session);
    options.eye = strip ? &*strip : nullptr;
    paper.above = make_picture(session, options);
    return {options.heat_range, legend_of(session, paper)};
}

Made make(Page& page, BenchOnPage<3>& on, const Session<3>& session, std::size_t side, double aspect) {
    Paper& paper = page.papers[side];
    auto options = on.sides.options<PictureOptions3>(side);
    options.aspect = aspect;
    const SolidList list = make_solid(session, options);
    paper.solid = make_flat(list);
    paper.below = paper.tessellation = {};
    paper.still.clear();
    paper.above = make_picture(session, options);
    paper.world = paper.above.world;
    const std::array<const DrawList*, 1> lists{&paper.above};
    const std::array<const SolidList*, 1> solids{&list};
    return {options.heat_range,
            legend_rows(lists, solids, session.settings(), key_title(session), current_notes(session))};
}

template <int D>
std::string picture_of(Page& page, BenchOnPage<D>& on, int pane, double width, double height, double unit) {
    const Workbench<D>& bench = on.bench;
    const std::size_t side = pane > 0 && bench.other ? 1 : 0;
    on.sides.update(page.revision);
    const ShownSession<D> shown(bench);
    const Session<D>& session = side == 0 ? *shown : bench.other->session;
    Made made = make(page, on, session, side, width / height);
    Paper& paper = page.papers[side];
    const Colours& palette = colours(session.settings().palette);
    JsonText json;
    json.object();
    if (D == 3) put_solid(json.name("solid"), paper.solid);
    const Box<2>& world = paper.world;
    json.name("world").values(std::array{world.min.x, world.min.y, world.max.x, world.max.y});
    json.member("background", colour_text(palette.background))
        .member("ink", colour_text(palette.ink))
        .member("accent", colour_text(palette.accent));
    json.name("lists").array();
    for (const DrawList* list : {&paper.below, &paper.tessellation, &paper.above}) put_list(json, *list);
    json.end_array();
    if (!paper.still.empty()) json.member("still", paper.still);
    put_labels(json.name("labels"), page, paper, width, height, unit);
    if (side == 0 && bench.desk.legend) put_legend(json.name("legend"), std::move(made.legend));
    if (const auto bar = colour_bar(session, made.heat_range)) {
        json.name("bar").object().member("title", bar->title).member("low", bar->low).member("high", bar->high);
        json.name("stops").array();
        for (const Colour& stop : bar->stops) json.value(colour_text(stop));
        json.end_array().end_object();
    }
    if (bench.other) json.member("head", side_head(session, side_titles(bench)[side]).text());
    return json.end_object().take();
}

}  // namespace

std::string picture_json(Page& page, int pane, double width, double height, double unit) {
    if (!(width > 0 && height > 0)) return "{}";
    return with_bench(page, [&](auto& on) { return picture_of(page, on, pane, width, height, unit); });
}

}  // namespace sightline
