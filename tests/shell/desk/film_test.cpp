// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/export/film.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <set>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/session/state_file.h"
#include "shell/desk/compare.h"
#include "shell/desk/moves.h"
#include "shell/desk/open.h"
#include "shell/export/encode.h"
#include "shell/export/export.h"
#include "tests/shell/desk/bench_support.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;

class FilmTest : public ::testing::Test {
protected:
    FilmTest() {
        fs::create_directories(folder);
        bench.session.run(12);
        bench.figure.size = "201x151";
    }
    ~FilmTest() override { fs::remove_all(folder); }

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

TEST_F(FilmTest, PicturesAreNumberedAndFitEachOther) {
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

TEST_F(FilmTest, TheSidecarOpensTheFirstStep) {
    write_film(bench, {3, 5, file("f.pdf")});
    EXPECT_EQ(files(), (std::set<std::string>{"f.pdf", "f.pdf.json"}));
    open(bench, file("f.pdf.json"));
    EXPECT_EQ(bench.session.position(), 3u);
    EXPECT_EQ(bench.figure.size, "201x151");
}

TEST_F(FilmTest, APathIsFilmedFrameByFrameWhileTheBenchStays) {
    Workbench<2>& b = bench;
    for (int i = 0; i < 5; ++i) {
        ViewSpec<2> view = b.session.culling_view();
        view.eye += Vec<2>(0.02 * i, 0);
        b.flight.path.frames.push_back(view);
    }
    const std::uint64_t hash = b.session.hash();
    write_film(b, {0, 4, file("p.png"), 25, true});
    std::set<std::string> contents;
    for (int i = 1; i <= 5; ++i) contents.insert(read_file(file("p-000" + std::to_string(i) + ".png")));
    EXPECT_EQ(contents.size(), 5u);
    EXPECT_EQ(files().size(), 6u);
    EXPECT_EQ(b.session.hash(), hash);
    // Picture 4 is what its view shows at the end of its run.
    Session<2> alone = b.session;
    alone.set_culling_view(b.flight.path.frames[3]);
    alone.run();
    write_film(b, {3, 3, file("q.png"), 25, true});
    EXPECT_EQ(open_state(read_file(file("q.png.json")), "q").session.hash(), alone.hash());
    EXPECT_THROW(write_film(b, {5, 5, file("r.png"), 25, true}), InputError);
    write_film(b, {3, 9, file("r.pdf"), 25, true});
    EXPECT_NE(read_file(file("r.pdf.json")).find("\"last\": 4"), std::string::npos) << "the last frame there is";
    b.flight.path.frames.clear();
    EXPECT_THROW(write_film(b, {0, 0, file("r.png"), 25, true}), InputError);
}

TEST_F(FilmTest, BothSidesOfAComparisonAreInIt) {
    Settings settings = bench.session.settings();
    settings.method = "centroid";
    write_film(bench, {2, 4, file("alone.pdf")});
    compare_settings(bench, settings, "centroid");
    write_film(bench, {2, 4, file("f.png")});
    const OpenedState<2> opened = open_state(read_file(file("f.png.json")), "f");
    ASSERT_TRUE(opened.other);
    EXPECT_EQ(opened.session.position(), 2u);
    EXPECT_EQ(opened.other->position(), 2u);
    EXPECT_EQ(opened.other->settings().method, "centroid");
    EXPECT_EQ(bench.session.position(), 12u);
    const auto letters = [](const std::string& svg) { return svg.find("(b) step 3") != std::string::npos; };
    if (std::system("command -v pdftotext > /dev/null 2>&1") != 0) return;
    write_film(bench, {2, 4, file("both.pdf")});
    for (const auto& [name, both] : {std::pair("alone", false), std::pair("both", true)}) {
        const std::string made = file(name);
        ASSERT_EQ(std::system(("pdftotext '" + made + ".pdf' '" + made + ".txt'").c_str()), 0);
        EXPECT_EQ(letters(read_file(made + ".txt")), both) << name;
    }
}

TEST_F(FilmTest, ItEndsWithTheLongerRun) {
    const auto last_of = [&](std::uint32_t last) {
        write_film(bench, {0, last, file("f.pdf")});
        const std::string text = read_file(file("f.pdf.json"));
        const std::string name = "\"last\": ";
        return static_cast<std::uint32_t>(std::stoul(text.substr(text.find(name) + name.size())));
    };
    Settings settings = bench.session.settings();
    const Budget all = settings.budget;
    settings.budget = {Budget::Kind::share, 0.2};
    bench.session.change(settings);
    const std::uint32_t end = whole_run(bench);
    EXPECT_EQ(last_of(film_to_end), end);
    EXPECT_EQ(last_of(end + 100), end);
    EXPECT_NE(on.said.at(on.said.size() - 2).find("the run ends at step " + std::to_string(end)), std::string::npos);
    EXPECT_EQ(last_of(3), 3u);
    // The right run is longer, and then the left one.
    settings.budget = all;
    compare_settings(bench, settings, "longer");
    const std::uint32_t longer = at_the_end(bench.other->session).position();
    ASSERT_GT(longer, end);
    EXPECT_EQ(last_of(film_to_end), longer);
    align_with(bench, Align::rendered);
    EXPECT_EQ(last_of(film_to_end), longer) << "the same order: the same step for as many drawn";
    swap_sides(bench);
    EXPECT_EQ(last_of(film_to_end), longer);
}

TEST_F(FilmTest, GifAndVideoComeFromFfmpeg) {
    if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    write_film(bench, {0, 6, file("f.gif")});
    write_film(bench, {0, 6, file("f.mp4"), 10});
    EXPECT_EQ(files(), (std::set<std::string>{"f.gif", "f.gif.json", "f.mp4", "f.mp4.json"}));
    const std::string gif = read_file(file("f.gif"));
    EXPECT_EQ(gif.substr(0, 6), "GIF89a");
    EXPECT_EQ(gif.substr(6, 4), std::string("\xc9\0\x97\0", 4)) << "201 x 151";
    EXPECT_EQ(read_file(file("f.mp4")).substr(4, 4), "ftyp");
}

TEST_F(FilmTest, SaysWhichPackageIsMissing) {
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

TEST_F(FilmTest, LeavesNothingBehindWhereItFails) {
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

TEST_F(FilmTest, RefusesStepsThatAreNot) {
    const auto refuses = [&](const FilmSpec& film) {
        EXPECT_THROW(write_film(bench, film), InputError);
        EXPECT_TRUE(files().empty());
    };
    refuses({5, 4, file("f.png")});
    refuses({100000, film_to_end, file("f.png")});
    refuses({0, 3, file("f.svg")});
    refuses({0, 3, file("f")});
    refuses({0, 3, file("f.gif"), 0});
    refuses({0, 3, file("f.gif"), 1000});
}

TEST_F(FilmTest, ANameThatIsTooLongForOneFileLeavesNeither) {
    const std::string longest = std::string(250, 'n') + ".png";  // its sidecar's name, and its pictures', are longer
    EXPECT_THROW(write_shot(bench, file(longest)), WorkError);
    EXPECT_TRUE(files().empty());
    EXPECT_THROW(write_film(bench, {0, 2, file(longest)}), WorkError);
    EXPECT_TRUE(files().empty());
    const std::string fits = std::string(245, 'n') + ".png";
    write_shot(bench, file(fits));
    EXPECT_EQ(files(), (std::set<std::string>{fits, fits + ".json"}));
}

/// A film that has as many pictures as steps takes a while: what is killed in it shows none of them.
TEST_F(FilmTest, NothingIsLeftOfOneThatIsKilled) {
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
        bench.say = [&](const std::string&) {  // 25 pictures are drawn
            const ssize_t told = write(ready[1], "x", 1);
            ::pause();
            _exit(told == 1);
        };
        write_film(bench, {0, 60, file("f.png")});
        _exit(0);
    }
    char c = 0;
    ASSERT_EQ(read(ready[0], &c, 1), 1);
    close(ready[0]);
    close(ready[1]);
    { const TemporaryFolder other(folder); }
    EXPECT_EQ(files().size(), 2u) << "what a living process makes stays: its folder and its sidecar";
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    for (const std::string& name : files()) EXPECT_TRUE(name.starts_with(".sightline-")) << name;
    write_film(bench, {0, 1, file("f.png")});
    EXPECT_EQ(files(), (std::set<std::string>{"f-0001.png", "f-0002.png", "f.png.json"}));
}

TEST_F(FilmTest, TellsHowFarItIs) {
    write_film(bench, {0, 60, file("f.png")});
    ASSERT_EQ(on.said.size(), 3u);
    EXPECT_EQ(on.said[0], "25 of 61 pictures are drawn");
}

}  // namespace
}  // namespace sightline
