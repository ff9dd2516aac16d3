// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "shell/commands/command_table.h"
#include "shell/commands/key_bindings.h"
#include "shell/commands/prompt.h"
#include "shell/commands/teach.h"
#include "shell/desk/faults.h"
#include "shell/desk/fly.h"
#include "shell/desk/measure_trade_off.h"
#include "shell/desk/moved.h"
#include "shell/desk/play.h"
#include "shell/desk/what_if.h"
#include "shell/desk/work_out.h"
#include "shell/window/imgui_backend.h"
#include "shell/window/keys.h"
#include "shell/window/parts.h"
#include "shell/window/screen_density.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

constexpr std::size_t most_messages = 500;
/// Pixels at scale 1.
constexpr float least_side = 32;
/// Longer a person sees nothing of what happens.
constexpr double most_undrawn_ms = 250;
/// Of a frame, for the trade-off, and for entries that are worked out beforehand.
constexpr double measuring_ms = 8, working_ms = 20;
constexpr float text_pixels = 15, label_pixels = 12;
/// Of the projector mode, in a window 1080 pixels high: 3 % of its height, so that the back row can read them; the
/// banner has 4 % (load_theme).
constexpr float projector_text_pixels = 32.4f, projector_label_pixels = 32.4f;

/// What clickers send beside PageDown and PageUp: a blank screen, and the start of a show, which does nothing here.
bool is_presenter_key(const std::string& key) { return key == "B" || key == "." || key == "F5"; }

/// A letter, a digit or a sign, with or without Shift: what acts on a picture that has to be seen for it.
bool is_character(const std::string& key) { return key.size() == 1 || (key.size() == 7 && key.starts_with("Shift+")); }

bool is_modifier(SDL_Keycode key) {
    for (const SDL_Keycode one :
         {SDLK_LCTRL, SDLK_RCTRL, SDLK_LSHIFT, SDLK_RSHIFT, SDLK_LALT, SDLK_RALT, SDLK_LGUI, SDLK_RGUI})
        if (key == one) return true;
    return false;
}

bool is_no_letter(SDL_Keycode key) { return key < SDLK_SPACE || (key & SDLK_SCANCODE_MASK) != 0; }

bool is_mouse_over(const SDL_Event& event, Uint32 window) {
    return (event.type == SDL_MOUSEMOTION && event.motion.windowID == window) ||
           ((event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP) &&
            event.button.windowID == window) ||
           (event.type == SDL_MOUSEWHEEL && event.wheel.windowID == window);
}

std::string clipboard_text() {
    char* const text = SDL_GetClipboardText();
    std::string copy = text ? text : "";
    SDL_free(text);
    return copy;
}

float pixels_per_unit(SDL_Window* window) {
    int w = 0, h = 0, pixels_w = 0, pixels_h = 0;
    SDL_GetWindowSize(window, &w, &h);
    SDL_GL_GetDrawableSize(window, &pixels_w, &pixels_h);
    return w > 0 ? static_cast<float>(pixels_w) / static_cast<float>(w) : 1;
}

/// A place on a screen that is no longer there is forgotten; a size beyond the screen is cut.
void place(SDL_Window* window, const Placement& placement, double density) {
    const int width = placement.width > 0 ? placement.width : static_cast<int>(usual_width * density);
    const int height = placement.height > 0 ? placement.height : static_cast<int>(usual_height * density);
    int display = std::max(0, SDL_GetWindowDisplayIndex(window));
    bool placed = false;
    for (int i = 0; placement.at && !placed && i < SDL_GetNumVideoDisplays(); ++i) {
        const SDL_Rect title{(*placement.at)[0], (*placement.at)[1], width, 40};
        SDL_Rect bounds;
        placed = SDL_GetDisplayBounds(i, &bounds) == 0 && SDL_HasIntersection(&title, &bounds);
        if (placed) display = i;
    }
    SDL_Rect room{0, 0, largest_size, largest_size};
    SDL_GetDisplayUsableBounds(display, &room);
    const int w = std::min(width, room.w), h = std::min(height, room.h);
    SDL_SetWindowSize(window, w, h);
    int x = 0, y = 0;
    SDL_GetWindowPosition(window, &x, &y);
    if (placed) {
        x = (*placement.at)[0];
        y = (*placement.at)[1];
    }
    // All of it on the screen: a window that was opened taller begins above it.
    SDL_SetWindowPosition(window, std::clamp(x, room.x, room.x + room.w - w),
                          std::clamp(y, room.y, room.y + room.h - h));
    if (placement.maximised) SDL_MaximizeWindow(window);
}

}  // namespace

template <int D>
Window<D>::Gui::Gui(const GlContext& context) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().ConfigInputTextCursorBlink = false;  // a standing picture needs no frames
    ImGui_ImplSDL2_InitForOpenGL(context.window(), context.handle());
    ImGui_ImplOpenGL3_Init("#version 330 core");
    ImGui_ImplOpenGL3_NewFrame();  // makes its objects, so that the theme can replace the font
}

template <int D>
Window<D>::Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext();
}

template <int D>
Window<D>::Window(Workbench<D>& bench, const WindowOptions& options)
    : bench_(bench),
      context_(options.place, "Sightline", usual_width, usual_height),
      gui_(context_),
      options_(options) {
    ui_.act = [this](const std::string& commands) { act(commands); };
    bench_.say = [this](const std::string& text) { tell({text, false}); };
    bench_.clipboard = {clipboard_text, [](const std::string& text) { SDL_SetClipboardText(text.c_str()); }};
    bench_.graphics.progress = [this](std::string_view what, double share) {
        progress_.show(context_.window(), ui_, what, share);
    };
    bench_.record_ahead = bench_.attended = true;
    traversal_changed(bench_);
    if (options_.scale == 0) options_.scale = screen_density(context_.window());
    if (options_.place == GlContext::Place::window) SDL_GL_SetSwapInterval(1);
    SDL_SetWindowMinimumSize(context_.window(), smallest_width, smallest_height);
    place(context_.window(), options_.placement, pixels_per_unit(context_.window()) > 1 ? 1 : options_.scale);
}

template <int D>
Window<D>::~Window() {
    bench_.graphics.progress = {};
    speaker_.reset();
    stage = {};  // while OpenGL is there
}

template <int D>
Placement Window<D>::placement() const {
    SDL_Window* const window = context_.window();
    Placement now = options_.placement;
    const Uint32 flags = SDL_GetWindowFlags(window);
    now.maximised = flags & SDL_WINDOW_MAXIMIZED;
    if (flags & (SDL_WINDOW_MAXIMIZED | SDL_WINDOW_FULLSCREEN | SDL_WINDOW_MINIMIZED)) return now;
    std::array<int, 2> at{};
    SDL_GetWindowSize(window, &now.width, &now.height);
    SDL_GetWindowPosition(window, &at[0], &at[1]);
    now.width = std::clamp(now.width, smallest_width, largest_size);
    now.height = std::clamp(now.height, smallest_height, largest_size);
    for (int& x : at) x = std::clamp(x, -farthest_place, farthest_place);
    now.at = at;
    return now;
}

template <int D>
void Window<D>::tell(Message message) {
    if (ui_.messages.size() >= most_messages) {
        ui_.messages.erase(ui_.messages.begin());
        if (ui_.said_before > 0) --ui_.said_before;
    }
    ui_.messages.push_back(std::move(message));
}

template <int D>
void Window<D>::act(const std::string& commands) {
    if (const std::string_view word = slow_word<D>(commands); !word.empty() && !after_frame_) {
        tell({std::string(word), false});
        after_frame_ = commands;
        return;
    }
    ++ui_.revision;
    progress_.begin();
    try {
        run_commands(bench_, commands);
    } catch (const std::exception& error) {
        tell({error.what(), true});
    }
}

template <int D>
void Window<D>::escape() {
    const Desk& desk = bench_.desk;
    if (close_topmost(bench_.desk)) return;
    if (stage.cancel && stage.cancel()) {
        ++ui_.revision;
        return;
    }
    if (ImGui::GetIO().WantTextInput) return;  // a field of the settings takes back what was typed
    if (bench_.flight.replaying)
        act("path stop");
    else if (bench_.transport.playing)
        act("pause");
    else if (bench_.work_out)
        act("work-out stop");
    else if (desk.tool != Tool::select)
        act("tool select");
    else if (desk.edit)
        act("edit off");
    else if (desk.projector)
        act("projector");
    else if (desk.fullscreen)
        act("fullscreen");
    else
        act("select none");
}

template <int D>
void Window<D>::press(const std::string& key) {
    if (key == "Escape") return escape();
    const bool covered = bench_.desk.help || bench_.desk.lessons;
    if (covered && is_character(key) && key != "P") return;  // the sheet of lessons speaks of P
    if (bench_.desk.lessons && (key == "Up" || key == "Down" || key == "Enter")) return;  // they choose in it
    if (bench_.desk.projector && is_presenter_key(key)) {
        bench_.desk.blank = key != "F5" && !bench_.desk.blank;
        return;
    }
    for (const Command<D>& command : command_table<D>())
        for (const KeyBinding& binding : key_bindings(command.id, command.keys)) {
            if (binding.key != key) continue;
            if (!binding.asks) return act(binding.command);
            return ask(bench_, binding.command);
        }
}

template <int D>
bool Window<D>::expects_text() const {
    return bench_.desk.console || bench_.desk.chooser || ui_.awaits_text;
}

/// Whether the end waits somewhere among the events: it does not wait for what came before.
template <int D>
bool Window<D>::asked_to_end() const {
    SDL_PumpEvents();  // signals become events here
    if (SDL_HasEvent(SDL_QUIT)) return true;
    std::array<SDL_Event, 64> events;
    const int count = SDL_PeepEvents(events.data(), events.size(), SDL_PEEKEVENT, SDL_WINDOWEVENT, SDL_WINDOWEVENT);
    const Uint32 window = SDL_GetWindowID(context_.window());
    return std::any_of(events.begin(), events.begin() + std::max(0, count), [&](const SDL_Event& event) {
        return event.window.event == SDL_WINDOWEVENT_CLOSE && event.window.windowID == window;
    });
}

/// Dear ImGui sees the state of keys and mouse once a frame: a press and its release, or a release and the next press,
/// need two. And what is typed around the key that opens or closes a text field waits until the keyboard has gone over.
template <int D>
void Window<D>::take_events() {
    constexpr int most_frames = 6;  // a field that never takes the keyboard must not hold events for ever
    const auto in_between = [&] {
        const bool has = ImGui::GetIO().WantTextInput;
        const bool changes = expects_text() != expected_text_ || frames_in_between_ > 0;
        return changes && expects_text() != has && frames_in_between_ < most_frames;
    };
    frames_in_between_ = in_between() ? frames_in_between_ + 1 : 0;
    expected_text_ = expects_text();
    std::vector<SDL_Keycode> pressed, released;
    mouse_.begin();
    const auto take = [&](const SDL_Event& event) {
        if (speaker_ && is_mouse_over(event, speaker_->id())) return;
        const auto is_in = [&](const std::vector<SDL_Keycode>& keys) {
            return std::find(keys.begin(), keys.end(), event.key.keysym.sym) != keys.end();
        };
        const bool is_key = event.type == SDL_KEYDOWN || event.type == SDL_KEYUP;
        // One state of the modifiers holds for all that is pressed in a frame.
        const bool early_key = (event.type == SDL_KEYUP && is_in(pressed)) ||
                               (event.type == SDL_KEYDOWN && is_in(released)) ||
                               (is_key && is_modifier(event.key.keysym.sym) && !pressed.empty());
        // What Tab and Enter do depends on all that was typed before.
        const bool after_text = event.type == SDL_KEYDOWN && is_no_letter(event.key.keysym.sym) && !pressed.empty() &&
                                ImGui::GetIO().WantTextInput;
        if (early_key || after_text || mouse_.waits(event)) {
            later_ = event;
            return;
        }
        if (event.type == SDL_KEYDOWN) pressed.push_back(event.key.keysym.sym);
        if (event.type == SDL_KEYUP) released.push_back(event.key.keysym.sym);
        mouse_.take(event);
        handle(event);
    };
    if (later_) take(*std::exchange(later_, std::nullopt));
    SDL_Event event;
    while (!later_ && !in_between() && SDL_PollEvent(&event)) take(event);
    if (later_ || frames_in_between_ > 0 || expects_text()) lively_frames_ = 3;
}

template <int D>
void Window<D>::handle(const SDL_Event& event) {
    lively_frames_ = 3;
    was_touched_ = true;
    if (event.type == SDL_MOUSEMOTION || event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEWHEEL)
        ui_.mouse_awake = true;
    if (event.type == SDL_KEYDOWN) ui_.mouse_awake = false;
    // What was said belongs to what was done before.
    if (event.type == SDL_KEYDOWN || event.type == SDL_MOUSEBUTTONDOWN) ui_.said_before = ui_.messages.size();
    const bool typing = ImGui::GetIO().WantTextInput || expects_text();
    if (event.type == SDL_KEYDOWN) opening_letter_ = false;
    if (event.type == SDL_TEXTINPUT && std::exchange(opening_letter_, false)) return;
    ImGui_ImplSDL2_ProcessEvent(&event);
    take_modifiers(event, ImGui::GetIO());
    if (event.type == SDL_QUIT) bench_.quit = true;
    if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_CLOSE) {
        const bool notes = speaker_ && event.window.windowID == speaker_->id();
        (notes ? bench_.desk.speaker : bench_.quit) = !notes;
    }
    if (event.type == SDL_DROPFILE) {
        act("open " + std::string(event.drop.file));
        SDL_free(event.drop.file);
    }
    const std::string key = key_name(event);
    // While text is typed, keys are letters; Escape leaves.
    const bool taken = stage.takes_key && stage.takes_key(key);
    const bool always = key == "Escape" || key == "F12";  // F12: the text dump
    if (!key.empty() && !taken && (!typing || always)) press(key);
    opening_letter_ = event.type == SDL_KEYDOWN && !typing && expects_text();
}

/// Fonts and sizes follow the window and the desk.
template <int D>
void Window<D>::fit_theme() {
    int w = 0, h = 0;
    SDL_GetWindowSize(context_.window(), &w, &h);
    ui_.framebuffer = pixels_per_unit(context_.window());
    const float density = ui_.framebuffer > 1 ? 1 : static_cast<float>(options_.scale);
    ui_.unit = density * static_cast<float>(bench_.desk.scale);
    const float height = static_cast<float>(h) / (1080 * density);
    const float text = bench_.desk.projector ? projector_text_pixels * height : text_pixels;
    const float label = bench_.desk.projector ? projector_label_pixels * height : label_pixels;
    if (ui_.unit == theme_unit_ && text == theme_text_ && ui_.framebuffer == theme_framebuffer_) return;
    ui_.fonts = load_theme(text * ui_.unit, label * ui_.unit, ui_.unit, ui_.framebuffer);
    theme_unit_ = ui_.unit;
    theme_text_ = text;
    theme_framebuffer_ = ui_.framebuffer;
    ++ui_.revision;
}

/// The second window comes and goes with the desk.
template <int D>
void Window<D>::update_speaker() {
    const bool wanted = bench_.desk.speaker && options_.place == GlContext::Place::window;
    if (!wanted && speaker_) {
        speaker_.reset();
        SDL_SetWindowInputFocus(context_.window());  // where no window manager gives it back
    }
    if (!wanted) return;
    try {
        if (!speaker_) speaker_ = std::make_unique<SpeakerWindow>(context_);
        speaker_->draw(speaker_rows(bench_));
    } catch (const std::exception& error) {
        bench_.desk.speaker = false;
        tell({error.what(), true});
    }
}

/// A little of the trade-off, where a person looks at it and does nothing else.
template <int D>
void Window<D>::measure() {
    const Panel<D>* const shown = find_panel<D>(bench_.desk.right);
    const bool watched = shown && shown->body == Body::chart && !bench_.desk.projector;
    if (!watched || was_touched_ || ImGui::IsAnyMouseDown() || after_frame_ || !stands_still(bench_)) return;
    glFinish();  // what still draws would be in the times
    if (advance_trade_off(bench_, measuring_ms)) lively_frames_ = std::max(lively_frames_, 1);
}

template <int D>
void Window<D>::frame(double seconds) {
    was_touched_ = false;
    if (asked_to_end()) {
        bench_.quit = true;
        return;
    }
    take_events();
    if (bench_.quit) return;
    const std::optional<std::string> slow = after_frame_;
    if (bench_.transport.playing) {
        const std::uint32_t before = bench_.session.position();
        advance_clock(bench_, seconds);
        ui_.revision += bench_.session.position() != before;
    }
    ui_.revision += advance_flight(bench_, seconds);
    measure();
    ui_.revision += advance_work_out(bench_, working_ms);
    // Not while an eye is dragged: each place would run every change again.
    if (!ImGui::IsAnyMouseDown() && stands_still(bench_)) {
        ui_.revision += update_what_if(bench_);
        ui_.revision += update_faults(bench_, bench_.desk.right == "objects");
    }
    if (fullscreen_ != bench_.desk.fullscreen) {
        fullscreen_ = bench_.desk.fullscreen;
        SDL_SetWindowFullscreen(context_.window(), fullscreen_ ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
    }
    fit_theme();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplSDL2_NewFrame();
    mouse_.give(ImGui::GetIO());
    ImGui::NewFrame();
    int w = 0, h = 0;
    SDL_GL_GetDrawableSize(context_.window(), &w, &h);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glViewport(0, 0, w, h);
    glClearColor(theme::panel.r / 255.0f, theme::panel.g / 255.0f, theme::panel.b / 255.0f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    // A window that is minimized or next to nothing has no room for widgets of any size.
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    if (size.x >= least_side && size.y >= least_side) lay_out();
    ImGui::Render();
    // While keys wait, frames only take them: one that draws may take longer than the next key needs to come.
    if (!later_ || slow || since_drawn_.milliseconds() > most_undrawn_ms) {
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        SDL_GL_SwapWindow(context_.window());
        since_drawn_ = {};
    }
    update_speaker();
    if (!slow) return;
    act(*slow);
    after_frame_.reset();
    lively_frames_ = 3;
}

/// Sleeps while nothing moves.
template <int D>
void Window<D>::wait_for_something() {
    if (bench_.transport.playing || bench_.flight.replaying || bench_.work_out || lively_frames_-- > 0 ||
        (stage.lively && stage.lively()))
        return;
    lively_frames_ = 0;
    SDL_WaitEventTimeout(nullptr, 250);
}

template <int D>
void Window<D>::run() {
    Stopwatch clock;
    while (!bench_.quit) {
        const double seconds = clock.milliseconds() / 1000;
        clock = {};
        frame(seconds);
        if (recent_ != bench_.recent) {
            recent_ = bench_.recent;
            if (opened) opened();
        }
        wait_for_something();
    }
}

template class Window<2>;
template class Window<3>;

}  // namespace sightline
