// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "core/base/error.h"
#include "lab/gallery/gallery_functions.h"

namespace sightline::lab {

namespace {

/// Primitives of one part: seen, rendered, both.
struct PartCounts {
    double visible = 0, rendered = 0, found = 0;
    double all_rendered = 0;  ///< of any part
};

template <int D>
PartCounts counts_of(const Probe<D>& p, CarPart part) {
    const std::span<const CarPart> parts = p.at.parts();
    if (parts.size() != p.at.scene().primitives.size())
        throw InputError(p.at.scene().id + ": it is not known which primitives are which part of a car");
    const Reference reference = p.at.truth(p.view, p.settings).reference;
    const OneRun run = ran(p);
    PartCounts counts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        counts.all_rendered += run.rendered[i];
        if (parts[i] != part) continue;
        counts.visible += reference.visible[i];
        counts.rendered += run.rendered[i];
        counts.found += reference.visible[i] && run.rendered[i];
    }
    return counts;
}

double share(double part, double whole) { return whole > 0 ? part / whole : std::numeric_limits<double>::quiet_NaN(); }

}  // namespace

template <int D>
double front_coverage(const Probe<D>& p) {
    const PartCounts front = counts_of(p, CarPart::front);
    return share(front.found, front.visible);
}

template <int D>
double back_coverage(const Probe<D>& p) {
    const PartCounts back = counts_of(p, CarPart::back);
    return share(back.found, back.visible);
}

template <int D>
double hidden_engine(const Probe<D>& p) {
    const PartCounts engine = counts_of(p, CarPart::engine);
    return share(engine.rendered - engine.found, engine.all_rendered);
}

#define SIGHTLINE_INSTANTIATE(D)                        \
    template double front_coverage<D>(const Probe<D>&); \
    template double back_coverage<D>(const Probe<D>&);  \
    template double hidden_engine<D>(const Probe<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline::lab
