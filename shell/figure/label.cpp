// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/label.h"

#include <algorithm>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/draw/label_pass.h"
#include "shell/figure/key.h"

namespace sightline {

namespace {

/// Points beside the text of a label with a halo.
constexpr double halo_margin = 1;

/// The text of a label, ready to be put somewhere.
struct SetText {
    std::vector<Line> lines;
    double size = 0;  ///< points
    double width = 0;
    double radius = 0;

    LabelSize extent(const Label& label) const {
        const double more = lines.empty() ? 0 : static_cast<double>(lines.size() - 1) * line_pitch * size;
        return {width, more / 2 + 0.6 * size, label.halo.a > 0 ? halo_margin : 0.5, radius};
    }
};

/// What a label must fit into, in points.
Vec<2> limits_of(const Label& label, const Layout::Panel& panel, double scale) {
    const double widest = panel.frame.w - 2 * halo_margin;
    return {label.fits.x > 0 ? std::min(label.fits.x * scale, widest) : widest,
            label.fits.y > 0 ? label.fits.y * scale : 1e9};
}

/// In its form `form`: the first is as wide as it likes, up to the panel; the lines of further ones are shorter.
std::optional<SetText> set_text(const Label& label, const Layout::Panel& panel, const Layout& layout, const Font& font,
                                std::size_t form) {
    if (!(label.scale > 0 && label.scale < 1000)) return std::nullopt;
    std::string text;
    for (const char c : clean_text(label.text)) text += c == '\n' ? ' ' : c;
    if (text.empty() && !label.disc) return std::nullopt;
    SetText set;
    set.size = layout.font_pt * label.scale;
    const Vec<2> limits = limits_of(label, panel, layout.scale);
    const double widest = limits.x;
    double width = text_width(font, text) * set.size;
    if (form > 0) {
        // A little more than a fair share, since words are not cut.
        width = 1.15 * std::min(width, widest) / static_cast<double>(form + 1);
        if (!label.note || label.disc || form > 3 || text.find(' ') == std::string::npos) return std::nullopt;
    }
    if (label.note && !label.disc && widest > 0) {
        set.lines = wrap_text(font, text, set.size, form > 0 ? width : widest);
    } else if (!text.empty()) {
        double share = std::min(1.0, limits.y / (1.2 * set.size));
        if (width > widest && widest > 0) share = std::min(share, widest / width);
        if (label.fixed && share < 0.5) return std::nullopt;
        set.size *= share;
        set.lines = {{text, text_width(font, text) * set.size}};
    }
    for (const Line& line : set.lines) set.width = std::max(set.width, line.width);
    if (form > 0 && set.width > width * 1.001) return std::nullopt;
    if (label.disc) set.radius = std::max(0.72 * set.size, set.width / 2 + 0.25 * set.size);
    return set;
}

Box<2> box_of(const Rect& r) { return {{r.x, r.y}, {r.right(), r.bottom()}}; }

PlacedLabel put(std::size_t index, const Label& label, const SetText& set, const Box<2>& box, const Font& font) {
    PlacedLabel placed;
    placed.label = index;
    placed.radius = set.radius;
    placed.box = {box.min.x, box.min.y, box.extent().x, box.extent().y};
    placed.centre = box.centre();
    const double pitch = line_pitch * set.size;
    double middle = placed.centre.y - pitch * (static_cast<double>(set.lines.size()) - 1) / 2;
    for (const Line& line : set.lines) {
        TextRun& run = placed.runs.emplace_back();
        run.text = line.text;
        run.size = set.size;
        run.width = line.width;
        // The end that the alignment fixes stays where it is even if a viewer's font is wider.
        run.align = label.disc ? TextAlign::centre : label.align;
        run.x = placed.centre.x;
        if (run.align != TextAlign::centre) run.x += (run.align == TextAlign::left ? -0.5 : 0.5) * set.width;
        run.baseline = middle + font.cap_height * set.size / 2;
        middle += pitch;
    }
    return placed;
}

/// What no text may hide, though it is none: insets, the legend, the eye.
std::vector<Box<2>> taken_places(const Figure::Panel& content, const PlacedTexts& texts, const Layout::Panel& panel,
                                 const Layout& layout) {
    std::vector<Box<2>> taken;
    for (const PlacedInset& inset : texts.insets) taken.push_back(box_of(inset.box));
    if (layout.legend_box && panel.frame.overlaps(*layout.legend_box))
        taken.push_back(box_of(layout.legend_box->grown(halo_margin)));
    const DrawList& list = content.list;
    for (const Shape& shape : list.shapes) {
        if (shape.kind != ShapeKind::disc || shape.style >= list.styles.size() ||
            shape.first_point >= list.points.size())
            continue;
        if (list.styles[shape.style].name != "eye") continue;
        const Vec<2> at = to_page(panel, layout.scale, list.points[shape.first_point]);
        const Vec<2> reach(shape.size_pt * line_scale(layout) + halo_margin);
        if (panel.frame.contains(at)) taken.push_back({at - reach, at + reach});
    }
    return taken;
}

std::string quoted(const std::string& text) { return "'" + text + "'"; }

std::string count_of(std::size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Of one panel.
std::vector<std::string> left_out_of(const Figure::Panel& content, const PlacedTexts& texts) {
    std::vector<std::string> remarks;
    std::size_t numbers = 0;
    for (const std::size_t i : texts.no_room) {
        const Label& label = content.list.labels[i];
        if (label.note) remarks.push_back("note " + quoted(label.text) + " dropped: no room");
        numbers += !label.note;
    }
    if (numbers > 0) remarks.push_back(count_of(numbers, "label") + " dropped: no room");
    for (const std::string& note : content.notes_outside)
        remarks.push_back("note " + quoted(note) + " lies outside the picture");
    return remarks;
}

bool in_panel(const Label& label, const Layout::Panel& panel, const Layout& layout) {
    return panel.frame.grown(0.5).contains(to_page(panel, layout.scale, label.at));
}

}  // namespace

std::optional<PlacedLabel> place_label(const Label& label, const Layout::Panel& panel, const Layout& layout,
                                       const Font& font) {
    const Vec<2> point = to_page(panel, layout.scale, label.at) + Vec<2>(label.offset_pt.x, -label.offset_pt.y);
    if (!in_panel(label, panel, layout) || !is_finite<2>(point)) return std::nullopt;
    const auto set = set_text(label, panel, layout, font, 0);
    if (!set) return std::nullopt;
    return put(0, label, *set, label_box(label, point, set->extent(label), box_of(panel.frame)), font);
}

PlacedTexts place_texts(const Figure::Panel& content, const Layout::Panel& panel, const Layout& layout,
                        const Font& font) {
    PlacedTexts texts;
    texts.insets = place_insets(content, panel, layout, font);
    const std::vector<Label>& labels = content.list.labels;
    LabelGround ground;
    ground.frame = box_of(panel.frame);
    ground.slack = 0.5;
    ground.least_room = 2;
    ground.keep_apart = true;
    ground.to_paper = [&](const Vec<2>& p) { return to_page(panel, layout.scale, p); };
    ground.size = [&](const Label& label, std::size_t form) -> std::optional<LabelSize> {
        const auto set = set_text(label, panel, layout, font, form);
        return set ? std::optional(set->extent(label)) : std::nullopt;
    };
    std::vector<std::uint8_t> stands(labels.size());
    for (const StandingLabel& own : stand_labels(labels, ground, taken_places(content, texts, panel, layout))) {
        const Label& label = labels[own.label];
        stands[own.label] = 1;
        texts.labels.push_back(put(own.label, label, *set_text(label, panel, layout, font, own.form), own.box, font));
        if (own.leader) texts.labels.back().tip = own.tip;
    }
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (!stands[i] && !labels[i].text.empty() && in_panel(labels[i], panel, layout)) texts.no_room.push_back(i);
    return texts;
}

std::vector<std::string> left_out(const Figure& figure, const Layout& layout, const Font& font, double asked_pt) {
    std::vector<std::string> remarks;
    if (layout.font_pt < asked_pt)
        remarks.push_back("texts are " + short_number(layout.font_pt) + " pt high: no room for " +
                          short_number(asked_pt) + " pt");
    for (std::size_t i = 0; i < layout.panels.size(); ++i) {
        const PlacedTexts texts = place_texts(figure.panels[i], layout.panels[i], layout, font);
        for (std::string& remark : left_out_of(figure.panels[i], texts)) {
            const std::string& title = figure.panels[i].title;
            const bool lettered = title.starts_with("(") && title.find(')') != std::string::npos;
            if (lettered) remark = title.substr(0, title.find(')') + 1) + " " + remark;
            remarks.push_back(std::move(remark));
        }
    }
    return remarks;
}

}  // namespace sightline
