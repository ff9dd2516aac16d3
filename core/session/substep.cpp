// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/substep.h"

namespace sightline {

template <int D>
std::uint32_t substep_count(const Session<D>& session, std::uint32_t step) {
    return session.traversal().substeps(session.timeline().steps[step - 1], session.timeline().changes_of(step));
}

template <int D>
Session<D> Session<D>::in_the_middle(std::uint32_t substep) const {
    Session copy = *this;
    const std::uint32_t step = position();
    if (step == 0 || substep + 1 >= substep_count(*this, step)) return copy;
    const auto changes = timeline_.changes_of(step);
    std::vector<Change> kept(changes.begin(), changes.end());
    // The record tells the same, so that words about the step do not run ahead.
    copy.run_->rewind_to(copy.timeline_.steps[step - 1], kept, timeline_.before(step), substep);
    copy.timeline_.shorten(step, kept);
    return copy;
}

template std::uint32_t substep_count<2>(const Session<2>&, std::uint32_t);
template std::uint32_t substep_count<3>(const Session<3>&, std::uint32_t);
template Session<2> Session<2>::in_the_middle(std::uint32_t) const;
template Session<3> Session<3>::in_the_middle(std::uint32_t) const;

}  // namespace sightline
