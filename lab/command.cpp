// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/command.h"

#include <array>

namespace sightline::lab {

std::span<const Command> commands() {
    static constexpr std::array table{
        Command{"measure", "measures methods on scenes along paths: accuracy, stability and time, with charts",
                measure_command},
        Command{"gallery", "measures the scenes in which methods fail: who passes, who fails, who surprises",
                gallery_command},
        Command{"stability", "measures how much what is rendered changes for what should not matter",
                stability_command},
        Command{"cells", "names the coarsest tessellation and the simplest method that a scene needs", cells_command},
        Command{"compare", "says what changed between two studies or two methods, and whether it is more than noise",
                compare_command},
        Command{"reduce", "shrinks a scene to the fewest primitives in which an expression holds", reduce_command},
        Command{"merge", "puts the parts of a study together that were measured apart", merge_command},
    };
    return table;
}

}  // namespace sightline::lab
