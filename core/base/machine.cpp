// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/machine.h"

#include <ctime>
#include <fstream>
#include <thread>

namespace sightline {

std::string machine_text() {
    std::string text;
    std::ifstream cpu("/proc/cpuinfo");
    for (std::string line; std::getline(cpu, line);)
        if (line.starts_with("model name")) {
            text = line.substr(line.find(':') + 2) + ", ";
            break;
        }
    return text + std::to_string(std::thread::hardware_concurrency()) + " cores";
}

std::string today_text() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char date[16];
    std::strftime(date, sizeof date, "%Y-%m-%d", &utc);
    return date;
}

}  // namespace sightline
