// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/halo.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace sightline {

namespace {

/// For each row of a disc of this radius, how far it reaches to either side.
std::vector<int> disc(int radius) {
    std::vector<int> reach;
    for (int y = -radius; y <= radius; ++y)
        reach.push_back(static_cast<int>(std::sqrt((radius + 0.5) * (radius + 0.5) - y * y)));
    return reach;
}

}  // namespace

FontHalo::FontHalo(const ImFont& font, int radius) : font_(&font), radius_(radius) {
    unsigned char* atlas = nullptr;
    int w = 0, h = 0;
    font.ContainerAtlas->GetTexDataAsAlpha8(&atlas, &w, &h);
    pixel_ = {1.0f / static_cast<float>(w), 1.0f / static_cast<float>(h)};
    std::vector<unsigned char> thick(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
    const std::vector<int> reach = disc(radius);
    for (const ImFontGlyph& glyph : font.Glyphs) {
        const int x0 = static_cast<int>(std::lround(glyph.U0 * static_cast<float>(w))),
                  x1 = static_cast<int>(std::lround(glyph.U1 * static_cast<float>(w))),
                  y0 = static_cast<int>(std::lround(glyph.V0 * static_cast<float>(h))),
                  y1 = static_cast<int>(std::lround(glyph.V1 * static_cast<float>(h)));
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                const unsigned char ink = atlas[y * w + x];
                if (ink == 0) continue;
                for (int dy = -radius; dy <= radius; ++dy) {
                    if (y + dy < 0 || y + dy >= h) continue;
                    const int half = reach[static_cast<std::size_t>(dy + radius)];
                    const int from = std::max(x - half, 0), to = std::min(x + half, w - 1);
                    for (int i = from; i <= to; ++i) {
                        unsigned char& cell = thick[static_cast<std::size_t>((y + dy) * w + i)];
                        cell = std::max(cell, ink);
                    }
                }
            }
    }
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, w, h, 0, GL_RED, GL_UNSIGNED_BYTE, thick.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    constexpr GLint white_with_alpha[] = {GL_ONE, GL_ONE, GL_ONE, GL_RED};
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, white_with_alpha);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void FontHalo::add(ImDrawList& list, float size, const ImVec2& at, ImU32 colour, const char* text) const {
    const float scale = size / font_->FontSize, r = static_cast<float>(radius_);
    const ImVec2 uv{r * pixel_.x, r * pixel_.y};
    // As ImFont::RenderText: whole units, then advances.
    float x = std::floor(at.x);
    const float y = std::floor(at.y);
    for (const char* s = text; *s;) {
        unsigned int c = 0;
        s += ImTextCharFromUtf8(&c, s, nullptr);
        const ImFontGlyph* glyph = font_->FindGlyph(static_cast<ImWchar>(c));
        if (!glyph) continue;
        if (glyph->Visible) {
            list.PrimReserve(6, 4);
            list.PrimRectUV({x + (glyph->X0 - r) * scale, y + (glyph->Y0 - r) * scale},
                            {x + (glyph->X1 + r) * scale, y + (glyph->Y1 + r) * scale},
                            {glyph->U0 - uv.x, glyph->V0 - uv.y}, {glyph->U1 + uv.x, glyph->V1 + uv.y}, colour);
        }
        x += glyph->AdvanceX * scale;
    }
}

}  // namespace sightline
