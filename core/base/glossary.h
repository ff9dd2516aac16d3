// The words of the field as this project uses them: one table, which the window, the documents and pages read.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sightline {

/// A term, one sentence on it, and where it is defined: a paper's section, or "here".
struct GlossaryEntry {
    std::string_view term;
    std::string_view sentence;
    std::string_view source;
};

/// In the order in which one needs them: what is looked at, the traversal, the key, the measures, the window.
std::span<const GlossaryEntry> glossary();

/// The entry of a term, whatever the case of its letters; nullptr: there is none.
const GlossaryEntry* find_term(std::string_view term);

/// A term within a text, with the s of its plural.
struct TermSpot {
    std::size_t first = 0, count = 0;  ///< bytes
    const GlossaryEntry* entry = nullptr;
};

/// The longest term of which the byte `at` is a part; without an entry where there is none.
TermSpot term_at(std::string_view text, std::size_t at);

/// The table of docs/glossary.md.
std::string glossary_markdown();

}  // namespace sightline
