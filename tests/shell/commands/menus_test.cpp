// The menus: short labels, and a row does something.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands/menus.h"

#include <cctype>
#include <map>

#include "core/base/number.h"
#include "core/session/settings_table.h"
#include "shell/commands/key_bindings.h"
#include "shell/commands/prompt.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using Kind = MenuRow::Kind;

/// All rows, those of menus in menus as well.
template <int D>
void add_all(const Workbench<D>& bench, const std::vector<MenuRow>& rows, std::vector<MenuRow>& all) {
    for (const MenuRow& row : rows) {
        if (row.kind != Kind::line) all.push_back(row);
        if (row.kind != Kind::line && row.kind != Kind::command) add_all(bench, rows_inside(bench, row), all);
    }
}

void expect_short(const std::string& label) {
    EXPECT_FALSE(label.empty());
    EXPECT_LE(label.size(), 24u) << label;
    EXPECT_LE(std::count(label.begin(), label.end(), ' '), 3) << label;
    const auto first = static_cast<unsigned char>(label.empty() ? ' ' : label[0]);
    EXPECT_TRUE(std::isupper(first) || std::isdigit(first)) << label;
    for (const char* sentence : {".", "…", ",", ";", ":", "?", "the next"})
        EXPECT_EQ(label.find(sentence), std::string::npos) << label;
}

template <int D>
void expect_menus() {
    std::set<std::string> titles;
    for (const Menu& menu : menus<D>()) {
        SCOPED_TRACE(menu.title);
        EXPECT_TRUE(titles.emplace(menu.title).second);
        expect_short(std::string(menu.title));
        std::set<std::string> labels;
        bool line = true;
        for (const MenuRow& row : menu.rows) {
            EXPECT_FALSE(line && row.kind == Kind::line) << "a line without anything over it";
            line = row.kind == Kind::line;
            if (line) continue;
            expect_short(row.says.label);
            EXPECT_TRUE(labels.insert(row.says.label).second) << row.says.label << " stands twice";
            EXPECT_EQ(row.says.text.empty(), row.kind != Kind::command) << row.says.label;
            for (const MenuRow& inside : row.inside) expect_short(inside.says.label);
        }
        EXPECT_FALSE(line) << "a line at the end";
        EXPECT_LE(menu.rows.size(), 26u) << "higher than a small window";
    }
    EXPECT_EQ(menus<D>().front().title, "File");
    EXPECT_EQ(menus<D>().front().rows.back().command, "quit");
    EXPECT_EQ(menus<D>().back().title, "Help");
}

TEST(Menus, LabelsAreShort) {
    expect_menus<2>();
    expect_menus<3>();
}

/// The list of keys has the same words.
template <int D>
void expect_spoken_keys() {
    for (const Command<D>& command : command_table<D>())
        for (const KeyBinding& binding : key_bindings(command.id, command.keys)) {
            SCOPED_TRACE(binding.command);
            expect_short(spoken<D>(binding.command).label);
            const bool has_argument = binding.command != command.id;
            EXPECT_FALSE(has_argument && spoken<D>(binding.command).label == command.label) << "has no name of its own";
        }
}

TEST(Menus, KeysAreSpokenOfInTheSameWords) {
    expect_spoken_keys<2>();
    expect_spoken_keys<3>();
    EXPECT_EQ(spoken<2>("seek start").label, "Go to the start");
    EXPECT_EQ(spoken<2>("seek start").keys, "Home");
    EXPECT_EQ(spoken<2>("cycle heat").label, "Heat map");
    EXPECT_EQ(spoken<3>("show why").label, "Why panel");
    EXPECT_EQ(spoken<2>("nothing").label, "");
}

class MenuRows : public test::Commands {
protected:
    MenuRows() {
        run("run; seek 10");
        bench->recent = {"rooms"};
        bench->clipboard = {[this] { return clipboard; }, [this](const std::string& text) { clipboard = text; }};
    }
    /// Everything that a person could notice.
    std::string state() {
        std::string text = clipboard;
        const auto add = [&](const auto& value) { text += " " + std::to_string(value); };
        const Session<2>& s = session();
        for (const SettingRow& row : settings_table()) text += row.get(s.settings()) + "|";
        add(s.hash());
        add(s.position());
        for (const ViewSpec<2>& v : {s.culling_view(), s.display_view()})
            text += number_text(v.eye.x) + number_text(v.eye.y) + number_text(v.fov);
        add(s.frozen());
        add(s.selected_cell);
        add(s.selected_primitive);
        add(s.notes.size());
        add(s.bookmarks.size());
        add(s.scene().primitives.size());
        add(bench->substep.value_or(none));
        add(bench->transport.playing);
        add(bench->transport.steps_per_second);
        add(bench->history.past.size());
        add(bench->teaching.has_value());
        for (const bool on : {bench->flight.bar, bench->flight.recording, bench->flight.replaying, bench->flight.loop})
            add(on);
        add(bench->quit);
        if (bench->other) {
            text += bench->other->title + bench->other->session.settings().method;
            add(static_cast<int>(bench->other->align));
        }
        for (const std::string& line : said) text += line;
        return text;
    }
    /// What the row can only do then.
    std::string before(const std::string& command) {
        static const std::map<std::string, std::string> all{{"unfreeze", "freeze"},
                                                            {"undo", "set heat=id"},
                                                            {"redo", "set heat=id; undo"},
                                                            {"delete", "note text 1,1 words; select note:1"},
                                                            {"paste", "copy; seek 3"},
                                                            {"difference", "compare penalty"},
                                                            {"swap", "compare layers"},
                                                            {"align step", "compare penalty; align drawn"},
                                                            {"align drawn", "compare penalty"},
                                                            {"compare off", "compare penalty"},
                                                            {"lesson end", "lesson plp"},
                                                            {"tool select", "tool text"},
                                                            {"scale 1", "scale 2"},
                                                            {"what-if", "select 20"},
                                                            {"fit selected", "select 20"},
                                                            {"look selected", "select 20"},
                                                            {"missed 1", "set budget=5"},
                                                            {"reach selected", "select 20"},
                                                            {"fit", "zoom 3"},
                                                            {"viewpoint next", "method by-viewpoint"},
                                                            {"work-out region", "method by-viewpoint"},
                                                            {"work-out all", "method by-viewpoint"},
                                                            {"method published", "method layers"}};
        const auto found = all.find(command);
        return found == all.end() ? "" : found->second;
    }

    std::string clipboard;
};

TEST_F(MenuRows, EachDoesSomething) {
    std::vector<MenuRow> rows;
    for (const Menu& menu : menus<2>()) add_all(*bench, menu.rows, rows);
    EXPECT_GT(rows.size(), 90u);
    const Workbench<2> fresh = *bench;
    for (const MenuRow& row : rows) {
        if (row.kind != Kind::command || row.command == "viewer3d") continue;  // opens another program
        SCOPED_TRACE(row.command);
        *bench = fresh;
        const ViewSpec<2> here = session().culling_view(), there{{3, 3}, here.look_at, here.fov};
        if (row.command.starts_with("path ")) bench->flight = {.path = {"test", {there, here, there}}, .frame = 1};
        clipboard.clear();
        run(before(row.command));
        said.clear();
        if (row.asks) {
            ask(*bench, row.command);
            EXPECT_TRUE(bench->desk.console);
            EXPECT_TRUE(bench->desk.console_text.starts_with(row.command + " ")) << bench->desk.console_text;
            continue;
        }
        const std::string was = state();
        const Desk desk = bench->desk;
        run_commands(*bench, row.command);
        EXPECT_TRUE(state() != was || !(bench->desk == desk)) << row.says.label << " does nothing";
    }
}

/// Menus have no command that only one viewer knows.
TEST(Menus, EachRowIsACommandOfItsViewer) {
    const auto expect_known = [](const auto& table, const std::vector<Menu>& all) {
        for (const Menu& menu : all)
            for (const MenuRow& row : menu.rows) {
                if (row.kind != Kind::command) continue;
                const std::string id = row.command.substr(0, row.command.find(' '));
                EXPECT_TRUE(std::any_of(table.begin(), table.end(), [&](const auto& c) { return c.id == id; }))
                    << row.command;
            }
    };
    expect_known(command_table<2>(), menus<2>());
    expect_known(command_table<3>(), menus<3>());
}

}  // namespace
}  // namespace sightline
