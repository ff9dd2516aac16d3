// What one change would do is told beside what the run does: both are runs of the same problem.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "core/base/error.h"
#include "core/session/counterfactual.h"
#include "core/session/explain_primitive.h"
#include "tests/session/session_3d_support.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

/// Of the session's run, met or not; how many were met.
template <int D>
int expect_now_is_the_run(Session<D> session, Random& random) {
    session.run();
    session.seek(static_cast<std::uint32_t>(random.below(session.recorded() + 1)));
    int met = 0;
    const std::size_t count = session.scene().primitives.size();
    for (int i = 0; i < 3 && count > 0; ++i) {
        const auto primitive = static_cast<std::uint32_t>(random.below(count));
        const Outcome now = counterfactuals(session, primitive_item(primitive)).now;
        const PrimitiveExplanation e = explain_primitive(session, primitive);
        EXPECT_EQ(now.step, e.met_at) << session.method().id << ", primitive " << primitive;
        EXPECT_EQ(now.culled, e.culled) << session.method().id << ", primitive " << primitive;
        if (e.met_at == 0) {
            EXPECT_EQ(now.steps, session.recorded()) << session.method().id;
        }
        met += e.met_at > 0;
    }
    return met;
}

template <int D, typename MakeStart>
void check_all_methods(MakeStart make_start) {
    Random random(160 + D);
    std::set<std::string_view> agreed;
    for (const Method<D>& method : method_table<D>())
        for (int i = 0; i < test::soak_count(6); ++i) {
            auto start = make_start(random);
            start.settings.method = method.id;
            for (const ParameterRow* row : method.parameters)
                if (!row->words.empty() && random.below(3) == 0)
                    start.settings.parameters.set(*row, row->words[random.below(row->words.size())]);
            apply_setting(start.settings, D == 2 ? "reference_size=300" : "reference_size=80x60");
            try {
                if (expect_now_is_the_run<D>(start.session(), random) > 0) agreed.insert(method.id);
            } catch (const InputError&) {  // needs what a random scene does not have
            }
        }
    EXPECT_GE(agreed.size() + 6, method_table<D>().size());
    for (const std::string_view id : {"tri-z", "boxes", "tri", "flux", "published", "view", "cplp"})
        EXPECT_TRUE(agreed.contains(id)) << id;
}

TEST(Counterfactual, NowIsWhatTheRunDoes2d) {
    check_all_methods<2>([](Random& random) { return test::random_start(random, 200); });
}
TEST(Counterfactual, NowIsWhatTheRunDoes3d) {
    check_all_methods<3>([](Random& random) { return test::random_start_3d(random, 400); });
}

/// Those that wait with lower keys come sooner.
TEST(Counterfactual, AWaitingPrimitiveSaysWithWhichKeyItWaits) {
    Random random(170);
    int compared = 0;
    for (int i = 0; i < test::soak_count(250); ++i) {
        test::Start start = test::random_start(random, 200);
        start.settings.method = "tri";
        start.settings.budget = {Budget::Kind::primitives, static_cast<double>(1 + random.below(60))};
        Session<2> session = start.session();
        session.run();
        std::vector<std::pair<double, std::uint32_t>> told;  // key, step of a run without a budget
        for (std::uint32_t p = 0; p < session.scene().primitives.size(); ++p) {
            const PrimitiveExplanation e = explain_primitive(session, p);
            if (e.met_at > 0 || e.cells.empty()) continue;
            const std::uint32_t cell = e.cells.front();
            if (session.mark(cell).state != CellState::projected) continue;
            const std::string text = put_off_sentence(session, e);
            if (session.counters().partial_cell == cell) {
                EXPECT_NE(text.find("the budget ended in it"), std::string::npos) << text;
                continue;
            }
            const std::string words = "; it waits since then, with a key of about ";
            const std::size_t at = text.find(words);
            ASSERT_NE(at, std::string::npos) << text;
            EXPECT_NE(text.find("and the budget ended before its turn"), std::string::npos) << text;
            if (e.cells.size() > 1) continue;  // another may bring it sooner
            Session<2> whole = session;
            Settings settings = whole.settings();
            settings.budget = {};
            whole.change(settings);
            whole.run();
            told.emplace_back(std::stod(text.substr(at + words.size())), explain_primitive(whole, p).met_at);
            ASSERT_GT(told.back().second, 0u);
        }
        for (const auto& [key, step] : told)
            for (const auto& [other_key, other_step] : told) {
                if (!(key < 0.95 * other_key)) continue;
                EXPECT_LE(step, other_step) << key << " and " << other_key;
                ++compared;
            }
    }
    EXPECT_GT(compared, 20);
}

}  // namespace
}  // namespace sightline
