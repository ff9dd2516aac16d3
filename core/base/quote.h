// Words inside other languages: gnuplot, shells, HTML and SVG, Markdown, CSV. What a file, a scene or a method is
// called is data: nothing gets into a script, a page or a command line but through the one function of its language.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sightline {

/// A string of gnuplot, on one line, in which gnuplot expands nothing and which it can put into an SVG: what it would
/// read wrongly is replaced by what looks like it. Marks such as _ and ^ are kept from meaning something by
/// `noenhanced` behind it.
std::string gnuplot_quoted(std::string_view text);

/// One word of a command line, on one line, for bash and zsh: as it is where it is plain. Keeps every byte but 0, which
/// no word can have.
std::string shell_quoted(std::string_view word);

/// Text between tags and in quoted attributes of HTML and SVG; on several lines where it has several.
std::string escaped(std::string_view text);

/// Text inside a line or a cell of a table of Markdown.
std::string markdown_escaped(std::string_view text);

/// A field of comma-separated values (RFC 4180).
std::string csv_field(std::string_view text);

/// For data: addresses.
std::string base64(std::string_view data);

}  // namespace sightline
