// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/transmittance/transmittance.h"

#include "core/base/number.h"

namespace sightline {

const ParameterRow& maximise_row() {
    static const ParameterRow row =
        choice_row("maximise", Maximise::count, "docs/methods.md, tri",
                   "what comes early: many visible primitives, or those that show at many pixels");
    return row;
}

const ParameterRow& transport_row() {
    static const ParameterRow row =
        choice_row("transport", LightTransport::usual, "docs/methods.md, flux",
                   "how light comes into a cell: through facets from projected cells, or to its corners (short "
                   "characteristics); usual: corners for tri in 3D, else facets");
    return row;
}

KeyExplanation explain_light(const LightTerms& t, int digits) {
    const auto number = [&](double v) { return short_number(v, digits); };
    KeyExplanation e;
    e.key = t.shade;
    e.parts = {{"1 − T = 1 − ("},
               {number(t.share), KeyAbout::angle, "share"},
               {" · "},
               {number(t.handed_on), KeyAbout::handed_on, "handed on"},
               {" · (1 − "},
               {number(t.opacity), KeyAbout::content, "opacity"},
               {") + "},
               {number(t.others), KeyAbout::own, "other facets"},
               {") = " + number(e.key)}};
    e.tip =
        "share of the light that this facet lets in, times the transmittance handed on, times what the cell before "
        "leaves open, plus what comes through the other facets";
    e.weightiest = weightiest_of(t);
    e.terms = {{"share", t.share, {}},   {"handed_on", t.handed_on, {}},           {"opacity", t.opacity, {}},
               {"others", t.others, {}}, {"transmittance", t.transmittance(), {}}, {"key", e.key, {}}};
    return e;
}

std::string weightiest_of(const LightTerms& t) {
    const double arrives = t.share * t.handed_on * (1 - t.opacity);
    if (t.shade == 0) return "nothing is in the way: all its light has come";
    const double missing = 1 - t.share - t.others, kept = t.share - arrives;
    if (kept >= missing)
        return "what the cell before keeps back (" + short_number(kept) + " of the light): its transmittance is " +
               short_number(t.handed_on) + ", and " + short_number(t.opacity) + " of it is covered";
    return "light that its other facets keep back or have not let in yet (" + short_number(missing) + ")";
}

void add_term_line(std::vector<CodeLine>& lines, std::string text, const KeyExplanation* e, std::string_view name,
                   int digits) {
    lines.push_back({std::move(text), 1, false, {}, {}});
    if (!e) return;
    for (const Term& term : e->terms)
        if (term.name == name) lines.back().values = short_number(term.value, digits);
}

void add_light_lines(std::vector<CodeLine>& lines, const KeyExplanation* e, int digits) {
    add_term_line(lines, "share = angle of the facet / angle of all facets of n that turn to the eye", e, "share",
                  digits);
    add_term_line(lines, "opacity = covered share of c, as the eye sees it", e, "opacity", digits);
    add_term_line(lines, "others = the same sum over the other facets of n", e, "others", digits);
    add_term_line(lines, "T = share · T of c · (1 − opacity) + others", e, "transmittance", digits);
}

}  // namespace sightline
