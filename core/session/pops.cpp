// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/pops.h"

#include "core/run/drawn_levels.h"

namespace sightline {

template <int D>
std::vector<Marker> pop_markers(const Session<D>& session, const ViewSpec<D>& before) {
    Session<D> earlier = session, now = session;
    earlier.unfreeze();
    earlier.fly(before);
    now.run();
    const std::size_t count = session.scene().primitives.size();
    const std::vector<std::uint8_t> then = found_mask(earlier.traversal()), here = found_mask(now.traversal());
    const auto &visible_then = earlier.reference().visible, &visible_here = now.reference().visible;

    std::vector<Marker> markers;
    const auto mark = [&](std::uint32_t step, std::size_t pops, const char* what) {
        if (pops > 0) markers.push_back({step, Marker::Kind::pop, std::to_string(pops) + what});
    };
    for (std::uint32_t step = 1; step <= now.position(); ++step) {
        std::size_t appear = 0;
        for_rendered(now.timeline().met_in(step, now.met()),
                     [&](std::uint32_t p) { appear += visible_here[p] && visible_then[p] && !then[p]; });
        mark(step, appear, " appear that were already visible in the previous frame");
    }
    std::size_t vanish = 0;
    for (std::size_t p = 0; p < count; ++p) vanish += visible_here[p] && visible_then[p] && then[p] && !here[p];
    if (now.position() > 0) mark(now.position(), vanish, " vanish that are still visible");
    return markers;
}

template std::vector<Marker> pop_markers<2>(const Session<2>&, const ViewSpec<2>&);
template std::vector<Marker> pop_markers<3>(const Session<3>&, const ViewSpec<3>&);

}  // namespace sightline
