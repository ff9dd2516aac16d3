// What a page in a browser works on: a bench of one dimension at a time, what was said, and the paper of its picture.
// The page itself only draws and forwards; all words and decisions come from here.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/draw/draw_list.h"
#include "core/draw/label_pass.h"
#include "shell/desk/gesture.h"
#include "shell/desk/workbench.h"
#include "shell/pane/side_by_side.h"
#include "web/core/solid.h"

namespace sightline {

struct Said {
    std::string text;
    bool bad = false;
};

/// Widths of characters in the font that labels are drawn with, in em.
struct LabelFont {
    std::array<float, 128> ascii{};  ///< of others too: `other`
    float other = 0.6f;

    double width(std::string_view utf8) const;  ///< in em
};

/// The lists of one pane, which live until they are made again: the page reads them where they lie.
struct Paper {
    DrawList below, tessellation, above;
    std::string still;  ///< what the tessellation was drawn of, in words: the same ones, the same list
    Solid solid;        ///< 3D: under the lists
    LabelMemory labels;
    Box<2> world;
};

template <int D>
struct BenchOnPage {
    Workbench<D> bench;
    SideBySide<D> sides{bench};
    explicit BenchOnPage(Workbench<D> made) : bench(std::move(made)) {}
    BenchOnPage(const BenchOnPage&) = delete;
};

/// What a hand on the picture drags.
enum class Held : std::uint8_t { picture, eye, wall };

/// The hand on the picture, while it drags.
struct Hand {
    Gesture<2> before;
    Vec<2> from;
    Box<2> world;
    Held held = Held::picture;
    std::uint32_t wall = none;         ///< segment
    std::optional<std::size_t> end{};  ///< of the wall; none: all of it
    double reach = 0;                  ///< within which an end goes to that of another wall
};

struct Page {
    std::unique_ptr<BenchOnPage<2>> plane;
    std::unique_ptr<BenchOnPage<3>> space;  ///< one of the two after the first open_on_page()
    std::vector<Said> said;                 ///< since they were last read
    std::array<Paper, 2> papers;
    LabelFont font;
    std::optional<Hand> hand;
    std::uint64_t revision = 1;  ///< grows with whatever may change the picture
    std::string reply;           ///< of the last call, for who reads it
};

/// `f` of the bench that is shown.
template <typename F>
auto with_bench(Page& page, F f) {
    return page.plane ? f(*page.plane) : f(*page.space);
}

/// A scene of either dimension by any name, or a state file. Throws InputError; then what was shown stays.
void open_on_page(Page& page, const std::string& name);
/// The text of a state file.
void open_state_on_page(Page& page, const std::string& text);

/// All that is shown, as a state file.
std::string state_of_page(Page& page);
/// The same for hand-outs and links (shell/export/handout.h).
std::string handout_of_page(Page& page);

/// Commands of the table; `viewer3d NAME` and `viewer2d NAME` open the scene on the page. What goes wrong is said.
void run_on_page(Page& page, const std::string& commands);

/// Moves the eye of a flight in seconds at its speed, to its right, up and ahead, and turns it by degrees to the right
/// and up: the traversal follows, unrecorded. 3D.
void fly_on_page(Page& page, const Vec<3>& seconds, const Vec<2>& degrees);

/// Time goes by: true when something has moved.
bool tick(Page& page, double seconds);

/// What panels ask for and takes a moment, while a person does nothing: true when they say more than before, or when
/// there is more to do.
bool idle(Page& page, double milliseconds);

}  // namespace sightline
