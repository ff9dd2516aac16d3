// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/strip_picking.h"

#include <algorithm>
#include <cmath>

#include "core/session/missed.h"

namespace sightline {

std::optional<StripPick> pick_strip(const EyeStrip& strip, const EyeStripPlace& place, const Vec<2>& at) {
    const bool beside = at.x < place.left || at.x > place.right || at.y < place.drawn_low || at.y > place.exact_high;
    if (beside || strip.pixels == 0) return std::nullopt;
    StripPick pick;
    pick.drawn_band = at.y < place.drawn_high;
    pick.pixel = static_cast<int>((at.x - place.left) / (place.right - place.left) * strip.pixels);
    pick.pixel = std::clamp(pick.pixel, 0, strip.pixels - 1);
    if (!pick.drawn_band && at.y < place.exact_low)
        for (const auto& stretch : wrong_stretches(strip)) {
            const auto [from, to] = place.mark_of(stretch, strip.pixels);
            if (at.x < from || at.x > to) continue;
            pick.pixel = std::clamp(pick.pixel, stretch[0], stretch[1] - 1);
            break;
        }
    pick.piece = strip.at(pick.pixel);
    return pick;
}

std::array<Vec<2>, 2> line_of_sight(const Session<2>& session, const EyeStrip& strip, const StripPick& pick,
                                    double far) {
    const View<2>& view = session.problem().view;
    const Vec<2> towards = through_pixel(view, strip.pixels, pick.pixel);
    double length = far / glm::length(towards);
    if (pick.primitive() != none) {
        const Primitive<2>& segment = session.scene().primitives[pick.primitive()];
        const Vec<2> along = segment[1] - segment[0];
        length = cross(segment[0] - view.eye, along) / cross(towards, along);
    }
    return {view.eye, view.eye + towards * length};
}

std::string strip_words(const Scene<2>& scene, const EyeStrip& strip, const StripPick& pick) {
    const auto segment = [&](std::uint32_t id) { return primitive_name(scene, id); };
    const std::string start = "pixel " + std::to_string(pick.pixel + 1) + ": ";
    const auto& [begin, end, exact, drawn] = pick.piece;
    if (strip.concealed) return start + (drawn == none ? "nothing is drawn yet" : segment(drawn) + " is drawn");
    if (exact == none && drawn == none) return start + "nothing is there";
    if (exact == drawn) return start + segment(exact) + ", drawn";
    return start + (exact == none ? "nothing" : segment(exact) + ", missing") + ": " +
           (drawn == none ? "nothing is drawn yet" : segment(drawn) + " is drawn instead");
}

}  // namespace sightline
