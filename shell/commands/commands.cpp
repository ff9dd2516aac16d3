// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands/commands.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <vector>

#include "core/error.h"
#include "core/number.h"
#include "core/session/condition.h"
#include "core/session/explain.h"
#include "core/session/report.h"
#include "core/session/state_file.h"

namespace sightline {

namespace {

using Text = const std::string&;

std::uint32_t whole(Text text, const char* what) {
    const auto number = parse_whole(text);
    if (!number) throw InputError("'" + text + "' is not " + what);
    return *number;
}

std::uint32_t count(Text text) { return text.empty() ? 1 : whole(text, "a number of steps"); }

/// A number, or "last": the cell of the last step.
std::uint32_t cell_id(const Workbench& bench, Text text) {
    const Session<2>& session = bench.session;
    if (text == "last") {
        if (session.position() > 0)
            if (const std::uint32_t cell = session.timeline().steps[session.position() - 1].cell; cell != none)
                return cell;
        throw InputError("no cell has been projected yet");
    }
    const std::uint32_t cell = whole(text, "a cell");
    if (cell >= bench.session.cells().cell_count())
        throw InputError("cell " + text + " does not exist; there are " +
                         std::to_string(bench.session.cells().cell_count()) + ", from 0");
    return cell;
}

/// "first rest" -> {first, rest}
std::array<std::string, 2> split_word(Text text) {
    const std::size_t space = text.find(' ');
    if (space == std::string::npos) return {text, ""};
    return {text.substr(0, space), text.substr(text.find_first_not_of(' ', space))};
}

void say_all(Workbench& bench, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) bench.say(line);
}

void step(Workbench& bench, Text text) {
    const std::uint32_t steps = count(text);
    for (std::uint32_t i = 0; i < steps; ++i) {
        bench.last_stop = bench.session.step();
        if (bench.last_stop != Stop::none) return;
    }
    bench.last_stop = Stop::steps;
}

void back(Workbench& bench, Text text) {
    const std::uint32_t steps = count(text);
    for (std::uint32_t i = 0; i < steps; ++i)
        if (!bench.session.back()) break;
    bench.last_stop = Stop::steps;
}

void seek(Workbench& bench, Text text) {
    if (text == "start") return go_to_step(bench, 0);
    if (text == "end") return run_to_end(bench);
    if (text.starts_with('@')) {
        for (const Bookmark& bookmark : bench.session.bookmarks)
            if (bookmark.label == text.substr(1)) return go_to_step(bench, bookmark.step);
        throw InputError("there is no bookmark '" + text.substr(1) + "'");
    }
    go_to_step(bench, whole(text, "a step, start, end or @BOOKMARK"));
}

void until(Workbench& bench, Text text) {
    const Condition<2> condition(text);
    bench.last_stop = bench.session.run_until([&](const Session<2>& s) { return condition.holds(s); });
}

void change_view(Workbench& bench, const std::function<void(ViewSpec<2>&)>& change) {
    ViewSpec<2> view = bench.session.display_view();
    change(view);
    bench.session.set_view(view);
}

void eye(Workbench& bench, Text text) {
    const Vec<2> p = parse_point(text, bench.session.scene());
    change_view(bench, [&](ViewSpec<2>& view) { view.eye = p; });
}

void look(Workbench& bench, Text text) {
    const Vec<2> p = parse_point(text, bench.session.scene());
    change_view(bench, [&](ViewSpec<2>& view) { view.look_at = p; });
}

void fov(Workbench& bench, Text text) {
    const auto degrees = parse_number(text);
    if (!degrees) throw InputError("'" + text + "' is not an angle in degrees");
    change_view(bench, [&](ViewSpec<2>& view) { view.fov = *degrees; });
}

/// Applies a change of settings and says what it meant for the traversal.
void change_settings(Workbench& bench, const Settings& settings) {
    const std::vector<StepRecord> before = bench.session.timeline().steps;
    if (difference(bench.session.settings(), settings) == Invalidates::scene)
        throw InputError("that setting decides how the scene is read: give it with --set");
    const Invalidates what = bench.session.change(settings);
    if (what < Invalidates::traversal) return;
    const auto& now = bench.session.timeline().steps;
    const std::size_t common = std::min(before.size(), now.size());
    std::size_t same = 0;
    while (same < common && before[same].cell == now[same].cell) ++same;
    std::string line = "step " + std::to_string(bench.session.position()) + " of " + std::to_string(now.size()) + "; ";
    if (what == Invalidates::tessellation)
        line += "new cells: " + std::to_string(bench.session.cells().cell_count());
    else
        line += same < common ? "order differs from step " + std::to_string(same + 1) : "same order so far";
    bench.say(line);
}

void set(Workbench& bench, Text text) {
    Settings settings = bench.session.settings();
    apply_setting(settings, text);
    change_settings(bench, settings);
}

void preset(Workbench& bench, Text text) {
    Settings settings = bench.session.settings();
    apply_preset(settings, text);
    change_settings(bench, settings);
}

void select(Workbench& bench, Text text) { bench.session.selected_cell = text == "none" ? none : cell_id(bench, text); }

void bookmark(Workbench& bench, Text text) {
    if (text.empty()) throw InputError("a bookmark needs a label");
    bench.session.bookmarks.push_back({bench.session.position(), text});
}

/// KIND ANCHOR [DX,DY] TEXT, with ANCHOR X,Y, cell:ID or primitive:ID.
void note(Workbench& bench, Text text) {
    Note<2> note;
    const auto [kind, rest] = split_word(text);
    const auto found = std::find(note_kind_words.begin(), note_kind_words.end(), kind);
    if (found == note_kind_words.end()) throw InputError("'" + kind + "' is not text, arrow, ring or callout");
    note.kind = static_cast<Note<2>::Kind>(found - note_kind_words.begin());
    auto [anchor, words] = split_word(rest);
    if (anchor.starts_with("cell:")) {
        note.anchor = Note<2>::Anchor::cell;
        note.index = cell_id(bench, anchor.substr(5));
    } else if (anchor.starts_with("primitive:")) {
        note.anchor = Note<2>::Anchor::primitive;
        note.index = whole(anchor.substr(10), "a primitive");
        if (note.index >= bench.session.scene().primitives.size())
            throw InputError("primitive " + anchor.substr(10) + " does not exist");
    } else {
        note.point = parse_point(anchor, bench.session.scene());
    }
    if (words.starts_with('[')) {
        const std::size_t end = words.find(']');
        const std::size_t comma = words.find(',');
        const std::string_view view = words;
        const auto x = end == std::string::npos || comma > end ? std::nullopt : parse_number(view.substr(1, comma - 1));
        const auto y = !x ? std::nullopt : parse_number(view.substr(comma + 1, end - comma - 1));
        if (!x || !y) throw InputError("write the offset in points as [DX,DY]");
        note.offset_pt = {*x, *y};
        const std::size_t start = words.find_first_not_of(' ', end + 1);
        words = start == std::string::npos ? "" : words.substr(start);
    }
    note.text = words;
    if (note.kind == Note<2>::Kind::callout)
        for (const Note<2>& other : bench.session.notes) note.number = std::max(note.number, other.number);
    note.number += note.kind == Note<2>::Kind::callout;
    bench.session.notes.push_back(note);
}

void explain(Workbench& bench, Text text) {
    const Session<2>& session = bench.session;
    if (text.starts_with("cell"))
        return say_all(bench, rows(explain_cell(session, cell_id(bench, split_word(text)[1])), session.settings()));
    std::uint32_t step = session.position();
    if (text.starts_with("step")) step = whole(split_word(text)[1], "a step");
    if (!text.empty() && !text.starts_with("step"))
        throw InputError("write explain, explain step N or explain cell ID");
    if (step == 0) return bench.say("Step 0: the seed cell is in the front, nothing is projected yet.");
    if (step > session.position())
        throw InputError("step " + std::to_string(step) + " is not done yet; the session stands at step " +
                         std::to_string(session.position()));
    say_all(bench, rows(explain_step(session, step), session.settings()));
}

void front(Workbench& bench, Text) {
    std::vector<std::pair<Front::Entry, CellState>> entries;
    for (std::uint32_t cell = 0; cell < bench.session.cells().cell_count(); ++cell)
        if (const CellMark mark = bench.session.state().mark(cell); mark.state == CellState::enqueued)
            entries.push_back({{mark.key, mark.stamp, cell}, mark.state});
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.first.before(b.first); });
    bench.say("Front: " + std::to_string(entries.size()) + " cells, first to last.");
    for (const auto& [entry, state] : entries)
        bench.say("  cell " + std::to_string(entry.cell) + ", key " + short_number(entry.key, 6) + ", stamp " +
                  std::to_string(entry.stamp));
}

void inversions(Workbench& bench, Text) {
    const auto found = bench.session.inversions();
    bench.say("Inversions: " + std::to_string(found.size()) + ", most wasted primitives first.");
    for (const Inversion& i : found)
        bench.say("  step " + std::to_string(i.step) + ": hidden cell " + std::to_string(i.cell) + " before cell " +
                  std::to_string(i.waiting) +
                  (i.kind == Inversion::Kind::mis_ranked ? " (mis-ranked: it was in the front)"
                                                         : " (unreached: it was still clean)") +
                  ", " + std::to_string(i.wasted) + " wasted");
}

void markers(Workbench& bench, Text) {
    constexpr std::array kinds{"penalty", "mis-ranked", "unreached", "budget"};
    for (const Marker& marker : bench.session.markers())
        bench.say("  step " + std::to_string(marker.step) + ": " + kinds[static_cast<std::size_t>(marker.kind)] + ", " +
                  marker.label);
    for (const Bookmark& bookmark : bench.session.bookmarks)
        bench.say("  step " + std::to_string(bookmark.step) + ": bookmark '" + bookmark.label + "'");
}

std::string need_file(Text text) {
    if (text.empty()) throw InputError("a file name is missing");
    return text;
}

constexpr std::array table{
    Command{"step", "[N]", "N steps forward (1)", "Right", step},
    Command{"back", "[N]", "N steps back (1)", "Left", back},
    Command{"seek", "N | start | end | @LABEL", "to a step, an end or a bookmark", "", seek},
    Command{"run", "", "forward to the budget or the end of the front", "End",
            [](Workbench& bench, Text) { run_to_end(bench); }},
    Command{"until", "CONDITION", "forward until step:N, cell:ID or an expression holds", "U", until},
    Command{"eye", "X,Y", "move the eye; while frozen, of the display view only", "", eye},
    Command{"look", "X,Y", "turn the view towards a point", "", look},
    Command{"fov", "DEGREES", "open the view; 360 looks all round", "", fov},
    Command{"set", "FIELD=VALUE", "change a setting", "", set},
    Command{"preset", "ID", "change a set of settings", "", preset},
    Command{"method", "ID", "change the method", "", [](Workbench& bench, Text text) { set(bench, "method=" + text); }},
    Command{"budget", "B", "change the budget: 500, 5%, 16ms or unlimited", "",
            [](Workbench& bench, Text text) { set(bench, "budget=" + text); }},
    Command{"select", "ID | last | none", "select a cell", "", select},
    Command{"freeze", "", "keep the culling view; eye, look and fov move the display view", "F",
            [](Workbench& bench, Text) { bench.session.freeze(); }},
    Command{"unfreeze", "", "the display view is the culling view again", "F",
            [](Workbench& bench, Text) { bench.session.unfreeze(); }},
    Command{"bookmark", "LABEL", "name this step", "B", bookmark},
    Command{"note", "KIND ANCHOR [[DX,DY]] TEXT",
            "text, arrow, ring or callout at X,Y, cell:ID, cell:last or primitive:ID, text shifted in points", "N",
            note},
    Command{"explain", "[step N | cell ID | cell last]", "say why: this step, another, or where a cell stands", "E",
            explain},
    Command{"front", "", "list the front", "", front},
    Command{"inversions", "", "list hidden cells projected before visible ones", "I", inversions},
    Command{"markers", "", "list penalties, inversions, budget ticks and bookmarks", "", markers},
    Command{"size", "84mm | WxH", "size of figures", "", set_figure_size},
    Command{"shot", "FILE", "write a figure (.png, .svg, .pdf) and its sidecar", "S",
            [](Workbench& bench, Text text) { write_shot(bench, need_file(text)); }},
    Command{"save", "FILE", "write a state file", "Ctrl+S",
            [](Workbench& bench, Text text) { write_text(need_file(text), state_json(bench.session, bench.figure)); }},
    Command{"trace", "FILE", "write the records of the steps so far", "",
            [](Workbench& bench, Text text) { write_text(need_file(text), trace_json(bench.session)); }},
    Command{
        "stats", "FILE", "write the statistics", "",
        [](Workbench& bench, Text text) { write_text(need_file(text), stats_json(bench.session, bench.last_stop)); }},
    Command{"quit", "", "end here", "Ctrl+Q", [](Workbench& bench, Text) { bench.quit = true; }},
};

std::vector<std::string> split_commands(std::string_view text) {
    std::vector<std::string> parts(1);
    bool quoted = false;
    for (const char c : text) {
        if (c == '"') {
            quoted = !quoted;
        } else if (c == ';' && !quoted) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    if (quoted) throw InputError("commands: a quote is not closed");
    for (std::string& part : parts) {
        const std::size_t begin = part.find_first_not_of(" \t\n"), end = part.find_last_not_of(" \t\n");
        part = begin == std::string::npos ? "" : part.substr(begin, end - begin + 1);
    }
    std::erase(parts, "");
    return parts;
}

}  // namespace

std::span<const Command> command_table() { return table; }

void run_commands(Workbench& bench, std::string_view text) {
    for (const std::string& part : split_commands(text)) {
        const auto words = split_word(part);
        const std::string &word = words[0], &argument = words[1];
        const auto found = std::find_if(table.begin(), table.end(), [&](const Command& c) { return c.id == word; });
        if (found == table.end()) {
            std::string known;
            for (const Command& command : table) known += (known.empty() ? "" : ", ") + std::string(command.id);
            throw InputError("command '" + word + "' does not exist; there are " + known);
        }
        try {
            found->run(bench, argument);
        } catch (const InputError& error) {
            throw InputError("command '" + part + "': " + error.what());
        }
        if (bench.quit) return;
    }
}

}  // namespace sightline
