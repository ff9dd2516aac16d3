// The glossary: one entry per term, whole sentences, and the document that shows it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/glossary.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/file.h"

namespace sightline {
namespace {

TEST(Glossary, EachTermHasOneSentenceAndASource) {
    std::set<std::string_view> terms;
    for (const GlossaryEntry& entry : glossary()) {
        SCOPED_TRACE(entry.term);
        EXPECT_TRUE(terms.insert(entry.term).second);
        EXPECT_EQ(find_term(entry.term), &entry);
        EXPECT_EQ(entry.sentence.back(), '.');
        EXPECT_EQ(entry.sentence.find(". "), std::string_view::npos) << "more than one sentence";
        EXPECT_FALSE(entry.source.empty());
    }
    EXPECT_EQ(find_term("front")->term, "front");
    EXPECT_EQ(find_term("FRONT")->term, "front");
    EXPECT_EQ(find_term("frontier"), nullptr);
}

TEST(Glossary, TheDocumentShowsIt) {
    const std::string page = read_file(std::string(SIGHTLINE_SOURCE_DIR) + "/docs/glossary.md");
    EXPECT_TRUE(page.ends_with("\n\n" + glossary_markdown())) << "docs/glossary.md should end with:\n"
                                                              << glossary_markdown();
}

TEST(Glossary, FindsTheTermUnderAPlaceInAText) {
    const std::string text = "Seed cells lie in the front; unseen ones, or recellular, do not: re-enqueued";
    const auto at = [&](std::string_view part) {
        const TermSpot spot = term_at(text, text.find(part));
        return spot.entry ? std::string(spot.entry->term) + "|" + text.substr(spot.first, spot.count) : "";
    };
    EXPECT_EQ(at("Seed"), "seed cell|Seed cells") << "the longest, in the plural, whatever the case";
    EXPECT_EQ(at("s lie"), "seed cell|Seed cells");
    EXPECT_EQ(at(" lie"), "");
    EXPECT_EQ(at("ront;"), "front|front");
    EXPECT_EQ(at("unseen"), "unseen|unseen");
    EXPECT_EQ(at("cellular"), "") << "within a word";
    EXPECT_EQ(term_at("", 0).entry, nullptr);
    EXPECT_EQ(term_at("cell", 9).entry, nullptr);
    for (const GlossaryEntry& entry : glossary())
        for (std::size_t i = 0; i < entry.term.size(); ++i) EXPECT_EQ(term_at(entry.term, i).entry, &entry);
}

}  // namespace
}  // namespace sightline
