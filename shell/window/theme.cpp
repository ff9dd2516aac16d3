// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/theme.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/error.h"
#include "shell/figure/font.h"
#include "shell/window/halo.h"
#include "shell/window/imgui_backend.h"

namespace sightline {

namespace {

/// The characters that our texts use beyond Latin: Greek, arrows, operators, dashes and shapes.
constexpr ImWchar characters[] = {0x20,   0x17f,  0x370,  0x3ff,  0x2010, 0x2027, 0x2030, 0x203a, 0x2070, 0x209f,
                                  0x2190, 0x21ff, 0x2200, 0x22ff, 0x2500, 0x25ff, 0x2713, 0x2717, 0};

ImVec4 rgb(const Colour& c) { return {c.r / 255.0f, c.g / 255.0f, c.b / 255.0f, c.a / 255.0f}; }

void set_style(float unit) {
    ImGuiStyle style;
    ImGui::StyleColorsLight(&style);
    style.WindowRounding = style.ChildRounding = style.ScrollbarRounding = 0;
    style.FrameRounding = style.GrabRounding = style.PopupRounding = 3;
    style.WindowBorderSize = 0;
    style.FrameBorderSize = 1;
    style.WindowPadding = {10, 8};
    style.FramePadding = {7, 4};
    style.ItemSpacing = {7, 5};
    style.ScrollbarSize = 13;
    style.ScaleAllSizes(unit);
    ImVec4* c = style.Colors;
    c[ImGuiCol_Text] = rgb(theme::ink);
    c[ImGuiCol_TextDisabled] = rgb(theme::faint);
    c[ImGuiCol_WindowBg] = c[ImGuiCol_ChildBg] = c[ImGuiCol_MenuBarBg] = rgb(theme::panel);
    c[ImGuiCol_PopupBg] = rgb(theme::paper);
    c[ImGuiCol_Border] = rgb(theme::line);
    c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = {1, 1, 1, 1};
    c[ImGuiCol_ButtonHovered] = c[ImGuiCol_HeaderHovered] = c[ImGuiCol_FrameBgHovered] = rgb(theme::hover);
    c[ImGuiCol_Header] = c[ImGuiCol_ButtonActive] = c[ImGuiCol_HeaderActive] = c[ImGuiCol_FrameBgActive] =
        rgb({198, 216, 236});
    c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrab] = c[ImGuiCol_SliderGrabActive] = rgb(theme::accent);
    ImGui::GetStyle() = style;
}

}  // namespace

Fonts load_theme(float text_size, float label_size, float unit, float framebuffer) {
    const std::string sans = find_font("DejaVu Sans").file, mono = find_font("DejaVu Sans Mono").file;
    std::string bold = (std::filesystem::path(sans).parent_path() / "DejaVuSans-Bold.ttf").string();
    if (!std::filesystem::exists(bold)) bold = sans;
    ImGuiIO& io = ImGui::GetIO();
    const bool again = io.Fonts->TexID != nullptr;  // the first texture is made with the first frame
    io.Fonts->Clear();
    // One point, but never so thin that a pattern shows through.
    const int halo = std::clamp(static_cast<int>(std::lround(1.5f * unit * framebuffer)), 2, 5);
    io.Fonts->TexGlyphPadding = 2 * halo + 1;
    const auto load = [&](const std::string& file, float size, int oversample = 2) {
        ImFontConfig config;
        config.OversampleH = oversample;
        config.OversampleV = 1;
        config.PixelSnapH = true;
        ImFont* font = io.Fonts->AddFontFromFileTTF(file.c_str(), std::round(size * framebuffer), &config, characters);
        if (!font) throw WorkError(file + ": not a font that can be read");
        return font;
    };
    Fonts fonts;
    fonts.text = load(sans, text_size);
    fonts.bold = load(bold, text_size);
    fonts.mono = load(mono, text_size * 0.93f);
    fonts.label = load(bold, label_size, 1);
    fonts.banner = load(sans, text_size * 4 / 3);
    io.FontGlobalScale = 1 / framebuffer;
    if (again) ImGui_ImplOpenGL3_DestroyFontsTexture();
    io.Fonts->Build();
    if (again) ImGui_ImplOpenGL3_CreateFontsTexture();
    fonts.label_halo = std::make_shared<const FontHalo>(*fonts.label, halo);
    ImGui_ImplOpenGL3_CreateFontsTexture();
    set_style(unit);
    return fonts;
}

}  // namespace sightline
