// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/rank_correlation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/measure/frame_numbers.h"
#include "tests/soak.h"

namespace sightline {
namespace {

/// By its definition: Pearson's correlation of the ranks, each counted by comparing all pairs.
double by_definition(const std::vector<double>& a, const std::vector<double>& b) {
    const auto ranks = [](const std::vector<double>& values) {
        std::vector<double> found;
        for (const double v : values) {
            double rank = 0;
            for (const double w : values) rank += w < v ? 1 : w == v ? 0.5 : 0;
            found.push_back(rank);
        }
        return found;
    };
    const std::vector<double> x = ranks(a), y = ranks(b);
    double mean_x = 0, mean_y = 0, xx = 0, yy = 0, xy = 0;
    const auto n = static_cast<double>(a.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / n;
        mean_y += y[i] / n;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        yy += (y[i] - mean_y) * (y[i] - mean_y);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    return xx > 1e-9 && yy > 1e-9 ? xy / std::sqrt(xx * yy) : std::nan("");
}

TEST(RankCorrelation, IsThatOfItsDefinition) {
    Random random(5);
    for (int round = 0; round < 300; ++round) {
        std::vector<double> a(random.below(40)), b(a.size());
        const auto values = 1 + random.below(12);  // few: many are equal
        for (double& v : a) v = static_cast<double>(random.below(values));
        for (double& v : b) v = static_cast<double>(random.below(values)) / 7;
        const double expected = a.size() < 3 ? std::nan("") : by_definition(a, b), r = rank_correlation(a, b);
        if (std::isnan(expected))
            EXPECT_TRUE(std::isnan(r)) << round;
        else
            EXPECT_NEAR(r, expected, 1e-12) << round;
    }
}

TEST(RankCorrelation, KnowsNoUnit) {
    const double grows[] = {1, 2, 3, 4}, bends[] = {-5, 0, 0.1, 1e9}, falls[] = {9, 3, 2.9, -1}, flat[] = {2, 2, 2, 2};
    EXPECT_EQ(rank_correlation(grows, bends), 1);
    EXPECT_EQ(rank_correlation(bends, falls), -1);
    EXPECT_TRUE(std::isnan(rank_correlation(grows, flat)));
    EXPECT_TRUE(std::isnan(rank_correlation(std::span(grows).first(2), std::span(bends).first(2))));
}

TEST(RankCorrelation, OfAFrameCountsTheCellsPoppedWithinTheBudget) {
    WholeRun run;
    run.popped_cells = {{1, 2, 0.1}, {2, 0, 0.2}, {4, 1, 0.9}, {5, 3, 1.5}};
    Reference reference;
    reference.cell_share = {0.3, 0.1, 0.6, 0.9};
    const KeysAndShares some = keys_and_shares(run, reference, 4), all = keys_and_shares(run, reference, 5);
    EXPECT_EQ(some.keys, (std::vector<double>{0.1, 0.2, 0.9}));
    EXPECT_EQ(some.shares, (std::vector<double>{0.6, 0.3, 0.1}));
    EXPECT_EQ(rank_correlation(some.keys, some.shares), -1);
    EXPECT_EQ(all.keys.size(), 4u);
    reference.cell_share.clear();
    EXPECT_TRUE(keys_and_shares(run, reference, 5).keys.empty()) << "a reference without shares";
}

}  // namespace
}  // namespace sightline
