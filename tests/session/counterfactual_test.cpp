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

}  // namespace
}  // namespace sightline
