// Commands that answer in words.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/glossary.h"
#include "core/methods/techniques.h"
#include "core/session/explain.h"
#include "core/session/explain_box.h"
#include "core/session/explain_primitive.h"
#include "core/session/explanation_json.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/faults.h"
#include "shell/desk/fly.h"
#include "shell/desk/moved.h"
#include "shell/desk/what_if.h"
#include "shell/export/export.h"
#include "shell/panels/panel_table.h"

namespace sightline {

namespace {

template <int D>
void say_all(Workbench<D>& bench, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) bench.say(line);
}

/// What of a command's words is left when the file that they may end with is taken off.
struct Asked {
    std::vector<std::string> words;
    std::string file;
};
Asked read_asked(Text text) {
    Asked asked;
    for (std::array<std::string, 2> parts = split_word(text); !parts[0].empty(); parts = split_word(parts[1]))
        asked.words.push_back(parts[0]);
    if (!asked.words.empty() && asked.words.back().ends_with(".json")) {
        asked.file = asked.words.back();
        asked.words.pop_back();
    }
    return asked;
}

template <int D>
void say_cell(Workbench<D>& bench, Text id, const std::string& file) {
    const Session<D>& session = bench.session;
    const std::uint32_t cell = cell_argument(bench, id);
    const CellExplanation e = explain_cell(session, cell);
    const Counterfactuals all = counterfactuals(session, cell_item(cell));
    if (!file.empty()) return write_text(file, explanation_json(session, e, all));
    say_all(bench, rows(e));
    if (session.method().orders_cells()) say_all(bench, rows(all));
}

template <int D>
void say_primitive(Workbench<D>& bench, Text id, bool seeds, const std::string& file) {
    const Session<D>& session = bench.session;
    const PrimitiveExplanation e = explain_primitive(session, primitive_argument(bench, id));
    const Counterfactuals all = counterfactuals(session, primitive_item(e.primitive), seeds);
    if (!file.empty()) return write_text(file, explanation_json(session, e, all));
    say_all(bench, rows(session, e));
    say_all(bench, rows(all));
}

template <int D>
void say_box(Workbench<D>& bench, Text id) {
    bench.say(box_sentence(bench.session, node_argument(bench, id)));
}

template <int D>
void explain(Workbench<D>& bench, Text text) {
    const Session<D>& session = bench.session;
    const auto [words, file] = read_asked(text);
    const std::string kind = words.empty() ? "" : words[0];
    if (kind == "cell" && words.size() == 2) return say_cell(bench, words[1], file);
    if (kind == "node" && words.size() == 2 && file.empty()) return say_box(bench, words[1]);
    if (kind == "primitive" && (words.size() == 2 || (words.size() == 3 && words[2] == "seeds")))
        return say_primitive(bench, words[1], words.size() == 3, file);
    std::uint32_t step = session.position();
    if (kind == "step" && words.size() == 2) step = whole_argument(words[1], "a step");
    if (!file.empty() || (!words.empty() && (kind != "step" || words.size() != 2)))
        throw InputError("write explain, explain step N, explain cell ID, explain node ID or explain primitive ID");
    if (step == 0) return bench.say("Step 0: the seed cell is in the front, nothing is projected yet.");
    if (step > session.position())
        throw InputError("step " + std::to_string(step) + " has not been made yet; the session is at step " +
                         std::to_string(session.position()));
    say_all(bench, rows(explain_step(session, step)));
}

/// What one change would do to what is selected; the panel keeps it.
template <int D>
void what_if_changed(Workbench<D>& bench, Text text) {
    if (!text.empty()) throw InputError("what-if takes no arguments; select a cell or a primitive first");
    if (!selected_item(bench)) throw InputError("select a cell or a primitive first");
    update_what_if(bench, true);
    if (const Counterfactuals* all = what_if(bench)) return say_all(bench, rows(*all));
    bench.say("this method orders no cells: select a primitive");
}

template <int D>
void front(Workbench<D>& bench, Text) {
    for (const Row& row : conceal_rows(bench, front_rows(bench)))
        bench.say((row.tone == Tone::heading ? "" : "  ") + row.text);
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

/// The list, or one region: selected at the end of the run, with what keeps it out.
template <int D>
void missed_regions(Workbench<D>& bench, Text text) {
    if (!text.empty()) {
        hunt(bench, whole_argument(text, "the number of a wrong region"));
        take_along(bench);
        const PrimitiveExplanation e = explain_primitive(bench.session, bench.session.selected_primitive);
        bench.say(sight_sentence(bench.session, e));
        const std::string why = put_off_sentence(bench.session, e);
        return bench.say(why.empty() ? met_sentence(e, bench.session.position()) : why);
    }
    update_faults(bench);
    for (const Row& row : missed_rows(bench)) bench.say(as_line(row));
}

template <int D>
void objects(Workbench<D>& bench, Text) {
    update_faults(bench, true);
    for (const Row& row : object_rows(bench)) bench.say(as_line(row));
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

/// The words of the field, or one of them.
template <int D>
void say_glossary(Workbench<D>& bench, Text text) {
    const auto say = [&](const GlossaryEntry& entry) {
        bench.say(std::string(entry.term) + ": " + std::string(entry.sentence) +
                  (entry.source == "here" ? "" : " (" + std::string(entry.source) + ")"));
    };
    if (!text.empty()) {
        const GlossaryEntry* const entry = find_term(text);
        if (!entry) throw InputError("the glossary has no '" + text + "'; glossary lists its terms");
        return say(*entry);
    }
    for (const GlossaryEntry& entry : glossary()) say(entry);
}

/// All, or what there is to know of one.
template <int D>
void say_techniques(Workbench<D>& bench, Text text) {
    if (text.empty()) {
        for (const Row& row : technique_rows(bench)) bench.say(as_line(row));
        return;
    }
    const Technique* const technique = find_technique(text);
    if (!technique) throw InputError("there is no technique '" + text + "'; techniques lists them");
    const Suitability found = suitability(*technique, bench.session.scene());
    const auto say = [&](std::string_view a, std::string_view b) { bench.say(std::string(a) + std::string(b)); };
    say(technique->name, technique->is_here() ? ": method " + std::string(technique->method) : ": not here");
    say(technique->in_table ? "DAS, table 1: " : "Added here to table 1 of DAS: ", technique->category);
    bench.say("Scenes: " + needs_words(*technique) + ". Finds: " + finds_words(*technique) + ".");
    bench.say("This scene: " + std::string(word(found.suits)) + "; " + found.reason + ".");
    if (!technique->is_here()) say("Not here: ", std::string(technique->absent) + ".");
    say("Source: ", std::string(technique->source) + ".");
    if (!technique->note.empty()) say("Note: ", std::string(technique->note) + ".");
}

/// What all panels say, for readers of the screen and for scripts.
template <int D>
void panels(Workbench<D>& bench, Text text) {
    update_what_if(bench);
    update_faults(bench, true);
    if (!text.empty()) return write_text(text, panels_text(bench));
    bench.say(panels_text(bench));
}

constexpr std::array regions{NamedArgument{"Largest wrong region", "1"}};
constexpr std::array written{NamedArgument{"Write panels", "panels.txt"}};

}  // namespace

template <int D>
std::span<const Command<D>> say_commands() {
    static constexpr std::array table{
        Command<D>{"explain", "Explain", "[step N | cell ID | node ID | primitive ID [seeds]] [FILE.json]",
                   "explain a step, why a cell or a box waits, or why a primitive is visible or hidden", "",
                   explain<D>},
        Command<D>{"what-if", "What if", "",
                   "change one parameter at a time; say when the selected cell or primitive is then reached", "",
                   what_if_changed<D>},
        Command<D>{"front", "List front", "", "list the front", "", front<D>},
        Command<D>{"inversions", "List inversions", "", "list hidden cells projected before visible ones", "",
                   list_inversions<D>},
        Command<D>{"missed", "Wrong regions", "[N]",
                   "list the wrong regions, largest first; with a number, go to the end and say why that one is missed",
                   "Shift+W=1", missed_regions<D>, "", regions},
        Command<D>{"objects", "List objects", "", "list what is missed and drawn in vain, object by object", "",
                   objects<D>},
        Command<D>{"markers", "List markers", "",
                   "list penalties, inversions, the first wrong pixel, budget ticks, pops and bookmarks", "",
                   markers<D>},
        Command<D>{"techniques", "Techniques", "[NAME]",
                   "list which techniques suit this scene and why, or say all about one", "", say_techniques<D>},
        Command<D>{"glossary", "Glossary", "[TERM]", "explain the terms used here", "", say_glossary<D>},
        Command<D>{"panels", "Panels as text", "[FILE]", "print the text of all panels", "F12=panels.txt", panels<D>,
                   "", written},
    };
    return table;
}

template std::span<const Command<2>> say_commands<2>();
template std::span<const Command<3>> say_commands<3>();

}  // namespace sightline
