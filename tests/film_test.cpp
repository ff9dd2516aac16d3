// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/bench/film.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <set>

#include "core/error.h"
#include "core/file.h"
#include "core/session/state_file.h"
#include "shell/bench/open.h"
#include "tests/bench_support.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;

class Film : public ::testing::Test {
protected:
    Film() {
        fs::create_directories(folder);
        bench.session.run(12);
        bench.figure.size = "201x151";
    }
    ~Film() override { fs::remove_all(folder); }

    std::string file(const std::string& name) const { return (folder / name).string(); }
    std::set<std::string> files() const {
        std::set<std::string> names;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder))
            names.insert(entry.path().filename().string());
        return names;
    }
    static bool has_ffmpeg() { return std::system("ffmpeg -version > /dev/null 2>&1") == 0; }

    fs::path folder = fs::temp_directory_path() / ("sightline-film-" + std::to_string(getpid()));
    test::Bench on{open_scene("bottleneck", {}, method_table<2>(), [](const std::string&) {})};
    Workbench<2>& bench = on.bench;
};

/// Width and height of a PNG, big-endian after its first header.
std::string size_of_png(const std::string& data) { return data.substr(16, 8); }

TEST_F(Film, PicturesAreNumberedAndFitEachOther) {
    bench.figure.size = "60mm";  // the height follows from the content
    Settings settings = bench.session.settings();
    settings.caption = Switch::on;
    settings.heat = CellNumber::order;
    bench.session.change(settings);
    const std::uint64_t hash = bench.session.hash();
    write_film(bench, {8, 11, file("f.png")});
    EXPECT_EQ(files(), (std::set<std::string>{"f-0001.png", "f-0002.png", "f-0003.png", "f-0004.png", "f.png.json"}));
    std::set<std::string> sizes, contents;
    for (const char* name : {"f-0001.png", "f-0002.png", "f-0003.png", "f-0004.png"}) {
        contents.insert(read_file(file(name)));
        sizes.insert(size_of_png(read_file(file(name))));
    }
    EXPECT_EQ(sizes.size(), 1u);
    EXPECT_EQ(contents.size(), 4u);
    EXPECT_EQ(bench.session.hash(), hash);
    EXPECT_EQ(bench.session.position(), 12u);
}

TEST_F(Film, TheSidecarOpensTheFirstStep) {
    write_film(bench, {3, 5, file("f.pdf")});
    EXPECT_EQ(files(), (std::set<std::string>{"f.pdf", "f.pdf.json"}));
    open(bench, file("f.pdf.json"));
    EXPECT_EQ(bench.session.position(), 3u);
    EXPECT_EQ(bench.figure.size, "201x151");
}

TEST_F(Film, GifAndVideoComeFromFfmpeg) {
    if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    write_film(bench, {0, 6, file("f.gif")});
    write_film(bench, {0, 6, file("f.mp4"), 10});
    EXPECT_EQ(files(), (std::set<std::string>{"f.gif", "f.gif.json", "f.mp4", "f.mp4.json"}));
    const std::string gif = read_file(file("f.gif"));
    EXPECT_EQ(gif.substr(0, 6), "GIF89a");
    EXPECT_EQ(gif.substr(6, 4), std::string("\xc9\0\x97\0", 4)) << "201 x 151";
    EXPECT_EQ(read_file(file("f.mp4")).substr(4, 4), "ftyp");
}

TEST_F(Film, SaysWhichPackageIsMissing) {
    const std::string path = std::getenv("PATH");
    setenv("PATH", folder.c_str(), 1);
    std::string said;
    try {
        write_film(bench, {0, 2, file("f.gif")});
    } catch (const WorkError& error) {
        said = error.what();
    }
    setenv("PATH", path.c_str(), 1);
    EXPECT_NE(said.find("install the package ffmpeg"), std::string::npos) << said;
    EXPECT_TRUE(files().empty());
}

TEST_F(Film, LeavesNothingBehindWhereItFails) {
    fs::create_directories(folder / "f-0003.png" / "in the way");
    EXPECT_THROW(write_film(bench, {0, 4, file("f.png")}), WorkError);
    EXPECT_EQ(files(), (std::set<std::string>{"f-0003.png"}));
    if (!has_ffmpeg()) return;
    // A place of its own for temporary files: other films may be in the making beside this test.
    const fs::path place = folder / "temporary";
    fs::create_directories(place);
    const std::string before = fs::temp_directory_path().string();
    setenv("TMPDIR", place.c_str(), 1);
    EXPECT_THROW(write_film(bench, {0, 2, file("missing/f.gif")}), WorkError);
    setenv("TMPDIR", before.c_str(), 1);
    EXPECT_TRUE(fs::is_empty(place));
}

TEST_F(Film, RefusesStepsThatAreNot) {
    const auto refuses = [&](const FilmSpec& film) {
        EXPECT_THROW(write_film(bench, film), InputError);
        EXPECT_TRUE(files().empty());
    };
    refuses({5, 4, file("f.png")});
    refuses({5, 100000, file("f.png")});
    refuses({0, 3, file("f.svg")});
    refuses({0, 3, file("f")});
    refuses({0, 3, file("f.gif"), 0});
    refuses({0, 3, file("f.gif"), 1000});
}

TEST_F(Film, TellsHowFarItIs) {
    write_film(bench, {0, 60, file("f.png")});
    ASSERT_EQ(on.said.size(), 3u);
    EXPECT_EQ(on.said[0], "25 of 61 pictures are drawn");
}

}  // namespace
}  // namespace sightline
