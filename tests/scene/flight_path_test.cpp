// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/flight_path.h"

#include "core/scene/flight_path_csv.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

TEST(FlightPath, FramesAreSpreadEvenly) {
    using Frames = std::vector<std::size_t>;
    EXPECT_EQ(spread_frames(160, 0), Frames{});
    EXPECT_EQ(spread_frames(0, 5), Frames{});
    EXPECT_EQ(spread_frames(160, 1), Frames{0});
    EXPECT_EQ(spread_frames(160, 2), (Frames{0, 159}));
    EXPECT_EQ(spread_frames(9, 5), (Frames{0, 2, 4, 6, 8}));
    EXPECT_EQ(spread_frames(10, 4), (Frames{0, 3, 6, 9}));
    EXPECT_EQ(spread_frames(3, 7), (Frames{0, 1, 2}));
    for (std::size_t count = 1; count < 60; ++count)
        for (std::size_t wanted = 1; wanted < 70; ++wanted) {
            const Frames frames = spread_frames(count, wanted);
            ASSERT_EQ(frames.size(), std::min(count, wanted));
            ASSERT_EQ(frames.front(), 0u);
            ASSERT_EQ(frames.back(), wanted == 1 ? 0 : count - 1);
            std::size_t least = frames.size() == 1 ? 1 : count, most = 1;
            for (std::size_t i = 1; i < frames.size(); ++i) {
                ASSERT_GT(frames[i], frames[i - 1]);
                least = std::min(least, frames[i] - frames[i - 1]);
                most = std::max(most, frames[i] - frames[i - 1]);
            }
            ASSERT_LE(most - least, 1u) << count << " " << wanted;
        }
}

template <int D>
FlightPath<D> some_path() {
    FlightPath<D> path{"round \"the\" house", {}};
    path.scene = "city:50k";
    for (int i = 0; i < D; ++i) path.origin[i] = 1024.0 * i;
    for (int k = 0; k < 3; ++k) {
        ViewSpec<D> frame;
        for (int i = 0; i < D; ++i) frame.eye[i] = (k + 1) / 3.0 * i, frame.look_at[i] = 0.1 + k - i;
        frame.fov = 60 + 0.1 * k;
        path.frames.push_back(frame);
    }
    return path;
}

TEST(FlightPath, ReadsBackWhatItWrote) {
    EXPECT_EQ(read_path<2>(write_path(some_path<2>()), "p"), some_path<2>());
    EXPECT_EQ(read_path<3>(write_path(some_path<3>()), "p"), some_path<3>());
    FlightPath<2> round = some_path<2>();
    round.frames[0].fov = 360;
    EXPECT_EQ(read_path<2>(write_path(round), "p"), round);
}

TEST(FlightPath, MovesIntoAnotherOrigin) {
    FlightPath<3> path = some_path<3>();
    path.frames[1].eye = {0.5, -7, 1};
    set_origin<3>(path, {8, 1040, -4});
    EXPECT_EQ(path.frames[1].eye, Vec<3>(0.5 - 8, -7 - 16, 1 + 2048 + 4));
    EXPECT_EQ(path.origin, Vec<3>(8, 1040, -4));
}

std::string with_frames(const std::string& frames) {
    return R"({"format": "sightline-path", "version": 1, "dimension": 3, "frames": )" + frames + "}";
}

TEST(FlightPath, SaysWhatIsWrong) {
    const std::string frame = R"({"eye": [0, 0, 0], "look_at": [1, 0, 0]})";
    EXPECT_EQ(read_path<3>(with_frames("[" + frame + "]"), "p").frames.at(0), (ViewSpec<3>{{0, 0, 0}, {1, 0, 0}, 60}));
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"", "p: line 1, column 1: *"},
        {"[]", "p: expected an object, found an array"},
        {"{}", "p: \"format\" is missing"},
        {R"({"format": "sightline-scene"})", "p: /format: expected \"sightline-path\""},
        {R"({"format": "sightline-path", "version": 2})", "p: /version: expected 1; *"},
        {R"({"format": "sightline-path", "version": 1, "dimension": 2})", "p: /dimension: expected 3"},
        {R"({"format": "sightline-path", "version": 1, "dimension": 3})", "p: \"frames\" is missing"},
        {R"({"format": "sightline-path", "version": 1, "dimension": 3, "id": 5})",
         "p: /id: expected a string, found a number"},
        {with_frames("{}"), "p: /frames: expected an array, found an object"},
        {with_frames("[]"), "p: /frames: a path needs one frame at least"},
        {with_frames("[" + frame + ", 7]"), "p: /frames/1: expected an object, found a number"},
        {with_frames(R"([{"eye": [0, 0, 0]}])"), "p: /frames/0: \"look_at\" is missing"},
        {with_frames(R"([{"eye": [0, 0]}])"), "p: /frames/0/eye: expected an array of 3 numbers, found one of 2"},
        {with_frames(R"([{"eye": [0, 0, "x"]}])"), "p: /frames/0/eye/2: expected a number, found a string"},
        {with_frames(R"([{"eye": [0, 0, 0], "look_at": [0, 0, 0]}])"),
         "p: /frames/0: look_at is the same point as eye"},
        {with_frames(R"([{"eye": [0, 0, 0], "look_at": [1, 0, 0], "fov": 360}])"),
         "p: /frames/0: fov 360 is not between 0 and 180"},
    };
    for (const auto& [text, line] : cases) test::expect_input_error([&] { read_path<3>(text, "p"); }, line);
}

TEST(FlightPath, IsAlsoATable) {
    FlightPath<3> path = some_path<3>();
    path.origin = {0, 0, 0};
    FlightPath<3> read = read_path<3>(write_csv_path(path), "p");
    EXPECT_EQ(read.frames, path.frames);
    EXPECT_EQ(read.origin, Vec<3>(0));
    // In the file's coordinates.
    path.origin = {1024, 0, -8};
    read = read_path<3>(write_csv_path(path), "p");
    set_origin(read, path.origin);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(glm::length(read.frames[i].eye - path.frames[i].eye), 0, 1e-12);
    EXPECT_TRUE(write_csv_path(path).starts_with("eye_x,eye_y,eye_z,look_at_x,look_at_y,look_at_z,fov\n"));
    EXPECT_TRUE(path_text(path, "a.csv").starts_with("eye_x,"));
    EXPECT_TRUE(path_text(path, "a.json").starts_with("{"));

    const FlightPath<2> flat = read_path<2>(
        "# of an engine\r\nframe, look_at_y ,look_at_x,eye_y,eye_x\r\n\r\n0, 4, 3, 2, 1\r\n1,4,3,2,1.5", "p");
    ASSERT_EQ(flat.frames.size(), 2u);
    EXPECT_EQ(flat.frames[0], (ViewSpec<2>{{1, 2}, {3, 4}, 60}));
    EXPECT_EQ(flat.frames[1].eye, Vec<2>(1.5, 2));
}

TEST(FlightPath, SaysWhatIsWrongInATable) {
    const std::string head = csv_path_columns<2>() + "\n";
    EXPECT_EQ(head, "eye_x,eye_y,look_at_x,look_at_y,fov\n");
    for (const auto& [text, line] : std::initializer_list<std::pair<std::string, std::string>>{
             {"hello",
              "p: line 1: no column eye_x: a path is JSON, or CSV with a first line such as " + csv_path_columns<2>()},
             {head, "p: a path needs one frame at least"},
             {head + "1,2,3,4\n", "p: line 2: 4 columns, 5 expected"},
             {head + "1,2,3,4,60\n1,2,x,4,60\n", "p: line 3: look_at_x \"x\" is not a number"},
             {head + "1,2,1,2,60\n", "p: line 2: look_at is the same point as eye"},
             {head + "1,2,3,4,200\n", "p: line 2: fov 200 is not between 0 and 180, nor 360"},
             {"eye_x,eye_x,eye_y,look_at_x,look_at_y\n", "p: line 1: column eye_x is there twice"}})
        test::expect_input_error([&, &text = text] { read_path<2>(text, "p"); }, line);
}

}  // namespace
}  // namespace sightline
