// Step into: through a step substep by substep (core/session/substep.h).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shell/desk/workbench.h"

namespace sightline {

/// One substep forward; after the last one, or between two steps, into the next step. Says a word where the run ends.
template <int D>
void step_into(Workbench<D>& bench);

/// One substep back: what step_into did is undone. Between two steps all substeps of the last one are done; before
/// substep 0 the step is undone.
template <int D>
void step_out(Workbench<D>& bench);

/// The session as it is shown: the one on the bench, without a copy, or a copy in the middle of its step. Good until
/// the bench changes.
template <int D>
class ShownSession {
public:
    explicit ShownSession(const Workbench<D>& bench) : session_(&bench.session) {
        if (bench.substep) middle_ = bench.session.in_the_middle(*bench.substep);
    }
    const Session<D>& operator*() const { return middle_ ? *middle_ : *session_; }
    const Session<D>* operator->() const { return &**this; }

private:
    const Session<D>* session_;
    std::optional<Session<D>> middle_;
};

}  // namespace sightline
