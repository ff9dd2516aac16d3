// The front against a sorted set of what it holds.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/front.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "core/base/index.h"
#include "core/base/random.h"
#include "tests/soak.h"

namespace sightline::test {
namespace {

using Row = std::tuple<double, std::uint32_t, std::uint32_t>;

void expect_first(Front& front, const std::set<Row>& rows, const std::vector<std::uint32_t>& stamps) {
    const Front::Entry* top = front.top([&](const Front::Entry& entry) { return stamps[entry.id] == entry.stamp; });
    ASSERT_EQ(top == nullptr, rows.empty());
    if (!top) return;
    ASSERT_EQ(Row(top->key, top->stamp, top->id), *rows.begin());
    ASSERT_EQ(front.likely_next(0, none), top->id);
}

/// Keys as layers, floods and solidities have them; items that are in the front get others.
TEST(Front, GivesTheLowestKeyAndOfEqualOnesTheOldest) {
    constexpr std::uint32_t items = 300;
    for (int seed = 1; seed <= soak_count(60); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        Front front;
        std::set<Row> rows;
        std::vector<std::uint32_t> stamps(items, none);
        std::vector<double> keys(items);
        std::uint32_t stamp = 0;
        double layer = 0;
        for (int i = 0; i < 3000; ++i) {
            if (random.below(5) < 3) {
                const auto id = static_cast<std::uint32_t>(random.below(items));
                if (stamps[id] != none) rows.erase({keys[id], stamps[id], id});
                const double fraction = random.below(2) ? random.uniform(-1, 2) : 0.25;
                keys[id] = seed % 3 == 0                      ? layer + static_cast<double>(random.below(2))
                           : seed % 3 == 1 && random.below(3) ? 0
                                                              : fraction;
                stamps[id] = stamp++;
                front.push({keys[id], stamps[id], id});
                rows.insert({keys[id], stamps[id], id});
            } else if (!rows.empty()) {
                ASSERT_NO_FATAL_FAILURE(expect_first(front, rows, stamps));
                layer = std::max(layer, std::get<0>(*rows.begin()));
                stamps[std::get<2>(*rows.begin())] = none;
                rows.erase(rows.begin());
                front.pop();
            }
            if (i == 2000) {  // as after an undo: the same, in the order of the items
                front.clear();
                for (std::uint32_t id = 0; id < items; ++id)
                    if (stamps[id] != none) front.push({keys[id], stamps[id], id});
            }
            ASSERT_NO_FATAL_FAILURE(expect_first(front, rows, stamps)) << seed << ' ' << i;
        }
    }
}

}  // namespace
}  // namespace sightline::test
