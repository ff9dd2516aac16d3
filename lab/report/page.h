// A page of HTML that needs no other file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "core/base/quote.h"

namespace sightline::lab {

/// `text` as a cell of a table: numbers to the right, words to the left.
std::string cell(const std::string& text, bool words = false);

/// A picture inside the page, with a caption in HTML; PNG or SVG by its ending. Throws InputError when it is not there.
std::string picture(const std::filesystem::path& file, const std::string& caption);

/// The whole page; `body` is HTML.
std::string page(const std::string& title, const std::string& body);

/// A share of 1 in per cent, or a number, with three digits; a dash for NaN.
std::string per_cent(double share);
std::string number(double value);

}  // namespace sightline::lab
