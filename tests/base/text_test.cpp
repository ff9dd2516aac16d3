// Words from elsewhere in a line for a terminal.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/base/excerpt.h"
#include "core/base/number.h"

#include <gtest/gtest.h>

namespace sightline {
namespace {

TEST(Text, TimesAreNeverTooShortToRead) {
    EXPECT_EQ(milliseconds_text(0), "0 ms");
    EXPECT_EQ(milliseconds_text(5e-5), "0.05 µs");
    EXPECT_EQ(milliseconds_text(0.00123), "0.00123 ms");
    EXPECT_EQ(milliseconds_text(12.34), "12.3 ms");
}

TEST(Text, OneLineIsFitForATerminal) {
    EXPECT_EQ(one_line("plain, ρ and 東"), "plain, ρ and 東");
    EXPECT_EQ(one_line("a\x1b[31mb\r\n\t\x7f"
                       "c"),
              "a?[31mb????c");
    EXPECT_EQ(one_line("a\xc2\x9b"
                       "2J"),
              "a?2J")
        << "a command to some terminals, as UTF-8";
    EXPECT_EQ(one_line("a\x9b"
                       "2J"),
              "a?2J")
        << "and as a byte";
    EXPECT_EQ(one_line("\xc2\xa0ok"), "\xc2\xa0ok");
    EXPECT_EQ(one_line("\xff\xc3"), "??");
    EXPECT_EQ(one_line("\xc2"), "?") << "half a character at the end";
    EXPECT_EQ(one_line("abcdef", 3), "abc...");
    EXPECT_EQ(one_line("aρρ", 4), "aρ...") << "no half character";
}

TEST(Text, ExcerptsAndErrorLinesAreShort) {
    EXPECT_EQ(excerpt("short"), "short");
    EXPECT_EQ(excerpt(std::string(1000, 'x')).size(), 63u);
    const std::string line = error_line("file " + std::string(5000, 'x') + ": the reason");
    EXPECT_LT(line.size(), 420u);
    EXPECT_TRUE(line.starts_with("file xxx"));
    EXPECT_TRUE(line.ends_with("x: the reason"));
    EXPECT_EQ(error_line("as it is"), "as it is");
}

}  // namespace
}  // namespace sightline
