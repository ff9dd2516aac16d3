// `auto`: the method, cells and budget that the trade-off of this scene on this machine recommends, measured once and
// remembered.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "shell/desk/workbench.h"

namespace sightline {

struct AutoChoice {
    std::string method;                ///< a variant
    std::string tessellation, budget;  ///< as settings have them
    double ms = 0;                     ///< per frame, as it was measured
    double wrong = 0;                  ///< share of pixels
    std::uint32_t frames = 1;          ///< that both are of: the median of times, the mean of shares
    double guessed_ms = 0;             ///< what a drawn primitive counts for in `ms`; 0: drawing was timed
    std::string close{};               ///< "tri at 10%, 3.2 ms": as right and, within the noise, as fast; else empty
    std::string since;                 ///< why view culling, whatever it takes: "nothing is in view"; else empty
    std::string date;                  ///< YYYY-MM-DD

    bool operator==(const AutoChoice&) const = default;
};

/// "auto: hzb, 3.6 ms, nothing wrong, over 4 frames; measured 2026-11-29"
std::string auto_text(const AutoChoice& choice);

/// auto.json in sightline's folder under $XDG_CACHE_HOME or ~/.cache; empty where neither is known.
std::filesystem::path auto_file();

/// What is remembered under the key; nothing where there is nothing, or the file is damaged: it is a cache.
std::optional<AutoChoice> recall_auto(const std::filesystem::path& file, const std::string& key);
/// Remembers it, with what is remembered under the last other keys, and makes the folder. An empty file: does nothing.
/// Throws WorkError.
void keep_auto(const std::filesystem::path& file, const std::string& key, const AutoChoice& choice);

/// Scene, path, reference size, cells and machine in one line: what a measurement is for.
template <int D>
std::string auto_key(const Workbench<D>& bench);

/// What is measured: what stands in studies that name no methods, those first that need no cells, so that what engines
/// do is not left out where time is short; but for levels of detail, whose wrong pixels are counted by objects.
/// `cells_only`: without those that need none.
template <int D>
std::vector<Variant<D>> auto_methods(const Workbench<D>& bench, bool cells_only);

/// Measures the methods of the bench on Delaunay and tree cells at the usual budgets, on four frames of the chosen
/// path, else of the scene's first, else in the view at hand; what is not done after `seconds` is left out. Methods
/// that look at the frame before see that of the path, or the same view. A frame's time is that of traversal, upload
/// and drawing; where nothing is drawn that can be timed, a millisecond for 1000 primitives. Throws WorkError where
/// nothing could be measured.
/// `budget`, which is not in milliseconds: the choice has this one, which cuts no method short that has no use for one.
template <int D>
AutoChoice measure_auto(const Workbench<D>& bench, double seconds = 20, const std::optional<Budget>& budget = {});

/// `wanted`, with the recommended method, cells and budget in place of its own, and `auto` on, in one change, which is
/// said. Takes what is remembered, or measures it (`again`: in any case) and remembers it; where that fails, a warning
/// says so. Throws as measure_auto.
template <int D>
void choose_auto(Workbench<D>& bench, bool again, const Settings& wanted, const std::optional<Budget>& budget = {});

/// change_settings(), or choose_auto() where that switches `auto` on.
template <int D>
void change_by_hand(Workbench<D>& bench, const Settings& settings);

}  // namespace sightline
