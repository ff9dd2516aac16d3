// Working out beforehand what a method by viewpoint would choose (core/methods/by_viewpoint), as a person asks for it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shell/desk/workbench.h"

namespace sightline {

/// The table of the session's method. Throws InputError for a method that does not choose by viewpoint.
template <int D>
std::shared_ptr<const ViewpointTable<D>> table_on(const Workbench<D>& bench);

/// Begins with the entries of the region of the eye, or with all of them. Where no window goes on with it between its
/// frames (Workbench::attended), all is done on return. Throws as table_on.
template <int D>
void begin_work_out(Workbench<D>& bench, bool all);

/// Works out entries until they are all known or some milliseconds have gone: at least one. True when some came in.
template <int D>
bool advance_work_out(Workbench<D>& bench, double milliseconds);

/// What is known stays.
template <int D>
void stop_work_out(Workbench<D>& bench);

/// "37 of 208 entries"; empty: nothing is being worked out.
template <int D>
std::string work_out_text(const Workbench<D>& bench);

/// Works out the next entry that is not known, after that of the culling view, and moves the culling view to a place in
/// its region that looks into its directions. Throws as table_on.
template <int D>
void go_to_next_entry(Workbench<D>& bench);

}  // namespace sightline
