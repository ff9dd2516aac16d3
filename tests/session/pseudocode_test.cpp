// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/pseudocode.h"
#include "core/session/settings_table.h"

#include <gtest/gtest.h>

#include <map>

#include "core/base/number.h"
#include "core/methods/cells/cell_method.h"
#include "core/session/explain.h"
#include "core/session/substep.h"
#include "tests/session/session_support.h"

namespace sightline {
namespace {

std::string all_of(const std::vector<CodeLine>& lines) {
    std::string text;
    for (const CodeLine& line : lines)
        text += std::string(static_cast<std::size_t>(line.indent) * 2, ' ') + (line.lit ? "> " : "  ") + line.text +
                "  [" + line.values + "]  " + line.source + "\n";
    return text;
}

/// The one lit line.
const CodeLine& lit(const std::vector<CodeLine>& lines) {
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const CodeLine& l) { return l.lit; }), 1) << all_of(lines);
    return *std::find_if(lines.begin(), lines.end(), [](const CodeLine& l) { return l.lit; });
}

const CodeLine& starting_with(const std::vector<CodeLine>& lines, const std::string& text) {
    const auto found =
        std::find_if(lines.begin(), lines.end(), [&](const CodeLine& l) { return l.text.starts_with(text); });
    if (found == lines.end()) throw std::runtime_error("no line starts with '" + text + "':\n" + all_of(lines));
    return *found;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// How the line of a rule begins.
std::string line_of(Rule rule, bool updates, OnReenqueue on) {
    switch (rule) {
        case Rule::border:
            return "no cell there";
        case Rule::projected:
            return "n was projected before";
        case Rule::unseen:
            return "n was found outside the view before";
        case Rule::marked_unseen:
            return "n is clean and outside the view";
        case Rule::enqueued:
            return "n is clean: put it";
        case Rule::reenqueued:
            return on == OnReenqueue::replace ? "n is in the front: key(n, c) and a new stamp"
                   : on == OnReenqueue::min   ? "n is in the front, key(n, c) is lower"
                                              : "n is in the front, key(n, c) is higher";
        default:
            return !updates                 ? "n is in the front: it keeps"
                   : on == OnReenqueue::min ? "n is in the front, key(n, c) is not lower"
                                            : "n is in the front, key(n, c) is not higher";
    }
}

TEST(Pseudocode, LightsTheLineOfEachRuleAndFillsInItsNumbers) {
    Random random(81);
    std::map<std::pair<Rule, bool>, int> seen;
    int penalised = 0, spared = 0, broken = 0;
    for (int i = 0; i < 200; ++i) {
        const test::Start start = test::random_cell_start(random);
        Session<2> session = start.session();
        const bool updates = start.settings.method == "published";
        Stop stop = Stop::none;
        while ((stop = session.step()) == Stop::none) {
            const StepExplanation step = explain_step(session, session.position());
            const int digits = step.digits;
            for (std::uint32_t substep = 0; substep < substep_count(session, step.step); ++substep) {
                const auto lines = pseudocode(session, substep);
                const CodeLine& now = lit(lines);
                const CodeLine &take = starting_with(lines, "take the cell c"), &project = starting_with(lines, "proj"),
                               &each = starting_with(lines, "for each facet"), &key = starting_with(lines, "key(n, c)");
                ASSERT_TRUE(starting_with(lines, "while").values.empty());
                ASSERT_TRUE(
                    has(take.values, "cell " + std::to_string(step.cell) + ", key " + short_number(step.key, digits)));
                if (step.runner_up != none) {
                    ASSERT_TRUE(has(take.values, "; next: cell " + std::to_string(step.runner_up) + ", key " +
                                                     short_number(step.runner_up_key, digits)));
                }
                if (substep == 0) {
                    ASSERT_EQ(&now, &take);
                    ASSERT_TRUE(project.values.empty() && each.values.empty() && key.values.empty());
                    continue;
                }
                ASSERT_EQ(project.values.find(std::to_string(step.rendered) + " primitive"), 0u);
                if (substep == 1) {
                    ASSERT_EQ(&now, &project);
                    ASSERT_TRUE(each.values.empty() && key.values.empty());
                    continue;
                }
                const Considered& facet = step.looked_at[substep - 2];
                ++seen[{Rule{facet.rule}, updates}];
                ASSERT_TRUE(now.text.starts_with(
                    line_of(Rule{facet.rule}, updates, test::choice<OnReenqueue>(start.settings, on_reenqueue_row()))))
                    << facet.words << "\n"
                    << all_of(lines);
                ASSERT_EQ(each.values.find("facet " + std::to_string(substep - 1) + " of " +
                                           std::to_string(step.looked_at.size())),
                          0u);
                ASSERT_EQ(has(each.values, "cell " + std::to_string(facet.item.id)), facet.item.id != none);
                ASSERT_EQ(now.values.empty(), !facet.key);
                ASSERT_EQ(key.values.empty(), !facet.key);
                if (!facet.key) continue;
                const KeyExplanation& t = *facet.key;
                const double was = facet.before.key;
                const bool again = facet.before.state == CellState::enqueued;
                const int apart = again ? std::max(digits, separating_digits(was, t.key)) : digits;
                ASSERT_TRUE(now.values.ends_with("key " + short_number(t.key, apart))) << all_of(lines);
                ASSERT_EQ(has(now.values, "key before " + short_number(was, apart)), again) << all_of(lines);
                ASSERT_TRUE(has(key.values, "n = cell " + std::to_string(facet.item.id) + ", c = cell " +
                                                std::to_string(step.cell)));
                if (!updates) {
                    ASSERT_TRUE(
                        starting_with(lines, "the layer of c + 1").values.ends_with("= " + short_number(t.key)));
                    continue;
                }
                // The function's lines are the formula, piece by piece.
                std::string whole = "ρ = " + starting_with(lines, "ρ = content").values;
                if (t.penalised) {
                    const std::string values = starting_with(lines, "then ρ").values;
                    const std::string before = short_number(test::term(t, "unpenalised"), digits) + " ";
                    ASSERT_EQ(values.find(before), 0u);
                    whole += ", " + values.substr(before.size());
                    ++penalised;
                } else if (t.tested) {
                    ASSERT_TRUE(starting_with(lines, "then ρ").values.empty());
                    ++spared;
                }
                ASSERT_EQ(whole, t.formula());
                ASSERT_EQ(starting_with(lines, "the key is ρ").values, short_number(t.key, digits));
                ASSERT_TRUE(starting_with(lines, "content")
                                .values.ends_with(" " + short_number(test::term(t, "density"), digits)));
                ASSERT_TRUE(
                    starting_with(lines, "angle").values.ends_with(short_number(test::term(t, "weight"), digits)));
                if (t.tested) {
                    const std::string answer = starting_with(lines, "the ray").values;
                    ASSERT_EQ(answer.find(t.penalised ? "yes" : "no"), 0u);
                }
            }
            const auto between = pseudocode(session, std::nullopt);
            const bool over = session.counters().spent >= session.problem().budget;
            ASSERT_TRUE(lit(between).text.starts_with(over ? "stop when" : "while")) << all_of(between);
            const auto size = test::sorted_front(test::marks(session)).size();
            ASSERT_EQ(starting_with(between, "while").values.find(std::to_string(size) + " cell"), 0u);
            ASSERT_TRUE(starting_with(between, "take").values.empty());
            broken += over;
        }
        if (stop == Stop::budget) {
            ASSERT_TRUE(lit(pseudocode(session, std::nullopt)).text.starts_with("stop when"));
        }
    }
    for (const Rule rule :
         {Rule::border, Rule::projected, Rule::enqueued, Rule::kept, Rule::marked_unseen, Rule::unseen})
        for (const bool updates : {false, true}) EXPECT_GT((seen[{rule, updates}]), 20) << static_cast<int>(rule);
    EXPECT_GT((seen[{Rule::reenqueued, true}]), 100);
    EXPECT_EQ((seen[{Rule::reenqueued, false}]), 0);
    EXPECT_GT(penalised, 100);
    EXPECT_GT(spared, 100);
    EXPECT_GT(broken, 20);
}

TEST(Pseudocode, TheBudgetStandsWhereTheSettingsPutIt) {
    Random random(82);
    test::Start start = test::random_start(random);
    start.settings.method = "published";
    for (const YesNo before : {YesNo::no, YesNo::yes}) {
        start.settings.parameters.set(neighbours_before_break_row(), word(before));
        const auto lines = pseudocode(start.session(), std::nullopt);
        EXPECT_EQ(&starting_with(lines, "stop when") > &starting_with(lines, "for each facet"), before == YesNo::yes);
    }
}

TEST(Pseudocode, OrdersOfPrimitives) {
    Random random(83);
    int steps = 0;
    for (const std::string method : {"centroid", "everything"})
        for (int i = 0; i < 30; ++i) {
            test::Start start = test::random_start(random, 200);
            start.settings.method = method;
            Session<2> session = start.session();
            EXPECT_EQ(pseudocode(session, 0u).size(), pseudocode(session, std::nullopt).size());
            const std::size_t all = session.scene().primitives.size();
            std::uint32_t before = 0;
            while (session.step() == Stop::none) {
                const auto popped = pseudocode(session, 0u), rendered = pseudocode(session, 1u);
                ASSERT_TRUE(lit(popped).text.starts_with("take the next 32"));
                ASSERT_TRUE(starting_with(popped, "render").values.empty());
                ASSERT_TRUE(lit(rendered).text.starts_with("render"));
                ASSERT_EQ(lit(rendered).text == "render them", method == "everything");
                ASSERT_EQ(
                    lit(rendered).values.find(std::to_string(session.counters().rendered_count - before) + " prim"),
                    0u);
                const auto between = pseudocode(session, std::nullopt);
                const bool over = session.counters().spent >= session.problem().budget;
                ASSERT_TRUE(lit(between).text.starts_with(over ? "stop when" : "while")) << all_of(between);
                ASSERT_EQ(starting_with(between, "while").values,
                          std::to_string(all - session.counters().offset) + " left");
                before = session.counters().rendered_count;
                ++steps;
            }
        }
    EXPECT_GT(steps, 100);
}

/// A heuristic that says nothing of itself but its key.
struct Silent {
    static constexpr double seed_key = 0;
    static constexpr OnReenqueue on_reenqueue = OnReenqueue::max;
    template <int D>
    Key key(const Problem<D>&, std::uint32_t, double key_a, const HalfFacet&) const {
        return 2 * key_a + 1;
    }
};

TEST(Pseudocode, AMethodFromAnotherTable) {
    const std::array table{cell_method<2, Silent>("mine", "my own", "a test's")};
    Random random(84);
    test::Start start = test::random_cell_start(random);
    start.settings.method = "mine";
    Session<2> session(start.scene, start.view, start.settings, table);
    int keys = 0;
    while (session.step() == Stop::none)
        for (std::uint32_t substep = 2; substep < substep_count(session, session.position()); ++substep) {
            const Considered facet = explain_step(session, session.position()).looked_at[substep - 2];
            const auto lines = pseudocode(session, substep);
            EXPECT_EQ(lines.back().values, facet.key ? facet.key->formula() : "");
            EXPECT_TRUE(!facet.key || facet.key->formula().starts_with("key = "));
            keys += facet.key.has_value();
        }
    EXPECT_GT(keys, 0);
    EXPECT_TRUE(has(all_of(pseudocode(session, std::nullopt)), "key(n, c): the key of n behind c"));
    EXPECT_TRUE(has(all_of(pseudocode(session, std::nullopt)), "key(n, c) is higher"));
}

TEST(Pseudocode, NoSettingsShowALineThatCannotHappen) {
    Random random(85);
    test::Start start = test::random_cell_start(random);
    apply_setting(start.settings, "outside_view=enqueue");
    apply_setting(start.settings, "star_shaped=off");
    start.settings.method = "published";
    const std::string text = all_of(pseudocode(start.session(), std::nullopt));
    EXPECT_FALSE(has(text, "unseen") || has(text, "outside the view") || has(text, "the ray")) << text;
    start.settings.method = "layers";
    EXPECT_FALSE(has(all_of(pseudocode(start.session(), std::nullopt)), "ρ"));
}

}  // namespace
}  // namespace sightline
