// Prints the lines of the hash list named that should stand otherwise, status 1 if there are any; without a list, all.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "core/base/error.h"
#include "core/base/file.h"
#include "tests/run/golden_hashes.h"

int main(int argc, char** argv) {
    try {
        const std::vector<std::string> all = sightline::test::golden_hashes();
        const std::vector<std::string> lines =
            argc > 1 ? sightline::test::changed_lines(sightline::read_file(argv[1]), all) : all;
        for (const std::string& line : lines) std::cout << line << "\n";
        return argc > 1 && !lines.empty();
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
