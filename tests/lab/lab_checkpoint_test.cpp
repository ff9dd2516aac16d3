// Files of finished frames: damaged ones are named and measured again; and the folders that they lie in.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/random.h"
#include "lab/measure/checkpoint.h"
#include "lab/measure/out_folder.h"
#include "lab/measure/run_study.h"
#include "tests/soak.h"

namespace sightline::lab {
namespace {

namespace fs = std::filesystem;

class LabCheckpoint : public testing::Test {
protected:
    void TearDown() override { fs::remove_all(folder_); }
    fs::path folder(const std::string& name) const { return folder_ / name; }
    static Study one_scene() {
        Study study;
        study.scenes = {"2d:rooms"};
        study.frames = 3;
        study.size = {160, 120};
        study.repeats = 0;
        return study;
    }
    /// All but times, in order.
    static std::string numbers_of(const Results& results) {
        std::string text;
        for (const Row& row : results.rows)
            for (const Values& v : row.values)
                for (const double value : v.all) text += number_text(value) + " ";
        return text;
    }
    LabGraphics graphics_;
    const fs::path folder_ = fs::temp_directory_path() / ("sightline-checkpoint-" + std::to_string(getpid()));
};

/// Whatever happens to the file: what is damaged is named and measured again, and the numbers are the right ones.
TEST_F(LabCheckpoint, MeasuresDamagedFramesAgain) {
    Study study = one_scene();
    study.scenes = {"2d:rooms"};
    study.methods = {parse_method("layers")};
    const Results right = run_study(study, folder("a"), graphics_);
    const fs::path file = folder("a") / "frames.jsonl";
    const std::string whole = read_file(file);
    std::vector<std::size_t> ends;
    for (std::size_t at = whole.find('\n'); at != std::string::npos; at = whole.find('\n', at + 1)) ends.push_back(at);
    ASSERT_EQ(ends.size(), 4u);
    const auto run_with = [&](const std::string& text) {
        write_file(file, text);
        testing::internal::CaptureStderr();
        const Results found = run_study(study, folder("a"), graphics_);
        const std::string said = testing::internal::GetCapturedStderr();
        EXPECT_EQ(numbers_of(found), numbers_of(right));
        return said;
    };
    EXPECT_EQ(run_with(whole), "");
    EXPECT_EQ(run_with(whole.substr(0, ends[2] - 5)),
              "lab: warning: " + file.string() + ": line 3: is cut or damaged; what it held is measured again\n");
    std::string large = whole;
    const std::size_t digit = large.find_first_of("123456789", large.find("\"piece\"", ends[1]));
    large.insert(digit, "1e308,");
    EXPECT_NE(run_with(large).find(": line 3: "), std::string::npos) << "a number that was never measured";
    EXPECT_NE(run_with("{}\n" + whole.substr(ends[0] + 1)).find("line 1: is cut or damaged; all is measured again"),
              std::string::npos);
    EXPECT_TRUE(fs::exists(file.string() + ".old"));
    Random random(5);
    for (std::size_t i = 0; i < static_cast<std::size_t>(sightline::test::soak_count(60)); ++i) {
        std::string mutated = whole;
        const std::size_t at = random.below(whole.size());
        switch (random.below(4)) {
            case 0:
                mutated[at] = static_cast<char>(random.below(256));
                break;
            case 1:
                mutated.erase(at, 1 + random.below(40));
                break;
            case 2:
                mutated.insert(at, std::to_string(random.below(1000)));
                break;
            default:
                mutated.resize(at);
        }
        EXPECT_EQ(run_with(mutated).empty(), mutated == whole || mutated.empty() || mutated.size() == ends[0] + 1 ||
                                                 mutated.size() == ends[1] + 1 || mutated.size() == ends[2] + 1)
            << at << '\n'
            << mutated;
    }
}

TEST_F(LabCheckpoint, HasAFolderOfItsOwn) {
    Study study = one_scene();
    study.scenes = {"2d:rooms", "3d:bottleneck"};
    EXPECT_EQ(folder_named("lab", name_parts(study)), "out/lab-2d_rooms-3d_bottleneck");
    study.scenes = {"city:100k", "cars", "room", "plant"};
    study.paths = {"street"};
    EXPECT_EQ(folder_named("lab", name_parts(study)), "out/lab-city_100k-cars-and-2-more-street");
    study = one_scene();
    study.scenes = {"2d:rooms"};
    const std::string base = folder("lab").string();
    const auto folder_of = [&] { return folder_for(base, "frames.jsonl", study_json(study)); };
    EXPECT_EQ(folder_of(), base);
    run_study(study, base, graphics_);
    EXPECT_EQ(folder_of(), base) << "it goes on there";
    study.budgets = {parse_budget("3%")};
    EXPECT_EQ(folder_of(), base + "-2") << "another study is not refused";
    run_study(study, folder_of(), graphics_);
    EXPECT_EQ(folder_of(), base + "-2");
    study.budgets = {parse_budget("4%")};
    EXPECT_EQ(folder_of(), base + "-3");

    study.scenes = {"nosuch.json"};
    try {
        run_study(study, base, graphics_);
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find("another study"), std::string::npos)
            << "what is missing is said before: " << error.what();
    }
}

}  // namespace
}  // namespace sightline::lab
