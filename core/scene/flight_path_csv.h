// Flight paths as tables, for other programs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/flight_path.h"

namespace sightline {

/// "eye_x,eye_y,eye_z,look_at_x,look_at_y,look_at_z,fov"; 2D: without z.
template <int D>
std::string csv_path_columns();

/// A first line that names these columns in any order, others besides, fov or not (60 then), and a line of numbers for
/// each frame, in the coordinates of the scene's file. Lines that begin with # and empty ones are passed over. Throws
/// InputError "name: line 3: reason".
template <int D>
FlightPath<D> read_csv_path(std::string_view text, const std::string& name);

/// Reading it back gives the same frames, in the file's coordinates.
template <int D>
std::string write_csv_path(const FlightPath<D>& path);

/// As CSV where the file's name ends in .csv, else as JSON.
template <int D>
std::string path_text(const FlightPath<D>& path, std::string_view file) {
    return file.ends_with(".csv") || file.ends_with(".CSV") ? write_csv_path(path) : write_path(path);
}

}  // namespace sightline
