// Words inside other languages: each language reads back what was put in, and runs nothing of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/quote.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "core/base/file.h"
#include "core/base/random.h"
#include "core/base/text.h"
#include "core/process/run_program.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;

/// Words of what means something to gnuplot, shells, HTML or CSV.
std::vector<std::string> hostile_words(std::uint64_t seed, std::size_t count) {
    static const std::vector<std::string> parts{"'",
                                                "\"",
                                                "`touch hacked`",
                                                "$(touch hacked)",
                                                "\\",
                                                "\n",
                                                "\r",
                                                "\t",
                                                "%s",
                                                "@a",
                                                "<script>",
                                                "&amp;",
                                                "{/*2 b}",
                                                "^",
                                                "_",
                                                "]]>",
                                                "!!",
                                                "#",
                                                ";",
                                                "|",
                                                "~",
                                                "=",
                                                "*",
                                                "?",
                                                "-",
                                                " ",
                                                "END",
                                                "ρ",
                                                "\xff",
                                                "\xc3",
                                                "\x01",
                                                "\x1b[0m",
                                                "\x7f",
                                                "a",
                                                "7",
                                                ","};
    Random random(seed);
    std::vector<std::string> words;
    while (words.size() < count) {
        std::string word;
        for (std::size_t i = random.below(9); i-- > 0;)
            word += parts[random.below(static_cast<std::uint32_t>(parts.size()))];
        words.push_back(word);
    }
    words.push_back(std::string(3000, '\''));
    return words;
}

class Quote : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path folder_ = fs::temp_directory_path() / ("sightline-quote-" + std::to_string(getpid()));
};

TEST_F(Quote, ShellsReadBackEveryByte) {
    const std::vector<std::string> words = hostile_words(1, 500);
    std::string script = "printf '%s\\0'", expected;
    for (const std::string& word : words) {
        script += " " + shell_quoted(word);
        expected += word + '\0';
    }
    EXPECT_EQ(script.find('\n'), std::string::npos);
    write_file(folder_ / "script", script + " > words\n");
    run_program({"bash", "./script"}, "bash", folder_);
    EXPECT_EQ(read_file(folder_ / "words"), expected);
    EXPECT_FALSE(fs::exists(folder_ / "hacked"));
    EXPECT_EQ(shell_quoted("out/a-b_c.json"), "out/a-b_c.json");
    EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_quoted(""), "''");
    EXPECT_EQ(shell_quoted("a\nb"), "$'a\\012b'");
}

TEST_F(Quote, GnuplotReadsBackTheTextOnOneLine) {
    const std::vector<std::string> words = hostile_words(2, 500);
    std::string script = "set print './words'\na = 'expanded'\n";
    for (const std::string& word : words)
        script += "print " + gnuplot_quoted(word) + ".'|'." + gnuplot_quoted(word) + "\n";
    write_file(folder_ / "script.gp", script);
    run_program({"gnuplot", "-d", "./script.gp"}, "gnuplot-nox", folder_);
    std::istringstream in(read_file(folder_ / "words"));
    for (const std::string& word : words) {
        std::string expected = clean_text(word), line;
        std::replace(expected.begin(), expected.end(), '\n', ' ');
        for (std::size_t at; (at = expected.find("]]>")) != std::string::npos;) expected.replace(at, 3, "]] >");
        for (std::size_t at; (at = expected.find('\'')) != std::string::npos;) expected.replace(at, 1, "\u2019");
        ASSERT_TRUE(std::getline(in, line));
        EXPECT_EQ(line, expected + "|" + expected);
    }
    EXPECT_FALSE(fs::exists(folder_ / "hacked"));
}

TEST_F(Quote, MarkupIsText) {
    std::string page = "<page>\n";
    for (const std::string& word : hostile_words(3, 500))
        page += "<a b=\"" + escaped(word) + "\" c='" + escaped(word) + "'>" + escaped(word) + "</a>\n";
    write_file(folder_ / "page.xml", page + "</page>\n");
    EXPECT_EQ(escaped("<&>\"'\x01\t"), "&lt;&amp;&gt;&quot;&#39; ");
    if (std::system("command -v xmllint > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "xmllint (libxml2-utils) is not installed";
    EXPECT_NO_THROW(run_program({"xmllint", "--noout", "page.xml"}, "libxml2-utils", folder_));
}

TEST_F(Quote, TablesKeepTheirColumns) {
    EXPECT_EQ(csv_field("plain 5%"), "plain 5%");
    EXPECT_EQ(csv_field("a,\"b\"\r"), "\"a,\"\"b\"\"\r\"");
    EXPECT_EQ(markdown_escaped("a|b\n`c` <d> on_x &"), "a\\|b \\`c\\` &lt;d> on\\_x &amp;");
}

TEST_F(Quote, ProgramsStartInTheirFolder) {
    run_program({"touch", "here"}, "coreutils", folder_);
    EXPECT_TRUE(fs::exists(folder_ / "here"));
}

}  // namespace
}  // namespace sightline
