// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/object_space/object_space_report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/base/number.h"
#include "lab/report/page.h"

namespace sightline::lab {

namespace {

using Json = nlohmann::ordered_json;

Json or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const WalkCost& cost) {
    return {{"frames", cost.frames},
            {"occluders_ms", cost.occluders_ms},
            {"visible_ms", cost.visible_ms},
            {"occluders", cost.occluders},
            {"tested_per_occluder", cost.tested_each()},
            {"boxes", cost.boxes},
            {"kept", cost.kept},
            {"tested", cost.tested},
            {"planes", cost.products},
            {"changed", cost.changed},
            {"drawn", cost.drawn}};
}

Json to_json(const Culled& culled) {
    return {{"cull", or_null(culled.share())},
            {"cull_with_back_faces", or_null(culled.not_drawn_share())},
            {"cull_of_front_faces", or_null(culled.facing_share())},
            {"cull_of_triangles", or_null(culled.primitive_share())},
            {"invisible_polygons", culled.invisible},
            {"culled_polygons", culled.culled},
            {"invisible_triangles", culled.invisible_primitives},
            {"missed", culled.missed},
            {"missed_pixels", culled.missed_pixels}};
}

Json to_json(const ObjectSpaceScene& scene) {
    Json json{{"scene", scene.name}, {"seeds", scene.seeds}};
    for (const Construction& row : scene.construction)
        json["construction"].push_back({{"tree", row.tree},
                                        {"triangles", row.primitives},
                                        {"polygons", row.polygons},
                                        {"references", row.references},
                                        {"boxes", row.boxes},
                                        {"polygons_ms", row.polygons_ms},
                                        {"tree_ms", row.tree_ms},
                                        {"regions_ms", row.regions_ms},
                                        {"first_frame_ms", row.first_frame_ms}});
    for (std::size_t seed = 0; seed < scene.all_round.size(); ++seed)
        for (const AllRound& row : scene.all_round[seed]) {
            Json one{{"seed", scene.seeds[seed]}, {"method", row.method}};
            one.update(to_json(row.cost));
            one.update(to_json(row.culled));
            json["all_round"].push_back(std::move(one));
        }
    for (const AtSpeed& row : scene.speeds)
        json["speeds"].push_back(
            {{"speed", row.speed}, {"keeping", to_json(row.keeping)}, {"nothing_kept", to_json(row.fresh)}});
    for (const WithWorkers& row : scene.workers)
        json["threads"].push_back({{"threads", row.workers}, {"cost", to_json(row.cost)}});
    for (const InView& row : scene.in_view)
        json["in_view"].push_back({{"method", row.method},
                                   {"cost", to_json(row.cost)},
                                   {"draw_ms", row.draw_ms > 0 ? Json(row.draw_ms) : Json(nullptr)},
                                   {"all_round", to_json(row.all_round)}});
    return json;
}

std::string conditions_text(const ObjectSpaceResults& results) {
    const Conditions& c = results.conditions;
    const ObjectSpaceOptions& o = results.options;
    std::string seeds;
    for (const ObjectSpaceScene& scene : results.scenes) {
        if (scene.seeds.empty()) continue;
        seeds += (seeds.empty() ? "" : "; ") + scene.name + " seeds";
        for (const std::uint64_t seed : scene.seeds) seeds += " " + std::to_string(seed);
    }
    return c.machine + "; " + c.build + "; " + (c.renderer.empty() ? "no OpenGL" : c.renderer) + "; " + c.date +
           ". No budget. Reference: six software item buffers of " + image_size_text(o.face) + " round the eye, in " +
           (o.frames == 0 ? std::string("every frame") : std::to_string(o.frames) + " frames of the path " + o.walk) +
           "; " + seeds + ". A time is the mean over the frames of a path, without the first one, of the median of " +
           std::to_string(o.repeats) +
           " passes, methods one after the other in every frame. Choosing occluders, and "
           "drawing, have columns of their own.";
}

}  // namespace

std::string object_space_json(const ObjectSpaceResults& results) {
    Json json{{"format", "sightline-object-space"},
              {"version", 1},
              {"conditions", Json::parse(conditions_json(results.conditions))},
              {"scenes", Json::array()}};
    for (const ObjectSpaceScene& scene : results.scenes) json["scenes"].push_back(to_json(scene));
    json["claims"] = Json::parse(claims_json(object_space_claims(results)));
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_object_space(const ObjectSpaceResults& results, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    write_file(folder / "results.json", object_space_json(results));
    std::string body = "<p class=lead>" + escaped(conditions_text(results)) + "</p>";
    if (const auto claims = object_space_claims(results); !claims.empty()) {
        body +=
            "<h2>What the paper says, and what we find</h2><table><tr><th class=t>they</th><th class=t>we</th>"
            "<th class=t></th></tr>";
        for (const Claim& claim : claims) {
            std::string ours;
            for (const Regime& regime : claim.regimes)
                ours += (ours.empty() ? "" : "<br>") + escaped(regime_text(claim, regime));
            body += "<tr><td class=t>" + escaped(claim.text + " (" + claim.source + "; " + claim.test + ")") +
                    "</td><td class=t>" + ours + "</td><td class='t " +
                    (judgement(claim) == Judgement::holds ? "holds" : "not") + "'>" + escaped(verdict_text(claim)) +
                    "</td></tr>";
        }
        body += "</table>";
    }
    for (const TitledTable& table : object_space_tables(results))
        body += "<h2>" + escaped(table.title) + "</h2>" + html(table.table, table.caption);
    write_file(folder / "object-space.html", page("Culling in object space", body));
}

std::string object_space_markdown(const ObjectSpaceResults& results, const std::string& command) {
    std::string text = "# Culling in object space\n\nMade by\n\n```sh\n" + command + "\n```\n\n" +
                       conditions_text(results) +
                       " [Measuring](measuring.md) says what each number is, and what we make of them.\n\n";
    TextTable claims{{"they", "we", ""}, {}};
    for (const Claim& claim : object_space_claims(results)) {
        std::string ours;
        for (const Regime& regime : claim.regimes) ours += (ours.empty() ? "" : "; ") + regime_text(claim, regime);
        claims.rows.push_back({claim.text + " (" + claim.source + "; " + claim.test + ")", ours, verdict_text(claim)});
    }
    if (!claims.rows.empty()) text += markdown(claims) + "\n";
    for (const TitledTable& table : object_space_tables(results))
        text += "## " + table.title + "\n\n" + table.caption + "\n\n" + markdown(table.table) + "\n";
    return text;
}

}  // namespace sightline::lab
