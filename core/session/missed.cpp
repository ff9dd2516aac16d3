// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/missed.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/run/drawn_levels.h"

namespace sightline {

std::string range_words(int first, int last, const std::string& what) {
    if (first == last) return what + " " + std::to_string(first);
    return what + "s " + std::to_string(first) + " to " + std::to_string(last);
}

template <int D>
Missed missed_by(const Session<D>& session) {
    const Reference& reference = session.reference();
    const std::vector<std::uint8_t> rendered = found_mask(session.traversal());
    const IdImage& exact = reference.image;
    const std::vector<std::uint32_t>& pixels = reference.pixels;
    Missed missed;
    missed.pixels = exact.ids.size();
    missed.regions = wrong_regions(exact, session.wrong_mask());
    for (const WrongRegion& region : missed.regions) missed.wrong += region.pixels;
    for (std::uint32_t p = 0; p < rendered.size(); ++p)
        if (!rendered[p] && (reference.visible[p] || pixels[p] > 0)) missed.primitives.push_back({p, pixels[p]});
    std::stable_sort(missed.primitives.begin(), missed.primitives.end(),
                     [](const PixelCount& a, const PixelCount& b) { return a.pixels > b.pixels; });
    return missed;
}

template <int D>
std::string region_words(const WrongRegion& region) {
    std::string text = counted(region.pixels, "pixel") + ", " + range_words(region.box[0], region.box[1], "column");
    if (D == 3) text += ", " + range_words(region.box[2], region.box[3], "row");
    return text;
}

template <int D>
std::string primitive_name(const Scene<D>& scene, std::uint32_t primitive) {
    const std::string name = (D == 2 ? "segment " : "triangle ") + std::to_string(primitive);
    return scene.objects.empty() ? name : name + " (" + scene.objects.names[scene.objects.of[primitive]] + ")";
}

#define SIGHTLINE_INSTANTIATE(D)                              \
    template Missed missed_by<D>(const Session<D>&);          \
    template std::string region_words<D>(const WrongRegion&); \
    template std::string primitive_name<D>(const Scene<D>&, std::uint32_t);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
