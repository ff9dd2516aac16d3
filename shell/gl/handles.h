// Owners of OpenGL's names: made by the constructor, deleted at the end of their life.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace sightline {

/// Traits has `GLuint make()` and `void drop(GLuint)`. The context that made it must be current at both ends.
template <typename Traits>
class GlHandle {
public:
    GlHandle() : name_(Traits::make()) {}
    ~GlHandle() {
        if (name_ != 0) Traits::drop(name_);
    }
    GlHandle(GlHandle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlHandle& operator=(GlHandle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    GLuint name() const { return name_; }

private:
    GLuint name_;
};

struct GlBufferTraits {
    static GLuint make() {
        GLuint name = 0;
        glGenBuffers(1, &name);
        return name;
    }
    static void drop(GLuint name) { glDeleteBuffers(1, &name); }
};

struct GlVertexArrayTraits {
    static GLuint make() {
        GLuint name = 0;
        glGenVertexArrays(1, &name);
        return name;
    }
    static void drop(GLuint name) { glDeleteVertexArrays(1, &name); }
};

struct GlTextureTraits {
    static GLuint make() {
        GLuint name = 0;
        glGenTextures(1, &name);
        return name;
    }
    static void drop(GLuint name) { glDeleteTextures(1, &name); }
};

struct GlRenderbufferTraits {
    static GLuint make() {
        GLuint name = 0;
        glGenRenderbuffers(1, &name);
        return name;
    }
    static void drop(GLuint name) { glDeleteRenderbuffers(1, &name); }
};

struct GlFramebufferTraits {
    static GLuint make() {
        GLuint name = 0;
        glGenFramebuffers(1, &name);
        return name;
    }
    static void drop(GLuint name) { glDeleteFramebuffers(1, &name); }
};

struct GlProgramTraits {
    static GLuint make() { return glCreateProgram(); }
    static void drop(GLuint name) { glDeleteProgram(name); }
};

struct GlVertexShaderTraits {
    static GLuint make() { return glCreateShader(GL_VERTEX_SHADER); }
    static void drop(GLuint name) { glDeleteShader(name); }
};

struct GlFragmentShaderTraits {
    static GLuint make() { return glCreateShader(GL_FRAGMENT_SHADER); }
    static void drop(GLuint name) { glDeleteShader(name); }
};

using GlBuffer = GlHandle<GlBufferTraits>;
using GlVertexArray = GlHandle<GlVertexArrayTraits>;
using GlTexture = GlHandle<GlTextureTraits>;
using GlRenderbuffer = GlHandle<GlRenderbufferTraits>;
using GlFramebuffer = GlHandle<GlFramebufferTraits>;
using GlProgram = GlHandle<GlProgramTraits>;
using GlVertexShader = GlHandle<GlVertexShaderTraits>;
using GlFragmentShader = GlHandle<GlFragmentShaderTraits>;

}  // namespace sightline
