// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/extinction/extinction.h"

#include "core/base/number.h"

namespace sightline {

KeyExplanation explain_extinction(const ExtinctionTerms& t, int digits) {
    const auto text = [&](double v) { return short_number(v, digits); };
    const double passed = t.depth * t.way;
    KeyExplanation e;
    e.key = t.key;
    e.parts = {{"depth = "},
               {text(t.handed_on), KeyAbout::handed_on, "handed on"},
               {" + "},
               {text(t.depth), KeyAbout::content, "extinction"},
               {" · "},
               {text(t.way), KeyAbout::angle, "way"},
               {" = " + text(t.key)}};
    e.tip =
        "the depth handed on by the cell it was reached from, plus that cell's extinction, 2 area / surface, times the "
        "way of the eye ray in it over its mean chord";
    e.weightiest = t.key == 0              ? "only its stamp: nothing lies between it and the eye"
                   : passed >= t.handed_on ? "the cell that it was reached from (" + text(passed) + "): extinction " +
                                                 text(t.depth) + " over a way of " + text(t.way) + " mean chords"
                                           : "what was handed on (" + text(t.handed_on) +
                                                 "): the depth from the eye to the cell that it "
                                                 "was reached from";
    e.terms = {{"depth_a", t.handed_on, {}}, {"extinction", t.depth, {}}, {"way", t.way, {}}, {"key", t.key, {}}};
    return e;
}

void add_extinction_lines(std::vector<CodeLine>& lines, const KeyExplanation* e, int digits) {
    const auto value = [&](std::size_t term) { return e ? short_number(e->terms[term].value, digits) : std::string(); };
    lines.push_back({"key(n, c): the optical depth from the eye to n, behind c", 0, false, {}, {}});
    lines.push_back({"extinction = 2 · area of the primitives in c / surface of c", 1, false, value(1),
                     "Cauchy: what a line through c meets in the mean"});
    lines.push_back({"way = length in c of the ray from the eye to the facet / mean chord of c", 1, false, value(2),
                     "gem, discussion"});
    lines.push_back({"the key is that of c + extinction · way", 1, false, {}, "gem, discussion"});
    if (!e) return;
    const std::string sum = e->sum();
    lines.back().values = sum.substr(sum.find('=') + 2);
}

}  // namespace sightline
