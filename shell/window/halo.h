// Text with a halo at the price of two texts: the halo is a second texture beside the font's, with thicker glyphs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <cstdint>

#include "shell/gl/handles.h"

namespace sightline {

class FontHalo {
public:
    /// Of a font that was loaded without oversampling into an atlas that is built, whose glyphs stand at least
    /// 2 * radius pixels apart. An OpenGL context is current.
    FontHalo(const ImFont& font, int radius);

    /// What goes behind ImDrawList::AddText with the same font, size and place.
    void add(ImDrawList& list, float size, const ImVec2& at, ImU32 colour, const char* text) const;
    ImTextureID texture() const { return reinterpret_cast<ImTextureID>(std::uintptr_t{texture_.name()}); }

private:
    const ImFont* font_;
    int radius_;
    ImVec2 pixel_;  ///< of the atlas, in texture coordinates
    GlTexture texture_;
};

}  // namespace sightline
