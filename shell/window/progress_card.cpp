// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/progress_card.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <string>

#include "shell/window/imgui_backend.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

constexpr double silent_ms = 500, between_ms = 100;

void clear(SDL_Window* window) {
    int w = 0, h = 0;
    SDL_GL_GetDrawableSize(window, &w, &h);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glViewport(0, 0, w, h);
    glClearColor(theme::panel.r / 255.0f, theme::panel.g / 255.0f, theme::panel.b / 255.0f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

void ProgressCard::show(SDL_Window* window, const Ui& ui, std::string_view what, double share) {
    if (since_.milliseconds() < silent_ms || (shown_ && drawn_.milliseconds() < between_ms)) return;
    if (!ui.fonts.text) return;  // before the first frame
    shown_ = true;
    drawn_ = {};
    SDL_PumpEvents();
    clear(window);
    // A list of its own: the frame that may be under way must not be begun again.
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushClipRect({0, 0}, size);
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    const float unit = ui.unit, text_size = ui.fonts.text->FontSize / ui.framebuffer;
    const float w = std::min(420 * unit, 0.8f * size.x), h = 12 * unit;
    const ImVec2 at{(size.x - w) / 2, size.y / 2};
    const auto filled = static_cast<float>(std::clamp(share, 0.0, 1.0));
    const std::string text = std::string(what) + ", " + std::to_string(static_cast<int>(100 * filled)) + " %";
    list.AddText(ui.fonts.text, text_size, {at.x, at.y - 1.5f * text_size}, colour(theme::ink), text.c_str());
    list.AddRectFilled(at, {at.x + w * filled, at.y + h}, colour(theme::accent));
    list.AddRect(at, {at.x + w, at.y + h}, colour(theme::ink), 0, 0, unit);
    list.PopTextureID();
    list.PopClipRect();
    ImDrawList* lists[]{&list};
    ImDrawData data;
    data.Valid = true;
    data.CmdLists = lists;
    data.CmdListsCount = 1;
    data.TotalVtxCount = list.VtxBuffer.Size;
    data.TotalIdxCount = list.IdxBuffer.Size;
    data.DisplaySize = size;
    data.FramebufferScale = ImGui::GetIO().DisplayFramebufferScale;
    ImGui_ImplOpenGL3_RenderDrawData(&data);
    SDL_GL_SwapWindow(window);
    clear(window);  // what a frame under way goes on with
}

}  // namespace sightline
