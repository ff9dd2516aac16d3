// Flying sessions, partly frozen views, and views that move.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shell/desk/camera.h"
#include "tests/session/session_3d_support.h"

namespace sightline {
namespace {

using namespace test;

TEST(Flight, AFrameIsTheOneThatARecordedRunReaches) {
    Random random(811);
    for (int i = 0; i < 40; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> flown = start.session(), stepped = start.session();
        const ViewSpec<3> view = random_view_3d(random);
        flown.fly(view);
        stepped.set_view(view);
        stepped.run();
        EXPECT_EQ(flown.hash(), stepped.hash());
        EXPECT_TRUE(flown.flying());
        EXPECT_EQ(flown.recorded(), 0u);
        EXPECT_EQ(flown.position(), 0u);
        flown.land();
        EXPECT_FALSE(flown.flying());
        EXPECT_EQ(flown.hash(), stepped.hash());
        EXPECT_EQ(flown.position(), stepped.position());
        EXPECT_EQ(flown.recorded(), stepped.recorded());
        const bool moved = stepped.position() > 0;
        EXPECT_EQ(flown.back(), moved);
        EXPECT_EQ(stepped.back(), moved);
        EXPECT_EQ(flown.hash(), stepped.hash());
    }
}

TEST(Flight, WhatMovesOrChangesASessionLandsFirst) {
    Random random(812);
    Start3 start = random_start_3d(random);
    while (start.scene->primitives.size() < 20) start = random_start_3d(random);
    Session<3> reference = start.session();
    reference.run();
    const auto flying = [&] {
        Session<3> session = start.session();
        session.fly(start.view);
        return session;
    };
    Session<3> back = flying();
    back.back();
    EXPECT_EQ(back.position() + 1, reference.position());
    Session<3> frozen = flying();
    frozen.freeze();
    EXPECT_EQ(frozen.recorded(), reference.recorded());
    Session<3> changed = flying();
    changed.change(start.settings);
    EXPECT_EQ(changed.position(), reference.position());
    Session<3> sought = flying();
    sought.seek(1);
    EXPECT_EQ(sought.position(), 1u);
}

TEST(Frozen, TheDisplayViewTakesAlongWhatIsNotFrozen) {
    Random random(813);
    for (int i = 0; i < 40; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> session = start.session();
        const ViewSpec<3> was = session.culling_view(), to = random_view_3d(random);
        for (const Frozen part : {Frozen::nothing, Frozen::eye, Frozen::direction, Frozen::all}) {
            Session<3> moved = session;
            if (part != Frozen::nothing) moved.freeze(part);
            moved.set_view(to);
            const ViewSpec<3>& now = moved.culling_view();
            const Vec<3> direction = now.look_at - now.eye;
            const bool eye_stays = part == Frozen::eye || part == Frozen::all;
            const bool direction_stays = part == Frozen::direction || part == Frozen::all;
            EXPECT_EQ(now.eye, eye_stays ? was.eye : to.eye);
            const Vec<3> wanted = direction_stays ? was.look_at - was.eye : to.look_at - to.eye;
            EXPECT_LT(glm::length(direction - wanted), 1e-12);
            EXPECT_EQ(now.fov, direction_stays ? was.fov : to.fov);
            EXPECT_EQ(moved.display_view(), to);
        }
    }
}

TEST(Camera3, MovesKeepWhatTheyPromise) {
    Random random(814);
    for (int i = 0; i < 300; ++i) {
        const ViewSpec<3> view = random_view_3d(random);
        const int up = random.below(2) ? 2 : 1;
        const double right = random.uniform(-400, 400), high = random.uniform(-200, 200);
        const double distance = glm::length(view.look_at - view.eye);

        const ViewSpec<3> o = orbited(view, up, right, high);
        EXPECT_EQ(o.look_at, view.look_at);
        EXPECT_NEAR(glm::length(o.look_at - o.eye), distance, 1e-9 * distance);
        const ViewSpec<3> t = turned(view, up, right, high);
        EXPECT_EQ(t.eye, view.eye);
        EXPECT_NEAR(glm::length(t.look_at - t.eye), distance, 1e-9 * distance);
        for (const ViewSpec<3>& moved : {o, t}) EXPECT_NO_THROW(make_view(moved, 1.5, up));

        // Up goes up, right goes right.
        const Axes a = axes(view, up);
        if (std::abs(a.forward[up]) < 0.9) {
            const Vec<3> small = orbited(view, up, 2, 0).eye - view.eye;
            EXPECT_GT(glm::dot(small, a.right), 0);
            EXPECT_GT(glm::dot(orbited(view, up, 0, 2).eye - view.eye, a.up), 0);
            EXPECT_GT(glm::dot(turned(view, up, 2, 0).look_at - view.look_at, a.right), 0);
            EXPECT_GT(glm::dot(turned(view, up, 0, 2).look_at - view.look_at, a.up), 0);
        }
        const ViewSpec<3> w = walked(view, up, {1, 2, 3});
        EXPECT_LT(glm::length(w.eye - view.eye - (a.right + a.up * 2.0 + a.forward * 3.0)), 1e-9);
        EXPECT_NEAR(glm::length(approached(view, 2).eye - view.look_at), distance / 2, 1e-9 * distance);
    }
}

TEST(Camera3, OutsideSeesTheWholeBox) {
    Random random(815);
    for (int i = 0; i < 200; ++i) {
        Box<3> box;
        for (int k = 0; k < 3; ++k) box.add(random_point_3d(random, -10, 10));
        const double aspect = random.uniform(0.3, 3);
        const ViewSpec<3> to = outside(random_view_3d(random), box, 2, aspect);
        const View<3> view = make_view(to, aspect);
        for (int corner = 0; corner < 8; ++corner) {
            Vec<3> p;
            for (int k = 0; k < 3; ++k) p[k] = (corner >> k & 1 ? box.max : box.min)[k];
            EXPECT_TRUE(in_view(view, std::span<const Vec<3>>(&p, 1)));
        }
    }
}

}  // namespace
}  // namespace sightline
