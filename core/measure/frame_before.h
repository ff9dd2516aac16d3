// What the frame before leaves to a frame that is measured by itself.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/run/method.h"

namespace sightline {

/// What a frame is left by the one `before` it, which had no history itself; nullptr where there is none or the method
/// asks for none. `problem` is that of the frame, whose budget counts where a budget changes the order.
template <int D>
std::shared_ptr<const FrameHistory> frame_history(const Method<D>& method, Problem<D> problem,
                                                  const std::optional<View<D>>& before);

}  // namespace sightline
