// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/speaker_window.h"

#include <epoxy/gl.h>

#include "core/base/error.h"
#include "shell/figure/font.h"
#include "shell/window/imgui_backend.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

constexpr int notes_width = 720, notes_height = 480;
constexpr float notes_pixels = 22, clock_pixels = 44;
/// Beyond Latin: operators, arrows, dashes and Greek, as the notes have them.
constexpr ImWchar note_characters[] = {0x20, 0x17f, 0x370, 0x3ff, 0x2010, 0x203a, 0x2190, 0x22ff, 0};

}  // namespace

/// OpenGL draws into this window and Dear ImGui works for it, as long as this lives.
class SpeakerWindow::InUse {
public:
    explicit InUse(const SpeakerWindow& speaker) : speaker_(speaker), before_(ImGui::GetCurrentContext()) {
        SDL_GL_MakeCurrent(speaker.window_.get(), speaker.context_.handle());
        SDL_GL_SetSwapInterval(0);  // the other window waits for the screen already
        ImGui::SetCurrentContext(speaker.gui_);
    }
    ~InUse() {
        ImGui::SetCurrentContext(before_);
        speaker_.context_.make_current();
        SDL_GL_SetSwapInterval(1);
    }
    InUse(const InUse&) = delete;
    InUse& operator=(const InUse&) = delete;

private:
    const SpeakerWindow& speaker_;
    ImGuiContext* before_;
};

SpeakerWindow::SpeakerWindow(const GlContext& context)
    : context_(context),
      window_(SDL_CreateWindow("Sightline: for the speaker", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED,
                               notes_width, notes_height,
                               SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI)) {
    if (!window_) throw WorkError(std::string("no window for the speaker: ") + SDL_GetError());
    ImGuiContext* const before = ImGui::GetCurrentContext();
    gui_ = ImGui::CreateContext();
    ImGui::SetCurrentContext(before);  // creating the first one makes it current
    const InUse in_use(*this);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    const std::string file = find_font("DejaVu Sans").file;
    text_ = io.Fonts->AddFontFromFileTTF(file.c_str(), notes_pixels, nullptr, note_characters);
    large_ = io.Fonts->AddFontFromFileTTF(file.c_str(), clock_pixels, nullptr, note_characters);
    ImGui_ImplSDL2_InitForOpenGL(window_.get(), context.handle());
    ImGui_ImplOpenGL3_Init("#version 330 core");
    ImGui::StyleColorsDark();
}

SpeakerWindow::~SpeakerWindow() {
    {
        const InUse in_use(*this);
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplSDL2_Shutdown();
    }
    ImGui::DestroyContext(gui_);
}

void SpeakerWindow::draw(const std::vector<Row>& rows) {
    const InUse in_use(*this);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplSDL2_NewFrame();
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::Begin("notes", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ImGui::PushFont(i == 0 ? large_ : text_);
        if (rows[i].tone == Tone::faint)
            ImGui::TextDisabled("%s", rows[i].text.c_str());
        else
            ImGui::TextWrapped("%s", rows[i].text.c_str());
        ImGui::PopFont();
        ImGui::Spacing();
    }
    ImGui::End();
    ImGui::Render();
    int w = 0, h = 0;
    SDL_GL_GetDrawableSize(window_.get(), &w, &h);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glViewport(0, 0, w, h);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    SDL_GL_SwapWindow(window_.get());
}

}  // namespace sightline
