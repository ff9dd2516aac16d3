// Films: the steps of a run, or the frames of a flight path, as numbered pictures, pages of a PDF, GIF or video.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "shell/desk/workbench.h"

namespace sightline {

/// The last step of the run, or of the longer one of two; the last frame of the path.
inline constexpr std::uint32_t film_to_end = none;

struct FilmSpec {
    std::uint32_t first = 0, last = 0;  ///< both in the film, which ends earlier where there are no more
    std::string file;                   ///< its ending chooses the format: .png (FILE-0001.png, …), .pdf, .gif, .mp4
    double frames_per_second = 4;       ///< of .gif and .mp4
    bool path = false;                  ///< frames of the chosen flight path, from 0, rather than steps
};

/// Most pictures of one film.
inline constexpr std::uint32_t most_frames = 1000;

/// Writes the film with one legend, scale and world for all its pictures, and beside it FILE.json, a state file of the
/// first one. A film of a path moves the culling view along it and runs each frame to the budget; the display view goes
/// along unless it is frozen. With a second session both stand beside each other until the longer run has ended. The
/// bench stays as it is. GIF and video need the program ffmpeg. Throws InputError for steps or frames that there are
/// not, an unknown ending or an impossible speed, WorkError when writing fails; then no part of it is left.
template <int D>
void write_film(Workbench<D>& bench, const FilmSpec& asked);

}  // namespace sightline
