// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/font.h"

#include <fontconfig/fontconfig.h>
#include <hb-ot.h>
#include <hb-subset.h>
#include <hb.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/text.h"
#include "shell/figure/handle.h"

namespace sightline {

namespace {

using Pattern = Handle<FcPattern, FcPatternDestroy>;
using Blob = Handle<hb_blob_t, hb_blob_destroy>;
using Face = Handle<hb_face_t, hb_face_destroy>;
using Buffer = Handle<hb_buffer_t, hb_buffer_destroy>;
using SubsetInput = Handle<hb_subset_input_t, hb_subset_input_destroy>;

std::string pattern_string(const FcPattern* pattern, const char* object) {
    FcChar8* value = nullptr;
    if (FcPatternGetString(pattern, object, 0, &value) != FcResultMatch) return {};
    return reinterpret_cast<const char*>(value);
}

}  // namespace

void HbFontDestroy::operator()(hb_font_t* font) const { hb_font_destroy(font); }

Font find_font(const std::string& family) {
    const WorkError missing("font \"" + family +
                            "\" is not installed: figures need it (Debian, Ubuntu: package fonts-dejavu-core)");
    const Pattern wanted(FcPatternCreate());
    FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
    FcPatternAddInteger(wanted.get(), FC_WEIGHT, FC_WEIGHT_NORMAL);
    FcPatternAddInteger(wanted.get(), FC_SLANT, FC_SLANT_ROMAN);
    FcPatternAddInteger(wanted.get(), FC_WIDTH, FC_WIDTH_NORMAL);
    if (!FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern)) throw missing;
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultNoMatch;
    const Pattern found(FcFontMatch(nullptr, wanted.get(), &result));
    // fontconfig always offers some font; only the asked one has the Greek and the signs that figures use.
    if (!found || pattern_string(found.get(), FC_FAMILY) != family) throw missing;

    Font font;
    font.family = family;
    font.file = pattern_string(found.get(), FC_FILE);
    FcPatternGetInteger(found.get(), FC_INDEX, 0, &font.index);
    const Blob blob(hb_blob_create_from_file(font.file.c_str()));
    if (hb_blob_get_length(blob.get()) == 0) throw WorkError("cannot read font " + font.file);
    const Face face(hb_face_create(blob.get(), static_cast<unsigned>(font.index)));
    font.handle.reset(hb_font_create(face.get()));
    const double em = hb_face_get_upem(face.get());
    hb_font_extents_t extents{};
    if (hb_font_get_h_extents(font.handle.get(), &extents)) {
        font.ascent = extents.ascender / em;
        font.descent = -extents.descender / em;
    }
    hb_position_t cap = 0;
    if (hb_ot_metrics_get_position(font.handle.get(), HB_OT_METRICS_TAG_CAP_HEIGHT, &cap) && cap > 0)
        font.cap_height = cap / em;
    return font;
}

ShapedText shape(const Font& font, std::string_view text) {
    const Buffer buffer(hb_buffer_create());
    hb_buffer_add_utf8(buffer.get(), text.data(), static_cast<int>(text.size()), 0, static_cast<int>(text.size()));
    hb_buffer_set_direction(buffer.get(), HB_DIRECTION_LTR);
    hb_buffer_guess_segment_properties(buffer.get());
    const std::array<hb_feature_t, 2> features{{{HB_TAG('l', 'i', 'g', 'a'), 0, 0, HB_FEATURE_GLOBAL_END},
                                                {HB_TAG('c', 'l', 'i', 'g'), 0, 0, HB_FEATURE_GLOBAL_END}}};
    hb_shape(font.handle.get(), buffer.get(), features.data(), features.size());
    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer.get(), &count);
    const double em = hb_face_get_upem(hb_font_get_face(font.handle.get()));
    ShapedText shaped;
    shaped.glyphs.reserve(count);
    for (unsigned i = 0; i < count; ++i) {
        shaped.glyphs.push_back({infos[i].codepoint, shaped.width + positions[i].x_offset / em,
                                 positions[i].y_offset / em, infos[i].cluster});
        shaped.width += positions[i].x_advance / em;
    }
    return shaped;
}

double text_width(const Font& font, std::string_view text) { return text.empty() ? 0 : shape(font, text).width; }

std::u32string code_points(std::string_view text) {
    std::u32string points;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = std::max<std::size_t>(character_length(text, i), 1);
        unsigned code = static_cast<unsigned char>(text[i]);
        if (length > 1) code &= 0x7f >> length;
        for (std::size_t k = 1; k < length; ++k) code = code << 6 | (static_cast<unsigned char>(text[i + k]) & 63);
        points += static_cast<char32_t>(code);
        i += length;
    }
    return points;
}

std::vector<Line> wrap_text(const Font& font, std::string_view text, double size, double width) {
    std::vector<Line> lines;
    if (text.empty()) return lines;
    const auto measure = [&](std::string_view part) { return text_width(font, part) * size; };
    Line line;
    const auto flush = [&] {
        lines.push_back(std::move(line));
        line = {};
    };
    // A word too long for a line is cut where the line ends.
    const auto add_long_word = [&](std::string_view word) {
        for (std::size_t at = 0; at < word.size();) {
            const std::size_t length = std::max<std::size_t>(character_length(word, at), 1);
            const std::string longer = line.text + std::string(word.substr(at, length));
            const double wide = measure(longer);
            if (wide > width && !line.text.empty()) {
                flush();
                continue;
            }
            line = {longer, wide};
            at += length;
        }
    };
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
        const std::string_view word = text.substr(begin, end - begin);
        if (!word.empty()) {
            std::string longer = line.text.empty() ? std::string(word) : line.text + " " + std::string(word);
            if (const double wide = measure(longer); wide <= width) {
                line = {std::move(longer), wide};
            } else {
                if (!line.text.empty()) flush();
                if (const double alone = measure(word); alone <= width)
                    line = {std::string(word), alone};
                else
                    add_long_word(word);
            }
        }
        if (end < text.size() && text[end] == '\n') flush();
        begin = end + 1;
    }
    if (!line.text.empty()) flush();
    return lines;
}

std::string subset_font(const Font& font, const std::set<char32_t>& characters) {
    const SubsetInput input(hb_subset_input_create_or_fail());
    if (!input) throw WorkError("out of memory while embedding the font");
    hb_set_t* unicodes = hb_subset_input_unicode_set(input.get());
    for (const char32_t c : characters) hb_set_add(unicodes, c);
    hb_set_t* features = hb_subset_input_set(input.get(), HB_SUBSET_SETS_LAYOUT_FEATURE_TAG);
    hb_set_clear(features);
    for (const hb_tag_t tag : {HB_TAG('k', 'e', 'r', 'n'), HB_TAG('m', 'a', 'r', 'k'), HB_TAG('c', 'c', 'm', 'p')})
        hb_set_add(features, tag);
    hb_set_add(hb_subset_input_set(input.get(), HB_SUBSET_SETS_DROP_TABLE_TAG), HB_TAG('M', 'A', 'T', 'H'));
    hb_subset_input_set_flags(input.get(), HB_SUBSET_FLAGS_NO_HINTING);
    const Face subset(hb_subset_or_fail(hb_font_get_face(font.handle.get()), input.get()));
    if (!subset) throw WorkError("cannot embed font " + font.file);
    const Blob blob(hb_face_reference_blob(subset.get()));
    unsigned length = 0;
    const char* data = hb_blob_get_data(blob.get(), &length);
    return {data, length};
}

}  // namespace sightline
