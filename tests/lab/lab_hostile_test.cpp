// Names of scenes, paths, folders and methods are data: no command runs them, and what is written stays well formed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/base/file.h"
#include "core/scene/flight_path.h"
#include "lab/measure/checkpoint.h"

namespace sightline::lab {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What would run makes a file of this name where it runs.
constexpr const char* mark = "hacked";
/// As a file name may be; '#' stands for a part of a scene.
const std::string name =
    "a`touch hacked`$(touch hacked)'\"%s%d\\\\@b<script>alert(1)<&amp;{}^x_|touch hacked;\n]]>\x1b[31m";
/// As results may name something. A slash would leave the folder of the results.
const std::string hostile =
    "../../#/*</code></td><script src=x>" + name + "' `touch hacked` \"`touch hacked`\" -->\r\t\x01\x7fρ";
/// gnuplot takes file names that begin with these as programs to run.
constexpr const char *to_program = "|touch hacked;: ", *from_program = "<touch hacked;: ";

/// Between quotes for sh; not by the function that is tested.
std::string sh(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\"'\"'") : std::string(1, c);
    return quoted + "'";
}

class LabHostile : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directories(work_);
        write_file(work_ / scene_,
                   R"({"format":"sightline-scene","version":1,"dimension":2,"title":"<b>`touch hacked`",)"
                   R"("view":{"eye":[-5,1],"look_at":[0,0]},)"
                   R"("segments":[[0,0,1,0],[0,1,1,1],[0,2,1,2],[-1,3,0,-3],[-2,-2,-2,2]]})");
        write_file(work_ / path_,
                   write_path(FlightPath<2>{name, {{{-5, 1}, {0, 0}}, {{-4, 1}, {0, 0}}, {{-3, 2}, {0, 0}}}}));
        write_file(work_ / "run", "#!/bin/sh\nfor word; do printf '%s\\0' \"$word\"; done > words\n");
        fs::permissions(work_ / "run", fs::perms::owner_all);
    }
    void TearDown() override { fs::remove_all(root_); }

    /// 0 or what a shell that started in `folder` says; what was said lies in root_/said and root_/complained.
    int shell(const std::string& command, const fs::path& folder) const {
        const std::string line = "cd " + sh(folder.string()) + " && { " + command + "\n} > " +
                                 sh((root_ / "said").string()) + " 2> " + sh((root_ / "complained").string());
        return WEXITSTATUS(std::system(line.c_str()));
    }
    std::string said() const { return read_file(root_ / "said"); }
    std::string complained() const { return read_file(root_ / "complained"); }

    /// Runs a command of the lab, which may write into `out` only, and looks at all that lies there afterwards.
    void lab(const std::string& command, const std::vector<std::string>& words, const std::string& out) {
        std::set<fs::path> before;
        for (const auto& entry : fs::directory_iterator(work_)) before.insert(entry.path());
        std::string line = sh(SIGHTLINE_LAB) + " " + command;
        for (const std::string& w : words) line += " " + sh(w);
        EXPECT_EQ(shell(line + " --out " + sh(out), work_), 0) << line << "\n" << complained();
        const std::string lines = said();
        for (const char c : {'\x1b', '\x01', '\x7f'})
            EXPECT_EQ((lines + complained()).find(c), std::string::npos) << command << " tells the terminal something";
        complained_ = complained();
        for (const auto& entry : fs::directory_iterator(work_))
            EXPECT_TRUE(before.contains(entry.path()) || entry.path() == work_ / out ||
                        entry.path().filename() == "images" || entry.path() == work_ / page_)
                << command << " wrote " << entry.path();
        nothing_ran(command);
        for (const fs::path& folder : {work_ / out, work_ / "images"})
            if (fs::exists(folder))
                for (const auto& entry : fs::recursive_directory_iterator(folder)) look_at(entry.path());
        nothing_ran(command + ", charts drawn again");
        commands_name_files(lines);
        nothing_ran(command + ", what it says pasted");
    }

    void nothing_ran(const std::string& what) const {
        for (const auto& entry : fs::recursive_directory_iterator(root_))
            EXPECT_NE(entry.path().filename(), mark) << what << " ran a name";
        fs::remove(work_ / mark);
    }

    void look_at(const fs::path& file) const {
        const std::string plain = " " + sh("./" + file.filename().string());
        if (file.extension() == ".gp") {
            EXPECT_EQ(shell("gnuplot" + plain, file.parent_path()), 0) << file << complained();
        }
        if (std::system("command -v xmllint > /dev/null 2>&1") != 0) return;
        if (file.extension() == ".svg") {
            EXPECT_EQ(shell("xmllint --noout" + plain, file.parent_path()), 0) << file << complained();
        }
        if (file.extension() == ".html") {
            const std::string html = read_file(file);
            EXPECT_EQ(html.find("<script"), std::string::npos) << file;
            // The parser knows the tags of HTML 4 only.
            shell("xmllint --html --noout" + plain + " 2>&1 | grep 'parser error' | grep -v 'Tag [a-z]* invalid'",
                  file.parent_path());
            EXPECT_EQ(said(), "") << file;
        }
    }

    /// Lines that a person may paste into a shell start a stand-in here, which keeps its words.
    void commands_name_files(const std::string& lines) const {
        std::istringstream in(lines);
        for (std::string line; std::getline(in, line);) {
            const std::size_t at = line.find("./run ");
            if (at == std::string::npos) continue;
            EXPECT_EQ(shell("bash -c " + sh(line.substr(at)), work_), 0) << line << complained();
            const std::string words = read_file(work_ / "words");
            const bool known = words.find(std::string(1, '\0') + scene_ + '\0') != std::string::npos ||
                               words.find("--state") != std::string::npos;
            EXPECT_TRUE(known) << line;
            if (const std::size_t state = words.find("--state"); state != std::string::npos) {
                EXPECT_TRUE(fs::exists(work_ / words.substr(state + 8, words.size() - state - 9))) << line;
            }
        }
    }

    std::string complained_;  ///< by the last command of the lab
    fs::path root_ = fs::temp_directory_path() / ("sightline-hostile-" + std::to_string(getpid()));
    fs::path work_ = root_ / "a" / "work";
    std::string scene_ = name + ".json", path_ = name + ".path.json", page_ = name + ".md";
    std::vector<std::string> study_{"2d:" + scene_, "--path", path_,    "--methods", "published,layers",
                                    "--budgets",    "40%",    "--size", "64x48"};
};

/// Somebody else's results: every text in them that says what was measured is another one.
std::string doctored(const fs::path& results) {
    Json json = Json::parse(read_file(results));
    for (const char* member : {"build", "machine", "renderer", "date", "program"})
        json["conditions"][member] = hostile + member;
    for (Json& row : json["rows"]) {
        for (const char* member : {"scene", "path", "reference"}) row[member] = hostile + member;
        for (const char* member : {"method", "budget_text"}) row[member] = row[member].get<std::string>() + hostile;
    }
    return json.dump();
}

TEST_F(LabHostile, NamesOfFilesAndOfResults) {
    std::vector<std::string> words = study_;
    words.insert(words.end(), {"--repeats", "1", "--markdown", page_});
    lab("measure", words, name);
    EXPECT_TRUE(fs::exists(work_ / name / "report.html"));
    const std::string page = read_file(work_ / page_);
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_NE(page.find("\n```\n\non "), std::string::npos) << "the command is one line";

    fs::create_directories(work_ / "theirs");
    write_file(work_ / "theirs" / "results.json", doctored(work_ / name / "results.json"));
    lab("merge", {"theirs"}, to_program + name);
    lab("merge", {"theirs"}, from_program + name);
    fs::create_directories(work_ / (name + "2"));
    write_file(work_ / (name + "2") / "results.json", doctored(work_ / name / "results.json"));
    lab("compare", {"theirs", name + "2"}, name + " compared");
}

TEST_F(LabHostile, ResultsWithOtherFrames) {
    std::vector<std::string> words = study_;
    words.insert(words.end(), {"--repeats", "0", "--frames", "2"});
    lab("measure", words, "ours");
    const Json ours = Json::parse(read_file(work_ / "ours" / "results.json"));
    const auto merge = [&](const Json& theirs) {
        fs::create_directories(work_ / "theirs");
        write_file(work_ / "theirs" / "results.json", theirs.dump());
        lab("merge", {"theirs"}, "merged");
        return complained_;
    };
    EXPECT_EQ(merge(ours).find("warning"), std::string::npos);
    Json none = ours, more = ours, endless = ours;
    for (std::size_t i = 0; i < ours["rows"].size(); ++i) {
        for (auto& [id, values] : none["rows"][i]["per_frame"].items()) values = Json::array();
        for (auto& [id, values] : more["rows"][i]["per_frame"].items())
            for (int n = 0; n < 9; ++n) values.push_back(id == "frame" ? Json(n) : Json(1000 * n));
        for (Json& value : endless["rows"][i]["per_frame"]["budget"]) value = 1e99;
        for (Json& value : endless["rows"][i]["per_frame"]["wrong"]) value = 0.5;  // or no picture is drawn
    }
    for (const Json& theirs : {none, more, endless})
        EXPECT_NE(merge(theirs).find("the report has no pictures"), std::string::npos) << complained_;
}

TEST_F(LabHostile, TwoMethods) {
    lab("compare", {"published", "layers", "2d:" + scene_, "--path", path_, "--budgets", "40%", "--repeats", "0"},
        to_program + name);
}

TEST_F(LabHostile, Stages) {
    std::vector<std::string> words = study_;
    words.insert(words.end(), {"--samples", "1", "--spots", "2"});
    lab("stability", words, name);
    const fs::path stages = work_ / name / "stages.jsonl";
    std::istringstream in(read_file(stages));
    std::string line, theirs;
    std::getline(in, theirs);  // what was asked for
    theirs += "\n";
    while (std::getline(in, line)) {
        Json json = Json::parse(line);
        for (Json& row : json["piece"])
            for (const char* member : {"scene", "path", "method", "budget"})
                row[member] = row[member].get<std::string>() + hostile;
        json.erase("hash");
        theirs += checkpoint_line(json.dump()) + "\n";
    }
    write_file(stages, theirs);
    lab("stability", words, name);
    EXPECT_NE(read_file(work_ / name / "stability.json").find("<script src=x>"), std::string::npos) << "they were read";
}

TEST_F(LabHostile, Cells) {
    std::vector<std::string> words = study_;
    words.insert(words.end(), {"--repeats", "0", "--error-bounds", "0.4,0.2", "--reach", "0"});
    lab("cells", words, from_program + name);
}

TEST_F(LabHostile, StateFiles) {
    lab("gallery", {"2d:bottleneck"}, name);
    lab("reduce", {"2d:" + scene_, "--until", "rendered_now > 0"}, name);
}

TEST_F(LabHostile, Figures) {
    const std::string shot = name + ".svg",
                      note = "\"note text 0,0 " +
                             std::string("`touch hacked` $(touch hacked) '%s @b <script> &amp; {}^_ \\ ]]>") + "\"";
    EXPECT_EQ(shell(sh(SIGHTLINE_VIEWER2D) + " --headless " + sh(scene_) + " --do " + sh(note) + " --shot " + sh(shot),
                    work_),
              0)
        << complained();
    nothing_ran("viewer2d");
    look_at(work_ / shot);
    const std::string svg = read_file(work_ / shot);
    EXPECT_EQ(svg.find("<script"), std::string::npos);
    EXPECT_NE(svg.find("&lt;script"), std::string::npos);
}

}  // namespace
}  // namespace sightline::lab
