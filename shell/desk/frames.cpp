// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/frames.h"

#include <algorithm>

#include "core/base/error.h"
#include "shell/desk/moved.h"
#include "shell/desk/undo.h"

namespace sightline {

namespace {

template <int D>
std::vector<ViewSpec<D>> all_frames(const Workbench<D>& bench) {
    std::vector<ViewSpec<D>> frames = bench.session.lane();
    frames.push_back(bench.session.culling_view());
    frames.insert(frames.end(), bench.flight.ahead.begin(), bench.flight.ahead.end());
    return frames;
}

/// Boxes that the frame tested and whose state differs: what step=change stops at.
std::uint32_t changed_boxes(const FrameHistory& before, const FrameHistory& after) {
    std::uint32_t changed = 0;
    for (std::size_t i = 0; i < std::min(before.boxes.size(), after.boxes.size()); ++i)
        changed += after.boxes[i] != 0 && after.boxes[i] != before.boxes[i];
    return changed;
}

}  // namespace

template <int D>
FrameCount count_frames(const Workbench<D>& bench) {
    const std::size_t before = bench.session.lane().size(), after = bench.flight.ahead.size();
    if (!bench.session.method().needs.keeps_lane() || before + after == 0) return {};
    return {before + 1 + after, before};
}

template <int D>
std::vector<FrameChange> frame_changes(const Workbench<D>& bench, std::size_t most) {
    std::vector<ViewSpec<D>> frames = all_frames(bench);
    if (frames.size() > most) frames.erase(frames.begin(), frames.end() - static_cast<std::ptrdiff_t>(most));
    Session<D> walk = bench.session;
    walk.unfreeze();
    walk.set_lane({});
    std::vector<FrameChange> changes;
    std::shared_ptr<const FrameHistory> before;
    for (const ViewSpec<D>& view : frames) {
        walk.fly(view);
        const auto after = walk.traversal().next_history();
        const bool known = before && after && !after->boxes.empty();
        changes.push_back({known ? std::optional(changed_boxes(*before, *after)) : std::nullopt,
                           after ? after->technique : std::string()});
        before = after;
    }
    return changes;
}

template <int D>
void step_into_frame(Workbench<D>& bench, std::size_t frame) {
    std::vector<ViewSpec<D>> frames = all_frames(bench);
    const FrameCount count = count_frames(bench);
    if (frame >= count.frames)
        throw InputError(count.frames == 0 ? "there are no frames: fly, or keep one with `frame keep`"
                                           : "there is no frame " + std::to_string(frame) + "; there are " +
                                                 std::to_string(count.frames) + ", from 0");
    remember(bench);
    const auto here = frames.begin() + static_cast<std::ptrdiff_t>(frame);
    const ViewSpec<D> view = *here;
    std::vector<ViewSpec<D>> ahead(here + 1, frames.end());
    frames.erase(here, frames.end());
    bench.session.set_lane(std::move(frames));
    bench.session.set_culling_view(view);
    bench.session.run();
    bench.flight.ahead = std::move(ahead);
    traversal_changed(bench);
}

template <int D>
void keep_frame(Workbench<D>& bench) {
    if (!bench.session.method().needs.keeps_lane()) throw InputError("this method does not look at the frame before");
    std::vector<ViewSpec<D>> lane = bench.session.lane();
    lane.push_back(bench.session.culling_view());
    bench.flight.ahead.clear();
    bench.session.set_lane(std::move(lane));
    traversal_changed(bench);
}

template <int D>
void forget_frames(Workbench<D>& bench) {
    bench.flight.ahead.clear();
    bench.session.set_lane({});
    traversal_changed(bench);
}

#define SIGHTLINE_INSTANTIATE(D)                                                          \
    template FrameCount count_frames<D>(const Workbench<D>&);                             \
    template std::vector<FrameChange> frame_changes<D>(const Workbench<D>&, std::size_t); \
    template void step_into_frame<D>(Workbench<D>&, std::size_t);                         \
    template void keep_frame<D>(Workbench<D>&);                                           \
    template void forget_frames<D>(Workbench<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
