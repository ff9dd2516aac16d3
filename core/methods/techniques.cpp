// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/techniques.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"

namespace sightline {

namespace {

constexpr auto all_techniques() {
    constexpr std::string_view image_point = "Visibility / Point Visibility / Image Space Techniques";
    constexpr std::string_view object_point = "Visibility / Point Visibility / Object Space Techniques";
    constexpr std::string_view interiors = "Visibility / Conservative Volume Visibility / Interiors";
    constexpr std::string_view exteriors = "Visibility / Conservative Volume Visibility / Exteriors";
    constexpr std::string_view by_geometry = "Detail / Geometry Based Techniques";
    constexpr std::string_view by_images = "Detail / Image Based Techniques";
    constexpr std::string_view in_view = "Visibility / View-Frustum Culling";
    constexpr std::string_view in_order = "Visibility / Point Visibility / Order and budget";

    constexpr std::string_view no_meshes = "needs a mesh that can be refined edge by edge; scenes here are soups";
    constexpr std::string_view no_images =
        "nothing here is drawn from an image of an earlier view; a picture from where it was not made has wrong pixels";

    constexpr auto any_motion = SceneMotion::any, still = SceneMotion::static_only;
    constexpr auto inside = ScenePlace::inside, outside = ScenePlace::outside, anywhere = ScenePlace::any;
    constexpr auto soup = SceneStructure::soup, objects = SceneStructure::objects;
    constexpr auto all = SceneReach::any, near = SceneReach::near, far = SceneReach::far;
    constexpr auto point = FoundFrom::point, region = FoundFrom::region;
    constexpr auto geometry = FoundIn::object_space, image = FoundIn::image_space;
    constexpr auto safe = Finding::conservative, guess = Finding::approximate, coarse = Finding::simplified;

    return std::array{
        Technique{"hierarchical z-buffer", "Hierarchical z-buffer", image_point, true, any_motion, anywhere, soup, all,
                  point, image, safe, "hzb", "", "Greene, Kass and Miller 1993", ""},
        Technique{"occlusion maps", "HOMs", image_point, true, any_motion, anywhere, objects, all, point, image, safe,
                  "hom", "", "Zhang, Manocha, Hudson and Hoff 1997",
                  "section 2.1.2 calls them an object space technique, the table an image space one, as the gem would; "
                  "section 2.3 says that they handle static occluders better and occludees may move, the table says "
                  "DYN/STA"},
        Technique{"shadow frusta", "Shadow Frusta", object_point, true, any_motion, anywhere, objects, all, point,
                  geometry, safe, "shadow-frusta", "", "Coorg and Teller 1997; Hudson et al. 1997",
                  "section 2.3 says that they handle static occluders better and occludees may move, the table says "
                  "DYN/STA; a mesh of large polygons will do here, no objects are asked for"},
        Technique{"bsp and pvs", "BSP+PVS", interiors, true, still, inside, soup, all, region, geometry, safe, "pvs",
                  "", "Airey 1990; Teller 1992",
                  "method pvs takes the rooms that the scene marks; the paper's tree finds them in a soup"},
        Technique{
            "portals", "Portals", interiors, true, still, inside, objects, all, region, geometry, safe, "portals", "",
            "Jones 1971; Airey 1990; Teller and Sequin 1991; Luebke and Georges 1995",
            "STR stands for objects or meshes, but what portals need is a scene cut into rooms; Luebke and Georges "
            "find what is seen from a point, though the table has them under volumes"},
        Technique{"octrees and pvs", "Octrees+PVS", exteriors, true, still, outside, objects, all, region, geometry,
                  safe, "", "occluders of which only several together hide something are not joined over a volume here",
                  "Cohen-Or et al. 1998; Durand et al. 2000; Schaufler et al. 2000", ""},
        Technique{"static levels", "Static LODs", by_geometry, true, any_motion, anywhere, objects, near, point,
                  geometry, coarse, "levels", "", "Clark 1976; Funkhouser and Sequin 1993",
                  "NEAR, but section 3.1.3 gives objects coarser levels from the farthest one on; Clark 1974 is cited "
                  "and stands in no list"},
        Technique{"view-dependent meshes", "View-Dependent Progressive Meshes", by_geometry, true, any_motion, anywhere,
                  objects, near, point, geometry, coarse, "", no_meshes,
                  "Xia and Varshney 1996; Hoppe 1997; Luebke and Erikson 1997", ""},
        Technique{"progressive meshes", "View-Independent Progressive Meshes", by_geometry, true, any_motion, anywhere,
                  objects, near, point, geometry, coarse, "", no_meshes, "Hoppe 1996", ""},
        Technique{"parametric surfaces", "Parametric Surfaces", by_geometry, true, any_motion, anywhere, objects, near,
                  point, geometry, coarse, "", "scenes here are triangles and segments; no file gives a curved surface",
                  "Kumar and Manocha 1996; Kumar et al. 1997", ""},
        Technique{"terrain", "Terrain", by_geometry, true, any_motion, outside, objects, all, point, geometry, coarse,
                  "", "needs ground as a field of heights; scenes here are soups",
                  "Lindstrom et al. 1996; Duchaineau et al. 1997; Hoppe 1998", ""},
        Technique{"impostors", "Impostors", by_geometry, true, still, anywhere, soup, far, point, image, coarse, "",
                  no_images, "Maciel and Shirley 1995",
                  "stands among the rows of geometry in the table; section 2.2.2 treats them among images"},
        Technique{"image caches", "Image Caches", by_images, true, still, anywhere, soup, far, point, image, coarse, "",
                  no_images, "Shade et al. 1996; Schaufler and Stuerzlinger 1996", ""},
        Technique{"portal textures", "Portal Textures", by_images, true, still, inside, soup, far, point, image, coarse,
                  "", no_images, "Aliaga and Lastra 1997", "UNSTR, but portals are needed to have a texture"},
        Technique{"pure image based", "Pure Image Based", by_images, true, still, anywhere, soup, far, point, image,
                  coarse, "", no_images, "McMillan and Bishop 1995",
                  "the text names no such technique but for warping"},

        Technique{"view culling", "View culling", in_view, false, any_motion, anywhere, soup, all, point, geometry,
                  safe, "view", "", "Moller and Haines, as DAS 2.1.1 cites it; Clark 1976",
                  "section 2.1.1 describes it, the table leaves it out: every application has it"},
        Technique{"coorg-teller", "Coorg and Teller", object_point, false, any_motion, anywhere, soup, all, point,
                  geometry, safe, "coorg-teller", "", "Coorg and Teller 1996, 1997", ""},
        Technique{"boxes", "Boxes against depth", image_point, false, any_motion, anywhere, soup, all, point, image,
                  safe, "boxes", "", "engines' culling in software", ""},
        Technique{"two passes", "Two passes", image_point, false, any_motion, anywhere, soup, all, point, image, safe,
                  "two-pass", "", "engines' culling on graphics processors", ""},
        Technique{"cplp", "cPLP", image_point, false, any_motion, anywhere, soup, all, point, image, safe, "cplp", "",
                  "gem; Klosowski and Silva 2001", ""},
        Technique{"plp", "PLP", in_order, false, any_motion, anywhere, soup, all, point, geometry, guess, "published",
                  "", "TR; TVCG 2000", ""},
        Technique{"layers", "Layers", in_order, false, any_motion, anywhere, soup, all, point, geometry, guess,
                  "layers", "", "gem", ""},
        Technique{"centroid order", "Nearest first", in_order, false, any_motion, anywhere, soup, all, point, geometry,
                  guess, "centroid", "", "TVCG 4.5", ""},
        Technique{"extinction", "Extinction", in_order, false, any_motion, anywhere, soup, all, point, geometry, guess,
                  "extinction", "", "what the gem wishes for", ""},
        Technique{"light", "Light", in_order, false, any_motion, anywhere, soup, all, point, geometry, guess, "flux",
                  "", "here", ""},
        Technique{"light and size", "Light and size", in_order, false, any_motion, anywhere, soup, all, point, geometry,
                  guess, "tri", "", "here", ""},
        Technique{"depth feedback", "Depth feedback", in_order, false, any_motion, anywhere, soup, all, point, image,
                  guess, "tri-z", "", "here; TVCG 7 wishes for it", ""},
        Technique{"choice by viewpoint", "Choice by viewpoint", "Visibility / By viewpoint", false, still, anywhere,
                  soup, all, region, geometry, safe, "by-viewpoint", "", "DAS 3",
                  "does what the technique does that a table names for the eye's region and direction"},
    };
}
constexpr auto technique_rows = all_techniques();

/// What rooms a scene has for a technique that needs some.
template <int D>
Suitability inside_of(const Scene<D>& scene) {
    if (scene.rooms.empty()) return {Suits::no, "it needs rooms, and the scene marks none"};
    const bool opens = std::any_of(scene.rooms.portals.begin(), scene.rooms.portals.end(),
                                   [](const Portal<D>& p) { return p.rooms[0] == none || p.rooms[1] == none; });
    const std::string rooms = "the scene marks " + counted(scene.rooms.all.size(), "room") + " and " +
                              counted(scene.rooms.portals.size(), "portal");
    if (!opens) return {Suits::yes, rooms};
    return {Suits::in_part, rooms + "; outside them another technique has to take over"};
}

}  // namespace

std::span<const Technique> techniques() { return technique_rows; }

const Technique* find_technique(std::string_view id) {
    const auto found = std::find_if(technique_rows.begin(), technique_rows.end(),
                                    [&](const Technique& t) { return t.id == id || (t.is_here() && t.method == id); });
    return found == technique_rows.end() ? nullptr : &*found;
}

template <int D>
Suitability suitability(const Technique& technique, const Scene<D>& scene) {
    if (technique.id == "terrain") return {Suits::no, "the scene is a soup and marks no ground"};
    if (technique.id == "parametric surfaces")
        return {Suits::no, D == 2 ? "the scene is made of segments" : "the scene is made of triangles"};
    if (technique.place == ScenePlace::inside) return inside_of(scene);
    Suitability found{Suits::yes, "it asks for nothing that the scene does not have"};
    if (technique.place == ScenePlace::outside && !scene.rooms.empty())
        found = {Suits::in_part, "only outside the " + counted(scene.rooms.all.size(), "room") + " of the scene"};
    const bool of_detail = technique.category.starts_with("Detail");
    if (technique.structure == SceneStructure::objects && !of_detail)
        found.reason = (found.suits == Suits::yes ? "" : found.reason + "; ") +
                       "it asks for objects in boxes, and boxes of a tree over all primitives will do";
    if (technique.structure == SceneStructure::objects && of_detail) {
        const std::string parts = scene.objects.empty()
                                      ? "the scene names no objects: parts that hang together stand for them"
                                      : "the scene names " + counted(scene.objects.names.size(), "object");
        if (found.suits == Suits::yes)
            found = {scene.objects.empty() ? Suits::in_part : Suits::yes, parts};
        else
            found.reason += "; " + parts;
    }
    if (technique.reach == SceneReach::near) found.reason += "; it pays for what is near";
    if (technique.reach == SceneReach::far) found.reason += "; it pays for what is far";
    return found;
}

template Suitability suitability<2>(const Technique&, const Scene<2>&);
template Suitability suitability<3>(const Technique&, const Scene<3>&);

std::string needs_words(const Technique& t) {
    std::string text =
        std::string(word(t.motion)) + ", " + std::string(word(t.place)) + ", " + std::string(word(t.structure));
    if (t.reach != SceneReach::any) text += ", " + std::string(word(t.reach));
    return text;
}

std::string finds_words(const Technique& t) {
    return std::string(word(t.finding)) + ", from a " + std::string(word(t.from)) + ", in " + std::string(word(t.in));
}

std::string techniques_markdown() {
    std::string text = "| technique | scenes | finds | here |\n|---|---|---|---|\n";
    std::string notes;
    std::string_view category;
    for (const Technique& t : technique_rows) {
        if (t.category != category) {
            category = t.category;
            text += "| *" + std::string(category) + (t.in_table ? "*" : ", added here*") + " | | | |\n";
        }
        text += "| " + std::string(t.name) + " (" + std::string(t.source) + ") | " + needs_words(t) + " | " +
                finds_words(t) + " | " +
                (t.is_here() ? "[" + std::string(t.method) + "](#" + std::string(t.method) + ")"
                             : "no: " + std::string(t.absent)) +
                " |\n";
        if (!t.note.empty()) notes += "- **" + std::string(t.name) + "**: " + std::string(t.note) + ".\n";
    }
    return text + "\n" + notes;
}

}  // namespace sightline
