// The lane of frames: a method that reads what the frame before left.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/scene/clean.h"
#include "core/session/condition.h"
#include "core/session/report.h"
#include "core/session/state_file.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

/// Renders what the last frame rendered, then the scene in its order; a primitive a step.
class Again final : public Run<2> {
public:
    explicit Again(const Problem<2>& problem) : Run<2>(problem) {
        const auto count = static_cast<std::uint32_t>(problem.primitives().size());
        for (const bool wanted : {true, false})
            for (std::uint32_t p = 0; p < count; ++p)
                if ((problem.history && problem.history->visible[p]) == wanted) order_.push_back(p);
    }
    Stop run(std::uint32_t steps, Recorder* recorder) override {
        const std::uint64_t end = std::uint64_t{steps_} + steps;
        while (steps_ < end) {
            if (steps_ == order_.size()) return Stop::front_empty;
            if (counters_.spent >= problem_.budget) return Stop::budget;
            if (recorder) recorder->popped(primitive_item(order_[steps_]), {});
            meet(order_[steps_], true);
            ++steps_;
            if (recorder) recorder->finished(counters_);
        }
        return Stop::steps;
    }
    bool finished() const override { return steps_ == order_.size() || counters_.spent >= problem_.budget; }
    std::unique_ptr<Run<2>> clone() const override {
        ++clones;
        return std::make_unique<Again>(*this);
    }
    std::size_t memory_bytes() const override { return order_.size() * 4 + drawn_.memory_bytes(); }
    std::uint64_t hash() const override {
        Hash hash;
        add_run(hash, *this);
        return hash.value();
    }
    std::shared_ptr<const FrameHistory> next_history() const override {
        return std::make_shared<const FrameHistory>(FrameHistory{rendered_mask(met(), order_.size())});
    }

    std::span<const Field<2>> fields() const override {
        static const std::array table{
            Field<2>{"rho", "key", "as others call it", [](const Run<2>&, const Item&) { return std::optional(1.0); }},
            Field<2>{"again", "again", "1: rendered in the last frame, too",
                     [](const Run<2>& run, const Item& item) -> std::optional<double> {
                         if (item.kind != Kind::primitive) return std::nullopt;
                         const auto& history = run.problem().history;
                         return history && history->visible[item.id] ? 1 : 0;
                     }}};
        return table;
    }
    static int clones;  ///< made so far

private:
    std::vector<std::uint32_t> order_;
};
int Again::clones = 0;

std::vector<Method<2>> table_with_again() {
    std::vector<Method<2>> table(method_table<2>().begin(), method_table<2>().end());
    Method<2> again{"again", "again", "a test's",
                    [](const Problem<2>& p) -> std::unique_ptr<Run<2>> { return std::make_unique<Again>(p); }};
    again.pops = Kind::primitive;
    again.needs = {.cells = false, .history = true};
    table.push_back(std::move(again));
    return table;
}

TEST(Lane, AFrameDependsOnThoseBeforeItAndIsMadeAgainFromTheirViews) {
    const std::vector<Method<2>> table = table_with_again();
    Random random(97);
    int decided = 0;
    for (int i = 0; i < test::soak_count(40); ++i) {
        test::Start start = test::random_start(random, 80);
        // Files hold scenes without duplicates.
        Scene<2> scene = *start.scene;
        clean(scene, Recentre::no, "lane");
        start.scene = std::make_shared<const Scene<2>>(std::move(scene));
        start.settings.method = "again";
        start.settings.budget = {Budget::Kind::primitives, static_cast<double>(1 + random.below(20))};
        Session<2> session(start.scene, start.view, start.settings, table);
        EXPECT_TRUE(session.lane().empty());
        std::vector<std::uint64_t> hashes;
        std::vector<ViewSpec<2>> views;
        for (int frame = 0; frame < 4; ++frame) {
            views.push_back(test::random_view(random));
            session.fly(views.back());
            hashes.push_back(session.hash());
        }
        session.land();
        ASSERT_EQ(session.hash(), hashes.back()) << "recording a frame changes what it depends on";
        const Session<2> alone(start.scene, views.back(), start.settings, table);
        Session<2> first = alone;
        first.run();
        decided += first.hash() != hashes.back();

        // A file holds the views; opened, they are run again.
        const OpenedState<2> opened = open_state<2>(state_json(session), "lane", table);
        EXPECT_TRUE(opened.warnings.empty());
        ASSERT_EQ(opened.session.hash(), hashes.back());
        ASSERT_EQ(opened.session.lane(), session.lane());

        // Back into an earlier frame, and step through it.
        const std::size_t flown = session.lane().size() - 3;  // those of `views` begin here, if the start was a frame
        session.step_into(flown + 1);
        ASSERT_EQ(session.culling_view(), views[1]);
        ASSERT_EQ(session.hash(), hashes[1]);
        session.seek(0);
        session.run();
        ASSERT_EQ(session.hash(), hashes[1]);
        // Other settings run the frames before it again, too.
        Settings other = session.settings();
        other.budget = {};
        session.change(other);
        other.budget = start.settings.budget;
        session.change(other);
        session.run();
        ASSERT_EQ(session.hash(), hashes[1]);
        // A method that asks for no history has none.
        other.method = "view";
        session.change(other);
        EXPECT_EQ(session.problem().history, nullptr);
    }
    EXPECT_GT(decided, 5);
}

TEST(Lane, ConditionsAndTracesReachTheFieldsOfAMethod) {
    const std::vector<Method<2>> table = table_with_again();
    Random random(5);
    test::Start start = test::random_start(random, 80);
    Scene<2> scene = *start.scene;
    clean(scene, Recentre::no, "lane");
    start.scene = std::make_shared<const Scene<2>>(std::move(scene));
    start.settings.method = "again";
    start.settings.budget = {Budget::Kind::primitives, 6};
    Session<2> session(start.scene, start.view, start.settings, table);
    session.run();
    session.fly(start.view);
    session.land();
    ASSERT_GE(session.recorded(), 6u);
    const std::vector<std::uint32_t> found = matches(session, condition_for<2>(session, "again == 1 && step > 2"));
    const auto json = nlohmann::ordered_json::parse(trace_json(session));
    std::vector<std::uint32_t> expected;
    for (std::uint32_t step = 1; step <= session.recorded(); ++step) {
        const std::uint32_t primitive = session.timeline().steps[step - 1].item.id;
        const bool again = session.problem().history->visible[primitive] != 0;
        if (again && step > 2) expected.push_back(step);
        const auto& fields = json["steps"][step - 1]["fields"];
        EXPECT_EQ(fields["again"].get<double>(), again) << step;
        EXPECT_FALSE(fields.contains("rho")) << "stands in the step already";
    }
    EXPECT_EQ(found, expected);
    EXPECT_FALSE(found.empty());
    try {
        condition_for(session, "againn == 1");
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("again"), std::string::npos) << error.what();
    }

    // A breakpoint over it is kept while another method runs, never holds there, and is not written where no method
    // could read it.
    session.breakpoints.push_back({"again == 1", true});
    const std::string with = state_json(session);
    EXPECT_EQ(open_state<2>(with, "lane", table).session.breakpoints, session.breakpoints);
    Settings other = session.settings();
    other.method = "published";
    session.change(other);
    EXPECT_THROW(condition_for<2>(session, "again == 1"), InputError);
    EXPECT_FALSE(condition_here<2>(session, "again == 1"));
    EXPECT_TRUE(condition_here<2>(session, "rho > 0 && count > 1"));
    EXPECT_TRUE(open_state<2>(state_json(session), "lane", table).session.breakpoints.empty());
    EXPECT_EQ(nlohmann::ordered_json::parse(trace_json(session))["steps"][0].contains("fields"), false);
}

TEST(Lane, AFlightKeepsNoKeyframes) {
    const std::vector<Method<2>> table = table_with_again();
    Random random(31);
    test::Start start = test::random_start(random, 80);
    start.settings.method = "again";
    start.settings.budget = {};
    Session<2> session(start.scene, start.view, start.settings, table);
    const int before = Again::clones;
    for (int frame = 0; frame < 10; ++frame) session.fly(test::random_view(random));
    EXPECT_EQ(Again::clones, before) << "nothing is recorded, so that there is nothing to go back to";
    EXPECT_EQ(session.timeline().keyframes().size(), 0u);
    const std::uint64_t flown = session.hash();
    session.land();
    ASSERT_EQ(session.hash(), flown);
    EXPECT_GT(Again::clones, before);
    ASSERT_GT(session.position(), 2u);
    session.seek(1);
    session.seek(0);
    EXPECT_EQ(session.position(), 0u);
    session.run();
    EXPECT_EQ(session.hash(), flown);
}

}  // namespace
}  // namespace sightline
