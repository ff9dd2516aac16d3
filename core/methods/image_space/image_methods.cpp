// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/image_space/image_methods.h"

#include "core/methods/image_space/box_run.h"

namespace sightline {

namespace {

template <int D>
Method<D> box_method(std::string_view id, std::string_view title, std::string_view sentence, const BoxMethod& method,
                     const typename BoxRun<D>::Picker& picker) {
    Method<D> row{id, title, sentence, [method, picker](const Problem<D>& problem) -> std::unique_ptr<Run<D>> {
                      return std::make_unique<BoxRun<D>>(problem, method, picker);
                  }};
    row.pops = Kind::node;
    row.needs.cells = false;
    row.needs.boxes = true;
    row.budgeted = false;
    if (method.test == BoxMethod::Test::view) {
        row.promise = Misses::none;
        return row;
    }
    row.needs.image = true;
    row.needs.history = true;
    row.promise = Misses::none_at_this_resolution;
    row.parameters = {&occluders_row(), &occluder_share_row(), &draws_row()};
    if (method.test == BoxMethod::Test::depth)
        row.parameters.insert(row.parameters.end(), {&refresh_row(), &worth_row()});
    if (method.test == BoxMethod::Test::opacity) row.parameters.push_back(&opacity_row());
    return row;
}

}  // namespace

template <int D>
Method<D> view_method() {
    return box_method<D>("view", "view culling", "primitives in the view, box by box from the root (the gem)",
                         {BoxMethod::Test::view, Occluders::none, Draws::whole}, {});
}

template <int D>
std::vector<Method<D>> image_methods(const Method<D>& picker) {
    using Test = BoxMethod::Test;
    const auto pick = picker.start;
    std::vector<Method<D>> rows;
    rows.push_back(
        box_method<D>("boxes", "boxes",
                      "nearest first: boxes that lie behind what is drawn are dropped (software culling of engines)",
                      {Test::depth, Occluders::none, Draws::winners}, pick));
    rows.push_back(box_method<D>(
        "hzb", "hierarchical z-buffer",
        "what the last frame saw first; then boxes, tested down to pixels against all that is drawn (Greene 1993)",
        {Test::pixels, Occluders::previous, Draws::winners}, pick));
    rows.push_back(
        box_method<D>("hom", "occlusion maps",
                      "chosen occluders first; then boxes, tested against their opacity and depth (Zhang 1997)",
                      {Test::opacity, Occluders::largest, Draws::whole}, pick));
    rows.push_back(box_method<D>(
        "two-pass", "two passes",
        "what the last frame saw first; then boxes, tested against its depth (the culling of engines on GPUs)",
        {Test::fixed, Occluders::previous, Draws::winners}, pick));
    return rows;
}

#define SIGHTLINE_INSTANTIATE(D)         \
    template Method<D> view_method<D>(); \
    template std::vector<Method<D>> image_methods<D>(const Method<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
