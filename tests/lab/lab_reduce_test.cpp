// What a reduction measures in each probe, what it says of them, and what it writes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "core/base/file.h"
#include "core/base/random.h"
#include "core/space/builders.h"
#include "lab/lab_graphics.h"
#include "lab/measure/measure_path.h"
#include "lab/reduce/probe.h"
#include "lab/reduce/reduce.h"

namespace sightline::lab {
namespace {

namespace fs = std::filesystem;
using M = Measure;

/// Measures of smaller and smaller parts are those that a study of each part gives, bit for bit.
template <int D>
void expect_measures_of_a_study(const std::string& scene, const std::string& method_text,
                                const std::vector<Measure>& used) {
    LabGraphics graphics;
    Study study;
    study.methods = {parse_method(method_text)};
    study.budgets = {parse_budget("200")};
    study.frames = 2;
    study.size = {160, 120};
    study.repeats = 0;
    const LabScene<D> lab = load_lab_scene<D>(scene, "", study);
    Instruments instruments;
    instruments.draw_ids = graphics.draw_ids();
    PartMeasures<D> parts(lab, study.methods[0], study.budgets[0], used, graphics.draw_ids());
    std::vector<std::uint32_t> kept(lab.scene->primitives.size());
    for (std::uint32_t i = 0; i < kept.size(); ++i) kept[i] = i;
    Random random(7);
    for (int round = 0; round < 6; ++round) {
        const Scene<D> part = subset(*lab.scene, kept);
        const Values found = parts.measure(kept, part);
        parts.take();
        LabScene<D> alone = lab;
        alone.scene = std::make_shared<const Scene<D>>(part);
        alone.cells = {};
        alone.cells[static_cast<std::size_t>(study.methods[0].tessellation)] =
            build_cells(part, lab.settings_for(study.methods[0]));
        const Values wanted = measure_path<D>(alone, study, instruments).front().values.back();
        for (const Measure measure : used)
            EXPECT_TRUE(found[measure] == wanted[measure] ||
                        (std::isnan(found[measure]) && std::isnan(wanted[measure])))
                << scene << ' ' << measure_row(measure).id << " in round " << round << ": " << found[measure]
                << ", not " << wanted[measure];
        const std::uint64_t share = 2 + random.below(4);
        std::erase_if(kept, [&](std::uint32_t) { return random.below(share) == 0; });
    }
}

TEST(LabReduceProbe, MeasuresWhatAStudyDoes) {
    const std::vector<Measure> cheap{M::budget,
                                     M::rendered,
                                     M::visible,
                                     M::coverage,
                                     M::coverage_px,
                                     M::oracle,
                                     M::wrong,
                                     M::blob,
                                     M::k95,
                                     M::efficiency,
                                     M::emitted_over_visible,
                                     M::steps,
                                     M::zero_keys,
                                     M::front,
                                     M::tested,
                                     M::pop,
                                     M::flip,
                                     M::visible_change};
    expect_measures_of_a_study<3>("bottleneck", "published", cheap);
    expect_measures_of_a_study<3>("bottleneck", "published@tree",
                                  {M::mis_ranked, M::unreached, M::cell_oracle, M::wrong});
    expect_measures_of_a_study<3>("bottleneck", "published", {M::key_rank});
    expect_measures_of_a_study<3>("bottleneck", "centroid", {M::zeta, M::fused, M::coverage});
    expect_measures_of_a_study<3>("bottleneck", "two-pass", {M::wrong, M::tested});
    expect_measures_of_a_study<2>("rooms", "published", cheap);
    expect_measures_of_a_study<2>("rooms", "layers", {M::mis_ranked, M::unreached, M::cell_oracle, M::zeta, M::fused});
}

TEST(LabReduceProbe, DrawsNothingWhereOnlyHiddenThingsGo) {
    LabGraphics graphics;
    Study study;
    study.methods = {parse_method("published")};
    study.size = {160, 120};
    const LabScene<3> lab = load_lab_scene<3>("bottleneck", "start", study);
    PartMeasures<3> parts(lab, study.methods[0], parse_budget("200"), {M::wrong}, graphics.draw_ids());
    std::vector<std::uint32_t> kept(lab.scene->primitives.size());
    for (std::uint32_t i = 0; i < kept.size(); ++i) kept[i] = i;
    parts.measure(kept, *lab.scene);
    parts.take();
    EXPECT_EQ(parts.images_drawn(), 1u);
    const auto visible = visible_set<3>(*lab.scene, lab.views.back(), lab.settings.reference_size, graphics.draw_ids());
    std::erase_if(kept, [&](std::uint32_t id) { return id % 3 == 0 && !visible[id]; });
    ASSERT_LT(kept.size(), visible.size());
    parts.measure(kept, subset(*lab.scene, kept));
    EXPECT_EQ(parts.images_drawn(), 1u);
    std::erase_if(kept, [&](std::uint32_t id) { return visible[id] != 0; });
    parts.measure(kept, subset(*lab.scene, kept));
    EXPECT_EQ(parts.images_drawn(), 2u);
}

TEST(LabReduce, SaysHowManyProbesAreLeftAtMost) {
    std::vector<ReduceProgress> said;
    std::size_t asked = 0;
    reduce(
        64, [&](std::span<const std::uint32_t> set) { return ++asked, set.size() >= 5; },
        [&](const ReduceProgress& at) {
            said.push_back(at);
            return true;
        });
    ASSERT_EQ(said.size(), asked);
    EXPECT_EQ(said.front().left, 64u);
    EXPECT_EQ(said.front().most, 2u + 4 + 8 + 16 + 32 + 64) << "if nothing can be taken";
    std::size_t smallest = 0;
    for (std::size_t i = 0; i < said.size(); ++i)
        if (said[i].left < said[smallest].left) smallest = i;
    EXPECT_EQ(said[smallest].left, 5u);
    EXPECT_LE(asked - said[smallest].probes, said[smallest].most) << "no more than was said";
    std::size_t none_goes = 0;
    reduce(
        64, [&](std::span<const std::uint32_t> set) { return set.size() == 64; },
        [&](const ReduceProgress& at) { return none_goes = at.probes, true; });
    EXPECT_EQ(none_goes, 1u + said.front().most) << "and that is what it takes then";
}

TEST(LabReduce, WritesWhatOpensFromAnywhere) {
    const fs::path folder = fs::temp_directory_path() / ("sightline-reduce-" + std::to_string(getpid()));
    const auto run = [&](const std::string& command) {
        const int status = std::system((command + " > " + (folder / "said").string() + " 2>&1").c_str());
        return WEXITSTATUS(status);
    };
    fs::create_directories(folder / "elsewhere");
    EXPECT_EQ(run("cd " + folder.string() + " && " + SIGHTLINE_LAB +
                  " reduce 3d:bottleneck --holds 'wrong > 0.01' --budgets 100 --size 160x120 --limit 20"),
              0)
        << read_file(folder / "said");
    const std::string said = read_file(folder / "said");
    EXPECT_NE(said.find("primitives left after 1 probe of "), std::string::npos) << said;
    EXPECT_NE(said.find(" primitives after "), std::string::npos) << said;
    fs::rename(folder / "out/reduce-3d_bottleneck-start", folder / "moved");
    EXPECT_EQ(run("cd " + (folder / "elsewhere").string() + " && " + SIGHTLINE_VIEWER3D +
                  " --headless --state ../moved/reduced.json --stats stats.json"),
              0)
        << read_file(folder / "said");
    EXPECT_EQ(run("cd " + folder.string() + " && " + SIGHTLINE_LAB +
                  " reduce 2d:rooms --until 'inversion == 1' --limit 0.001 --out limited"),
              0);
    EXPECT_NE(read_file(folder / "said").find("stopped by --limit"), std::string::npos) << read_file(folder / "said");
    fs::remove_all(folder);
}

}  // namespace
}  // namespace sightline::lab
