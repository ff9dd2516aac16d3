// Contexts off screen: their messages, their pictures, and displays.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>

#include "tests/shell/gl/gl_support.h"

namespace sightline {
namespace {

using namespace test;

class GlContextTest : public GlTest {};

TEST_F(GlContextTest, IsOpenGl33Core) {
    EXPECT_GE(epoxy_gl_version(), 33);
    GLint mask = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &mask);
    EXPECT_TRUE(mask & GL_CONTEXT_CORE_PROFILE_BIT);
    EXPECT_EQ(context->description().rfind("OpenGL ", 0), 0u);
}

TEST_F(GlContextTest, CollectsAnErrorOnce) {
    if (!epoxy_has_gl_extension("GL_KHR_debug")) GTEST_SKIP() << "the driver has no KHR_debug";
    GlContext second(GlContext::Place::off_screen, "second", 16, 16);
    for (int i = 0; i < 3; ++i) glEnable(0x1234);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
    EXPECT_EQ(second.messages().size(), 1u);
    context->make_current();
    EXPECT_TRUE(context->messages().empty());
}

TEST_F(GlContextTest, OffScreenIsNoDisplay) {
    EXPECT_FALSE(Display().found());
    EXPECT_THROW(GlContext(GlContext::Place::window, "window", 64, 64), WorkError);
    context->make_current();  // the one that there is works on
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(GlContextTest, PicturesHaveTheTopRowFirst) {
    const GlTarget target(7, 5, 4);
    target.bind();
    clear(red);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 4, 2, 1);
    clear(blue);
    glDisable(GL_SCISSOR_TEST);
    const Pixels p = target.read();
    ASSERT_EQ(p.colours.size(), 35u);
    EXPECT_EQ(p.at(0, 0), blue);
    EXPECT_EQ(p.at(1, 0), blue);
    EXPECT_EQ(p.at(2, 0), red);
    EXPECT_EQ(p.at(0, 1), red);
    EXPECT_EQ(p.at(6, 4), red);
}

TEST_F(GlContextTest, AnImpossiblePictureIsAnError) {
    EXPECT_THROW(GlTarget(0, 5), WorkError);
    EXPECT_THROW(GlTarget(1 << 30, 5), WorkError);
}

TEST_F(GlContextTest, ABrokenShaderIsAnError) {
    const GlContext second(GlContext::Place::off_screen, "second", 16, 16);  // keeps the driver's own words
    EXPECT_THROW(make_program("#version 330 core\nvoid main() { gl_Position = nonsense; }\n",
                              "#version 330 core\nvoid main() {}\n"),
                 WorkError);
    context->make_current();
}

}  // namespace
}  // namespace sightline
