// Runs the real viewer2d in a folder of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

extern char** environ;

namespace sightline::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Result {
    int status = -1;  ///< 1000 + signal for a crash
    std::string out, err;
    std::size_t error_lines() const { return static_cast<std::size_t>(std::count(err.begin(), err.end(), '\n')); }
};

class Viewer2dRun : public ::testing::Test {
protected:
    Viewer2dRun() { fs::create_directories(folder); }
    ~Viewer2dRun() override { fs::remove_all(folder); }

    std::string read(const std::string& name) const {
        std::ifstream in(folder / name, std::ios::binary);
        EXPECT_TRUE(in) << name << " is missing";
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
    }
    /// Everything that a run left in the folder.
    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
    }

    /// Runs viewer2d in the folder; its output goes to files beside the folder, not into it.
    Result run(std::vector<std::string> arguments) const {
        const std::string out = folder.string() + ".out", err = folder.string() + ".err";
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
        arguments.insert(arguments.begin(), program);
        std::vector<char*> argv;
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        pid_t child = 0;
        Result result;
        EXPECT_EQ(posix_spawn(&child, path.c_str(), &actions, nullptr, argv.data(), environ), 0);
        posix_spawn_file_actions_destroy(&actions);
        int status = 0;
        waitpid(child, &status, 0);
        result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
        const auto content = [](const std::string& path) {
            std::ifstream in(path, std::ios::binary);
            std::ostringstream text;
            text << in.rdbuf();
            fs::remove(path);
            return text.str();
        };
        result.out = content(out);
        result.err = content(err);
        return result;
    }
    Result headless(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "--headless");
        return run(std::move(arguments));
    }
    /// A run that must do what it is asked, silently.
    Result good(std::vector<std::string> arguments) const {
        const Result result = headless(std::move(arguments));
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return result;
    }
    /// Wrong usage or unreadable input: exit 2, one line that names `what`, nothing written.
    void bad(std::vector<std::string> arguments, const std::string& what) const {
        SCOPED_TRACE(::testing::PrintToString(arguments));
        const std::size_t before = files();
        const Result result = headless(std::move(arguments));
        EXPECT_EQ(result.status, 2) << result.err;
        EXPECT_EQ(result.error_lines(), 1u) << result.err;
        EXPECT_EQ(result.err.find(program + ": "), 0u) << result.err;
        EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
        EXPECT_EQ(files(), before) << "something was written";
    }
    Json stats(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--stats", "s.json"});
        good(std::move(arguments));
        return Json::parse(read("s.json"));
    }

    std::string program = "viewer2d", path = SIGHTLINE_VIEWER2D;
    fs::path folder = fs::temp_directory_path() / ("sightline-viewer2d-" + std::to_string(getpid()));
};

}  // namespace sightline::test
