// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/id_renderer.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "core/base/error.h"
#include "shell/gl/program.h"

namespace sightline {

namespace {

constexpr std::size_t corners_at_once = 3 << 16;

constexpr const char* vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 corner;
layout(location = 1) in uint corner_id;
flat out uint id;
noperspective out float nearness;
void main() {
    id = corner_id;
    nearness = corner.z;
    gl_Position = vec4(corner.xy, 0.0, 1.0);
})";

// The depth is written here because fixed-function depth loses the small ones.
constexpr const char* nearest_shader = R"(#version 330 core
flat in uint id;
noperspective in float nearness;
out uint seen;
void main() {
    seen = id;
    gl_FragDepth = nearness;
})";

// Strictly behind the last layer in the order of depth, then id, so that triangles that coincide follow each other.
constexpr const char* behind_shader = R"(#version 330 core
flat in uint id;
noperspective in float nearness;
uniform usampler2D last_ids;
uniform sampler2D last_depths;
out uint seen;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float last = texelFetch(last_depths, pixel, 0).r;
    if (nearness > last || (nearness == last && id <= texelFetch(last_ids, pixel, 0).r)) discard;
    seen = id;
    gl_FragDepth = nearness;
})";

void make_texture(GLuint texture, const ImageSize& size, GLint internal, GLenum format, GLenum type) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, internal, size.width, size.height, 0, format, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void set_state(const ImageSize& size) {
    glViewport(0, 0, size.width, size.height);
    for (const GLenum off : {GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_BLEND, GL_CULL_FACE, GL_DITHER}) glDisable(off);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace

IdRenderer::IdRenderer()
    : nearest_(make_program(vertex_shader, nearest_shader)), behind_(make_program(vertex_shader, behind_shader)) {
    glUseProgram(behind_.name());
    glUniform1i(glGetUniformLocation(behind_.name(), "last_ids"), 0);
    glUniform1i(glGetUniformLocation(behind_.name(), "last_depths"), 1);
    glUseProgram(0);
    glBindVertexArray(layout_.name());
    glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(ImageCorner), nullptr);
    glEnableVertexAttribArray(1);
    glVertexAttribIPointer(1, 1, GL_UNSIGNED_INT, sizeof(ImageCorner),
                           reinterpret_cast<const void*>(offsetof(ImageCorner, id)));
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

IdRenderer::Layer IdRenderer::make_layer(const ImageSize& size) {
    const std::string words =
        "an image of ids of " + std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels";
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (size.width < 1 || size.height < 1 || size.width > largest || size.height > largest)
        throw WorkError(words + ": OpenGL draws 1 to " + std::to_string(largest) + " a side");
    Layer layer;
    make_texture(layer.ids.name(), size, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT);
    make_texture(layer.depths.name(), size, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
    glBindFramebuffer(GL_FRAMEBUFFER, layer.frame.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, layer.ids.name(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, layer.depths.name(), 0);
    const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (glGetError() == GL_OUT_OF_MEMORY || !complete) throw WorkError(words + ": the graphics card has no room");
    return layer;
}

void IdRenderer::draw_triangles(const Scene<3>& scene, const View<3>& view) {
    glBindVertexArray(layout_.name());
    glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
    for (std::size_t next = 0; next < scene.primitives.size();) {
        staged_.clear();
        append_image_triangles(scene, view, size_, next, corners_at_once, staged_);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(staged_.size() * sizeof(ImageCorner)), staged_.data(),
                     GL_STREAM_DRAW);
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(staged_.size()));
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

IdImage IdRenderer::read() const {
    IdImage image{size_.width, size_.height, {}};
    image.ids.resize(static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    // Drawn upside down, so that OpenGL's first row is the image's top.
    glReadPixels(0, 0, size_.width, size_.height, GL_RED_INTEGER, GL_UNSIGNED_INT, image.ids.data());
    return image;
}

std::vector<IdImage> IdRenderer::draw(const Scene<3>& scene, const View<3>& view, const ImageSize& size, int layers) {
    if (size != size_) layers_.clear();
    size_ = size;
    while (layers_.size() < (layers > 1 ? 2 : 1)) layers_.push_back(make_layer(size));
    set_state(size);
    std::vector<IdImage> images;
    for (int i = 0; i < std::max(layers, 1); ++i) {
        const std::size_t turn = static_cast<std::size_t>(i) % 2;
        glBindFramebuffer(GL_FRAMEBUFFER, layers_[turn].frame.name());
        constexpr GLuint nothing[4] = {none, 0, 0, 0};
        constexpr GLfloat farthest = 0;
        glClearBufferuiv(GL_COLOR, 0, nothing);
        glClearBufferfv(GL_DEPTH, 0, &farthest);
        glUseProgram(i == 0 ? nearest_.name() : behind_.name());
        if (i > 0) {
            const Layer& last = layers_[1 - turn];
            glActiveTexture(GL_TEXTURE1);
            glBindTexture(GL_TEXTURE_2D, last.depths.name());
            glActiveTexture(GL_TEXTURE0);
            glBindTexture(GL_TEXTURE_2D, last.ids.name());
        }
        draw_triangles(scene, view);
        IdImage image = read();
        const bool empty = std::all_of(image.ids.begin(), image.ids.end(), [](auto id) { return id == none; });
        if (i > 0 && empty) break;
        images.push_back(std::move(image));
    }
    for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE0}) {
        glActiveTexture(unit);
        glBindTexture(GL_TEXTURE_2D, 0);
    }
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    return images;
}

}  // namespace sightline
