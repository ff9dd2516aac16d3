// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/cell_number.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/draw/choice.h"
#include "tests/draw/picture_support.h"

namespace sightline {
namespace {

using namespace test;

TEST(CellNumbers, LabelsAreTheNumbersOfTheCells) {
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    session.seek(20);
    const std::uint32_t last = session.timeline().steps[19].item.id;
    for (const CellNumber what : {CellNumber::solidity, CellNumber::count, CellNumber::order, CellNumber::zeta,
                                  CellNumber::share, CellNumber::id})
        for (const LabelWhere where : {LabelWhere::all, LabelWhere::front, LabelWhere::selected}) {
            Settings settings = session.settings();
            settings.label = what;
            settings.label_where = where;
            session.change(settings);
            session.selected_cell = last;
            const auto numbers = cell_numbers(session, what);
            const Box<2> world = make_picture(session).world;
            std::multiset<std::string> expected, found;
            for (std::uint32_t cell = 0; cell < numbers.size(); ++cell) {
                const bool front = session.mark(cell).state == CellState::enqueued;
                const bool wanted = where == LabelWhere::all || cell == last || (where == LabelWhere::front && front);
                if (numbers[cell] && wanted && world.contains(session.cells().centre(cell)))
                    expected.insert(cell_label(session, choice_of(session), cell, *numbers[cell]));
            }
            const DrawList list = make_picture(session);
            for (const Label& label : list.labels) found.insert(label.text);
            if (where != LabelWhere::selected) {
                EXPECT_EQ(found, expected) << number_title(what, "key");
            }
            EXPECT_EQ(found.empty(), !numbers[last] && where == LabelWhere::selected);
            if (numbers[last]) {
                // The cell just projected keeps its number however crowded the picture is.
                ASSERT_FALSE(list.labels.empty());
                const auto kept = std::find_if(list.labels.begin(), list.labels.end(), [&](const Label& label) {
                    return label.at == session.cells().centre(last);
                });
                ASSERT_NE(kept, list.labels.end());
                EXPECT_FALSE(kept->yields);
                // So does the one that comes next, and it is placed before all others.
                const std::uint32_t first = first_in_front(session);
                if (numbers[first] && where != LabelWhere::selected) {
                    EXPECT_FALSE(list.labels.front().yields);
                    EXPECT_EQ(list.labels.front().at, session.cells().centre(first));
                }
            }
        }
}

TEST(CellNumbers, CellNumbersAreWhatTheySay) {
    Random random(73);
    for (int i = 0; i < 60; ++i) {
        const test::Start start = test::random_cell_start(random);
        Session<2> session = start.session();
        session.seek(static_cast<std::uint32_t>(random.below(40)));
        const auto order = cell_numbers(session, CellNumber::order), keys = cell_numbers(session, CellNumber::solidity);
        const auto share = cell_numbers(session, CellNumber::share), ids = cell_numbers(session, CellNumber::id);
        const auto count_of = cell_numbers(session, CellNumber::count);
        for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
            const Mark mark = session.mark(cell);
            ASSERT_EQ(order[cell].has_value(), mark.state == CellState::projected);
            if (order[cell]) {
                ASSERT_EQ(session.timeline().steps[static_cast<std::size_t>(*order[cell]) - 1].item.id, cell);
            }
            ASSERT_EQ(keys[cell].has_value(), mark.state == CellState::projected || mark.state == CellState::enqueued);
            if (keys[cell]) {
                ASSERT_EQ(*keys[cell], mark.key);
            }
            ASSERT_EQ(share[cell], session.reference().cell_share[cell]);
            ASSERT_EQ(ids[cell], cell);
            ASSERT_EQ(count_of[cell], session.cells().count(cell));
        }
        // A scale covers every number of the recording, wherever the session stands, and no more.
        std::optional<std::array<double, 2>> all;
        Session<2> walk = session;
        walk.seek(0);
        do {
            for (const auto& number : cell_numbers(walk, CellNumber::solidity))
                if (number) {
                    if (!all) all = {*number, *number};
                    all = {std::min((*all)[0], *number), std::max((*all)[1], *number)};
                }
        } while (walk.position() < session.recorded() && walk.step() == Stop::none);
        ASSERT_EQ(number_range(session, CellNumber::solidity), all);
        const auto range = number_range(session, CellNumber::order);
        const std::uint32_t recorded = session.recorded();
        session.seek(session.position() / 2);
        ASSERT_EQ(number_range(session, CellNumber::order), range);
        ASSERT_EQ(number_range(session, CellNumber::solidity), all);
        if (recorded > 0) {
            ASSERT_EQ(range, (std::array<double, 2>{1, double(recorded)}));
        }
    }
}

/// Every field of every method, by its name; the names of others are refused with the list.
TEST(CellNumbers, AFieldOfTheMethodIsANumberToo) {
    Random random(93);
    std::size_t fields = 0, numbered = 0;
    for (const Method<2>& method : method_table<2>())
        for (int i = 0; i < 3; ++i) {
            test::Start start = test::random_start(random, 30);
            start.settings.method = method.id;
            Session<2> session = start.session();
            session.run();
            Settings settings = session.settings();
            for (const Field<2>& field : session.traversal().fields()) {
                SCOPED_TRACE(std::string(method.id) + " " + std::string(field.name));
                ++fields;
                apply_setting(settings, "heat=" + std::string(field.name));
                session.change(settings);
                EXPECT_EQ(setting_row("heat").get(session.settings()), field.name);
                const auto numbers = cell_numbers(session, session.settings().heat);
                std::optional<std::array<double, 2>> range;
                for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
                    ASSERT_EQ(numbers[cell], field.value(session.traversal(), cell_item(cell)));
                    numbered += numbers[cell].has_value();
                }
                EXPECT_EQ(number_range(session, session.settings().heat).has_value(),
                          std::any_of(numbers.begin(), numbers.end(), [](const auto& n) { return n.has_value(); }));
            }
            const Settings before = session.settings();
            apply_setting(settings, "heat=nosuchfield");
            EXPECT_THROW(session.change(settings), InputError);
            EXPECT_EQ(session.settings(), before);
            // Another method may not have it: then nothing is shown, and nothing is lost.
            settings = before;
            settings.method = "everything";
            EXPECT_NO_THROW(session.change(settings));
        }
    EXPECT_GT(fields, 12u);
    EXPECT_GT(numbered, 100u);
}

TEST(CellNumbers, LayeringNumbersAreThoseOfTheViewAndTheSceneNow) {
    Random random(78);
    for (int i = 0; i < 60; ++i) {
        const test::Start start = test::random_cell_start(random);
        Session<2> session = start.session();
        const auto check = [&] {
            const auto layers = layering_numbers(session.scene().primitives, make_view(session.culling_view()));
            const auto numbers = cell_numbers(session, CellNumber::zeta);
            for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
                std::optional<double> least;
                for (const std::uint32_t p : session.cells().primitives_of(cell))
                    if (layers[p] > 0) least = std::min<double>(least.value_or(layers[p]), layers[p]);
                ASSERT_EQ(numbers[cell], least);
            }
        };
        check();
        session.set_view(test::random_view(random));
        check();
        session.seek(7);
        session.set_scene(test::random_start(random).scene);
        check();
        Settings settings = session.settings();
        settings.error_bound = 0.3;
        session.change(settings);
        check();
    }
}

}  // namespace
}  // namespace sightline
