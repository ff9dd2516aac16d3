// Culling in object space, in all scenes, from anywhere and along all paths: nothing that can be seen is culled.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/methods/method_table.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/scene_view.h"
#include "core/truth/software_ids.h"
#include "core/truth/visible_set.h"
#include "tests/soak.h"

namespace sightline {
namespace {

constexpr std::array object_space{"coorg-teller",
                                  "coorg-teller connected=on tree=octree",
                                  "coorg-teller connected=grow leaves=polygons occluder_count=64 threshold=0.003",
                                  "coorg-teller connected=fused leaves=polygons threshold=0.003",
                                  "shadow-frusta",
                                  "shadow-frusta leaves=polygons shadows=32 threshold=0.003"};

Scene<2> whole_scene(const CatalogueRow<2>& row) { return make_scene(row); }
Scene<3> whole_scene(const CatalogueRow<3>& row) { return make_scene(row, 50'000); }

constexpr ImageSize image{160, 120};
View<2> view_of(const ViewSpec<2>& spec, const Scene<2>&) { return make_view(spec); }
View<3> view_of(const ViewSpec<3>& spec, const Scene<3>& scene) { return make_view(spec, 4.0 / 3, scene.up_axis); }

std::vector<std::uint8_t> visible_from(const Scene<2>& scene, const View<2>& view) {
    return exact_visible_set(scene.primitives, view).visible;
}
std::vector<std::uint8_t> visible_from(const Scene<3>& scene, const View<3>& view) {
    std::vector<std::uint8_t> visible(scene.primitives.size());
    const IdImage ids = draw_ids_in_software(scene, view, image, 1).front();
    for (const std::uint32_t id : ids.ids)
        if (id != none) visible[id] = 1;
    return visible;
}

template <int D>
class ObjectSpaceViews {
public:
    explicit ObjectSpaceViews(const Scene<D>& scene) : scene_(scene) {
        for (const char* const text : object_space) {
            variants_.push_back(make_variant<D>(method_table<D>(), text));
            runs_.emplace_back();
        }
    }

    /// Runs go on from view to view, so that what they keep is asked too.
    void miss_nothing_from(const ViewSpec<D>& spec) {
        const View<D> view = view_of(spec, scene_);
        const std::vector<std::uint8_t> visible = visible_from(scene_, view);
        for (std::size_t i = 0; i < variants_.size(); ++i) {
            const Problem<D> problem = make_problem(variants_[i].method, variants_[i].parameters, scene_, cells_, view);
            runs_[i].start(problem, variants_[i].method.start);
            runs_[i]->run(none);
            ASSERT_EQ(runs_[i]->misses(), Misses::none);
            const auto rendered = rendered_mask(runs_[i]->met(), visible.size());
            for (std::size_t p = 0; p < visible.size(); ++p) {
                seen += visible[p];
                drawn += rendered[p];
                ASSERT_LE(visible[p], rendered[p])
                    << object_space[i] << " misses primitive " << p << ", seen from "
                    << testing::PrintToString(std::array<double, 2>{spec.eye[0], spec.eye[1]});
            }
        }
    }

    std::size_t seen = 0, drawn = 0;

private:
    const Scene<D>& scene_;
    CellComplex<D> cells_;  ///< none: the methods ask for no cells
    std::vector<Variant<D>> variants_;
    std::vector<OwnRun<D>> runs_;
};

template <int D>
void cull_nothing_visible(std::uint64_t seed, int views, int frames) {
    Random random(seed);
    std::vector<CatalogueRow<D>> rows(catalogue<D>().begin(), catalogue<D>().end());
    rows.insert(rows.end(), failure_scenes<D>().begin(), failure_scenes<D>().end());
    const int of_each = std::max(1, views / static_cast<int>(rows.size()));
    for (const CatalogueRow<D>& row : rows) {
        const Scene<D> scene = whole_scene(row);
        if (scene.primitives.empty()) continue;
        ObjectSpaceViews<D> test(scene);
        const Box<D> box = bounds<D>(scene.primitives);
        for (int i = 0; i < of_each; ++i) {
            SCOPED_TRACE(testing::Message() << row.id << " view " << i);
            const auto point = [&](double reach) {
                Vec<D> p;
                for (int k = 0; k < D; ++k)
                    p[k] = box.centre()[k] + box.extent()[k] * random.uniform(-reach, reach) + 1e-3;
                return p;
            };
            test.miss_nothing_from({point(random.below(3) ? 0.5 : 0.9), point(0.5), random.uniform(20, 120)});
            if (testing::Test::HasFatalFailure()) return;
        }
        for (const FlightPath<D>& path : scene.paths) {
            const std::size_t count = std::min(path.frames.size(), static_cast<std::size_t>(frames));
            for (std::size_t i = 0; i < count; ++i) {
                SCOPED_TRACE(testing::Message() << row.id << '@' << path.id << " frame " << i << " of " << count);
                test.miss_nothing_from(path.frames[i * path.frames.size() / count]);
                if (testing::Test::HasFatalFailure()) return;
            }
        }
        EXPECT_GT(test.drawn, test.seen / 2) << row.id;
    }
}

TEST(ObjectSpaceViews, InThePlaneNothingVisibleIsCulled) {
    cull_nothing_visible<2>(63, test::soak_count(100), 0);
}
TEST(ObjectSpaceViews, InSpaceNothingVisibleIsCulled) {
    cull_nothing_visible<3>(64, test::soak_count(100), test::soak_count(6));
}

}  // namespace
}  // namespace sightline
