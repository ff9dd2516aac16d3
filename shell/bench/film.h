// Films: the steps of a run as numbered pictures, as pages of a PDF, as GIF or as video.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shell/bench/workbench.h"

namespace sightline {

struct FilmSpec {
    std::uint32_t first = 0, last = 0;  ///< steps, both in the film
    std::string file;                   ///< its ending chooses the format: .png (FILE-0001.png, …), .pdf, .gif, .mp4
    double frames_per_second = 4;       ///< of .gif and .mp4
};

/// Most steps of one film.
inline constexpr std::uint32_t most_frames = 1000;

/// Writes the film with one legend, scale and world for all its steps, and beside it FILE.json, a state file of the
/// first one. The session on the bench stays where it is. GIF and video need the program ffmpeg. Throws InputError for
/// steps that the run does not have, an unknown ending or an impossible speed, WorkError when writing fails; then no
/// part of it is left.
template <int D>
void write_film(Workbench<D>& bench, const FilmSpec& film);

}  // namespace sightline
