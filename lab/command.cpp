// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/command.h"

#include <array>
#include <exception>
#include <iostream>
#include <string>

#include "core/base/error.h"
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
        Command{"reduce", "shrinks a scene to the fewest primitives for which an expression still holds",
                reduce_command},
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
    throw InputError("there is no command '" + id + "' (lab --help lists them)");
}

}  // namespace

int lab_program(int argc, const char* const* argv, const MethodTables& tables) {
    try {
        return run(argc, argv, tables);
    } catch (const InputError& error) {
        std::cerr << "lab: " << one_line(error.what(), 4096) << "\n";
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "lab: " << one_line(error.what(), 4096) << "\n";
        return 1;
    }
}

}  // namespace sightline::lab
