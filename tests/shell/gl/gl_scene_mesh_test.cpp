// Triangles of a scene on the card: where the camera's matrix puts them, which ids they have, which are chosen.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "core/base/random.h"
#include "shell/gl/camera_matrix.h"
#include "shell/gl/program.h"
#include "shell/gl/reversed_depth.h"
#include "shell/gl/scene_mesh.h"
#include "tests/shell/gl/gl_support.h"

namespace sightline::test {
namespace {

constexpr int width = 160, height = 120;

/// What the card draws: id + 1 of the nearest triangle at each pixel, rows from the bottom; 0 where there is none.
class MeshPicture {
public:
    MeshPicture() {
        for (const auto& [name, format] : {std::pair{ids_.name(), GL_R32UI}, {depths_.name(), GL_DEPTH_COMPONENT32F}}) {
            glBindRenderbuffer(GL_RENDERBUFFER, name);
            glRenderbufferStorage(GL_RENDERBUFFER, static_cast<GLenum>(format), width, height);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, ids_.name());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depths_.name());
        EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
        glViewport(0, 0, width, height);
    }

    template <typename Draw>
    std::vector<std::uint32_t> of(const View<3>& view, const Box<3>& box, const Draw& draw) {
        const ReversedDepth depth;
        const CameraMatrix camera = camera_matrix(view, box, depth.zero_to_one());
        glClear(GL_DEPTH_BUFFER_BIT);
        constexpr GLuint nothing[4] = {0, 0, 0, 0};
        glClearBufferuiv(GL_COLOR, 0, nothing);
        glUseProgram(program_.name());
        glUniformMatrix4fv(glGetUniformLocation(program_.name(), "clip"), 1, GL_FALSE, &camera.clip[0][0]);
        glUniform3fv(glGetUniformLocation(program_.name(), "eye"), 1, &camera.eye[0]);
        glUniform3fv(glGetUniformLocation(program_.name(), "eye_rest"), 1, &camera.eye_rest[0]);
        draw();
        glUseProgram(0);
        std::vector<std::uint32_t> seen(std::size_t{width} * height);
        glReadPixels(0, 0, width, height, GL_RED_INTEGER, GL_UNSIGNED_INT, seen.data());
        return seen;
    }

private:
    GlRenderbuffer ids_, depths_;
    GlFramebuffer frame_;
    GlProgram program_ = make_program(R"(#version 330 core
layout(location = 0) in vec3 corner;
uniform mat4 clip;
uniform vec3 eye, eye_rest;
flat out uint id;
void main() {
    id = uint(gl_VertexID / 3 + 1);
    gl_Position = clip * vec4((corner - eye) - eye_rest, 1.0);
})",
                                      R"(#version 330 core
flat in uint id;
out uint seen;
void main() { seen = id; })");
};

/// The nearest triangle on the ray through the pixel's centre by the volumes that the ray has with its sides; id + 1.
std::uint32_t nearest(const Scene<3>& scene, const View<3>& view, int x, int y) {
    const auto& c = view.corners;
    const Vec<3> through = c[0] + (c[1] - c[0]) * ((x + 0.5) / width) + (c[3] - c[0]) * ((y + 0.5) / height) - view.eye;
    double best = 1e300;
    std::uint32_t seen = 0;
    for (std::size_t t = 0; t < scene.primitives.size(); ++t) {
        const auto& [p0, p1, p2] = scene.primitives[t];
        const Vec<3> a = p0 - view.eye, b = p1 - view.eye, d = p2 - view.eye;
        const double ab = glm::dot(glm::cross(a, b), through), bd = glm::dot(glm::cross(b, d), through),
                     da = glm::dot(glm::cross(d, a), through);
        const bool inside = (ab > 0 && bd > 0 && da > 0) || (ab < 0 && bd < 0 && da < 0);
        const double along = glm::dot(glm::cross(a, b), d) / (ab + bd + da);
        if (!inside || along <= 0 || along >= best) continue;
        best = along;
        seen = static_cast<std::uint32_t>(t + 1);
    }
    return seen;
}

/// Triangles about a point far from the origin, of coordinates that are floats.
Scene<3> random_soup(std::size_t count, const Vec<3>& centre, double size, std::uint64_t seed) {
    Random random(seed);
    Scene<3> scene;
    const auto around = [&](const Vec<3>& p, double reach) {
        Vec<3> q;
        for (int i = 0; i < 3; ++i) q[i] = static_cast<float>(p[i] + random.uniform(-reach, reach));
        return q;
    };
    for (std::size_t i = 0; i < count; ++i) {
        const Vec<3> middle = around(centre, size);
        scene.primitives.push_back({around(middle, size / 2), around(middle, size / 2), around(middle, size / 2)});
    }
    return scene;
}

class GlSceneMesh : public GlTest {};

TEST_F(GlSceneMesh, ThePictureIsWhatRaysThroughThePixelsMeet) {
    MeshPicture picture;
    struct Case {
        Vec<3> centre;
        double size;
    };
    for (const Case& c : {Case{{0, 0, 0}, 1},
                          {{5000, -3000, 800}, 1},
                          {{5000, -3000, 800}, 0.05},
                          {{0, 0, 0}, 1e-6},
                          {{0, 0, 0}, 1e7}}) {
        const Scene<3> scene = random_soup(60, c.centre, c.size, 7);
        const SceneMesh mesh(scene);
        View<3> view = make_view({c.centre + Vec<3>(-2.5, 0.3, 0.4) * c.size, c.centre, 50}, 4.0 / 3);
        for (const double aside : {0.0, 0.4}) {  // straight ahead; off the axis
            const Vec<3> shift = (view.corners[1] - view.corners[0]) * aside;
            for (Vec<3>& corner : view.corners) corner += shift;
            const auto seen = picture.of(view, bounds<3>(scene.primitives), [&] { mesh.draw_all(); });
            int wrong = 0, covered = 0;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const std::uint32_t right = nearest(scene, view, x, y);
                    wrong += seen[static_cast<std::size_t>(y * width + x)] != right;
                    covered += right != 0;
                }
            EXPECT_GT(covered, width * height / 8);
            EXPECT_LE(wrong, width * height / 2000) << "size " << c.size << " aside " << aside;
        }
    }
}

TEST_F(GlSceneMesh, ADrawnChoiceKeepsTheIdsAndLeavesTheOthersOut) {
    const Scene<3> scene = random_soup(200, {0, 0, 0}, 1, 3);
    const SceneMesh mesh(scene);
    EXPECT_EQ(mesh.triangles(), 200u);
    TriangleChoice choice;
    choice.set(std::array<std::uint32_t, 6>{150, 3, 77, 12, 199, 0});
    EXPECT_EQ(choice.count(), 6u);
    Scene<3> chosen = scene;
    for (std::uint32_t t = 0; t < 200; ++t)
        if (t != 77 && t != 12 && t != 199) chosen.primitives[t].fill({0, 0, 0});
    const View<3> view = make_view({{-3, 0, 0}, {0, 0, 0}, 50}, 4.0 / 3);
    const SceneMesh others(chosen);
    MeshPicture picture;
    const Box<3> box = bounds<3>(scene.primitives);
    const auto part = picture.of(view, box, [&] { mesh.draw(choice, 2, 3); });
    EXPECT_EQ(part, picture.of(view, box, [&] { others.draw_all(); }));
    EXPECT_NE(part, picture.of(view, box, [&] { mesh.draw_all(); }));
    EXPECT_TRUE(std::any_of(part.begin(), part.end(), [](std::uint32_t id) { return id == 200; }));
}

TEST_F(GlSceneMesh, NoTrianglesAreNoError) {
    const SceneMesh mesh(Scene<3>{});
    MeshPicture picture;
    const View<3> view = make_view({{-3, 0, 0}, {0, 0, 0}, 50}, 4.0 / 3);
    const auto seen = picture.of(view, Box<3>{}, [&] { mesh.draw_all(); });
    EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](std::uint32_t id) { return id == 0; }));
}

TEST_F(GlSceneMesh, AfterReversedDepthTheStateIsThatOfTheStart) {
    { const ReversedDepth depth; }
    GLint function = 0;
    GLfloat cleared = 0;
    glGetIntegerv(GL_DEPTH_FUNC, &function);
    glGetFloatv(GL_DEPTH_CLEAR_VALUE, &cleared);
    EXPECT_FALSE(glIsEnabled(GL_DEPTH_TEST));
    EXPECT_EQ(function, GL_LESS);
    EXPECT_EQ(cleared, 1);
}

}  // namespace
}  // namespace sightline::test
