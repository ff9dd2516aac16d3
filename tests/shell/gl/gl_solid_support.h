// A view of one unit a pixel, plain faces and a renderer: what the tests of solids draw with.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/gl/solid_renderer.h"
#include "tests/draw/solid_samples.h"
#include "tests/shell/gl/gl_support.h"

namespace sightline::test {

inline constexpr Colour green{0, 200, 0};

/// Looks along +y at a square of 100 x 100 around the origin, one unit a pixel there.
inline View<3> front_view(double distance = 1000) {
    View<3> view;
    view.eye = {0, -distance, 0};
    view.look_at = {0, 0, 0};
    view.corners = {Vec<3>(-50, 0, -50), Vec<3>(50, 0, -50), Vec<3>(50, 0, 50), Vec<3>(-50, 0, 50)};
    return view;
}

inline SolidStyle plain(Colour colour, double width = 0.5) { return {"", colour, false, width}; }

inline SolidList list_of(std::vector<SolidStyle> styles) {
    SolidList list;
    list.camera = front_view();
    list.styles = std::move(styles);
    return list;
}

/// A face that is square to the view.
inline void square(SolidList& list, std::uint8_t style, double from, double to, double y) {
    add_face(list, style, {{from, y, from}, {to, y, from}, {to, y, to}, {from, y, to}});
}

class GlSolid : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (context) renderer.emplace();
    }
    void TearDown() override {
        renderer.reset();
        GlTest::TearDown();
    }
    /// One sample a pixel, one pixel a point.
    Pixels drawn(const SolidList& list, int width = 100, int height = 100, bool quick = false) {
        renderer->set(list);
        const GlTarget target(width, height, 1, true);
        target.bind();
        renderer->draw(list.camera, 0, 0, width, height, 1, quick);
        return target.read();
    }
    std::optional<SolidRenderer> renderer;
};

}  // namespace sightline::test
