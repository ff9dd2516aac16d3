// Explanations as JSON: where a cell stands and why, how a primitive is seen, and what one change would do.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/session/explain.h"
#include "core/session/explain_primitive.h"

namespace sightline {

/// One object: scene, method, step, the explanation, and "changes", a row for each counterfactual. Numbers of steps
/// that there are not are null; docs/debugging.md lists the fields.
template <int D>
std::string explanation_json(const Session<D>& session, const CellExplanation& cell, const Counterfactuals& changes);
template <int D>
std::string explanation_json(const Session<D>& session, const PrimitiveExplanation& primitive,
                             const Counterfactuals& changes);

}  // namespace sightline
