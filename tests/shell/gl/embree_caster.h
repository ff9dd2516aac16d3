// Which triangle a ray meets first, by Embree: nothing of the item buffer's code or arithmetic.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <embree3/rtcore.h>

#include "core/truth/id_image.h"

namespace sightline::test {

/// Single precision inside; the scene's coordinates and the eye's should be floats.
class EmbreeCaster {
public:
    EmbreeCaster(const Scene<3>& scene, const Vec<3>& eye) : scene_(scene), eye_(eye) {
        const std::size_t count = scene.primitives.size();
        auto* corners = static_cast<float*>(
            rtcSetNewGeometryBuffer(triangles_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, count * 3));
        auto* indices = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(triangles_, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, count));
        for (std::size_t i = 0; i < count * 3; ++i) {
            for (int k = 0; k < 3; ++k) *corners++ = static_cast<float>(scene.primitives[i / 3][i % 3][k]);
            *indices++ = static_cast<unsigned>(i);
        }
        rtcSetGeometryUserData(triangles_, this);
        rtcSetGeometryIntersectFilterFunction(triangles_, leave_out_backs);
        rtcCommitGeometry(triangles_);
        rtcAttachGeometry(tree_, triangles_);
        rtcSetSceneFlags(tree_, RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(tree_);
    }
    ~EmbreeCaster() {
        rtcReleaseGeometry(triangles_);
        rtcReleaseScene(tree_);
        rtcReleaseDevice(device_);
    }
    EmbreeCaster(const EmbreeCaster&) = delete;
    EmbreeCaster& operator=(const EmbreeCaster&) = delete;

    /// The nearest triangle that turns a seen side to the eye on the ray towards a point; none where none is.
    std::uint32_t first(const Vec<3>& through) const {
        const Vec<3> direction = glm::normalize(through - eye_);
        RTCRayHit ray{};
        ray.ray.org_x = static_cast<float>(eye_.x);
        ray.ray.org_y = static_cast<float>(eye_.y);
        ray.ray.org_z = static_cast<float>(eye_.z);
        ray.ray.dir_x = static_cast<float>(direction.x);
        ray.ray.dir_y = static_cast<float>(direction.y);
        ray.ray.dir_z = static_cast<float>(direction.z);
        ray.ray.tfar = std::numeric_limits<float>::infinity();
        ray.ray.mask = ~0u;
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(tree_, &context, &ray);
        return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? none : ray.hit.primID;
    }

private:
    static void leave_out_backs(const RTCFilterFunctionNArguments* hits) {
        const auto& self = *static_cast<const EmbreeCaster*>(hits->geometryUserPtr);
        const std::uint32_t id = RTCHitN_primID(hits->hit, hits->N, 0);
        if (!self.scene_.two_sided.empty() && self.scene_.two_sided[id]) return;
        const auto& [a, b, c] = self.scene_.primitives[id];
        if (glm::dot(glm::cross(b - a, c - a), self.eye_ - a) <= 0) hits->valid[0] = 0;
    }

    const Scene<3>& scene_;
    Vec<3> eye_;
    RTCDevice device_ = rtcNewDevice("threads=1");
    RTCScene tree_ = rtcNewScene(device_);
    RTCGeometry triangles_ = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
};

}  // namespace sightline::test
