// A page starts no other program: both dimensions open in it (page.cpp).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "shell/desk/launch.h"

namespace sightline {

void launch(const std::string& program, const std::string&) {
    throw InputError("a page does not start " + program + ": open the scene itself");
}

}  // namespace sightline
