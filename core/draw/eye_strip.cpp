// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/eye_strip.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/draw/depth_strip.h"
#include "core/truth/item_buffer.h"

namespace sightline {

namespace {

constexpr int wall_shades = 12;  ///< from near to far

double distance_from(const Vec<2>& p, const Primitive<2>& s) {
    const Vec<2> d = s[1] - s[0];
    const double t = std::clamp(glm::dot(p - s[0], d) / glm::dot(d, d), 0.0, 1.0);
    return glm::length(p - (s[0] + d * t));
}

class EyePainter {
public:
    EyePainter(const Session<2>& session, const EyeStrip& strip, const Colours& colours, DrawList& list)
        : session_(session),
          strip_(strip),
          colours_(colours),
          list_(list),
          place_(eye_strip_place(list.world, session.settings().show_depth == Switch::on)),
          side_(bounds<2>(session.scene().primitives).longest_side()) {}

    void paper() {
        const Box<2>& world = list_.world;
        box(world.min.x, world.max.x, world.min.y, place_.top, fill("eye_paper", colours_.background));
    }

    void bands() {
        for (const EyeStrip::Piece& piece : strip_.pieces) {
            if (piece.exact != none) band(piece, place_.exact_low, place_.exact_high, wall(piece.exact));
            if (piece.drawn != none) band(piece, place_.drawn_low, place_.drawn_high, wall(piece.drawn));
        }
        if (strip_.wrong > 0) {
            const std::uint16_t red = fill("eye_wrong", colours_.wrong);
            for (const auto& stretch : wrong_stretches(strip_)) {
                const auto [from, to] = place_.mark_of(stretch, strip_.pixels);
                box(from, to, place_.drawn_high, place_.exact_low, red);
            }
        }
        if (strip_.concealed) {
            Style veil{"eye_concealed"};
            veil.hatch = Hatch::diagonal;
            veil.hatch_colour = between({colours_.background, colours_.ink}, 0.35);
            veil.fill = between({colours_.background, colours_.ink}, 0.1);
            box(place_.left, place_.right, place_.exact_low, place_.exact_high, add(veil));
        }
        const std::uint16_t rim = line("eye_rim", colours_.ink, 0.6);
        box(place_.left, place_.right, place_.drawn_low, place_.drawn_high, rim);
        box(place_.left, place_.right, place_.exact_low, place_.exact_high, rim);
    }

    /// Outlines where the selected segment is seen.
    void selection() {
        const std::uint32_t selected = session_.selected_primitive;
        if (selected == none) return;
        const std::uint16_t outline = line("eye_selected", colours_.accent, 1.8);
        for (const bool upper : {true, false}) {
            int begin = 0, end = 0;
            const auto close = [&] {
                if (begin == end) return;
                const EyeStrip::Piece piece{begin, end};
                if (upper)
                    band(piece, place_.exact_low, place_.exact_high, outline);
                else
                    band(piece, place_.drawn_low, place_.drawn_high, outline);
            };
            for (const EyeStrip::Piece& piece : strip_.pieces) {
                if ((upper ? piece.exact : piece.drawn) != selected) continue;
                if (piece.begin != end) {
                    close();
                    begin = piece.begin;
                }
                end = piece.end;
            }
            close();
        }
    }

    void words() {
        name("exact", place_.exact_low, place_.exact_high);
        name("drawn", place_.drawn_low, place_.drawn_high);
        if (strip_.concealed)
            label({(place_.left + place_.right) / 2, (place_.exact_low + place_.exact_high) / 2}, TextAlign::centre,
                  "?", colours_.ink);
        std::string text = "what the eye sees: ";
        if (strip_.concealed)
            text += "drawn so far";
        else if (strip_.wrong == 0)
            text += "all " + std::to_string(strip_.pixels) + " pixels right";
        else
            text += std::to_string(strip_.wrong) + " of " + std::to_string(strip_.pixels) + " pixels wrong";
        label({place_.left, (place_.exact_high + place_.top) / 2}, TextAlign::left, std::move(text),
              strip_.wrong > 0 ? between({colours_.wrong, colours_.ink}, 0.2) : colours_.ink);
        list_.labels.back().fits.x = place_.right - place_.left;
    }

private:
    std::uint16_t add(const Style& style) {
        list_.styles.push_back(style);
        return static_cast<std::uint16_t>(list_.styles.size() - 1);
    }
    std::uint16_t fill(const char* name, Colour colour) {
        Style style{name};
        style.fill = colour;
        return add(style);
    }
    std::uint16_t line(const char* name, Colour colour, double width_pt) {
        Style style{name};
        style.stroke = colour;
        style.width_pt = width_pt;
        return add(style);
    }
    void box(double left, double right, double low, double high, std::uint16_t style) {
        list_.add(ShapeKind::polygon, style, {{left, low}, {right, low}, {right, high}, {left, high}});
    }
    void band(const EyeStrip::Piece& piece, double low, double high, std::uint16_t style) {
        box(place_.x_of(piece.begin, strip_.pixels), place_.x_of(piece.end, strip_.pixels), low, high, style);
    }

    /// The tone follows the number, so that walls built one after the other differ; the shade says how near it is. Both
    /// are the same in every picture from this eye, whatever is drawn.
    std::uint16_t wall(std::uint32_t id) {
        const double distance = distance_from(strip_eye(), session_.scene().primitives[id]);
        constexpr double middle = 0.15;  // of the scene's longest side
        const double far = side_ > 0 ? distance / (distance + middle * side_) : 0;
        const int shade = std::min(static_cast<int>(far * wall_shades), wall_shades - 1);
        const std::size_t tone = id % colours_.walls.size();
        const auto [found, is_new] = walls_.try_emplace({tone, shade}, std::uint16_t{0});
        if (is_new) {
            const Colour own = colours_.walls[tone];
            const std::vector<Colour> stops{between({own, colours_.ink}, 0.4), own,
                                            between({own, colours_.background}, 0.65)};
            found->second = fill("eye_sees", between(stops, shade / (wall_shades - 1.0)));
        }
        return found->second;
    }
    Vec<2> strip_eye() const { return session_.problem().view.eye; }

    void name(const char* text, double low, double high) {
        label({place_.left, (low + high) / 2}, TextAlign::right, text, colours_.ink);
        list_.labels.back().offset_pt = {-3, 0};
        list_.labels.back().fits = {0.85 * (place_.left - list_.world.min.x), 1.25 * (high - low)};
    }
    void label(const Vec<2>& at, TextAlign align, std::string text, Colour colour) {
        Label label;
        label.at = at;
        label.align = align;
        label.text = std::move(text);
        label.scale = 0.8;
        label.fixed = true;
        label.colour = colour;
        list_.labels.push_back(std::move(label));
    }

    const Session<2>& session_;
    const EyeStrip& strip_;
    const Colours& colours_;
    DrawList& list_;
    EyeStripPlace place_;
    double side_;
    std::map<std::pair<std::size_t, int>, std::uint16_t> walls_;
};

/// Of a picture so wide and tall. In a wide one a share of its height, but never so flat that nothing can be seen.
double strip_height(double width, double share_of_height) {
    return std::min(0.12 * width, std::max(share_of_height, 0.06 * width));
}

}  // namespace

const EyeStrip::Piece& EyeStrip::at(int pixel) const {
    return *(std::upper_bound(pieces.begin(), pieces.end(), pixel,
                              [](int p, const Piece& piece) { return p < piece.begin; }) -
             1);
}

EyeStrip eye_strip(const Session<2>& session) {
    const PixelLine line = line_so_far(session);
    EyeStrip strip;
    strip.pixels = line.width();
    strip.concealed = session.settings().show_visibility == Switch::off;
    ItemBuffer exact;
    if (!strip.concealed) exact = item_buffer(session.scene().primitives, session.problem().view, strip.pixels);
    const bool by_objects = !session.traversal().stand_ins().empty();
    const auto object_of = [&](std::uint32_t p) { return session.traversal().levels()->objects.of[p]; };
    for (int pixel = 0; pixel < strip.pixels; ++pixel) {
        const auto at = static_cast<std::size_t>(strip.pixels - 1 - pixel);  // a line of pixels begins at the right
        const std::uint32_t seen = strip.concealed ? none : exact.ids[at];
        std::uint32_t drawn = line.ids[at];
        if (by_objects && seen != none && drawn != none && object_of(seen) == object_of(drawn)) drawn = seen;
        if (strip.pieces.empty() || strip.pieces.back().exact != seen || strip.pieces.back().drawn != drawn)
            strip.pieces.push_back({pixel, pixel, seen, drawn});
        ++strip.pieces.back().end;
        strip.wrong += strip.is_wrong(strip.pieces.back());
    }
    return strip;
}

Vec<2> through_pixel(const View<2>& view, int pixels, int pixel) {
    const int from_right = pixels - 1 - pixel;
    const auto between_ends = [](const Vec<2>& right, const Vec<2>& left, int at, int width) {
        return right + (left - right) * ((at + 0.5) / width);
    };
    if (!view.all_round)
        return between_ends(view.corners[0] - view.eye, view.corners[1] - view.eye, from_right, pixels);
    constexpr std::array<Vec<2>, 4> corners{{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
    const int side = pixels / 4;
    const auto i = static_cast<std::size_t>(from_right / side);
    return between_ends(corners[i], corners[(i + 1) % 4], from_right % side, side);
}

std::vector<std::array<int, 2>> wrong_stretches(const EyeStrip& strip) {
    std::vector<std::array<int, 2>> stretches;
    for (const EyeStrip::Piece& piece : strip.pieces) {
        if (!strip.is_wrong(piece)) continue;
        if (stretches.empty() || stretches.back()[1] != piece.begin) stretches.push_back({piece.begin, piece.begin});
        stretches.back()[1] = piece.end;
    }
    return stretches;
}

std::array<double, 2> EyeStripPlace::mark_of(const std::array<int, 2>& stretch, int pixels) const {
    const double from = x_of(stretch[0], pixels), to = x_of(stretch[1], pixels);
    const double more = std::max(0.0, (right - left) / 400 - (to - from)) / 2;
    return {std::max(from - more, left), std::min(to + more, right)};
}

EyeStripPlace eye_strip_place(const Box<2>& world, bool over_depths) {
    const Vec<2> extent = world.extent();
    const double unit = strip_height(extent.x, 0.16 * extent.y);
    const double low = world.min.y + (over_depths ? depth_strip_top * extent.y : 0);
    EyeStripPlace place;
    place.left = world.min.x + 0.11 * extent.x;
    place.right = world.min.x + 0.98 * extent.x;
    place.drawn_low = low + 0.07 * unit;
    place.drawn_high = low + 0.36 * unit;
    place.exact_low = low + 0.45 * unit;
    place.exact_high = low + 0.74 * unit;
    place.top = low + unit;
    return place;
}

double eye_strip_room(const Box<2>& shown, bool over_depths) {
    const Vec<2> extent = shown.extent();
    // 0.19 of what is shown is 0.16 of that and the strip.
    return strip_height(extent.x, 0.19 * extent.y) + (over_depths ? depth_strip_top * extent.y : 0);
}

void add_eye_strip(const Session<2>& session, const EyeStrip& strip, const Colours& colours, DrawList& list) {
    EyePainter painter(session, strip, colours, list);
    painter.paper();
    painter.bands();
    painter.selection();
    painter.words();
}

}  // namespace sightline
