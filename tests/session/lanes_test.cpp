// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/lanes.h"

#include <gtest/gtest.h>

#include "tests/session/session_support.h"

namespace sightline {
namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

TEST(Lanes, AreWhatAWalkFindsWhereverTheSessionStands) {
    Random random(51);
    int keys = 0, orders = 0, empty = 0;
    for (int i = 0; i < 200; ++i) {
        const test::Start start = test::random_start(random);
        Session<2> session = start.session();
        const double nan = std::numeric_limits<double>::quiet_NaN();
        Lanes walk;
        std::uint32_t visible = 0, rendered = 0;
        for (;;) {
            const auto front = session.traversal().front();
            if (session.step() != Stop::none) break;
            const Reference& reference = session.reference();
            const bool pops = static_cast<bool>(session.timeline().steps.back().item) && !front.empty();
            walk.cell.push_back(pops ? id_of(front.front().first, Kind::cell) : none);
            walk.key.push_back(pops ? front.front().second.key : nan);
            walk.visible.push_back(static_cast<std::uint32_t>(session.visible_rendered()) - visible);
            visible += walk.visible.back();
            walk.hidden.push_back(session.counters().rendered_count - rendered - walk.visible.back());
            rendered = session.counters().rendered_count;
            walk.rendered.push_back(rendered);
            walk.front.push_back(static_cast<std::uint32_t>(session.traversal().front().size()));
            const double all = static_cast<double>(reference.count);
            walk.coverage.push_back(all == 0 ? nan : visible / all);
            walk.oracle.push_back(all == 0 ? nan : std::min(1.0, rendered / all));
            keys += pops;
            orders += !pops;
            empty += all == 0;
        }
        session.seek(static_cast<std::uint32_t>(random.below(session.position() + 1)));
        if (random.below(2)) session.set_time_stop(session.position());
        const std::uint32_t position = session.position();
        const std::uint64_t hash = session.hash();
        const Lanes lanes = make_lanes(session);
        ASSERT_EQ(session.position(), position);
        ASSERT_EQ(session.hash(), hash);
        ASSERT_EQ(lanes.cell, walk.cell);
        ASSERT_EQ(lanes.visible, walk.visible) << "scene " << i;
        ASSERT_EQ(lanes.hidden, walk.hidden);
        ASSERT_EQ(lanes.rendered, walk.rendered);
        ASSERT_EQ(lanes.front, walk.front);
        for (const auto lane : {&Lanes::key, &Lanes::coverage, &Lanes::oracle}) {
            ASSERT_EQ((lanes.*lane).size(), (walk.*lane).size());
            for (std::size_t s = 0; s < (walk.*lane).size(); ++s)
                ASSERT_TRUE(same((lanes.*lane)[s], (walk.*lane)[s])) << "scene " << i << " step " << s + 1;
        }
        for (std::uint32_t count = 0; count <= rendered + 1; ++count) {
            std::uint32_t step = 0;
            while (step < session.recorded() && (step == 0 ? 0 : walk.rendered[step - 1]) < count) ++step;
            ASSERT_EQ(step_of_rendered(session, count), step) << count << " of " << rendered;
        }
    }
    EXPECT_GT(keys, 1000);
    EXPECT_GT(orders, 20);
    EXPECT_GT(empty, 0);
}

}  // namespace
}  // namespace sightline
