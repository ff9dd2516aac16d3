// Conservative methods where others fail, seen from anywhere: no pixel of the software reference is missed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/methods/method_table.h"
#include "core/scene/make/catalogue.h"
#include "core/space/builders.h"
#include "core/truth/software_ids.h"
#include "core/truth/truth.h"
#include "tests/soak.h"

namespace sightline {
namespace {

constexpr std::array from_anywhere{
    "cplp first=layers", "cplp first=layers draws=winners", "boxes refresh=16", "hzb", "hom",
    "two-pass",          "two-pass occluders=plp",          "boxes draws=whole"};

Scene<2> gallery_scene(const CatalogueRow<2>& row) { return make_scene(row); }
Scene<3> gallery_scene(const CatalogueRow<3>& row) { return make_scene(row, 10'000); }

View<2> view_from(const ViewSpec<2>& spec, const Scene<2>&) { return make_view(spec); }
View<3> view_from(const ViewSpec<3>& spec, const Scene<3>& scene) { return make_view(spec, 4.0 / 3, scene.up_axis); }

IdImage ids_from(const Scene<2>& scene, const View<2>& view) { return item_row(scene, view, {1024, 0}); }
IdImage ids_from(const Scene<3>& scene, const View<3>& view) {
    return draw_ids_in_software(scene, view, {160, 120}, 1).front();
}

template <int D>
void miss_nothing_from_anywhere(std::uint64_t seed, int views) {
    Random random(seed);
    const auto rows = failure_scenes<D>();
    const int of_each = std::max(1, views / static_cast<int>(rows.size()));
    std::size_t seen = 0;
    for (const CatalogueRow<D>& row : rows) {
        const Scene<D> scene = gallery_scene(row);
        if (scene.primitives.empty()) continue;
        const CellComplex<D> cells = build_cells(scene, TessellationSettings{.tessellation = Tessellation::tree});
        const Box<D> box = bounds<D>(scene.primitives);
        for (int i = 0; i < of_each; ++i) {
            SCOPED_TRACE(testing::Message() << row.id << " view " << i);
            const auto point = [&](double reach) {
                Vec<D> p;
                for (int k = 0; k < D; ++k)
                    p[k] = box.centre()[k] + box.extent()[k] * random.uniform(-reach, reach) + 1e-3;
                return p;
            };
            ViewSpec<D> spec{point(random.below(3) ? 0.5 : 0.9), point(0.5), random.uniform(20, 120)};
            const View<D> view = view_from(spec, scene);
            spec.eye += (spec.look_at - spec.eye) * 0.001;
            const View<D> before = view_from(spec, scene);
            std::vector<std::uint8_t> visible(scene.primitives.size());
            for (const std::uint32_t id : ids_from(scene, view).ids)
                if (id != none) visible[id] = 1;
            Services services;
            services.image = D == 2 ? ImageSize{1024, 0} : ImageSize{160, 120};
            for (const char* text : from_anywhere) {
                const Variant<D> variant = make_variant<D>(method_table<D>(), text);
                const auto problem_in = [&](const View<D>& from, std::shared_ptr<const FrameHistory> history) {
                    const std::uint32_t budget = variant.method.budgeted ? 200 : none;
                    return make_problem(variant.method, variant.parameters, scene, cells, from, budget, services,
                                        std::move(history));
                };
                std::shared_ptr<const FrameHistory> history;
                if (variant.method.needs.history) {
                    const auto last = variant.method.start(problem_in(before, nullptr));
                    last->run(none);
                    history = last->next_history();
                }
                const auto run = variant.method.start(problem_in(view, history));
                run->run(none);
                ASSERT_TRUE(run->finished());
                ASSERT_NE(run->misses(), Misses::may) << text;
                const auto rendered = rendered_mask(run->met(), visible.size());
                for (std::size_t p = 0; p < visible.size(); ++p) {
                    seen += visible[p];
                    ASSERT_LE(visible[p], rendered[p]) << text << " misses primitive " << p;
                }
            }
        }
    }
    EXPECT_GT(seen, 1000u);
}

TEST(GalleryViews, InThePlaneConservativeMethodsMissNothing) {
    miss_nothing_from_anywhere<2>(61, test::soak_count(100));
}
TEST(GalleryViews, InSpaceConservativeMethodsMissNothing) { miss_nothing_from_anywhere<3>(62, test::soak_count(100)); }

}  // namespace
}  // namespace sightline
