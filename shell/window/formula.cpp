// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/formula.h"

#include <algorithm>
#include <array>

#include "shell/window/theme.h"

namespace sightline {

namespace {

constexpr float caption_size = 0.8f, line_pitch = 1.2f;  // of the letters

/// A piece that stays together, with its place.
struct Token {
    std::string text;
    std::string_view caption;
    KeyAbout about = KeyAbout::nothing;
    float x = 0, y = 0, w = 0;
};

struct Placed {
    std::vector<Token> tokens;
    float height = 0;
};

float width(const FormulaLook& look, float size, std::string_view text) {
    return look.font->CalcTextSizeA(size, 1e9f, 0, text.data(), text.data() + text.size()).x;
}

/// Signs and words between the terms may part at their spaces.
void add_words(std::string_view text, std::vector<Token>& tokens) {
    while (!text.empty()) {
        const std::size_t first = text.find_first_not_of(' ');
        const std::size_t space = first == text.npos ? text.npos : text.find(' ', first);
        const std::size_t end = space == text.npos ? text.size() : space;
        tokens.push_back({std::string(text.substr(0, end)), {}});
        text.remove_prefix(end);
    }
}

Placed placed_tokens(std::span<const KeyPart> parts, const FormulaLook& look) {
    Placed placed;
    for (const KeyPart& part : parts)
        if (part.about == KeyAbout::nothing)
            add_words(part.text, placed.tokens);
        else
            placed.tokens.push_back({part.text, part.name, part.about});
    const float pitch = line_pitch * look.size;
    float x = 0, y = 0, captions = 0;  // of the line
    for (Token& token : placed.tokens) {
        token.w = width(look, look.size, token.text);
        const bool has_caption = look.captions && token.about != KeyAbout::nothing;
        if (has_caption) token.w = std::max(token.w, width(look, caption_size * look.size, token.caption));
        if (x > 0 && x + token.w > look.room) {
            x = 0;
            y += pitch + captions;
            captions = 0;
            token.text.erase(0, token.text.find_first_not_of(' '));
        }
        if (has_caption) captions = caption_size * pitch;
        token.x = x;
        token.y = y;
        x += token.w;
    }
    placed.height = y + pitch + captions;
    return placed;
}

}  // namespace

Colour term_colour(KeyAbout about) {
    static constexpr std::array<Colour, static_cast<std::size_t>(KeyAbout::count)> colours{
        {{20, 22, 26}, {125, 85, 0}, {0, 90, 170}, {110, 55, 165}, {50, 105, 20}, {175, 30, 105}}};
    return colours[static_cast<std::size_t>(about)];
}

float formula_height(std::span<const KeyPart> parts, const FormulaLook& look) {
    return placed_tokens(parts, look).height;
}

KeyAbout draw_formula(ImDrawList& list, const ImVec2& at, std::span<const KeyPart> parts, const FormulaLook& look,
                      const Colour& ink, const ImVec2& mouse) {
    KeyAbout under = KeyAbout::nothing;
    const float small = caption_size * look.size;
    for (const Token& token : placed_tokens(parts, look).tokens) {
        const bool term = token.about != KeyAbout::nothing;
        const ImVec2 corner{at.x + token.x, at.y + token.y};
        const float height = line_pitch * (look.size + (look.captions ? small : 0));
        const Area box{corner.x, corner.y, token.w, height};
        if (term && box.contains(mouse)) {
            under = token.about;
            list.AddRectFilled(box.min(), box.max(), colour(theme::hover), 3);
        }
        const auto draw = [&](std::string_view text, float size, float y) {
            const float x = term ? corner.x + (token.w - width(look, size, text)) / 2 : corner.x;
            list.AddText(look.font, size, {x, y}, colour(term ? term_colour(token.about) : ink), text.data(),
                         text.data() + text.size());
        };
        draw(token.text, look.size, corner.y);
        if (term && look.captions) draw(token.caption, small, corner.y + look.size);
    }
    return under;
}

}  // namespace sightline
