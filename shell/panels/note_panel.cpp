// Notes and bookmarks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/panels/panel_table.h"

namespace sightline {

template <int D>
std::vector<Row> note_rows(const Workbench<D>& bench) {
    const Session<D>& s = bench.session;
    std::vector<Row> rows{{"Notes", Tone::heading}};
    for (std::size_t i = 0; i < s.notes.size(); ++i) {
        const Note<D>& note = s.notes[i];
        std::string text = std::to_string(i + 1) + ". " +
                           std::string(note_kind_words[static_cast<std::size_t>(note.kind)]) + ": " + note.text;
        if (note.first_step > 0 || note.last_step != none)
            text += " (steps " + std::to_string(note.first_step) + " to " +
                    (note.last_step == none ? "end" : std::to_string(note.last_step)) + ")";
        rows.push_back({std::move(text)});
    }
    if (s.notes.empty()) rows.push_back({"none; press T, A, R or C, then click in the picture", Tone::faint});
    rows.push_back({"Bookmarks", Tone::heading});
    for (const Bookmark& bookmark : s.bookmarks) {
        Row row{"step " + std::to_string(bookmark.step) + ": " + bookmark.label};
        row.command = "seek " + std::to_string(bookmark.step);
        rows.push_back(std::move(row));
    }
    if (s.bookmarks.empty()) rows.push_back({"none; B gives this step a name", Tone::faint});
    return rows;
}

template std::vector<Row> note_rows<2>(const Workbench<2>&);
template std::vector<Row> note_rows<3>(const Workbench<3>&);

}  // namespace sightline
