// Before CGAL: WebAssembly cannot change how numbers are rounded, and interval filters that count on it say nonsense.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#if !defined(CGAL_ALWAYS_ROUND_TO_NEAREST)
#error "CGAL_ALWAYS_ROUND_TO_NEAREST is not set: compile with web/toolchain.cmake"
#endif
