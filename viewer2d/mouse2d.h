// The mouse on the 2D picture: hover, click, double-click, drag, wheel.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "shell/pane/click_cycle.h"
#include "shell/pane/labels.h"
#include "shell/pane/note_field.h"
#include "viewer2d/drag2d.h"
#include "viewer2d/strip_picking.h"

namespace sightline {

/// A picture that the mouse may be on.
struct MousePane {
    const Session<2>* session = nullptr;
    Camera camera;
    bool lead = true;                       ///< it is the bench's own session: with handles and notes
    bool same_cells = true;                 ///< cells have the numbers of the bench's session
    std::span<const LabelSpot> note_spots;  ///< of the current notes
    const EyeStrip* strip = nullptr;        ///< nullptr: not shown

    EyeStripPlace strip_place() const {
        return eye_strip_place(camera.world, session->settings().show_depth == Switch::on);
    }
};

class Mouse2d {
public:
    /// The bench must live longer.
    explicit Mouse2d(Workbench<2>& bench) : bench_(bench) {}

    /// After the ImGui item that covers all panes.
    void frame(Ui& ui, std::span<const MousePane> panes);
    /// Handles, snapping, tooltips, the note's field.
    void draw(Ui& ui, std::span<const MousePane> panes, const Area& area);
    /// Ends a drag without effect, or drops a note that is being written; false when there is neither.
    bool cancel();
    bool dragging() const { return drag_.has_value(); }
    /// The mouse is on something that lies over the picture.
    void leave() { hovered_ = false; }
    /// What the picture must go on showing while a handle is dragged.
    std::optional<Box<2>> held_world() const;

private:
    /// A note that is shown: its number among all notes and its label.
    struct ShownNote {
        std::uint32_t note = none;
        const LabelSpot* spot = nullptr;
    };

    void look_under(Ui& ui, std::span<const MousePane> panes);
    void wheel(Ui& ui);
    void press(Ui& ui);
    void release(Ui& ui, bool clicked);
    void double_click(Ui& ui);
    void click(Ui& ui);
    void look_at_strip(const Vec<2>& mouse);
    void click_strip(Ui& ui);
    void click_gap(Ui& ui);
    void draw_gap(Ui& ui, const MousePane& pane);
    void draw_strip(Ui& ui, const MousePane& pane);
    void place_note(Ui& ui);
    void edit_note(std::uint32_t note, const ImVec2& at);
    std::vector<ShownNote> shown_notes(const MousePane& pane) const;
    EditMode edit_mode(const MousePane& pane, float unit) const;
    std::vector<HandlePoint> shown_handles(const MousePane& pane, float unit) const;
    void draw_handles(Ui& ui, const MousePane& pane);
    void tooltip(Ui& ui);

    Workbench<2>& bench_;
    NoteField field_;
    std::optional<Drag> drag_;
    ClickCycle cycle_;
    /// The first of the two clicks that cut a gap.
    struct GapStart {
        std::uint32_t segment = none;
        Vec<2> at{};
        std::shared_ptr<const Scene<2>> of;
    };
    std::optional<GapStart> gap_;
    std::uint64_t pressed_run_ = 0;  ///< Workbench::run when the button went down
    bool swallow_click_ = false;     ///< the second click of a double-click
    bool hovered_ = false;

    // Under the mouse in this frame.
    std::optional<MousePane> pane_;
    std::vector<HandlePoint> handles_;
    Pick pick_;
    bool on_paper_ = false;  ///< of the strip, which hides what lies under it
    std::optional<StripPick> strip_;
    std::uint32_t note_ = none;
};

}  // namespace sightline
