// docs/methods.md has a section for every method, with all that a reader looks for.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/methods/method_table.h"
#include "core/scene/make/catalogue.h"

namespace sightline {
namespace {

const std::string& page() {
    static const std::string text = read_file(SIGHTLINE_SOURCE_DIR "/docs/methods.md");
    return text;
}

/// From its heading to the next; empty where there is none.
std::string section_of(std::string_view id) {
    const std::size_t begin = page().find("\n## " + std::string(id) + "\n");
    if (begin == std::string::npos) return {};
    return page().substr(begin, page().find("\n## ", begin + 1) - begin);
}

template <int D>
void expect_sections() {
    for (const Method<D>& method : method_table<D>()) {
        const std::string text = section_of(method.id);
        ASSERT_FALSE(text.empty()) << "docs/methods.md has no section \"" << method.id << '"';
        for (const char* part : {"**Idea.**", "**Rule.**", "**Source.**", "**Cost.**", "**Where it fails.**"})
            EXPECT_NE(text.find(part), std::string::npos) << method.id << " does not say " << part;
        const std::size_t option = text.find("--method ");
        ASSERT_NE(option, std::string::npos) << method.id << " has no command";
        const std::size_t at = text.find(method.id, option);
        EXPECT_LE(at, option + std::string_view("--method \"").size()) << method.id << ": the command shows another";
    }
}

TEST(MethodPages, HaveASectionForEveryMethod) {
    expect_sections<2>();
    expect_sections<3>();
}

/// What a section names as the place of a failure is a scene that can be opened.
TEST(MethodPages, NameScenesThatExist) {
    const std::string begin = "**Where it fails.**";
    std::size_t scenes = 0;
    for (const Method<2>& method : method_table<2>()) {
        std::string text = section_of(method.id);
        text = text.substr(text.find(begin) + begin.size());
        text = text.substr(0, text.find("```"));
        for (std::size_t at = text.find('`'); at != std::string::npos; at = text.find('`', at + 1)) {
            const std::size_t end = text.find('`', at + 1);
            const std::string name = text.substr(at + 1, end - at - 1);
            at = end;
            const bool is_method = !section_of(name).empty();
            const bool is_scene = find_in_catalogue<2>(name) || find_in_catalogue<3>(name);
            const bool is_other = name == "distance" || name == "from-above" ||
                                  method.parameter(name.substr(0, name.find('=')));
            EXPECT_TRUE(is_method || is_scene || is_other) << method.id << ": " << name;
            scenes += is_scene;
        }
    }
    EXPECT_GE(scenes, method_table<2>().size());
}

}  // namespace
}  // namespace sightline
