// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/target.h"

#include <algorithm>

#include "core/base/error.h"

namespace sightline {

namespace {

void check_complete(int width, int height) {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw WorkError("OpenGL cannot draw into a picture of " + std::to_string(width) + " x " +
                        std::to_string(height) + " pixels");
}

}  // namespace

GlTarget::GlTarget(int width, int height, int samples, bool depth)
    : width_(width), height_(height), multisampled_(samples > 1) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (width < 1 || height < 1 || width > largest || height > largest)
        throw WorkError("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                        " pixels: OpenGL draws 1 to " + std::to_string(largest) + " a side");
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, single_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
    check_complete(width, height);
    GLint most = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    // Attaches to the bound framebuffer.
    const auto attach = [&](const GlRenderbuffer& buffer, GLenum place, GLenum format) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, multisampled_ ? std::min(samples, most) : 0, format, width,
                                         height);
        glBindRenderbuffer(GL_RENDERBUFFER, 0);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer.name());
        check_complete(width, height);
    };
    if (multisampled_) {
        glBindFramebuffer(GL_FRAMEBUFFER, multiple_.name());
        attach(samples_, GL_COLOR_ATTACHMENT0, GL_RGBA8);
    }
    if (depth) attach(depth_, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void GlTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, multisampled_ ? multiple_.name() : single_.name());
    glViewport(0, 0, width_, height_);
}

void GlTarget::resolve() const {
    if (multisampled_) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, multiple_.name());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, single_.name());
        glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

Pixels GlTarget::read() const {
    resolve();
    Pixels pixels{width_, height_, {}};
    pixels.colours.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, single_.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.colours.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    const auto row = [&](int y) { return pixels.colours.begin() + static_cast<std::ptrdiff_t>(y) * width_; };
    for (int y = 0; y < height_ / 2; ++y) std::swap_ranges(row(y), row(y + 1), row(height_ - 1 - y));
    return pixels;
}

}  // namespace sightline
