// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/insets.h"

#include "core/draw/palette.h"
#include "core/draw/pixels.h"
#include "core/draw/solid_list.h"
#include "core/draw/wrong_picture.h"

namespace sightline {

namespace {

/// What is rendered so far, as the culling view sees it.
SolidList rendered_so_far(const Session<3>& session) {
    SolidList list;
    list.camera = session.frame().view;
    list.styles = {{"rendered", {200, 200, 205}, true}};
    list.background = colours(session.settings().palette).background;
    list.scene = session.shared_scene();
    const State<3>& state = session.state();
    for (const std::uint32_t entry : std::span(state.touched).first(state.touched_count))
        if (!(entry & State<3>::culled_bit)) list.triangles.push_back(entry);
    list.runs = {{0, 0, static_cast<std::uint32_t>(list.triangles.size())}};
    return list;
}

}  // namespace

std::vector<Figure::Inset> make_insets(const Session<3>& session) {
    const Settings& set = session.settings();
    const ImageSize size = image_size<3>(set.reference_size);
    const double aspect = static_cast<double>(size.width) / size.height;
    std::vector<Figure::Inset> insets;
    if (set.inset == Inset::image || set.inset == Inset::both)
        insets.push_back(
            {"the culling eye, so far", aspect, std::make_shared<const SolidList>(rendered_so_far(session)), nullptr});
    if (set.inset == Inset::missed || set.inset == Inset::both) {
        const State<3>& state = session.state();
        insets.push_back({"missed pixels", aspect, nullptr,
                          std::make_shared<const Pixels>(wrong_picture(
                              session.reference(), std::span(state.touched).first(state.touched_count)))});
    }
    return insets;
}

}  // namespace sightline
