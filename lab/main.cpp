// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"
#include "lab/command.h"

namespace {

using namespace sightline;

void print_help(std::ostream& out) {
    out << "Measures occlusion-culling methods: speed against accuracy, stability, and where they fail.\n\n"
           "lab COMMAND …   (lab COMMAND --help lists its options)\n\n";
    for (const lab::Command& command : lab::commands())
        out << "  " << command.id << std::string(12 - command.id.size(), ' ') << command.text << "\n";
}

int run(int argc, char** argv) {
    const std::string id = argc > 1 ? argv[1] : "";
    if (id.empty() || id == "--help" || id == "-h") {
        print_help(id.empty() ? std::cerr : std::cout);
        return id.empty() ? 2 : 0;
    }
    for (const lab::Command& command : lab::commands())
        if (command.id == id) return command.run(argc - 1, argv + 1);
    throw InputError("there is no command '" + id + "' (lab --help lists them)");
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const InputError& error) {
        std::cerr << "lab: " << one_line(error.what(), 4096) << "\n";
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "lab: " << one_line(error.what(), 4096) << "\n";
        return 1;
    }
}
