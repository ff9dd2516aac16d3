// The two backends of Dear ImGui, whose headers moved between versions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <backends/imgui_impl_opengl3.h>
#if __has_include(<backends/imgui_impl_sdl2.h>)
#include <backends/imgui_impl_sdl2.h>
#else
#include <backends/imgui_impl_sdl.h>
#endif
