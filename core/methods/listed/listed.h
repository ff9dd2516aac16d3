// A visible set from elsewhere, an engine's say, as a method: it renders what a file lists for the frame.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/listed/sets_file.h"
#include "core/run/method.h"

namespace sightline {

inline constexpr std::string_view listed_id = "listed";

/// The frame is that of the file whose view is the problem's own: equal bit for bit, or once both are rounded to single
/// precision, in which engines keep cameras. Failing that, the one with the number that this view has in the path
/// `along`. Where neither is there, or no file is given, it renders nothing; listed_lacks() says why.
template <int D>
Method<D> listed_method();

/// Why a run on this problem would render nothing, or the id or name that the scene does not have; empty: all is there.
/// Throws InputError for a file that cannot be read.
template <int D>
std::string listed_lacks(const Problem<D>& problem);

/// What the parameters' files hold: equal where they are. 0 for a method without.
std::uint64_t listed_hash(const Parameters& parameters);

}  // namespace sightline
