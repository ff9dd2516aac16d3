// A figure put down as PNG, SVG or PDF at its final size. Needs neither a window nor OpenGL.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/draw/draw_list.h"
#include "core/draw/solid_list.h"
#include "shell/figure/figure_size.h"

namespace sightline {

/// Writes the figure; the ending of the name (.png, .svg, .pdf, any case) chooses the format. Lines follow the
/// size of the text and are at least 0.5 pt wide; text stays text; fonts are embedded in SVG and PDF. Texts shrink,
/// down to half their size, where few pixels would leave no room for the panels. The file is written to a temporary
/// name and renamed. The same figure gives the same bytes. Solids become images of at most largest_solid_picture a
/// side, whatever lies on them stays vectors. Throws InputError for another ending, an impossible size or one too small
/// for the content; WorkError when the file cannot be written, the font is not installed, or there is a solid and
/// nothing that draws it.
void write_figure(const Figure& figure, const FigureSize& size, const std::filesystem::path& path,
                  const DrawSolid& draw_solid = {});

/// Throws InputError for a name whose ending is none of those.
void check_figure_name(const std::filesystem::path& path);

/// What that writes into a file of this name. Throws as it does.
std::string figure_bytes(const Figure& figure, const FigureSize& size, const std::filesystem::path& path,
                         const DrawSolid& draw_solid = {});

/// What the figure does not show as it was asked for: labels without room, notes that lie outside, smaller text.
/// Throws as write_figure does.
std::vector<std::string> left_out(const Figure& figure, const FigureSize& size);

/// Makes page i; asked for once, in order.
using MakePage = std::function<Figure(std::size_t)>;

/// The same for a PDF of several pages, e.g. the steps of a film: panels, legend and caption lie at the same places on
/// each page, so that nothing jumps. `plan` has all pages with their worlds and texts, and of some at least the
/// pictures, which say where the legend hides little; its first page says where the legend stands.
void write_figure_pages(std::span<const Figure> plan, const MakePage& page, const FigureSize& size,
                        const std::filesystem::path& path, const DrawSolid& draw_solid = {});

/// The same as PNGs that fit each other; file(i) is asked for the name of page i before it is drawn.
void write_figure_frames(std::span<const Figure> plan, const MakePage& page, const FigureSize& size,
                         const std::function<std::filesystem::path(std::size_t)>& file,
                         const DrawSolid& draw_solid = {});

}  // namespace sightline
