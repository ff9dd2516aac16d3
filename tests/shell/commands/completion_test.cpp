// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands/completion.h"

#include <fstream>

#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using Completions = test::Commands;

TEST_F(Completions, AreCommandsAndWhatTheyTake) {
    const auto tab = [&](const std::string& line) { return completed(line, completions(*bench, line)); };
    EXPECT_EQ(tab("met"), "method ");
    EXPECT_EQ(tab("method lay"), "method layers ");
    EXPECT_EQ(tab("step; met"), "step; method ");
    EXPECT_EQ(tab("set pen"), "set penalty");
    EXPECT_EQ(tab("set on_r"), "set on_reenqueue=");
    EXPECT_EQ(tab("set on_reenqueue=mi"), "set on_reenqueue=min ");
    EXPECT_EQ(tab("freeze d"), "freeze direction ");
    EXPECT_EQ(tab("show inv"), "show inversions ");
    EXPECT_EQ(tab("lesson pl"), "lesson plp ");
    EXPECT_EQ(tab("open bott"), "open bottleneck ");
    EXPECT_EQ(tab("nosuch thing"), "nosuch thing") << "nothing to complete is left alone";
    std::ofstream(folder / "a long name.json") << "{}";
    std::ofstream(folder / "shelf.json") << "{}";
    EXPECT_EQ(tab("open " + file("she")), "open " + file("shelf.json") + " ");
    EXPECT_EQ(tab("open " + folder.string().substr(0, folder.string().size() - 1)), "open " + folder.string() + "/");
}

TEST_F(Completions, EachBeginsWithWhatIsTypedAndTheSharedBeginningIsLongest) {
    for (const std::string line :
         {"", "s", "se", "set ", "set s", "method ", "open ", "glossary ", "cycle pe", "show "}) {
        const Completion completion = completions(*bench, line);
        ASSERT_FALSE(completion.words.empty()) << line;
        const std::string typed = line.substr(completion.from), now = completed(line, completion);
        EXPECT_TRUE(now.starts_with(line)) << line;
        for (const std::string& word : completion.words) EXPECT_TRUE(word.starts_with(typed)) << line << ": " << word;
        if (completion.words.size() > 1) {
            const std::string shared = now.substr(completion.from);
            EXPECT_TRUE(std::any_of(completion.words.begin(), completion.words.end(),
                                    [&](const std::string& word) {
                                        return word.size() == shared.size() ||
                                               word[shared.size()] != completion.words[0][shared.size()];
                                    }) ||
                        completion.words[0].size() == shared.size())
                << line;
        }
    }
}

}  // namespace
}  // namespace sightline
