// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/number.h"
#include "core/scene/catalogue.h"
#include "core/scene/generators_3d.h"
#include "core/scene/text.h"

namespace sightline {

template <>
std::span<const CatalogueRow<3>> catalogue<3>() {
    static const std::vector<CatalogueRow<3>> rows = {
        {"city",
         1,
         "City",
         "From a street only the nearest fronts and what shows through their windows can be seen, a few percent of all "
         "triangles, while furnished rooms by the hundred stand hidden behind them.",
         generate::city,
         {{-8, 0, 1.7}, {20, 1, 2.4}, 60},
         0.05,
         "published",
         "5%",
         {},
         {{"step:100", "along the street"},
          {"visible_share == 0 && count > 200", "inside a house that nobody looks into"}},
         500'000,
         {"street", "air", "test"}},
    };
    return rows;
}

namespace {

/// "500k", "16M", "20000".
std::optional<std::size_t> parse_size(std::string_view text) {
    std::size_t unit = 1;
    if (text.ends_with('k')) unit = 1'000;
    if (text.ends_with('M')) unit = 1'000'000;
    if (unit > 1) text.remove_suffix(1);
    const std::optional<std::uint32_t> number = parse_whole(text);
    if (!number) return std::nullopt;
    return *number * unit;
}

}  // namespace

Scene<3> make_scene(const CatalogueRow<3>& row, std::size_t triangles) {
    Generated made = row.generate(row.seed, triangles);
    Scene<3> scene;
    scene.id = row.id;
    scene.title = row.title;
    scene.lesson = row.lesson;
    scene.source = "generated";
    scene.seed = row.seed;
    // Clean as made, which is tested: a check here would take longer and more memory than making it.
    scene.primitives = std::move(made.triangles);
    scene.two_sided = std::move(made.two_sided);
    scene.start_view = row.view;
    scene.paths = std::move(made.paths);
    return scene;
}

std::optional<Scene<3>> generated_scene(std::string_view name) {
    const std::size_t colon = name.find(':');
    const CatalogueRow<3>* const row = find_in_catalogue<3>(name.substr(0, colon));
    if (!row) return std::nullopt;
    std::size_t triangles = row->triangles;
    if (colon != std::string_view::npos) {
        const std::string_view text = name.substr(colon + 1);
        if (row->triangles == 0)
            throw input_error(name, "", "this scene has one size only: write " + std::string(row->id));
        const std::optional<std::size_t> size = parse_size(text);
        if (!size || *size < fewest_triangles || *size > most_triangles)
            throw input_error(name, "",
                              "\"" + one_line(text, 40) +
                                  "\" is no size: a number of triangles from 10k to 16M, such as 20000, 500k or 2M");
        triangles = *size;
    }
    return make_scene(*row, triangles);
}

}  // namespace sightline
