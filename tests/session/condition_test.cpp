// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/condition.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/number.h"
#include "core/methods/cells/star_shape.h"
#include "tests/scene/scene_support.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using Values = std::map<std::string_view, double>;
const double nan = std::numeric_limits<double>::quiet_NaN();

/// The fields of the step just made, worked out from the marks before and after it.
Values expected(const Session<2>& session, const std::vector<Mark>& before, std::uint32_t rendered_before,
                std::uint32_t touched_before, const std::vector<std::pair<Item, Mark>>& waiting) {
    const Reference& reference = session.reference();
    const Counters& counters = session.counters();
    const auto after = test::marks(session);
    Values v;
    v["step"] = session.position();
    v["cell"] = v["node"] = v["rho"] = v["count"] = v["runner_up"] = v["visible_share"] = nan;
    v["inversion"] = v["enqueued"] = v["reenqueued"] = v["unseen"] = v["penalties"] = v["front"] = 0;
    v["rendered"] = counters.rendered_count;
    v["rendered_now"] = counters.rendered_count - rendered_before;
    v["visible_now"] = 0;
    for (const std::uint32_t p : rendered_ids(session.met().subspan(touched_before)))
        v["visible_now"] += reference.visible[p];
    v["hidden_now"] = v["rendered_now"] - v["visible_now"];
    double visible = 0;
    const std::vector<std::uint32_t> ids = rendered_ids(session.met());
    const std::set<std::uint32_t> rendered(ids.begin(), ids.end());
    for (std::uint32_t p = 0; p < reference.visible.size(); ++p)
        visible += reference.visible[p] && rendered.contains(p);
    v["coverage"] = reference.count == 0 ? nan : visible / static_cast<double>(reference.count);
    const std::vector<std::uint32_t>& image = reference.image.ids;  // one row: regions are runs of wrong pixels
    double wrong = 0, run = 0, longest = 0;
    for (const std::uint32_t id : image) {
        const bool is_wrong = id != none && !rendered.contains(id);
        wrong += is_wrong;
        run = is_wrong ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    v["wrong_pixels"] = wrong / static_cast<double>(image.size());
    v["wrong_region"] = longest / static_cast<double>(image.size());
    std::set<std::uint32_t> objects;
    for (const std::uint32_t p : rendered) objects.insert(session.objects().of[p]);
    v["objects"] = static_cast<double>(objects.size());

    const auto front = test::sorted_front(before);
    if (session.method().pops == Kind::node && session.timeline().steps[session.position() - 1].item) {
        v["node"] = waiting.front().first.id;
        v["rho"] = waiting.front().second.key;
        if (waiting.size() > 1) v["runner_up"] = waiting[1].second.key;
    }
    if (session.method().pops == Kind::node) v["front"] = static_cast<double>(session.traversal().front().size());
    if (!session.method().orders_cells()) return v;
    const std::uint32_t cell = front.front().id;
    v["cell"] = cell;
    v["rho"] = front.front().key;
    v["count"] = static_cast<double>(session.cells().primitives_of(cell).size());
    if (front.size() > 1) v["runner_up"] = front[1].key;
    v["visible_share"] = reference.cell_share[cell];
    const Settings& set = session.settings();
    const bool tested = set.method == "published" && PlpParameters(set.parameters).tests_star_shape;
    for (std::uint32_t c = 0; c < before.size(); ++c) {
        v["front"] += after[c].state == CellState::enqueued;
        v["unseen"] += before[c].state == CellState::clean && after[c].state == CellState::unseen;
        const bool fresh = before[c].state == CellState::clean && after[c].state == CellState::enqueued;
        const bool again = before[c].state == CellState::enqueued && after[c].state == CellState::enqueued &&
                           before[c].stamp != after[c].stamp;
        v["enqueued"] += fresh;
        v["reenqueued"] += again;
        if (tested && (fresh || again))
            for (const HalfFacet& half : session.cells().facets_of(cell))
                if (half.neighbour == c)
                    v["penalties"] +=
                        !star_shaped(session.cells(), half, session.culling_view().eye, session.cells().centre(c));
    }
    if (reference.cell_share[cell] == 0 && v["count"] > 0) {
        bool in_front = false, clean = false;
        for (std::uint32_t c = 0; c < before.size(); ++c) {
            in_front |= reference.cell_share[c] > 0 && before[c].state == CellState::enqueued;
            clean |= reference.cell_share[c] > 0 && before[c].state == CellState::clean;
        }
        v["inversion"] = in_front ? 1 : clean ? 2 : 0;
    }
    return v;
}

TEST(Condition, FieldsAreThoseOfTheStep) {
    Random random(31);
    std::map<std::string_view, std::set<double>> seen;
    for (int i = 0; i < test::soak_count(200); ++i) {
        const test::Start start = test::random_start(random);
        Session<2> session = start.session();
        for (;;) {
            const auto before = test::marks(session);
            const auto waiting = session.traversal().front();
            const std::uint32_t rendered = session.counters().rendered_count,
                                touched = session.counters().touched_count;
            if (session.step() != Stop::none) break;
            const bool redone = random.below(3) == 0;  // a step that was undone and redone tells the same
            if (redone) {
                session.back();
                session.step();
            }
            const Values values = expected(session, before, rendered, touched, waiting);
            ASSERT_EQ(record_fields<2>().size(), values.size());
            for (const RecordField<2>& field : record_fields<2>()) {
                ASSERT_TRUE(values.contains(field.name)) << field.name;
                const double value = field.value(session), wanted = values.at(field.name);
                ASSERT_TRUE(value == wanted || (std::isnan(value) && std::isnan(wanted)))
                    << field.name << " = " << value << ", not " << wanted << "; scene " << i << " step "
                    << session.position();
                if (!std::isnan(value)) seen[field.name].insert(value);
            }
        }
    }
    for (const RecordField<2>& field : record_fields<2>()) {
        EXPECT_GE(seen[field.name].size(), 2u) << field.name << " was always the same";
        EXPECT_FALSE(field.help.empty());
    }
    EXPECT_EQ(seen["inversion"], (std::set<double>{0, 1, 2}));
}

TEST(Condition, StopsAtTheFirstStepWhereItHolds) {
    Random random(32);
    int stops = 0;
    for (int i = 0; i < test::soak_count(150); ++i) {
        test::Start start = test::random_cell_start(random);
        start.settings.budget = {};
        Session<2> session = start.session();
        std::vector<double> shares, keys;
        std::vector<std::uint32_t> cells;
        while (session.step() == Stop::none) {
            cells.push_back(session.timeline().steps.back().item.id);
            shares.push_back(session.reference().cell_share[cells.back()]);
            keys.push_back(session.mark(cells.back()).key);
        }
        if (cells.empty()) continue;
        const auto stops_at = [&](const std::string& text) {
            session.seek(0);
            const Condition<2> condition(text);
            const Stop stop = session.run_until([&](const Session<2>& s) { return condition.holds(s); });
            return stop == Stop::breakpoint ? session.position() : 0;
        };
        const std::size_t n = random.below(cells.size());
        ASSERT_EQ(stops_at("step:" + std::to_string(n + 1)), n + 1);
        ASSERT_EQ(stops_at("cell:" + std::to_string(cells[n])), n + 1);
        ASSERT_EQ(stops_at("cell: " + std::to_string(cells[n])), n + 1);
        ASSERT_EQ(stops_at("step:" + std::to_string(cells.size() + 1)), 0u);
        ASSERT_EQ(stops_at("cell:999999"), 0u);
        std::size_t wanted = 0;
        while (wanted < cells.size() && !(keys[wanted] > 0.25 && shares[wanted] == 0)) ++wanted;
        ASSERT_EQ(stops_at("rho > 0.25 && visible_share == 0"), wanted < cells.size() ? wanted + 1 : 0);
        stops += wanted < cells.size();
    }
    EXPECT_GT(stops, 30);
}

TEST(Condition, MatchesAreTheStepsThatARunWouldStopAt) {
    Random random(35);
    constexpr const char* texts[] = {
        "hidden_now > 0", "rho > runner_up - 0.05", "inversion == 1", "step > 3", "0", "penalties > 0 && front > 4",
        "coverage > 0.5"};
    std::size_t found = 0, passed = 0;
    for (int i = 0; i < test::soak_count(100); ++i) {
        Session<2> session = test::random_start(random).session();
        session.run(static_cast<std::uint32_t>(random.below(80)));
        const Condition<2> condition(texts[random.below(std::size(texts))]);
        std::vector<std::uint32_t> wanted;
        Session<2> walker = session;
        while (walker.back()) {
        }
        while (walker.position() < session.recorded()) {
            walker.step();
            if (condition.holds(walker)) wanted.push_back(walker.position());
        }
        session.seek(static_cast<std::uint32_t>(random.below(session.position() + 1)));
        if (random.below(3) == 0) session.set_time_stop(session.position());
        const std::uint32_t position = session.position();
        ASSERT_EQ(matches(session, condition), wanted) << condition.text();
        ASSERT_EQ(session.position(), position);
        found += wanted.size();
        passed += session.recorded() - wanted.size();
    }
    EXPECT_GT(found, 200u);
    EXPECT_GT(passed, 200u);
}

/// A session at its second step, where step = 2.
Session<2> at_second_step() {
    Random random(33);
    for (;;) {
        const test::Start start = test::random_cell_start(random);
        Session<2> session = start.session();
        session.seek(2);
        if (session.position() == 2) return session;
    }
}

TEST(Condition, Operators) {
    const Session<2> session = at_second_step();
    const std::pair<const char*, bool> cases[] = {
        {"step == 2", true},
        {"step != 2", false},
        {"step < 2", false},
        {"step <= 2", true},
        {"step > 1", true},
        {"step >= 3", false},
        {"!(step == 2)", false},
        {"!(step == 3)", true},
        {"!0", true},
        {"!step", false},
        {"!(!step)", true},
        {"step == 2 && step > 5", false},
        {"step == 2 && step < 5", true},
        {"step == 1 || step == 2", true},
        {"step == 1 || step == 3", false},
        {"step == 2 || step == 1 && 0", true},  // && binds more tightly
        {"(step == 2 || step == 1) && 0", false},
        {"step * 3 - 2 == 4", true},
        {"step ^ 3 == 8", true},
        {"-step < 0", true},
        {"step / 4 == 0.5", true},
        {"step > 1 ? 0 : 1", false},
        {"step", true},
        {"0", false},
        {"0/0", false},  // NaN
        {"0/0 == 0/0", false},
        {"step:2", true},
        {"step:3", false},
        {"step:2 && 0", false},
        {"!(0/0 > 1)", true},
    };
    for (const auto& [text, holds] : cases) EXPECT_EQ(Condition<2>(text).holds(session), holds) << text;
    // Asking changes nothing: the same condition answers the same again, and for another session.
    const Condition<2> condition("step == 2");
    Session<2> other = session;
    EXPECT_TRUE(condition.holds(session));
    other.seek(1);
    EXPECT_FALSE(condition.holds(other));
    EXPECT_TRUE(condition.holds(session));
    other.seek(0);
    EXPECT_FALSE(Condition<2>("1").holds(other)) << "nothing holds before the first step";
    EXPECT_EQ(Condition<2>("step  == 2").text(), "step  == 2");
}

TEST(Condition, ErrorsAreOneLineThatQuotesTheText) {
    const std::string deep(20000, '(');
    for (const std::string text : {"",           " ",
                                   "rho >",      "rho > && 1",
                                   "rhoo > 1",   "step:",
                                   "cell:",      "step:x",
                                   "cell:a b",   "rho > 1, step > 2",
                                   "1, 2",       "rho > 1; step > 2",
                                   "(rho > 1",   "rho > 1)",
                                   "rho 1",      "1 +* 2",
                                   "\"text\"",   "rho > \"a\"",
                                   "@",          "\n",
                                   "rho >\n1 )", "step = 2",
                                   "step=2",     "rho = 1 && step > 2",
                                   "cell:1 = 2", "$",
                                   "1..2",       "_pi = 3",
                                   "sin(",       "\xff\xfe",
                                   "rho > 1 rho"})
        try {
            const Condition<2> condition(text);
            ADD_FAILURE() << "takes '" << text << "'";
        } catch (const InputError& error) {
            const std::string what = error.what();
            EXPECT_EQ(what.find("condition '"), 0u) << what;
            EXPECT_EQ(what.find_first_of("\n\r"), std::string::npos) << what;
            EXPECT_NE(what.find("'" + excerpt(text) + "'"), std::string::npos) << what;
        }
    EXPECT_THROW(Condition<2>{deep}, InputError);
    try {
        const Condition<2> condition("solidity > 1");
    } catch (const InputError& error) {
        for (const RecordField<2>& field : record_fields<2>())
            EXPECT_NE(std::string(error.what()).find(field.name), std::string::npos) << error.what();
    }
}

TEST(Condition, AnyTextIsACondtionOrAnInputError) {
    const Session<2> session = at_second_step();
    constexpr const char* pieces[] = {"rho", "step", "cell",  ":",  " ",   "==",  "=", "<",  ">",  "&&",    "||", "!",
                                      "(",   ")",    "1",     ".5", "-",   "+",   "*", "/",  "^",  "?",     ":",  ",",
                                      "\"",  "1e9",  "1e999", "_e", "sin", "0x1", "#", "\n", "\\", "count", "if", ";"};
    Random random(34);
    int taken = 0;
    for (int i = 0; i < test::soak_count(20000); ++i) {
        std::string text;
        for (std::uint64_t k = 1 + random.below(7); k > 0; --k) text += pieces[random.below(std::size(pieces))];
        try {
            const Condition<2> condition(text);
            condition.holds(session);
            ++taken;
        } catch (const InputError& error) {
            ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        }
    }
    EXPECT_GT(taken, 200);
}

TEST(Condition, OfAPrimitiveOrAnObjectHoldsWhereItIsRendered) {
    Random random(77);
    int found = 0;
    for (int i = 0; i < test::soak_count(10); ++i) {
        Session<2> session = test::random_cell_start(random).session();
        session.run();
        const auto step_of = [&](const auto& is_one) {  // the first that renders one
            for (std::uint32_t step = 1; step <= session.recorded(); ++step) {
                const std::size_t first = session.timeline().before(step).touched_count,
                                  last = session.timeline().after(step).touched_count;
                for (const Met met : session.met().subspan(first, last - first))
                    if (!met.culled() && is_one(met.primitive())) return step;
            }
            return 0u;
        };
        const std::uint32_t count = static_cast<std::uint32_t>(session.scene().primitives.size());
        if (count == 0) continue;
        const std::uint32_t wanted = static_cast<std::uint32_t>(random.below(count));
        const auto first_match = [&](const std::string& text) {
            const auto steps = matches(session, condition_for(session, text));
            return steps.empty() ? 0u : steps.front();
        };
        const std::uint32_t step = step_of([&](std::uint32_t p) { return p == wanted; });
        EXPECT_EQ(first_match("primitive:" + std::to_string(wanted)), step);
        const Objects& objects = session.objects();
        const std::uint32_t object = objects.of[wanted];
        EXPECT_EQ(first_match("object:" + objects.names[object]),
                  step_of([&](std::uint32_t p) { return objects.of[p] == object; }));
        found += step > 0;
    }
    EXPECT_GT(found, 3);
    test::expect_input_error([] { Condition<2>("primitive:x"); }, "condition: write primitive:N, with a number");
    test::expect_input_error([] { Condition<2>("object:"); }, "condition: write object:NAME");
}

}  // namespace
}  // namespace sightline
