// The cell taken, the one that came next, and the labels that say how keys changed: against the records.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/choice.h"

#include <gtest/gtest.h>

#include "core/base/number.h"
#include "core/draw/palette.h"
#include "core/draw/picture.h"
#include "tests/session/session_support.h"

namespace sightline {
namespace {

std::size_t shapes(const DrawList& list, Look look) {
    std::size_t count = 0;
    for (const Shape& shape : list.shapes) count += shape.style == static_cast<std::uint16_t>(look);
    return count;
}

TEST(Choice, NamesWhatTheStepTookAndHowItChangedKeys) {
    Random random(5);
    std::uint32_t changed = 0, runners_up = 0;
    for (int i = 0; i < 30; ++i) {
        test::Start start = test::random_cell_start(random);
        apply_setting(start.settings, "label=solidity");
        Session<2> session = start.session();
        EXPECT_EQ(choice_of(session).taken, none);
        std::vector<Mark> before = test::marks(session);
        while (!session.finished()) {
            session.step();
            const auto front = test::sorted_front(before);
            const Choice choice = choice_of(session);
            ASSERT_EQ(choice.taken, front.front().id);
            ASSERT_EQ(choice.next, front.size() > 1 ? front[1].id : none);
            ASSERT_EQ(shapes(make_picture(session), Look::next), choice.next != none);
            runners_up += choice.next != none;
            const std::vector<Mark> now = test::marks(session);
            for (std::uint32_t cell = 0; cell < now.size(); ++cell) {
                const std::string label = cell_label(session, choice, cell, now[cell].key);
                const bool was_waiting = before[cell].state == CellState::enqueued;
                const bool moved =
                    was_waiting && now[cell].state == CellState::enqueued && before[cell].key != now[cell].key;
                ASSERT_EQ(label.find("→") != label.npos, moved) << label;
                ASSERT_EQ(label.starts_with(std::to_string(cell) + " · "),
                          moved || cell == choice.taken || cell == choice.next)
                    << label;
                changed += moved;
            }
            before = now;
        }
        apply_setting(start.settings, "show_choice=off");
        Session<2> off = start.session();
        off.run(3);
        EXPECT_EQ(shapes(make_picture(off), Look::next), 0u);
    }
    EXPECT_GT(changed, 20u);
    EXPECT_GT(runners_up, 100u);
}

}  // namespace
}  // namespace sightline
