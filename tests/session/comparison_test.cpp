// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/comparison.h"

#include <gtest/gtest.h>

#include "core/base/number.h"
#include "core/session/explain.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using test::Start;

/// A start and a second one that differs in some of: traversal settings, budget, tessellation, view.
std::pair<Start, Start> random_pair(Random& random) {
    std::pair<Start, Start> pair{test::random_start(random), {}};
    Start& b = pair.second;
    b = pair.first;
    const Settings other = test::random_settings(random);
    if (random.below(2)) b.settings.method = other.method;
    for (const ParameterRow* row : {&transfer_sign_row(), &penalty_row()})
        if (random.below(2)) b.settings.parameters.set(*row, other.parameters.text(*row));
    if (random.below(3) == 0) b.settings.budget = other.budget;
    if (random.below(4) == 0) b.settings.error_bound = other.error_bound;
    if (random.below(4) == 0) b.settings.tessellation = other.tessellation;
    if (random.below(4) == 0) b.view = test::random_view(random);
    return pair;
}

/// What a step of a fresh walk popped and rendered.
struct Made {
    std::uint32_t cell = none;
    std::vector<std::uint32_t> rendered;
    std::uint32_t rendered_so_far = 0;
};

std::vector<Made> walk(const Start& start, std::uint32_t steps) {
    std::vector<Made> made;
    Session<2> session = start.session();
    for (std::uint32_t i = 0; i < steps; ++i) {
        const std::uint32_t before = session.counters().touched_count;
        const auto front = test::sorted_front(test::marks(session));
        if (session.step() != Stop::none) break;
        Made m;
        if (session.method().orders_cells()) m.cell = front.front().id;
        m.rendered = rendered_ids(session.met().subspan(before));
        m.rendered_so_far = session.counters().rendered_count;
        made.push_back(m);
    }
    return made;
}

TEST(Comparison, TheFirstDifferenceIsTheFirstStepThatDiffers) {
    Random random(71);
    std::array<int, 3> by{};
    int none_found = 0, ends = 0;
    for (int i = 0; i < test::soak_count(400); ++i) {
        const auto [left, right] = random_pair(random);
        Session<2> a = left.session(), b = right.session();
        const auto steps_a = static_cast<std::uint32_t>(random.below(60));
        const auto steps_b = random.below(2) ? steps_a : static_cast<std::uint32_t>(random.below(60));
        a.run(steps_a);
        b.run(steps_b);
        const auto made_a = walk(left, steps_a), made_b = walk(right, steps_b);
        a.seek(static_cast<std::uint32_t>(random.below(a.position() + 1)));

        const bool cells = a.method().orders_cells() && b.method().orders_cells() && same_cells(a, b);
        std::optional<std::uint32_t> wanted;
        const std::size_t longer = std::max(made_a.size(), made_b.size());
        for (std::size_t s = 0; s < longer && !wanted; ++s) {
            const bool one = s >= made_a.size() || s >= made_b.size();
            if (one || (cells ? made_a[s].cell != made_b[s].cell : made_a[s].rendered != made_b[s].rendered)) {
                wanted = static_cast<std::uint32_t>(s) + 1;
                ++by[cells];
                ends += one;
            }
        }
        ASSERT_EQ(first_difference(a, b), wanted) << "pair " << i;
        ASSERT_EQ(first_difference(b, a), wanted);
        ASSERT_EQ(first_difference(a, a), std::nullopt);
        none_found += !wanted;
        if (!wanted) continue;

        const std::uint32_t position = a.position();
        const std::string text = difference_sentence(a, b, *wanted);
        ASSERT_EQ(a.position(), position);
        ASSERT_EQ(text.find("Step " + std::to_string(*wanted) + ": left "), 0u) << text;
        ASSERT_NE(text.find("; right "), std::string::npos) << text;
        ASSERT_EQ(text.back(), '.');
        // Each popped cell is there with the key that its session popped it with, and with the one in the other.
        for (const auto& [own, name] :
             {std::pair(&left, std::string("left")), std::pair(&right, std::string("right"))}) {
            const auto& made = own == &left ? made_a : made_b;
            const std::size_t begin = name == "left" ? 0 : text.find("; right ");
            const std::string part = text.substr(begin, name == "left" ? text.find("; right ") : std::string::npos);
            if (made.size() < *wanted) {
                ASSERT_NE(part.find("is recorded for " + std::to_string(made.size()) + " step"), std::string::npos)
                    << text;
                continue;
            }
            const Made& m = made[*wanted - 1];
            if (m.cell == none) {
                ASSERT_NE(part.find("renders " + std::to_string(m.rendered.size()) + " primitive"), std::string::npos)
                    << text;
                continue;
            }
            Session<2> before = own->session();
            before.seek(*wanted - 1);
            const std::string phrase = "projects cell " + std::to_string(m.cell) + " with key ";
            const std::size_t at = part.find(phrase);
            ASSERT_NE(at, std::string::npos) << text;
            const std::string number =
                part.substr(at + phrase.size(), part.find_first_of(" ;", at + phrase.size()) - at - phrase.size());
            const double key = before.mark(m.cell).key;
            const auto told = parse_number(number.ends_with('.') ? number.substr(0, number.size() - 1) : number);
            ASSERT_TRUE(told) << text;
            ASSERT_NEAR(*told, key, std::abs(key) * 5.01e-3) << text;
            const auto& others = own == &left ? made_b : made_a;
            const bool comparable = cells && others.size() >= *wanted;
            ASSERT_EQ(part.find("(its cell ") != std::string::npos, comparable) << text;
            if (comparable) {
                const std::uint32_t theirs = others[*wanted - 1].cell;
                const Mark mark = before.mark(theirs);
                const std::string word(cell_state_words[static_cast<std::size_t>(mark.state)]);
                ASSERT_NE(part.find("(its cell " + std::to_string(theirs) + ": " + word), std::string::npos) << text;
                if (mark.state == CellState::enqueued && mark.key != key) {
                    const int digits = separating_digits(key, mark.key);
                    ASSERT_GE(number.size(), short_number(key, digits).size()) << text;
                }
                ++by[2];
            }
        }
    }
    for (const int count : by) EXPECT_GT(count, 30);
    EXPECT_GT(none_found, 20);
    EXPECT_GT(ends, 20);
}

TEST(Comparison, DifferencesAreTheCellsThatOnlyOneProjected) {
    Random random(72);
    std::array<std::size_t, 3> seen{};
    int apart = 0, without_cells = 0;
    for (int i = 0; i < test::soak_count(200); ++i) {
        const auto [left, right] = random_pair(random);
        Session<2> a = left.session(), b = right.session();
        a.seek(static_cast<std::uint32_t>(random.below(40)));
        b.seek(static_cast<std::uint32_t>(random.below(40)));
        const auto here = cell_differences(a, b), there = cell_differences(b, a);
        const bool both_by_cells = goes_through_cells(a) && goes_through_cells(b);
        if (!same_cells(a, b) || !both_by_cells) {
            ASSERT_TRUE(here.empty() && there.empty());
            apart += both_by_cells;
            without_cells += !both_by_cells;
            continue;
        }
        std::vector<bool> by_a(a.cells().cell_count()), by_b(by_a);
        for (std::uint32_t s = 0; s < a.position(); ++s)
            if (const auto cell = id_of(a.timeline().steps[s].item, Kind::cell); cell != none) by_a[cell] = true;
        for (std::uint32_t s = 0; s < b.position(); ++s)
            if (const auto cell = id_of(b.timeline().steps[s].item, Kind::cell); cell != none) by_b[cell] = true;
        ASSERT_EQ(here.size(), by_a.size());
        ASSERT_EQ(there.size(), by_a.size());
        for (std::size_t cell = 0; cell < here.size(); ++cell) {
            ASSERT_EQ(here[cell], by_a[cell] == by_b[cell] ? Differs::no
                                  : by_a[cell]             ? Differs::only_here
                                                           : Differs::only_there);
            ASSERT_EQ(there[cell], by_a[cell] == by_b[cell] ? Differs::no
                                   : by_a[cell]             ? Differs::only_there
                                                            : Differs::only_here);
            ++seen[static_cast<std::size_t>(here[cell])];
        }
    }
    for (const std::size_t count : seen) EXPECT_GT(count, 50u);
    EXPECT_GT(apart, 10);
    EXPECT_GT(without_cells, 10);
}

TEST(Comparison, SoFarComesFromTheStepsThatBothHave) {
    Random random(75);
    int differ = 0, agree = 0;
    for (int i = 0; i < test::soak_count(200); ++i) {
        const auto [left, right] = random_pair(random);
        Session<2> a = left.session(), b = right.session();
        a.run(static_cast<std::uint32_t>(random.below(20)));
        b.run(static_cast<std::uint32_t>(random.below(20)));
        const std::uint32_t common = std::min(a.recorded(), b.recorded());
        const std::string said = so_far_sentence(a, b);
        const auto step = first_difference(a, b);
        if (step && *step <= common) {
            ASSERT_EQ(said, difference_sentence(a, b, *step));
            ++differ;
        } else if (common == 0) {
            ASSERT_EQ(said, "No step to compare yet.");
        } else {
            ASSERT_EQ(said, "Both agree in the first " + std::to_string(common) + (common == 1 ? " step." : " steps."));
            ++agree;
        }
    }
    EXPECT_GT(differ, 30);
    EXPECT_GT(agree, 10);
}

TEST(Comparison, SaysHowTheTwoAreAligned) {
    Random random(76);
    int ended = 0;
    for (int i = 0; i < test::soak_count(100); ++i) {
        const auto [left, right] = random_pair(random);
        Session<2> lead = left.session(), other = right.session();
        lead.run(static_cast<std::uint32_t>(random.below(30)));
        const auto number = [](std::uint32_t n) { return std::to_string(n); };
        follow(lead, other, Align::rendered);
        ASSERT_EQ(align_sentence(lead, other, Align::rendered),
                  "aligned by drawn: " + number(lead.counters().rendered_count) + " against " +
                      number(other.counters().rendered_count));
        follow(lead, other, Align::step);
        const std::string by_step = align_sentence(lead, other, Align::step);
        if (lead.position() == other.position())
            ASSERT_EQ(by_step, "aligned by step: both have made " + number(lead.position()) +
                                   (lead.position() == 1 ? " step" : " steps"));
        else
            ASSERT_EQ(by_step, "aligned by step: " + number(lead.position()) + " against " + number(other.position()) +
                                   ", where the right one ends");
        ended += lead.position() != other.position();
    }
    EXPECT_GT(ended, 5);
}

TEST(Comparison, SameCellsMeansTheSamePointsAndNeighbours) {
    Random random(73);
    int same = 0, different = 0;
    for (int i = 0; i < test::soak_count(100); ++i) {
        Start start = test::random_start(random);
        const Session<2> a = start.session();
        const Session<2> copy = a, again = start.session();
        ASSERT_TRUE(same_cells(a, copy));
        ASSERT_TRUE(same_cells(a, again));
        const Settings old = start.settings;
        start.settings.seed = old.seed + 1;
        start.settings.jitter = 0.04;
        const Session<2> b = start.session();
        bool equal = a.cells().points == b.cells().points && a.cells().cell_count() == b.cells().cell_count();
        for (std::uint32_t cell = 0; equal && cell < a.cells().cell_count(); ++cell) {
            equal = a.cells().centre(cell) == b.cells().centre(cell);
            const auto f = a.cells().facets_of(cell), g = b.cells().facets_of(cell);
            equal = equal && f.size() == g.size();
            for (std::size_t k = 0; equal && k < f.size(); ++k) equal = f[k].neighbour == g[k].neighbour;
        }
        ASSERT_EQ(same_cells(a, b), equal);
        same += equal;
        different += !equal;
    }
    EXPECT_GT(same, 10);
    EXPECT_GT(different, 10);
}

TEST(Comparison, FollowingGoesToTheStepOrToAsManyPrimitives) {
    Random random(74);
    int short_of = 0, further = 0;
    for (int i = 0; i < test::soak_count(300); ++i) {
        const auto [left, right] = random_pair(random);
        Session<2> lead = left.session(), other = right.session();
        other.run(static_cast<std::uint32_t>(random.below(30)));
        lead.run(static_cast<std::uint32_t>(random.below(60)));
        lead.seek(static_cast<std::uint32_t>(random.below(lead.position() + 1)));
        const auto made = walk(right, none);

        follow(lead, other, Align::step);
        ASSERT_EQ(other.position(), std::min<std::size_t>(lead.position(), made.size()));

        const std::uint32_t recorded = other.recorded(), wanted = lead.counters().rendered_count;
        follow(lead, other, Align::rendered);
        std::uint32_t step = 0;
        while (step < made.size() && (step == 0 ? 0 : made[step - 1].rendered_so_far) < wanted) ++step;
        ASSERT_EQ(other.position(), step) << "pair " << i;
        short_of += other.counters().rendered_count < wanted;
        further += step > recorded;
    }
    EXPECT_GT(short_of, 5);
    EXPECT_GT(further, 20);
}

}  // namespace
}  // namespace sightline
