// Table 1 of the paper on algorithm selection: as printed, tied to the methods that are here, and in the documents.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/techniques.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/base/file.h"
#include "core/methods/method_table.h"
#include "core/scene/make/catalogue.h"

namespace sightline {
namespace {

// The rows as printed, columns as the paper abbreviates them.
TEST(Techniques, TheTableIsThatOfThePaper) {
    const std::string printed = R"(Hierarchical z-buffer|DYN/STA, IN/OUT, UNSTR
HOMs|DYN/STA, IN/OUT, STR
Shadow Frusta|DYN/STA, IN/OUT, STR
BSP+PVS|STA, IN, UNSTR
Portals|STA, IN, STR
Octrees+PVS|STA, OUT, STR
Static LODs|DYN/STA, IN/OUT, STR, NEAR
View-Dependent Progressive Meshes|DYN/STA, IN/OUT, STR, NEAR
View-Independent Progressive Meshes|DYN/STA, IN/OUT, STR, NEAR
Parametric Surfaces|DYN/STA, IN/OUT, STR, NEAR
Terrain|DYN/STA, OUT, STR
Impostors|STA, IN/OUT, UNSTR, FAR
Image Caches|STA, IN/OUT, UNSTR, FAR
Portal Textures|STA, IN, UNSTR, FAR
Pure Image Based|STA, IN/OUT, UNSTR, FAR
)";
    std::string rows;
    bool after = false;
    for (const Technique& technique : techniques()) {
        EXPECT_FALSE(after && technique.in_table) << "what is added comes after the table";
        after = !technique.in_table;
        if (technique.in_table) rows += std::string(technique.name) + "|" + needs_words(technique) + "\n";
    }
    EXPECT_EQ(rows, printed);
}

TEST(Techniques, RowsAreComplete) {
    std::set<std::string_view> ids;
    for (const Technique& technique : techniques()) {
        SCOPED_TRACE(technique.id);
        EXPECT_TRUE(ids.insert(technique.id).second);
        EXPECT_EQ(find_technique(technique.id), &technique);
        for (const std::string_view text : {technique.name, technique.category, technique.source})
            EXPECT_FALSE(text.empty());
        for (const std::string_view text : {technique.absent, technique.note})
            EXPECT_TRUE(text.empty() || text.back() != '.');
        EXPECT_NE(technique.is_here(), !technique.absent.empty()) << "here, or absent for a reason";
        EXPECT_NE(technique.finding == Finding::simplified, technique.category.starts_with("Visibility"));
    }
    EXPECT_EQ(find_technique("frontier"), nullptr);
    EXPECT_EQ(find_technique("hom"), find_technique("occlusion maps"));
}

/// What stands in the table of methods but is no technique: references, what a person or a file makes up, and what is
/// another method from another start.
const std::set<std::string_view> no_techniques = {"everything", "perfect", "formula", "listed", "tri-seen"};

template <int D>
void expect_rows() {
    for (const Method<D>& method : method_table<D>()) {
        SCOPED_TRACE(method.id);
        const Technique* const technique = find_technique(method.id);
        ASSERT_EQ(technique != nullptr, !no_techniques.contains(method.id));
        if (!technique) continue;
        EXPECT_EQ(technique->method, method.id);
        if (technique->finding != Finding::simplified) {
            EXPECT_EQ(technique->finding == Finding::conservative, method.promise != Misses::may);
        }
    }
    for (const Technique& technique : techniques()) {
        if (!technique.is_here()) continue;
        EXPECT_NO_THROW(find_method<D>(method_table<D>(), technique.method)) << technique.id;
    }
}

TEST(Techniques, EveryMethodIsOneAndEachThatIsHereHasItsMethod) {
    expect_rows<2>();
    expect_rows<3>();
}

TEST(Techniques, ASceneSaysWhichSuitIt) {
    const Scene<3> campus = *generated_scene("campus:10k"), city = *generated_scene("city:10k");
    const auto fits = [](const char* id, const auto& scene) { return suitability(*find_technique(id), scene); };
    EXPECT_EQ(fits("portals", city).suits, Suits::no);
    EXPECT_EQ(fits("portals", city).reason, "it needs rooms, and the scene marks none");
    EXPECT_EQ(fits("portals", campus).suits, Suits::in_part);
    EXPECT_NE(fits("portals", campus).reason.find("26 rooms"), std::string::npos);
    EXPECT_EQ(fits("octrees and pvs", city).suits, Suits::yes);
    EXPECT_EQ(fits("octrees and pvs", campus).suits, Suits::in_part);
    EXPECT_EQ(fits("static levels", city).suits, Suits::in_part);
    EXPECT_EQ(fits("static levels", campus).suits, Suits::yes);
    EXPECT_EQ(fits("terrain", campus).suits, Suits::no);
    Scene<3> closed = campus;
    std::erase_if(closed.rooms.portals, [](const Portal<3>& p) { return p.rooms[1] == none; });
    EXPECT_EQ(fits("portals", closed).suits, Suits::yes);
    // Whatever the scene, each gets a reason, and what asks for nothing suits.
    const Scene<2> rooms = make_scene(*find_in_catalogue<2>("rooms"));
    for (const Technique& technique : techniques()) {
        for (const Suitability& found :
             {suitability(technique, campus), suitability(technique, city), suitability(technique, rooms)}) {
            EXPECT_FALSE(found.reason.empty() || found.reason.back() == '.') << technique.id;
            EXPECT_TRUE(technique.in_table || found.suits == Suits::yes) << technique.id;
        }
    }
}

TEST(Techniques, TheDocumentShowsThem) {
    const std::string page = read_file(SIGHTLINE_SOURCE_DIR "/docs/methods.md");
    EXPECT_NE(page.find("\n\n" + techniques_markdown() + "\n"), std::string::npos) << "docs/methods.md should show:\n"
                                                                                   << techniques_markdown();
}

}  // namespace
}  // namespace sightline
