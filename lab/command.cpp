// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/command.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <iostream>
#include <string>
#include <system_error>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/text.h"

namespace sightline::lab {

std::span<const Command> commands() {
    static constexpr std::array table{
        Command{"measure", "measures methods on scenes along paths: accuracy, stability and time, with charts",
                measure_command},
        Command{"gallery", "measures the scenes in which methods fail: which pass, which fail, which surprise",
                gallery_command},
        Command{"stability", "measures how much the rendered set changes under disturbances that should not matter",
                stability_command},
        Command{"cells", "finds the coarsest tessellation and the simplest method that suffice for a scene",
                cells_command},
        Command{"compare", "says what changed between two studies or two methods, and whether it is more than noise",
                compare_command},
        Command{"object-space", "measures culling by occluders plane by plane, beside the tables of Coorg and Teller",
                object_space_command},
        Command{"viewpoint", "measures the choice of a technique by viewpoint beside each technique alone",
                viewpoint_command},
        Command{"reduce", "shrinks a scene to the fewest primitives for which an expression still holds",
                reduce_command},
        Command{"sets", "writes per frame and per object what is visible, rendered and missed, for other programs",
                sets_command},
        Command{"merge", "merges the parts of a study that were measured separately", merge_command},
    };
    return table;
}

namespace {

void print_help(std::ostream& out) {
    out << "Measures occlusion-culling methods: speed against accuracy, stability, and where they fail.\n\n"
           "lab COMMAND …   (lab COMMAND --help lists its options)\n\n";
    for (const Command& command : commands())
        out << "  " << command.id << std::string(14 - command.id.size(), ' ') << command.text << "\n";
}

int run(int argc, const char* const* argv, const MethodTables& tables) {
    const std::string id = argc > 1 ? argv[1] : "";
    if (id.empty() || id == "--help" || id == "-h") {
        print_help(id.empty() ? std::cerr : std::cout);
        return id.empty() ? 2 : 0;
    }
    for (const Command& command : commands())
        if (command.id == id) return command.run(argc - 1, argv + 1, tables);
    throw InputError("there is no command '" + excerpt(id) + "' (lab --help lists them)");
}

}  // namespace

int lab_program(int argc, const char* const* argv, const MethodTables& tables) {
    // Whatever cannot be written is said in words, by whoever writes it.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        const int status = run(argc, argv, tables);
        errno = 0;
        if (std::cout.flush()) return status;
        throw WorkError(std::string("standard output cannot be written") +
                        (errno != 0 ? ": " + std::generic_category().message(errno) : std::string()));
    } catch (const InputError& error) {
        std::cerr << "lab: " << error_line(error.what()) << "\n";
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "lab: " << error_line(error.what()) << "\n";
        return 1;
    }
}

}  // namespace sightline::lab
