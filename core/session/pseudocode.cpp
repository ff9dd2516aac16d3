// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/pseudocode.h"

namespace sightline {

template <int D>
std::vector<CodeLine> pseudocode(const Session<D>& session, std::optional<std::uint32_t> substep) {
    CodePlace place;
    if (const std::uint32_t step = session.position(); step > 0) {
        const Timeline<D>& timeline = session.timeline();
        place = {&timeline.steps[step - 1], step, timeline.changes_of(step),
                 timeline.after(step).rendered_count - timeline.before(step).rendered_count, substep};
    }
    return session.traversal().code(place);
}

template std::vector<CodeLine> pseudocode<2>(const Session<2>&, std::optional<std::uint32_t>);
template std::vector<CodeLine> pseudocode<3>(const Session<3>&, std::optional<std::uint32_t>);

}  // namespace sightline
