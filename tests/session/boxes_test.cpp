// A session whose method walks a tree of boxes: what pictures show of it and what is said of a box.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/number.h"
#include "core/draw/shown_boxes.h"
#include "core/session/explain.h"
#include "core/session/explain_box.h"
#include "core/session/explain_primitive.h"
#include "core/space/box_tree.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

TEST(Boxes, APictureShowsEachPrimitiveInOneBoxWhateverTheStep) {
    Random random(41);
    std::array<std::size_t, 5> seen{};
    for (int i = 0; i < test::soak_count(30); ++i) {
        test::Start start = test::random_start(random, 1500);
        start.settings.method = random.below(2) ? "boxes" : "view";
        apply_setting(start.settings, "refresh=2");
        apply_setting(start.settings, "reference_size=512");
        start.settings.budget = {};
        Session<2> session = start.session();
        if (session.scene().primitives.empty()) continue;
        const BoxTree<2>& tree = session.problem().boxes();
        for (int stop = 0; stop < 5; ++stop) {
            session.seek(static_cast<std::uint32_t>(random.below(80)));
            std::vector<std::uint32_t> around(session.scene().primitives.size(), none);
            for (const ShownBox<2>& shown : shown_boxes(session)) {
                ++seen[static_cast<std::size_t>(shown.state)];
                ASSERT_EQ(session.traversal().mark(Item{shown.node, Kind::node}).state, shown.state);
                for (const std::uint32_t primitive : tree.primitives_of(shown.node)) {
                    ASSERT_EQ(around[primitive], none) << "in two boxes";
                    around[primitive] = shown.node;
                }
            }
            for (std::uint32_t primitive = 0; primitive < around.size(); ++primitive)
                ASSERT_EQ(around[primitive], box_around(session, primitive));
            const auto last = last_box(session);
            ASSERT_EQ(last.has_value(), session.position() > 0);
            if (!last) continue;
            const std::uint32_t node = session.timeline().steps[session.position() - 1].item.id;
            ASSERT_TRUE(last->min == tree.nodes[node].box.min && last->max == tree.nodes[node].box.max);
        }
    }
    EXPECT_EQ(seen[static_cast<std::size_t>(CellState::clean)], 0u);
    for (const CellState state : {CellState::enqueued, CellState::projected, CellState::unseen, CellState::hidden})
        EXPECT_GT(seen[static_cast<std::size_t>(state)], 50u) << cell_state_words[static_cast<std::size_t>(state)];
}

TEST(Boxes, OfEachIsSaidWhatItsKeyIsMadeOf) {
    Random random(43);
    int told = 0, considered = 0;
    for (int i = 0; i < test::soak_count(20); ++i) {
        test::Start start = test::random_start(random, 1500);
        for (const char* const method : {"tri-z", "tri-z maximise=pixels", "boxes", "hzb", "view"}) {
            start.settings.method = method;
            apply_setting(start.settings, "reference_size=512");
            Session<2> session = start.session();
            session.seek(static_cast<std::uint32_t>(random.below(60)));
            for (const auto& [item, mark] : session.traversal().front()) {
                const auto key = session.traversal().key_terms(item, 3);
                ASSERT_TRUE(key) << method;
                ASSERT_EQ(key->key, mark.key) << method;
                ASSERT_EQ(key->terms.back().value, mark.key);
                const std::string text = box_sentence(session, item.id);
                ASSERT_TRUE(text.ends_with("it waits in the front; " + key->formula())) << text;
                ASSERT_TRUE(text.ends_with(" = " + short_number(mark.key))) << text;
                ++told;
            }
            for (std::uint32_t step = 1; step <= session.position(); ++step) {
                const StepExplanation e = explain_step(session, step);
                if (e.item.kind == Kind::node) {
                    ASSERT_NE(sentence(e).find(", " + e.formula + "; "), std::string::npos) << sentence(e);
                }
                for (const Considered& c : e.looked_at) {
                    ASSERT_EQ(c.key.has_value(), c.item.kind == Kind::node && c.item != e.item);
                    considered += c.key.has_value();
                }
            }
        }
    }
    EXPECT_GT(told, 300);
    EXPECT_GT(considered, 1000);
}

TEST(Boxes, OfEachIsSaidWhatBecameOfIt) {
    Random random(42);
    int hidden = 0;
    for (int i = 0; i < test::soak_count(20); ++i) {
        test::Start start = test::random_start(random, 1500);
        start.settings.method = "boxes";
        apply_setting(start.settings, "refresh=2");
        apply_setting(start.settings, "reference_size=512");
        Session<2> session = start.session();
        session.seek(40);
        for (std::uint32_t node = 0; node < session.problem().boxes().nodes.size(); ++node) {
            const std::string text = box_sentence(session, node);
            ASSERT_TRUE(text.starts_with("node " + std::to_string(node) + ", ")) << text;
            const CellState state = session.traversal().mark(Item{node, Kind::node}).state;
            const char* const says = state == CellState::enqueued ? "waits in the front"
                                     : state == CellState::hidden ? "it is hidden: "
                                     : state == CellState::unseen ? "it covers no pixel of the view"
                                     : state == CellState::clean  ? "it lies in node "
                                                                  : "it may be seen, and ";
            ASSERT_NE(text.find(says), std::string::npos) << text;
            hidden += state == CellState::hidden;
        }
    }
    EXPECT_GT(hidden, 20);
    test::Start told = test::random_start(random, 200);
    told.settings.method = "boxes";
    Session<2> session = told.session();
    session.seek(10);
    const std::vector<std::string> text = rows(session, explain_primitive(session, 0));
    EXPECT_TRUE(text.back().starts_with("  It lies in node ")) << text.back();
    test::Start start = test::random_start(random);
    start.settings.method = "published";
    const Session<2> cells = start.session();
    EXPECT_TRUE(shown_boxes(cells).empty());
    EXPECT_EQ(box_around(cells, 0), none);
}

}  // namespace
}  // namespace sightline
