// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "core/base/index.h"
#include "core/base/text.h"
#include "core/base/trig.h"
#include "core/scene/read/gltf_document.h"
#include "core/scene/read/gltf_nodes.h"

namespace sightline {

namespace {

constexpr double frames_a_second = 25;
constexpr std::size_t most_frames = 100000;  // over an hour

/// A camera of perspective that is shown.
struct Camera {
    std::uint32_t node;
    std::string name;
    double fov;  ///< degrees
};

/// What moves a node during an animation.
struct Channel {
    std::uint32_t node;
    enum class Part { translation, rotation, scale } part;
    enum class Way { linear, step, cubic } way;
    std::vector<double> times;
    GltfNumbers values;

    glm::dvec4 value(std::size_t i) const {
        glm::dvec4 v(0);
        for (int c = 0; c < values.components; ++c) v[c] = values.at(i, c);
        return v;
    }
    glm::dvec4 at(double time) const {
        const std::size_t stride = way == Way::cubic ? 3 : 1, middle = way == Way::cubic ? 1 : 0;
        const auto after = std::upper_bound(times.begin(), times.end(), time);
        if (after == times.begin()) return value(middle);
        const auto i = static_cast<std::size_t>(after - times.begin()) - 1;
        const glm::dvec4 from = value(i * stride + middle);
        if (after == times.end() || way == Way::step) return from;
        const glm::dvec4 to = value((i + 1) * stride + middle);
        const double span = times[i + 1] - times[i], t = (time - times[i]) / span;
        if (way == Way::linear) return part == Part::rotation ? between(from, to, t) : from + (to - from) * t;
        const glm::dvec4 leave = value(i * 3 + 2) * span, arrive = value((i + 1) * 3) * span;
        return from * (2 * t * t * t - 3 * t * t + 1) + leave * (t * t * t - 2 * t * t + t) +
               to * (3 * t * t - 2 * t * t * t) + arrive * (t * t * t - t * t);
    }
};

std::vector<Camera> cameras_of(const GltfDocument& file, const GltfNodes& nodes, std::vector<std::string>& warnings) {
    std::vector<Camera> cameras;
    std::size_t without = 0;
    for (const std::uint32_t i : nodes.shown) {
        const std::string at = "/nodes/" + std::to_string(i);
        const Json& node = file.element("nodes", i, at);
        const auto index = file.whole(node, "camera", at);
        if (!index) continue;
        const Json& camera = file.element("cameras", *index, at);
        const auto lens = camera.find("perspective");
        const auto angle = lens == camera.end() || !lens->is_object() ? camera.end() : lens->find("yfov");
        if (lens == camera.end() || !lens->is_object() || angle == lens->end() || !angle->is_number()) {
            ++without;
            continue;
        }
        std::string name = file.text(node, "name");
        if (name.empty()) name = file.text(camera, "name");
        if (name.empty()) name = "camera " + std::to_string(cameras.size() + 1);
        cameras.push_back({i, one_line(name, 60), std::clamp(angle->get<double>() * 180 / pi, 10.0, 120.0)});
    }
    if (without > 0)
        warnings.push_back(counted(without, "camera") + " without perspective (orthographic): not used as a view");
    return cameras;
}

std::vector<Channel> channels_of(GltfDocument& file, const Json& animation, const std::string& at) {
    std::vector<Channel> channels;
    const auto list = animation.find("channels"), samplers = animation.find("samplers");
    if (list == animation.end() || samplers == animation.end() || !list->is_array() || !samplers->is_array())
        return channels;
    for (const Json& of : *list) {
        const auto target = of.is_object() ? of.find("target") : of.end();
        if (!of.is_object() || target == of.end() || !target->is_object()) continue;
        const auto node = file.whole(*target, "node", at);
        const std::string path = file.text(*target, "path");
        const std::size_t sampler = file.required(of, "sampler", at);
        if (!node || (path != "translation" && path != "rotation" && path != "scale")) continue;
        file.element("nodes", *node, at);
        if (sampler >= samplers->size() || !(*samplers)[sampler].is_object()) file.fail(at, "has no such sampler");
        const Json& by = (*samplers)[sampler];
        Channel channel{static_cast<std::uint32_t>(*node),
                        path == "translation" ? Channel::Part::translation
                        : path == "rotation"  ? Channel::Part::rotation
                                              : Channel::Part::scale,
                        Channel::Way::linear,
                        {},
                        {}};
        const std::string way = file.text(by, "interpolation");
        if (way == "STEP") channel.way = Channel::Way::step;
        if (way == "CUBICSPLINE") channel.way = Channel::Way::cubic;
        const GltfNumbers times = file.numbers(file.required(by, "input", at));
        channel.values = file.numbers(file.required(by, "output", at));
        const std::size_t each = channel.way == Channel::Way::cubic ? 3 : 1;
        const int components = channel.part == Channel::Part::rotation ? 4 : 3;
        if (times.components != 1 || times.count == 0 || channel.values.count / each < times.count ||
            channel.values.components != components || times.count > file.bytes())
            file.fail(at, "the times and values of a channel do not fit each other");
        for (std::size_t i = 0; i < times.count; ++i) {
            channel.times.push_back(times.at(i, 0));
            if (!std::isfinite(channel.times[i]) || (i > 0 && !(channel.times[i] > channel.times[i - 1])))
                file.fail(at, "the times of a channel do not rise");
        }
        channels.push_back(std::move(channel));
    }
    return channels;
}

ViewSpec<3> view_from(const glm::dmat4& to_scene, double fov, double ahead) {
    const Vec<3> eye(to_scene[3]);
    const Vec<3> forward = -Vec<3>(to_scene[2]);  // a camera looks along its -z
    const double length = std::sqrt(glm::dot(forward, forward));
    return {eye, eye + (length > 0 ? forward / length : Vec<3>(0, 0, -1)) * ahead, fov};
}

/// Where a node stands at a time of an animation.
glm::dmat4 moved(const GltfNodes& nodes, const std::vector<Channel>& channels, std::uint32_t node, double time) {
    glm::dmat4 to_scene(1);
    for (std::uint32_t i = node; i != none; i = nodes.parents[i]) {
        GltfPlace place = nodes.places[i];
        for (const Channel& channel : channels) {
            if (channel.node != i) continue;
            const glm::dvec4 value = channel.at(time);
            place.fixed.reset();
            if (channel.part == Channel::Part::translation) place.translation = Vec<3>(value);
            if (channel.part == Channel::Part::rotation) place.rotation = value;
            if (channel.part == Channel::Part::scale) place.scale = Vec<3>(value);
        }
        to_scene = place.matrix() * to_scene;
    }
    return to_scene;
}

bool moves(const GltfNodes& nodes, const std::vector<Channel>& channels, std::uint32_t node) {
    for (std::uint32_t i = node; i != none; i = nodes.parents[i])
        if (std::any_of(channels.begin(), channels.end(), [i](const Channel& c) { return c.node == i; })) return true;
    return false;
}

}  // namespace

GltfCameras gltf_cameras(GltfDocument& file, const GltfNodes& nodes, double ahead) {
    GltfCameras result;
    const std::vector<Camera> cameras = cameras_of(file, nodes, result.warnings);
    if (cameras.empty()) return result;
    result.first = view_from(nodes.to_scene[cameras[0].node], cameras[0].fov, 1);
    if (cameras.size() > 1) {
        FlightPath<3> all{"cameras", {}, {}, {}};
        for (const Camera& camera : cameras)
            all.frames.push_back(view_from(nodes.to_scene[camera.node], camera.fov, ahead));
        result.paths.push_back(std::move(all));
    }
    const Json& animations = file.list("animations");
    for (std::size_t k = 0; k < animations.size(); ++k) {
        const std::string at = "/animations/" + std::to_string(k);
        const Json& animation = file.element("animations", k, at);
        const std::vector<Channel> channels = channels_of(file, animation, at);
        for (const Camera& camera : cameras) {
            if (!moves(nodes, channels, camera.node)) continue;
            double begin = channels[0].times.front(), end = channels[0].times.back();
            for (const Channel& channel : channels) {
                begin = std::min(begin, channel.times.front());
                end = std::max(end, channel.times.back());
            }
            const double frames = std::floor((end - begin) * frames_a_second + 1e-6) + 1;  // times are floats
            if (frames > most_frames)
                result.warnings.push_back("the flight of " + camera.name + " is cut after " +
                                          std::to_string(most_frames) + " frames");
            FlightPath<3> path{camera.name, {}, {}, {}};
            if (animations.size() > 1) {
                const std::string name = file.text(animation, "name");
                path.id += ", " + (name.empty() ? "animation " + std::to_string(k + 1) : one_line(name, 60));
            }
            const std::string id = path.id;
            const auto taken = [&] {
                return std::any_of(result.paths.begin(), result.paths.end(),
                                   [&](const FlightPath<3>& other) { return other.id == path.id; });
            };
            for (int n = 2; taken(); ++n) path.id = id + " (" + std::to_string(n) + ")";
            for (std::size_t f = 0; f < static_cast<std::size_t>(std::min(frames, double{most_frames})); ++f) {
                const double time = begin + static_cast<double>(f) / frames_a_second;
                path.frames.push_back(view_from(moved(nodes, channels, camera.node, time), camera.fov, ahead));
            }
            result.paths.push_back(std::move(path));
        }
    }
    return result;
}

}  // namespace sightline
