// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/wrap.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace sightline {
namespace {

std::string wrapped(const std::string& text, double width) {
    return wrapped_at_spaces(text, width, [](std::string_view line) { return static_cast<double>(line.size()); });
}

TEST(Wrap, BreaksAtSpacesOnly) {
    EXPECT_EQ(wrapped("wrong 12.9%, coverage 48.2%", 24), "wrong 12.9%, coverage\n48.2%");
    EXPECT_EQ(wrapped("fits", 4), "fits");
    EXPECT_EQ(wrapped("", 4), "");
    EXPECT_EQ(wrapped("a-word-of-its-own b", 4), "a-word-of-its-own\nb");
    EXPECT_EQ(wrapped("one\ntwo three", 9), "one\ntwo three") << "a line of its own begins anew";
}

TEST(Wrap, KeepsEveryCharacterAndFillsLines) {
    Random random(91);
    for (int round = 0; round < 500; ++round) {
        std::string text = "a";  // words with a space or a line break between
        for (std::size_t i = random.below(30); i-- > 0;) {
            if (random.below(3) == 0) text += random.below(6) ? ' ' : '\n';
            text += "ab."[random.below(3)];
        }
        const std::size_t width = 1 + random.below(20);
        const std::string lines = wrapped(text, static_cast<double>(width));
        ASSERT_EQ(lines.size(), text.size());
        std::size_t begin = 0;
        for (std::size_t i = 0; i <= lines.size(); ++i) {
            if (i < lines.size()) {
                ASSERT_TRUE(lines[i] == text[i] || (lines[i] == '\n' && text[i] == ' '));
                if (lines[i] != '\n') continue;
            }
            const std::string line = lines.substr(begin, i - begin);
            EXPECT_TRUE(line.size() <= width || line.find(' ', 1) == std::string::npos) << '"' << text << '"';
            if (i < lines.size() && text[i] == ' ') {
                const std::size_t next = std::min(text.find_first_of(" \n", i + 1), text.size());
                EXPECT_GT(next - begin, width) << "the next word had room: " << text;
            }
            begin = i + 1;
        }
    }
}

TEST(Wrap, ShortensToWholeCharacters) {
    const auto width = [](std::string_view text) {  // in characters
        return static_cast<double>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
    };
    EXPECT_EQ(shortened("fits", 4, width), "fits");
    EXPECT_EQ(shortened("one two three", 9, width), "one two…");
    EXPECT_EQ(shortened("ρρρρρρ", 4, width), "ρρρ…");
    EXPECT_EQ(shortened("too long", 0, width), "…");
}

}  // namespace
}  // namespace sightline
