// A session as a figure of a page: the picture that the viewer exports, its caption apart.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "core/draw/solid_list.h"
#include "core/session/session.h"

namespace sightline::lab {

/// PNG or SVG by its ending; the caption is returned, for the page has it as text. Throws as write_figure.
template <int D>
std::string write_session_figure(const Session<D>& session, const std::filesystem::path& file,
                                 const DrawSolid& draw_solid);

}  // namespace sightline::lab
