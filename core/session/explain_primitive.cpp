// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/explain_primitive.h"

#include <algorithm>

namespace sightline {

template <int D>
PrimitiveExplanation explain_primitive(const Session<D>& session, std::uint32_t primitive) {
    PrimitiveExplanation e;
    e.primitive = primitive;
    e.visible = session.reference().visible[primitive] != 0;
    const CellComplex<D>& cells = session.cells();
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        const auto held = cells.primitives_of(cell);
        if (std::find(held.begin(), held.end(), primitive) != held.end()) e.cells.push_back(cell);
    }
    const Session<D> end = copy_at(session, session.recorded());
    const auto met = end.met();
    for (std::uint32_t i = 0; i < met.size(); ++i) {
        if (met[i].primitive() != primitive) continue;
        e.culled = met[i].culled();
        const auto& steps = end.timeline().steps;
        const auto step =
            std::find_if(steps.begin(), steps.end(), [i](const Step& s) { return s.after.touched_count > i; });
        e.met_at = static_cast<std::uint32_t>(step - steps.begin()) + 1;
    }
    return e;
}

template <int D>
std::string sentence(const PrimitiveExplanation& e, std::uint32_t position) {
    std::string text = (D == 2 ? "Segment " : "Triangle ") + std::to_string(e.primitive);
    text += e.visible ? " is visible; " : " is hidden; ";
    if (e.met_at == 0)
        text += "no step of the recorded run meets it";
    else if (e.culled)
        text += "step " + std::to_string(e.met_at) + " finds it outside the view";
    else
        text += "step " + std::to_string(e.met_at) + (e.met_at <= position ? " rendered it" : " will render it");
    text += e.cells.empty()       ? "; it lies in no cell"
            : e.cells.size() == 1 ? "; it lies in cell "
                                  : "; it lies in cells ";
    for (std::size_t i = 0; i < e.cells.size(); ++i)
        text += (i == 0 ? "" : i + 1 == e.cells.size() ? " and " : ", ") + std::to_string(e.cells[i]);
    return text + ".";
}

template PrimitiveExplanation explain_primitive<2>(const Session<2>&, std::uint32_t);
template PrimitiveExplanation explain_primitive<3>(const Session<3>&, std::uint32_t);
template std::string sentence<2>(const PrimitiveExplanation&, std::uint32_t);
template std::string sentence<3>(const PrimitiveExplanation&, std::uint32_t);

}  // namespace sightline
