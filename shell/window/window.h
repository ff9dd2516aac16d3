// The window around a viewer's picture: menus, transport, panels, timeline, overlays. The same for two and three
// dimensions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/stopwatch.h"
#include "shell/desk/workbench.h"
#include "shell/gl/context.h"
#include "shell/window/mouse_state.h"
#include "shell/window/placement.h"
#include "shell/window/progress_card.h"
#include "shell/window/speaker_window.h"
#include "shell/window/stage.h"

namespace sightline {

struct WindowOptions {
    GlContext::Place place = GlContext::Place::window;
    Placement placement;
    double scale = 0;  ///< of everything; 0: as the screen's density asks
};

template <int D>
class Window {
public:
    /// Opens it and takes over the bench's words and clipboard. The bench must live longer. Throws WorkError.
    Window(Workbench<D>& bench, const WindowOptions& options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Made after the window, since it needs OpenGL; destroyed before it.
    Stage stage;
    std::function<void()> opened;  ///< after a frame in which another scene was opened

    /// Frames until the person or a command quits.
    void run();
    /// One frame after `seconds`: events, clock, drawing.
    void frame(double seconds);

    /// Where it stands; while it fills the screen, where it would go back to.
    Placement placement() const;
    /// A line for the person.
    void tell(Message message);

    const GlContext& context() const { return context_; }
    Ui& ui() { return ui_; }

private:
    struct Gui {  // Dear ImGui's context and backends
        explicit Gui(const GlContext& context);
        ~Gui();
    };

    void act(const std::string& commands);
    bool asked_to_end() const;
    void take_events();
    bool expects_text() const;
    void handle(const SDL_Event& event);
    void press(const std::string& key);
    void escape();
    void fit_theme();
    void update_speaker();
    Area parts_around(const ImVec2& size);
    void projector_parts(Area& middle);
    void columns_and_timeline(Area& middle, float whole);
    void picture_part(const Area& area);
    void lay_out();
    void measure();
    void wait_for_something();

    Workbench<D>& bench_;
    GlContext context_;
    Gui gui_;
    WindowOptions options_;
    Ui ui_;
    float theme_unit_ = 0, theme_text_ = 0, theme_framebuffer_ = 0;
    bool fullscreen_ = false;
    std::unique_ptr<SpeakerWindow> speaker_;
    std::vector<std::string> recent_;  ///< of the bench, at the last frame
    MouseState mouse_;
    ProgressCard progress_;
    std::optional<SDL_Event> later_;          ///< a release that must not fall into the frame of what came before
    std::optional<std::string> after_frame_;  ///< a command that takes seconds, until its word has been drawn
    bool expected_text_ = false;              ///< in the frame before
    int frames_in_between_ = 0;  ///< since a text field was opened or closed and the keyboard has not followed
    /// A key has opened a text field: the letter that it sends as well is not for the field.
    bool opening_letter_ = false;
    bool was_touched_ = false;  ///< by keys or mouse, in this frame
    Stopwatch since_drawn_;
    int lively_frames_ = 0;  ///< ImGui needs a few frames after an event
};

}  // namespace sightline
