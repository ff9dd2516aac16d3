// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/measure/summary.h"
#include "lab/object_space/object_space_report.h"
#include "lab/object_space/papers_scenes.h"
#include "lab/report/page.h"

namespace sightline::lab {

namespace {

using Cells = std::vector<std::string>;
constexpr const char* papers_words = " (the paper)";

std::string whole_number(double value) { return std::isnan(value) ? "–" : short_number(std::round(value), 9); }
std::string pair(double first, double second) { return number(first) + " + " + number(second); }

/// The mean over seeds of a number of a method.
template <typename Value>
double over_seeds(const ObjectSpaceScene& scene, std::size_t method, Value value) {
    double sum = 0;
    for (const auto& seed : scene.all_round) sum += static_cast<double>(value(seed[method]));
    return sum / static_cast<double>(scene.all_round.size());
}

TitledTable table_of_construction(const ObjectSpaceResults& results) {
    TitledTable made{"Table 1: building",
                     "Polygons; those referred to from the leaves, each once a leaf, and how many times the polygons "
                     "that is; milliseconds for joining triangles to polygons + building the tree, and for placing the "
                     "regions of occluders + the first frame. Theirs on a machine of 1996, and their construction is "
                     "that of the tree alone.",
                     {{"scene", "tree", "triangles", "polygons", "references", "times", "boxes", "construction, ms",
                       "initialisation, ms"},
                      {}}};
    for (const ObjectSpaceScene& scene : results.scenes) {
        if (scene.construction.empty()) continue;
        if (const PapersScene* const paper = papers_scene(scene.name))
            made.table.rows.push_back({std::string(paper->theirs) + papers_words, "kd", "–",
                                       std::to_string(paper->polygons), std::to_string(paper->references),
                                       number(static_cast<double>(paper->references) / paper->polygons), "–",
                                       std::to_string(paper->construction_ms), std::to_string(paper->first_frame_ms)});
        for (const Construction& row : scene.construction)
            made.table.rows.push_back({scene.name, row.tree, std::to_string(row.primitives),
                                       std::to_string(row.polygons), std::to_string(row.references),
                                       number(static_cast<double>(row.references) / static_cast<double>(row.polygons)),
                                       std::to_string(row.boxes), pair(row.polygons_ms, row.tree_ms),
                                       pair(row.regions_ms, row.first_frame_ms)});
    }
    return made;
}

TitledTable table_of_culling(const ObjectSpaceResults& results) {
    TitledTable made{
        "Table 2: a walk, seen all round",
        "Occ: choosing occluders; Vis: down the tree, with listing what is drawn; ms a frame. Rel: boxes tested per "
        "occluder. Cull: polygons that occluders hide, with their boxes or alone (leaves=polygons), over all that no "
        "pixel "
        "of six item buffers shows, so back faces count as hidden; Cull+: the same with back faces that are left out "
        "of "
        "drawn boxes taken as culled; Cull f: of those that turn their front to the eye; Cull t: of triangles. Missed: "
        "triangles that are seen and were not drawn, in all frames and seeds. Means over frames and seeds.",
        {{"scene", "method", "Occ", "Rel", "Vis", "Cull", "Cull+", "Cull f", "Cull t", "missed", "occluders", "boxes",
          "of them kept", "tested", "planes", "changed", "drawn"},
         {}}};
    for (const ObjectSpaceScene& scene : results.scenes) {
        if (scene.all_round.empty()) continue;
        if (const PapersScene* const paper = papers_scene(scene.name))
            for (const auto& [words, test] : {std::pair{"single", paper->single}, {"connected", paper->connected}}) {
                Cells row{std::string(paper->theirs) + papers_words,
                          words,
                          number(paper->occluders_ms),
                          number(test.tested_each),
                          number(test.visible_ms),
                          share_text(test.culled)};
                row.resize(made.table.head.size(), "–");
                made.table.rows.push_back(std::move(row));
            }
        for (std::size_t i = 0; i < scene.all_round.front().size(); ++i) {
            const auto cost = [&](double WalkCost::*what) {
                return over_seeds(scene, i, [&](const AllRound& row) { return row.cost.*what; });
            };
            const auto culled = [&](double (Culled::*what)() const) {
                return share_text(over_seeds(scene, i, [&](const AllRound& row) { return (row.culled.*what)(); }));
            };
            std::size_t missed = 0;
            for (const auto& seed : scene.all_round) missed += seed[i].culled.missed;
            made.table.rows.push_back(
                {scene.name, scene.all_round.front()[i].method, number(cost(&WalkCost::occluders_ms)),
                 number(over_seeds(scene, i, [](const AllRound& row) { return row.cost.tested_each(); })),
                 number(cost(&WalkCost::visible_ms)), culled(&Culled::share), culled(&Culled::not_drawn_share),
                 culled(&Culled::facing_share), culled(&Culled::primitive_share), std::to_string(missed),
                 number(cost(&WalkCost::occluders)), whole_number(cost(&WalkCost::boxes)),
                 whole_number(cost(&WalkCost::kept)), whole_number(cost(&WalkCost::tested)),
                 whole_number(cost(&WalkCost::products)), number(cost(&WalkCost::changed)),
                 whole_number(cost(&WalkCost::drawn))});
        }
    }
    return made;
}

TitledTable table_of_speeds(const ObjectSpaceResults& results) {
    TitledTable made{"Table 3: the faster the eye, the less is kept",
                     "Vis, ms a frame, of an eye on a straight line that takes every so many frames of it, seen all "
                     "round; how many times that of the lowest speed; the same with nothing kept (coherence=off); and "
                     "how many boxes were asked for and of them kept, pairs of box and occluder tested, planes looked "
                     "at, boxes in another state than a frame before.",
                     {{"scene", "speed", "Vis", "times", "Occ", "Vis, nothing kept", "boxes", "of them kept", "tested",
                       "planes", "planes, nothing kept", "changed"},
                      {}}};
    for (const ObjectSpaceScene& scene : results.scenes) {
        if (scene.speeds.empty()) continue;
        if (const PapersScene* const paper = papers_scene(scene.name))
            for (std::size_t i = 0; i < paper->speeds.size(); ++i) {
                Cells row{std::string(paper->theirs) + papers_words, std::to_string(1 << i), number(paper->speeds[i]),
                          number(paper->speeds[i] / paper->speeds[0])};
                row.resize(made.table.head.size(), "–");
                made.table.rows.push_back(std::move(row));
            }
        const double slowest = scene.speeds.front().keeping.visible_ms;
        for (const AtSpeed& row : scene.speeds)
            made.table.rows.push_back({scene.name, std::to_string(row.speed), number(row.keeping.visible_ms),
                                       number(row.keeping.visible_ms / slowest), number(row.keeping.occluders_ms),
                                       number(row.fresh.visible_ms), whole_number(row.keeping.boxes),
                                       whole_number(row.keeping.kept), whole_number(row.keeping.tested),
                                       whole_number(row.keeping.products), whole_number(row.fresh.products),
                                       number(row.keeping.changed)});
    }
    return made;
}

TitledTable table_of_workers(const ObjectSpaceResults& results) {
    TitledTable made{"Table 4: threads",
                     "Vis, ms a frame, seen all round, with " + results.options.parallel +
                         ". The paper's Tetra took 26 and 18 ms, which is 1.44 times as fast; 1.55 is printed.",
                     {{"scene", "threads", "Vis", "times as fast", "tested", "planes", "drawn"}, {}}};
    for (const ObjectSpaceScene& scene : results.scenes) {
        if (scene.workers.empty()) continue;
        if (const PapersScene* const paper = papers_scene(scene.name); paper && scene.name == paper->ours)
            for (std::size_t i = 0; i < paper->workers.size(); ++i)
                made.table.rows.push_back({std::string(paper->theirs) + papers_words, std::to_string(1 << i),
                                           number(paper->workers[i]), number(paper->speedups[i]), "–", "–", "–"});
        for (const WithWorkers& row : scene.workers)
            made.table.rows.push_back({scene.name, std::to_string(row.workers), number(row.cost.visible_ms),
                                       number(scene.workers.front().cost.visible_ms / row.cost.visible_ms),
                                       whole_number(row.cost.tested), whole_number(row.cost.products),
                                       whole_number(row.cost.drawn)});
    }
    return made;
}

TitledTable table_in_view(const ObjectSpaceResults& results) {
    const ImageSize size = image_size<3>(results.options.image);
    TitledTable made{
        "A frame in a view",
        "The same walk as a person sees it, " + image_size_text(size) +
            ": culling (Occ + Vis), drawing what is left with its upload, both; what view culling spends on what the "
            "method hides (its culling and drawing less the drawing of what the method leaves), and the method's "
            "culling "
            "over that: below 1 it pays, at most 0.25 is asked. Vis of that, and all round, where nothing is switched "
            "off; how many times as long that takes. ms a frame.",
        {{"scene", "method", "culling", "drawing", "both", "hidden costs view", "culling over that", "drawn", "boxes",
          "planes", "Vis", "Vis all round", "times", "boxes all round"},
         {}}};
    for (const ObjectSpaceScene& scene : results.scenes)
        for (const InView& row : scene.in_view) {
            const InView& view = scene.in_view.front();
            const bool is_drawn = view.draw_ms > 0, is_view = &row == &view;
            const double hidden = hidden_ms(view, row);
            made.table.rows.push_back(
                {scene.name, row.method, number(row.cost.cull_ms()), is_drawn ? number(row.draw_ms) : "–",
                 is_drawn ? number(row.cost.cull_ms() + row.draw_ms) : "–", is_drawn && !is_view ? number(hidden) : "–",
                 is_drawn && !is_view && hidden > 0 ? number(row.cost.cull_ms() / hidden) : "–",
                 whole_number(row.cost.drawn), is_view ? "–" : whole_number(row.cost.boxes),
                 is_view ? "–" : whole_number(row.cost.products), is_view ? "–" : number(row.cost.visible_ms),
                 is_view ? "–" : number(row.all_round.visible_ms),
                 is_view ? "–" : number(row.all_round.visible_ms / row.cost.visible_ms),
                 is_view ? "–" : whole_number(row.all_round.boxes)});
        }
    return made;
}

}  // namespace

double hidden_ms(const InView& view, const InView& method) {
    return view.cost.cull_ms() + view.draw_ms - method.draw_ms;
}

double mean_cull(const ObjectSpaceScene& scene, std::size_t method) {
    return over_seeds(scene, method, [](const AllRound& row) { return row.culled.share(); });
}

std::vector<TitledTable> object_space_tables(const ObjectSpaceResults& results) {
    std::vector<TitledTable> all{table_of_construction(results), table_of_culling(results), table_of_speeds(results),
                                 table_of_workers(results), table_in_view(results)};
    std::erase_if(all, [](const TitledTable& table) { return table.table.rows.empty(); });
    return all;
}

std::string plain_text(const TitledTable& titled) {
    const auto width = [](const std::string& text) {
        return static_cast<std::size_t>(std::count_if(
            text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
    };
    std::vector<std::size_t> widths;
    const auto each_row = [&](const auto& use) {
        use(titled.table.head);
        for (const Cells& row : titled.table.rows) use(row);
    };
    each_row([&](const Cells& row) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
    });
    std::string text = titled.title + "\n";
    each_row([&](const Cells& row) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string space(widths[i] - width(row[i]), ' ');
            text += "  " + (i < 2 ? row[i] + space : space + row[i]);
        }
        while (text.ends_with(' ')) text.pop_back();
        text += "\n";
    });
    return text;
}

}  // namespace sightline::lab
