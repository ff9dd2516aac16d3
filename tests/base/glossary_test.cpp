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

}  // namespace
}  // namespace sightline
