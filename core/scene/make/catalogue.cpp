// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/catalogue.h"

#include "core/scene/clean.h"
#include "core/scene/make/generators.h"

namespace sightline {

template <>
std::span<const CatalogueRow<2>> catalogue<2>() {
    static const std::vector<CatalogueRow<2>> rows = {
        {"bottleneck",
         147,
         "Bottleneck",
         "Empty cells behind two dense blocks are reached round the gap between them, so hidden crates are drawn while "
         "visible walls still wait: this is what the star-shape penalty is for, as long as cells are as coarse as the "
         "gap.",
         bottleneck,
         {{8, 2.05}, {8, 8}, 80},
         0.24,
         "published",
         "30%",
         // A class first meets the published rule without the penalty, and turns it on by hand.
         {{"penalty", "none"}, {"label", "solidity"}},
         {{"visible_share == 0 && count > 0", "the first hidden cell that holds something"},
          {"step:12", "the front has passed the gap"}},
         0,
         {}},
        {"field",
         147,
         "Bottleneck in a field",
         "In a wide field cells of 5 % are about as wide as the gap between the blocks, so the order needs the "
         "star-shape penalty, which it does not where cells are much finer than the gap.",
         field,
         {{8, 2.05}, {8, 8}, 80},
         0.05,
         "published",
         "30%",
         {{"penalty", "none"}},
         {{"visible_share == 0 && count > 0", "the first hidden cell that holds something"},
          {"inversion > 0", "a hidden cell comes while a visible one waits"}},
         0,
         {}},
        {"streets",
         1,
         "Street blocks",
         "From a street only the nearest facades can be seen: a few percent of the segments make the "
         "whole "
         "picture.",
         streets,
         {{10, 43.5}, {100, 42}, 90},
         0.05,
         "published",
         "10%",
         {},
         {{"step:20", "along the street"},
          {"visible_share == 0 && count > 10", "inside a house that nobody looks into"}},
         0,
         {}},
        {"rooms",
         2,
         "Rooms and corridors",
         "Indoors walls stand behind everything and doors open narrow views into the next room, so counting visible "
         "segments and counting visible pixels judge a method differently.",
         rooms,
         {{19, 16}, {38, 11}, 90},
         0.05,
         "published",
         "5%",
         {},
         {{"visible_share == 0 && count > 0", "through a wall"}, {"step:30", "where the corridors cross"}},
         0,
         {},
         rooms_of_rooms},
        {"cars",
         4,
         "Cars",
         "A closed shell hides a dense inside: a traversal that counts segments draws hidden wheels and "
         "luggage while a side of the shell still waits.",
         cars,
         {{12, 8.5}, {16, 4}, 100},
         0.05,
         "published",
         "5%",
         {},
         {{"coverage >= 0.5", "half of what can be seen of the shells"},
          {"visible_share == 0 && count > 20", "spare wheel and luggage, while the side of the car waits"}},
         0,
         {}},
        {"jungle",
         5,
         "Jungle",
         "Thousands of separate leaves hide one another only in combination: the 32 that look largest hide less than "
         "half of "
         "what cannot be seen, so methods that choose a few large occluders leave most of the work undone.",
         jungle,
         {{20, 7}, {20, 30}, 90},
         0.05,
         "published",
         "10%",
         {},
         {{"step:40", "past the first trees"}},
         0,
         {}},
        {"terrain",
         6,
         "Terrain from above",
         "When nearly everything is visible no order can help: the best possible coverage is the budget itself, and "
         "drawing the nearest first is as good as anything.",
         terrain,
         {{100, 160}, {100, 0}, 80},
         0.05,
         "published",
         "60%",
         {},
         {{"rendered > 0", "the first piece of ground"}, {"coverage >= 0.5", "half of the valley"}},
         0,
         {}},
        {"wallholes",
         7,
         "Wall with holes",
         "Through small holes thin beams reach the store room behind, but one solidity per cell cannot tell a beam "
         "from "
         "the shadow beside it.",
         wallholes,
         {{20, 3}, {20, 14}, 100},
         0.05,
         "published",
         "10%",
         {},
         {{"visible_share == 0 && hidden_now >= 4", "in the store room, between two beams"}},
         0,
         {}},
        {"wall2",
         8,
         "Wall of two segments",
         "Two long segments hide a whole store, yet a cell with one segment counts as almost empty: the number of "
         "primitives says little about what a cell hides.",
         wall2,
         {{20, 3}, {20, 14}, 100},
         0.05,
         "published",
         "10%",
         {},
         {{"coverage == 1", "all that can be seen is drawn"},
          {"visible_share == 0 && count >= 4", "the first crates behind the wall"}},
         0,
         {}},
        {"statue",
         9,
         "Statue",
         "One cell with hundreds of segments sets the scale of solidity, so all others look empty; with the 95th "
         "percentile as the scale their keys grow, yet hardly a step changes, because all keys grow alike, until a "
         "penalty is added to them.",
         statue,
         {{25, 4}, {25, 25}, 90},
         0.15,
         "published",
         "60%",
         {{"solidity_scale", "max"}},
         {{"count > 300", "the statue's cell"}, {"step:35", "a store room nobody can see"}},
         0,
         {}},
        {"forget",
         10,
         "Forgotten wall",
         "Solidity fades at every oblique facet: after a long empty run the front has forgotten the wall and draws the "
         "store behind it before the reeds that can be seen.",
         forget,
         {{3, 20}, {20, 20}, 70},
         0.05,
         "published",
         "50%",
         {},
         {{"visible_share == 0 && rho > 0.5", "behind the wall, which still counts"},
          {"visible_share == 0 && hidden_now >= 4 && rho == 0", "the store, with solidity 0, while reeds wait"}},
         0,
         {}},
        {"soda",
         11,
         "Office floor",
         "Walls of an office floor hide nearly all of it, and a few long ones near the eye do most of the hiding.",
         soda,
         {{20, 22}, {31, 21.8}, 90},
         0.05,
         "published",
         "10%",
         {},
         {{"visible_share == 0 && count > 0", "a room behind a wall"}},
         0,
         {},
         rooms_of_soda},
        {"blocks",
         12,
         "City of blocks",
         "From the street a few outlines hide most of the city, but many stand askew, and where a square opens the "
         "view no wall alone hides much.",
         blocks,
         {{-20, 0.8}, {40, 3}, 90},
         0.05,
         "published",
         "10%",
         {},
         {{"visible_share == 0 && count > 0", "a house behind the first row"}},
         0,
         {}},
        {"tetra",
         13,
         "Triangles",
         "No two triangles touch, so each hides by itself alone: near ones hide a good part of what stands behind, and "
         "the gaps between them stay open.",
         tetra,
         {{-8, 0}, {10, 0}, 90},
         0.05,
         "published",
         "10%",
         {},
         {{"visible_share == 0 && count > 0", "behind a large triangle"}},
         0,
         {}},
        {"campus",
         14,
         "Campus",
         "In a room walls and doors decide what is seen, on the lawn facades and trees do, so no one technique is best "
         "everywhere.",
         campus,
         {{-38, 12.5}, {-38, 18}, 90},
         0.05,
         "published",
         "10%",
         {},
         {{"visible_share == 0 && count > 0", "the first that cannot be seen"}},
         0,
         {},
         rooms_of_campus},
    };
    return rows;
}

template <int D>
const CatalogueRow<D>* find_in_catalogue(std::string_view id) {
    if (D == 3) id = id.substr(0, id.find(':'));  // "city:500k"
    for (const auto rows : {catalogue<D>(), failure_scenes<D>()})
        for (const CatalogueRow<D>& row : rows)
            if (id == row.id) return &row;
    return nullptr;
}

template const CatalogueRow<2>* find_in_catalogue<2>(std::string_view);
template const CatalogueRow<3>* find_in_catalogue<3>(std::string_view);

Scene<2> make_scene(const CatalogueRow<2>& row) {
    Scene<2> scene;
    scene.id = row.id;
    scene.title = row.title;
    scene.lesson = row.lesson;
    scene.source = "generated";
    scene.seed = row.seed;
    scene.primitives = row.generate(row.seed);
    clean(scene, Recentre::no, row.id);
    if (row.rooms) scene.rooms = row.rooms(row.seed);
    scene.start_view = row.view;
    return scene;
}

}  // namespace sightline
