// A context off screen, and small lists drawn into a picture.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/base/error.h"
#include "shell/gl/context.h"
#include "shell/gl/list_renderer.h"
#include "shell/gl/target.h"

namespace sightline::test {

constexpr Colour white{255, 255, 255}, red{255, 0, 0}, blue{0, 0, 255}, black{0, 0, 0};

/// Tests with a context; without OpenGL they are skipped. At the end no message of the driver may be there.
class GlTest : public ::testing::Test {
protected:
    void SetUp() override {
        try {
            context = std::make_unique<GlContext>(GlContext::Place::off_screen, "test", 64, 64);
        } catch (const WorkError& error) {
            GTEST_SKIP() << "no OpenGL here: " << error.what();
        }
    }
    void TearDown() override {
        if (!context) return;
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        EXPECT_TRUE(context->messages().empty()) << context->messages().front();
    }

    std::unique_ptr<GlContext> context;
};

/// One scene unit is a pixel, one point too; scene (0, 0) is the lower left corner.
inline ListView plain_view(int width, int height) { return {{{0, 0}, {width, height}}, 0, 0, width, height, 1, 1}; }

inline void clear(const Colour& c) {
    glClearColor(c.r / 255.0f, c.g / 255.0f, c.b / 255.0f, c.a / 255.0f);
    glClear(GL_COLOR_BUFFER_BIT);
}

/// The list on white.
inline Pixels drawn(const DrawList& list, const ListView& view, int width, int height, int samples = 1) {
    const GlTarget target(width, height, samples);
    ListRenderer renderer;
    renderer.set(list);
    target.bind();
    clear(white);
    renderer.draw(view);
    return target.read();
}

inline Style filled(Colour colour) {
    Style style;
    style.fill = colour;
    return style;
}

inline Style stroked(Colour colour, double width, Dash dash = Dash::solid) {
    Style style;
    style.stroke = colour;
    style.width_pt = width;
    style.dash = dash;
    return style;
}

/// How much black lies on white, in whole pixels: 1 for a black pixel, less for grey.
inline double ink(const Colour& c) { return 1 - (c.r + c.g + c.b) / 765.0; }

}  // namespace sightline::test
