// Commands that answer in words.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/session/explain.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/fly.h"
#include "shell/export/export.h"
#include "shell/panels/panel_table.h"

namespace sightline {

namespace {

template <int D>
void say_all(Workbench<D>& bench, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) bench.say(line);
}

template <int D>
void explain(Workbench<D>& bench, Text text) {
    const Session<D>& session = bench.session;
    if (text.starts_with("cell"))
        return say_all(bench, rows(explain_cell(session, cell_argument(bench, split_word(text)[1]))));
    std::uint32_t step = session.position();
    if (text.starts_with("step")) step = whole_argument(split_word(text)[1], "a step");
    if (!text.empty() && !text.starts_with("step"))
        throw InputError("write explain, explain step N or explain cell ID");
    if (step == 0) return bench.say("Step 0: the seed cell is in the front, nothing is projected yet.");
    if (step > session.position())
        throw InputError("step " + std::to_string(step) + " is not done yet; the session stands at step " +
                         std::to_string(session.position()));
    say_all(bench, rows(explain_step(session, step)));
}

template <int D>
void front(Workbench<D>& bench, Text) {
    for (const Row& row : front_rows(bench)) bench.say((row.tone == Tone::heading ? "" : "  ") + row.text);
}

template <int D>
void list_inversions(Workbench<D>& bench, Text) {
    const auto found = bench.session.inversions();
    bench.say("Inversions: " + std::to_string(found.size()) + ", most wasted primitives first.");
    for (const Inversion& i : found)
        bench.say("  step " + std::to_string(i.step) + ": hidden cell " + std::to_string(i.cell) + " before cell " +
                  std::to_string(i.waiting) +
                  (i.kind == Inversion::Kind::mis_ranked ? " (mis-ranked: it was in the front)"
                                                         : " (unreached: it was still clean)") +
                  ", " + std::to_string(i.wasted) + " wasted");
}

template <int D>
void markers(Workbench<D>& bench, Text) {
    const auto say = [&](const std::vector<Marker>& markers) {
        for (const Marker& marker : markers)
            bench.say("  step " + std::to_string(marker.step) + ": " +
                      std::string(marker_words[static_cast<std::size_t>(marker.kind)]) + ", " + marker.label);
    };
    say(bench.session.markers());
    say(frame_pops(bench));
    for (const Bookmark& bookmark : bench.session.bookmarks)
        bench.say("  step " + std::to_string(bookmark.step) + ": bookmark '" + bookmark.label + "'");
}

/// What all panels say, for readers of the screen and for scripts.
template <int D>
void panels(Workbench<D>& bench, Text text) {
    if (!text.empty()) return write_text(text, panels_text(bench));
    bench.say(panels_text(bench));
}

}  // namespace

template <int D>
std::span<const Command<D>> say_commands() {
    static constexpr std::array table{
        Command<D>{"explain", "[step N | cell ID | cell last]", "say why: this step, another, or where a cell stands",
                   "", explain<D>},
        Command<D>{"front", "", "list the front", "", front<D>},
        Command<D>{"inversions", "", "list hidden cells projected before visible ones", "", list_inversions<D>},
        Command<D>{"markers", "", "list penalties, inversions, the first wrong pixel, budget ticks, pops and bookmarks",
                   "", markers<D>},
        Command<D>{"panels", "[FILE]", "what all panels of the window say, as text", "F12=panels.txt", panels<D>},
    };
    return table;
}

template std::span<const Command<2>> say_commands<2>();
template std::span<const Command<3>> say_commands<3>();

}  // namespace sightline
