// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/cells_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/methods/method_table.h"
#include "core/session/settings_table.h"
#include "tests/run/run_support.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

template <int D>
Scene<D> some_scene(Random& random) {
    const std::size_t count = random.below(50);
    if constexpr (D == 2) return test::random_scene(random, count);
    if constexpr (D == 3) return test::random_scene_3d(random, count);
}

Settings some_settings(Random& random) {
    Settings settings = test::random_wide_settings(random);
    settings.error_bound = 0.3;
    return settings;
}

/// One of this process alone: tests run beside each other.
std::filesystem::path some_file() {
    static const struct File {
        std::filesystem::path path =
            std::filesystem::path(testing::TempDir()) / ("cells_file_test-" + std::to_string(getpid()) + ".cells");
        ~File() {
            std::error_code error;
            std::filesystem::remove(path, error);
        }
    } file;
    return file.path;
}

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

template <int D>
bool same(const CellComplex<D>& a, const CellComplex<D>& b) {
    return a.kind == b.kind && a.points == b.points && a.cell_points == b.cell_points &&
           same_bytes(a.half_facets, b.half_facets) && a.cell_facet_begin == b.cell_facet_begin &&
           a.facet_points == b.facet_points && a.border_cells == b.border_cells &&
           a.cell_primitive_begin == b.cell_primitive_begin && a.cell_primitives == b.cell_primitives &&
           a.rho_max == b.rho_max && a.rho_p95 == b.rho_p95 && a.unassigned == b.unassigned &&
           same_bytes(a.tree.nodes, b.tree.nodes) && a.tree.leaves == b.tree.leaves && a.leaf_cell == b.leaf_cell;
}

/// What read_cells() has to say; empty when it has nothing to complain of.
template <int D>
std::string complaint(const Scene<D>& scene, const Settings& settings) {
    try {
        read_cells<D>(some_file(), scene, settings);
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}

template <int D>
void expect_round_trips(std::uint64_t seed) {
    Random random(seed);
    for (int i = 0; i < test::soak_count(40); ++i) {
        const Scene<D> scene = some_scene<D>(random);
        const Settings settings = some_settings(random);
        const CellComplex<D> cells = build_cells(scene, settings);
        write_cells(cells, scene, settings, some_file());
        ASSERT_TRUE(same(read_cells<D>(some_file(), scene, settings), cells)) << i;
    }
}

TEST(CellsFile, ComesBackAsItWasWritten) {
    expect_round_trips<2>(51);
    expect_round_trips<3>(52);
}

TEST(CellsFile, IsRefusedWhenItDoesNotFit) {
    Random random(53);
    Scene<3> scene = test::random_scene_3d(random, 30);
    scene.id = "thing";
    Settings settings;
    settings.error_bound = 0.3;
    write_cells(build_cells(scene, settings), scene, settings, some_file());
    ASSERT_EQ(complaint(scene, settings), "");
    const auto expect = [](const std::string& text, const std::string& part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
        EXPECT_NE(text.find(some_file().string()), std::string::npos) << text;
    };
    Scene<3> other = scene;
    other.primitives[3][1].y += 1;
    expect(complaint(other, settings), "another scene");
    other = scene;
    other.origin.x = 1;
    expect(complaint(other, settings), "not for 'thing'");
    expect(complaint(Scene<2>{}, settings), "3 dimensions, not in 2");
    for (const char* change : {"tessellation=tree", "error_bound=0.25", "border=none", "jitter=0.01", "seed=7"}) {
        Settings changed = settings;
        apply_setting(changed, change);
        expect(complaint(scene, changed), std::string(", not with ") + change);
    }
    for (const char* change : {"leaf_capacity=4", "empty_leaves=drop", "neighbours=touching", "split_for=opacity"}) {
        Settings changed = settings;
        apply_setting(changed, change);
        expect(complaint(scene, changed), std::string("was made without ") + change);
        write_cells(build_cells(scene, changed), scene, changed, some_file());
        EXPECT_EQ(complaint(scene, changed), "");
        expect(complaint(scene, settings), std::string("was made with ") + change + ", which is not asked for");
        write_cells(build_cells(scene, settings), scene, settings, some_file());
    }
    Settings picture = settings;
    apply_setting(picture, "method=layers");
    EXPECT_EQ(complaint(scene, picture), "");

    const std::string good = read_file(some_file());
    write_file(some_file(), good.substr(0, good.size() / 2));
    expect(complaint(scene, settings), "truncated");
    write_file(some_file(), good + "12345678");
    expect(complaint(scene, settings), "longer than it says");
    write_file(some_file(), "solid nothing");
    expect(complaint(scene, settings), "not a file of cells");
    std::string newer = good;
    newer[8] = 2;
    write_file(some_file(), newer);
    expect(complaint(scene, settings), "version 2");
    std::filesystem::remove(some_file());
    expect(complaint(scene, settings), "no such file");
}

TEST(CellsFile, AnyChangedByteIsNoticed) {
    Random random(54);
    const Scene<3> scene = test::random_scene_3d(random, 10);
    Settings settings;
    settings.error_bound = 0.5;
    write_cells(build_cells(scene, settings), scene, settings, some_file());
    const std::string good = read_file(some_file());
    for (int i = 0; i < test::soak_count(200); ++i) {
        std::string bad = good;
        if (i % 4 == 0) {
            bad.resize(random.below(bad.size()));
        } else {
            bad[random.below(bad.size())] ^= static_cast<char>(1 << random.below(8));
        }
        write_file(some_file(), bad);
        ASSERT_NE(complaint(scene, settings), "") << i;
    }
}

std::string with_checksum(std::string bytes) {
    Hash hash;
    for (std::size_t i = 0; i + 16 <= bytes.size(); i += 8) {
        std::uint64_t word;
        std::memcpy(&word, bytes.data() + i, sizeof word);
        hash.add(word);
    }
    const std::uint64_t value = hash.value();
    std::memcpy(bytes.data() + bytes.size() - 8, &value, sizeof value);
    return bytes;
}

/// Damage under a right checksum: refused, or cells that can be used without reading out of bounds.
template <int D>
void expect_safe(std::uint64_t seed) {
    Random random(seed);
    std::size_t refused = 0, used = 0;
    for (int file = 0; file < 6; ++file) {
        const Scene<D> scene = some_scene<D>(random);
        Settings settings = some_settings(random);
        settings.method = "published";
        write_cells(build_cells(scene, settings), scene, settings, some_file());
        const std::string good = read_file(some_file());
        ASSERT_EQ(with_checksum(good), good);
        for (int i = 0; i < 50; ++i) {
            std::string bad = good;
            constexpr std::size_t header = 40;
            const std::size_t at = header + random.below(bad.size() - header - 8) / 4 * 4;
            constexpr std::uint32_t values[] = {0, 1, 2, 7, 100, 0x7fffffff, 0xffffffff};
            const std::uint32_t value = random.below(2) ? values[random.below(std::size(values))]
                                                        : static_cast<std::uint32_t>(random.below(40));
            std::memcpy(bad.data() + at, &value, sizeof value);
            write_file(some_file(), with_checksum(bad));
            try {
                const CellComplex<D> cells = read_cells<D>(some_file(), scene, settings);
                ViewSpec<D> spec;
                spec.look_at.x = 1;
                View<D> view;
                if constexpr (D == 2) view = make_view(spec);
                if constexpr (D == 3) view = make_view(spec, 1);
                const Method<D>& method = find_method<D>(method_table<D>(), settings.method);
                method.start(test::problem_of(scene, cells, view, settings))->run(none);
                ++used;
            } catch (const InputError&) {
                ++refused;
            }
        }
    }
    EXPECT_GT(refused, 100u);
    EXPECT_GT(used, 20u);
}

TEST(CellsFile, DamageUnderARightChecksumDoesNoHarm) {
    expect_safe<2>(55);
    expect_safe<3>(56);
}

TEST(CellsFile, WhatCannotBeWrittenIsSaid) {
    const Scene<2> scene;
    const CellComplex<2> cells = build_cells(scene, {});
    EXPECT_THROW(write_cells(cells, scene, {}, "/dev/full"), WorkError);
    EXPECT_THROW(write_cells(cells, scene, {}, some_file() / "below" / "a.cells"), WorkError);
}

}  // namespace
}  // namespace sightline
