// A person before a screen: Xvfb, a program on it, keys and mouse through xdotool.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

extern char** environ;

namespace sightline::test {

/// Whether a program of this name is in the PATH.
inline bool installed(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    return false;
}

/// Polls; false after `seconds` without success. Waits are as short as the machine allows.
inline bool await(const std::function<bool()>& holds, double seconds = 120) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (!holds()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

/// A child process; killed and reaped at the end.
class Process {
public:
    struct Setup {
        std::vector<std::string> environment;  ///< "NAME=value": replaces or adds; "NAME" takes away
        std::filesystem::path folder = ".";
        std::filesystem::path output = "/dev/null";
        int pipe_fd = -1;  ///< the end of a pipe that it gets as descriptor 3
    };
    Process(std::vector<std::string> arguments, const Setup& setup) {
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions, 1, setup.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_adddup2(&actions, 1, 2);
        if (setup.pipe_fd >= 0) posix_spawn_file_actions_adddup2(&actions, setup.pipe_fd, 3);
        posix_spawn_file_actions_addchdir_np(&actions, setup.folder.c_str());
        std::vector<std::string> environment = setup.environment;
        for (char** entry = environ; *entry; ++entry) {
            const std::string name = std::string(*entry).substr(0, std::string(*entry).find('='));
            bool replaced = false;
            for (const std::string& ours : setup.environment)
                replaced = replaced || ours.substr(0, ours.find('=')) == name;
            if (!replaced) environment.emplace_back(*entry);
        }
        std::erase_if(environment, [](const std::string& entry) { return entry.find('=') == std::string::npos; });
        const auto pointers = [](std::vector<std::string>& words) {
            std::vector<char*> all;
            for (std::string& word : words) all.push_back(word.data());
            all.push_back(nullptr);
            return all;
        };
        const int failed = posix_spawnp(&pid_, arguments[0].c_str(), &actions, nullptr, pointers(arguments).data(),
                                        pointers(environment).data());
        posix_spawn_file_actions_destroy(&actions);
        if (failed) pid_ = -1;
    }
    /// Asks first: an X server then takes its lock away.
    ~Process() {
        if (running()) kill(pid_, SIGTERM);
        if (!await([&] { return !running(); }, 5)) kill(pid_, SIGKILL);
        wait();
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    bool running() {
        if (pid_ < 0) return false;
        int status = 0;
        if (waitpid(pid_, &status, WNOHANG) == pid_) end(status);
        return pid_ >= 0;
    }
    void send(int signal) {
        if (running()) kill(pid_, signal);
    }
    /// The exit status; 1000 + signal for a crash, -1 when it never started.
    int wait() {
        int status = 0;
        if (pid_ >= 0 && waitpid(pid_, &status, 0) == pid_) end(status);
        return status_;
    }

private:
    void end(int status) {
        status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
        pid_ = -1;
    }
    pid_t pid_ = -1;
    int status_ = -1;
};

/// A screen that nobody sees, on a display of its own.
class Xvfb {
public:
    /// `size` as 1280x800. display() is empty when it did not start.
    Xvfb(const std::string& size, int dpi) {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) return;
        server_ = std::make_unique<Process>(
            std::vector<std::string>{"Xvfb", "-displayfd", "3", "-screen", "0", size + "x24", "-dpi",
                                     std::to_string(dpi), "-nolisten", "tcp", "-noreset"},
            Process::Setup{{}, ".", "/dev/null", ends[1]});
        close(ends[1]);
        std::string number;
        pollfd ready{ends[0], POLLIN, 0};
        for (char c = 0; poll(&ready, 1, 20000) == 1 && read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
        if (!number.empty()) display_ = ":" + number;
        close(ends[0]);
    }
    const std::string& display() const { return display_; }

private:
    std::unique_ptr<Process> server_;
    std::string display_;
};

/// Hands on the keyboard and the mouse of a display. Positions are those of the window.
class Hands {
public:
    Hands(const std::string& display, std::filesystem::path folder)
        : display_("DISPLAY=" + display), folder_(std::move(folder)) {}

    /// Waits for the window of this title and gives it the keyboard.
    bool take_window(const std::string& title) {
        const bool found = await([&] {
            return !(window_ = output({"search", "--onlyvisible", "--name", title})).empty();
        });
        return found && xdotool({"windowfocus", "--sync", window_});
    }
    /// Another window of this title comes, or goes; the keyboard goes back to the first one.
    bool has_window(const std::string& title) {
        const bool found = await([&] { return !output({"search", "--onlyvisible", "--name", title}).empty(); });
        return found && xdotool({"windowfocus", "--sync", window_});
    }
    bool lost_window(const std::string& title) {
        const bool gone = await([&] { return output({"search", "--onlyvisible", "--name", title}).empty(); });
        return gone && xdotool({"windowfocus", "--sync", window_});
    }
    /// Whether a window manager minds the screen.
    bool has_manager() {
        return await([&] { return xdotool({"get_num_desktops"}); }, 20);
    }
    /// Left, top, width and height of the window on the screen, without a frame.
    std::array<int, 4> geometry() {
        std::array<int, 4> numbers{-1, -1, -1, -1};
        const std::filesystem::path file = folder_ / "geometry.txt";
        Process({"xdotool", "getwindowgeometry", "--shell", window_}, {{display_}, ".", file}).wait();
        std::ifstream in(file);
        for (std::string line; std::getline(in, line);)
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                const std::string name = std::array{"X=", "Y=", "WIDTH=", "HEIGHT="}[i];
                if (line.starts_with(name)) numbers[i] = std::stoi(line.substr(name.size()));
            }
        return numbers;
    }
    bool key(const std::string& name) { return xdotool({"key", name}); }
    bool down(const std::string& name) { return xdotool({"keydown", name}); }
    bool up(const std::string& name) { return xdotool({"keyup", name}); }
    bool type(const std::string& text) { return xdotool({"type", "--delay", "2", text}); }
    bool move(double x, double y) { return xdotool({"mousemove", "--window", window_, whole(x), whole(y)}); }
    bool click(double x, double y) { return move(x, y) && xdotool({"click", "1"}); }
    bool resize(int w, int h) { return xdotool({"windowsize", window_, std::to_string(w), std::to_string(h)}); }
    /// Off the screen, as a minimized window is, and back with the keyboard.
    bool hide() { return xdotool({"windowunmap", window_}); }
    bool show() { return xdotool({"windowmap", "--sync", window_}) && xdotool({"windowfocus", "--sync", window_}); }
    bool wheel_up() { return xdotool({"click", "4"}); }
    /// Slowly enough to be seen as a drag.
    bool drag(double x, double y, double to_x, double to_y) {
        bool good = move(x, y) && xdotool({"mousedown", "1"});
        for (int i = 1; i <= 8; ++i) good = good && move(x + (to_x - x) * i / 8, y + (to_y - y) * i / 8);
        return good && xdotool({"mouseup", "1"});
    }

private:
    static std::string whole(double x) { return std::to_string(static_cast<int>(x + 0.5)); }
    bool xdotool(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "xdotool");
        return Process(std::move(arguments), {{display_}, ".", "/dev/null"}).wait() == 0;
    }
    /// The first line that it prints.
    std::string output(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "xdotool");
        const std::filesystem::path file = folder_ / "xdotool.txt";
        Process(std::move(arguments), {{display_}, ".", file}).wait();
        std::ifstream in(file);
        std::string line;
        std::getline(in, line);
        return line.find_first_not_of("0123456789") == std::string::npos ? line : "";
    }

    std::string display_;
    std::filesystem::path folder_;
    std::string window_;
};

}  // namespace sightline::test
