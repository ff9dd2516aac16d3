// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/insets.h"

#include "core/draw/depth_picture.h"
#include "core/draw/palette.h"
#include "core/draw/pixels.h"
#include "core/draw/solid_palette.h"
#include "core/draw/viewpoint_plan.h"
#include "core/draw/wrong_picture.h"
#include "core/run/drawn_levels.h"

namespace sightline {

namespace {

/// Triangles as the culling view sees them, in one colour.
SolidList seen_by_culling_eye(const Session<3>& session, std::vector<std::uint32_t> triangles) {
    SolidList list;
    list.camera = session.problem().view;
    list.styles = {solid_styles(session.settings().palette)[static_cast<std::size_t>(SolidLook::plain)]};
    list.background = colours(session.settings().palette).background;
    list.scene = session.shared_scene();
    list.triangles = std::move(triangles);
    list.runs = {{0, 0, static_cast<std::uint32_t>(list.triangles.size())}};
    return list;
}

}  // namespace

SolidList image_so_far(const Session<3>& session) {
    std::vector<std::uint32_t> ids;
    drawn_ids(session.traversal(), ids);
    SolidList list = seen_by_culling_eye(session, std::move(ids));
    list.scene = drawn_scene(session.traversal(), session.shared_scene());
    return list;
}

SolidList exact_image(const Session<3>& session) {
    // At the size of the reference nothing can be seen but what shows at the centre of one of its pixels.
    const Reference& reference = session.reference();
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t i = 0; i < reference.visible.size(); ++i)
        if (reference.visible[i]) triangles.push_back(i);
    return seen_by_culling_eye(session, std::move(triangles));
}

bool shows_depth(const Settings& settings) {
    return settings.inset == Inset::depth || settings.inset == Inset::pyramid;
}

std::string depth_title(const Settings& settings, const std::string& text) {
    return (settings.inset == Inset::pyramid ? "blocks: " : "depth: ") + text;
}

std::vector<Figure::Inset> make_insets(const Session<3>& session) {
    const Settings& set = session.settings();
    const ImageSize size = image_size<3>(set.reference_size);
    const double aspect = static_cast<double>(size.width) / size.height;
    std::vector<Figure::Inset> insets;
    const auto solid = [&](const char* title, SolidList list) {
        insets.push_back({title, aspect, std::make_shared<const SolidList>(std::move(list)), nullptr});
    };
    if (set.inset == Inset::image || set.inset == Inset::both) solid(title_of_image, image_so_far(session));
    if (set.inset == Inset::exact) solid(title_of_exact, exact_image(session));
    if (set.inset == Inset::missed || set.inset == Inset::both)
        insets.push_back({title_of_missed, aspect, nullptr,
                          std::make_shared<const Pixels>(
                              wrong_picture(session.reference(), session.wrong_mask(), session.scene()))});
    if (shows_depth(set)) {
        DepthPicture depth = depth_picture(session, set.inset == Inset::pyramid);
        insets.push_back(
            {depth_title(set, depth.text), aspect, nullptr, std::make_shared<const Pixels>(std::move(depth.pixels))});
    }
    if (auto plan = viewpoint_plan(session)) {
        const double own = plan->aspect();
        insets.push_back(
            {std::move(plan->title), own, nullptr, nullptr, std::make_shared<const DrawList>(std::move(plan->list))});
    }
    return insets;
}

}  // namespace sightline
