// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/snap_primitives.h"

#include "core/raster/band.h"

namespace sightline {

namespace {

constexpr std::size_t block_size = 64;

template <typename T>
using Lanes = std::array<T, block_size>;
template <typename T>
using Corners = std::array<Lanes<T>, 3>;

/// What the vectors could tell of a triangle.
enum Told : std::uint8_t {
    front = 1,    ///< it turns its front to the eye
    back = 2,     ///< its back; neither: too close to edge-on for doubles
    whole = 4,    ///< within reach of the cone, so that nothing is cut
    beyond = 8,   ///< beyond one side of the cone
    missing = 16  ///< of those that are whole: no pixel's centre lies in its box
};

struct Block {
    Corners<double> from_eye_x, from_eye_y, from_eye_z, x, y, w;
    Corners<std::int32_t> place_x, place_y;
    Corners<float> nearness;
    Lanes<std::uint8_t> told;
};

/// Compiled twice, for other vectors: the same sums, products and quotients of doubles, so the same bits.
[[gnu::always_inline]] inline void tell(Block& block, const ImageOf& image, std::size_t count) {
    const auto& across = image.plane.across;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < count; ++i) {
            const double x = block.from_eye_x[k][i], y = block.from_eye_y[k][i], z = block.from_eye_z[k][i];
            block.x[k][i] = across[0].x * x + across[0].y * y + across[0].z * z;
            block.y[k][i] = across[1].x * x + across[1].y * y + across[1].z * z;
            block.w[k][i] = across[2].x * x + across[2].y * y + across[2].z * z;
        }
    for (std::size_t i = 0; i < count; ++i) {
        // orient(), its first stage.
        const double ux = block.from_eye_x[0][i], uy = block.from_eye_y[0][i], uz = block.from_eye_z[0][i],
                     vx = block.from_eye_x[1][i], vy = block.from_eye_y[1][i], vz = block.from_eye_z[1][i],
                     wx = block.from_eye_x[2][i], wy = block.from_eye_y[2][i], wz = block.from_eye_z[2][i];
        const double vw = vx * wy, wv = wx * vy, wu = wx * uy, uw = ux * wy, uv = ux * vy, vu = vx * uy;
        const double up = std::abs(uz), vp = std::abs(vz), wp = std::abs(wz);
        const double det = uz * (wv - vw) + vz * (uw - wu) + wz * (vu - uv);
        const double size = up * (std::abs(vw) + std::abs(wv)) + vp * (std::abs(wu) + std::abs(uw)) +
                            wp * (std::abs(uv) + std::abs(vu));
        const double bound = 8 * 0x1p-53 * size;
        const bool sure = size > 1e-280 * (1 + up + vp + wp);
        block.told[i] = static_cast<std::uint8_t>((sure & (det > bound)) * front | (sure & (-det > bound)) * back);
    }
    for (std::size_t i = 0; i < count; ++i) {
        bool in = true, right = true, left = true, above = true, below = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = block.x[k][i], y = block.y[k][i], w = block.w[k][i];
            in &= (std::abs(x) <= cone_reach * w) & (std::abs(y) <= cone_reach * w) & (w > nearness_1);
            right &= x > w;
            left &= -x > w;
            above &= y > w;
            below &= -y > w;
        }
        block.told[i] |= static_cast<std::uint8_t>(in * whole | (right | left | above | below) * beyond);
    }
    const double scale_x = 0.5 * subpixels * image.size.width, scale_y = 0.5 * subpixels * image.size.height;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < count; ++i) {
            const bool in = block.told[i] & whole;
            const double x = in ? block.x[k][i] : 0, y = in ? block.y[k][i] : 0, w = in ? block.w[k][i] : 1;
            const double nearness = nearness_1 / w;
            const float image_x = static_cast<float>(x / w), image_y = static_cast<float>(-y / w);
            block.nearness[k][i] = static_cast<float>(nearness < 0x1p-126 ? 0x1p-126 : nearness);
            block.place_x[k][i] = static_cast<std::int32_t>(std::floor((image_x + 1.0) * scale_x + 0.5));
            block.place_y[k][i] = static_cast<std::int32_t>(std::floor((image_y + 1.0) * scale_y + 0.5));
        }
    for (std::size_t i = 0; i < count; ++i) {
        const auto least = [&](const Corners<std::int32_t>& c) { return std::min({c[0][i], c[1][i], c[2][i]}); };
        const auto most = [&](const Corners<std::int32_t>& c) { return std::max({c[0][i], c[1][i], c[2][i]}); };
        const bool misses = (std::max(first_centre(least(block.place_x)), 0) >=
                             std::min(first_centre(most(block.place_x)), image.size.width)) |
                            (std::max(first_centre(least(block.place_y)), 0) >=
                             std::min(first_centre(most(block.place_y)), image.size.height));
        block.told[i] |= static_cast<std::uint8_t>(misses * missing);
    }
}

void tell_any(Block& block, const ImageOf& image, std::size_t count) { tell(block, image, count); }
#if defined(__x86_64__)
[[gnu::target("avx2")]] void tell_avx2(Block& block, const ImageOf& image, std::size_t count) {
    tell(block, image, count);
}
#else
void tell_avx2(Block& block, const ImageOf& image, std::size_t count) { tell(block, image, count); }
#endif

void snap_one_by_one(const ImageOf& image, std::uint32_t primitive, std::uint32_t place, SnappedTriangles& out) {
    std::vector<ImageCorner> corners;
    append_image_triangle(*image.scene, *image.view, image.plane, image.size, primitive, corners);
    for (std::size_t k = 0; k < corners.size(); k += 3) {
        FixedTriangle triangle;
        if (!snap_triangle(&corners[k], image.size, triangle)) continue;
        out.triangles.push_back(triangle);
        out.place.push_back(place);
    }
}

}  // namespace

void snap_primitives(const ImageOf& image, std::span<const std::uint32_t> primitives, std::uint32_t first_place,
                     bool best_vectors, SnappedTriangles& out) {
    const auto tell_block = best_vectors && has_avx2() ? tell_avx2 : tell_any;
    const Scene<3>& scene = *image.scene;
    const Vec<3>& eye = image.plane.eye;
    Block block;
    for (std::size_t begin = 0; begin < primitives.size(); begin += block_size) {
        const std::size_t count = std::min(block_size, primitives.size() - begin);
        for (std::size_t i = 0; i < count; ++i) {
            const Primitive<3>& triangle = scene.primitives[primitives[begin + i]];
            for (std::size_t k = 0; k < 3; ++k) {
                block.from_eye_x[k][i] = triangle[k].x - eye.x;
                block.from_eye_y[k][i] = triangle[k].y - eye.y;
                block.from_eye_z[k][i] = triangle[k].z - eye.z;
            }
        }
        tell_block(block, image, count);
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint8_t told = block.told[i];
            if (told & beyond) continue;
            const std::uint32_t primitive = primitives[begin + i];
            if ((told & back) && !shows_both_sides(scene, primitive)) continue;
            const auto place = first_place + static_cast<std::uint32_t>(begin + i);
            if (!(told & whole) || !(told & (front | back))) {
                snap_one_by_one(image, primitive, place, out);
                continue;
            }
            if (told & missing) continue;
            FixedTriangle triangle;
            for (std::size_t k = 0; k < 3; ++k) {
                triangle.x[k] = block.place_x[k][i];
                triangle.y[k] = block.place_y[k][i];
                triangle.nearness[k] = block.nearness[k][i];
            }
            triangle.id = primitive;
            if (!turn(triangle)) continue;
            out.triangles.push_back(triangle);
            out.place.push_back(place);
        }
    }
}

}  // namespace sightline
