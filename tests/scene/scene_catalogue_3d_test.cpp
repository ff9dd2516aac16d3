// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "core/scene/clean.h"
#include "core/scene/make/catalogue.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

TEST(SceneCatalogue3, RowsAreComplete) {
    std::set<std::string> ids;
    for (const CatalogueRow<3>& row : catalogue<3>()) {
        SCOPED_TRACE(row.id);
        EXPECT_TRUE(ids.insert(row.id).second);
        EXPECT_EQ(find_in_catalogue<3>(row.id), &row);
        const std::string lesson = row.lesson;
        EXPECT_GT(lesson.size(), 60u);
        EXPECT_EQ(lesson.back(), '.');
        EXPECT_EQ(lesson.find(". "), std::string::npos) << "one sentence";
        EXPECT_GT(row.error_bound, 0);
        EXPECT_LE(row.error_bound, 1);
        EXPECT_FALSE(row.bookmarks.empty());
        check_view(row.view, row.id, "view");
        ASSERT_FALSE(row.paths.empty());
        EXPECT_STREQ(row.paths.back(), "test");
    }
    EXPECT_EQ(find_in_catalogue<3>("nothing"), nullptr);
}

TEST(SceneCatalogue3, NamesCarrySizes) {
    EXPECT_FALSE(generated_scene("nothing").has_value());
    EXPECT_FALSE(generated_scene("nothing:10k").has_value());
    EXPECT_FALSE(generated_scene("streets").has_value());
    const Scene<3> scene = *generated_scene("city:20k");
    EXPECT_EQ(scene_hash(scene), scene_hash(*generated_scene("city:20000")));
    EXPECT_EQ(scene.id, "city");
    EXPECT_EQ(scene.source, "generated");
    for (const std::string size : {"", "9999", "9k", "17M", "16000001", "-20k", "20K", "k", "1.5M", "20 k", "20k,", "x",
                                   "99999999999999999999", "4000000000M"})
        test::expect_input_error(
            [&] { generated_scene("city:" + size); },
            "city:" + size + ": \"" + size +
                "\" is not a size: write a number of triangles from 10k to 16M, such as 20000, 500k or 2M");
    // Scenes that are smaller can be asked for as they are, not smaller still.
    EXPECT_EQ(scene_hash(*generated_scene("soda:3394")), scene_hash(*generated_scene("soda")));
    test::expect_input_error([] { generated_scene("soda:3393"); },
                             "soda:3393: \"3393\" is not a size: write a number of triangles from 3394 to 16M, such as "
                             "20000, 500k or 2M");
    test::expect_input_error([] { generated_scene("blocks:1k"); },
                             "blocks:1k: \"1k\" is not a size: write a number of triangles from 5520 to 16M, such as "
                             "20000, 500k or 2M");
}

}  // namespace
}  // namespace sightline
