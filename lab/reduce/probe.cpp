// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduce/probe.h"

#include <algorithm>

#include "core/measure/distance.h"
#include "core/measure/frame_change.h"
#include "core/measure/frame_numbers.h"
#include "core/measure/wrong_region.h"
#include "core/space/builders.h"
#include "core/truth/software_ids.h"
#include "core/truth/truth.h"
#include "lab/measure/measure_path.h"

namespace sightline::lab {

template <int D>
PartMeasures<D>::PartMeasures(const LabScene<D>& lab, const MethodChoice& method, const Budget& budget,
                              std::vector<Measure> used, const DrawIds& draw_ids)
    : lab_(lab),
      choice_(method),
      variant_(lab.variant_for(method)),
      settings_(lab.settings_for(method)),
      budget_(budget),
      used_(std::move(used)),
      draw_ids_(drawing_of(lab.settings.reference, draw_ids)) {
    const bool before = uses(Measure::pop) || uses(Measure::flip) || uses(Measure::visible_change);
    if (before && lab.views.size() > 1) views_.push_back(lab.views.size() - 2);
    views_.push_back(lab.views.size() - 1);
}

template <int D>
bool PartMeasures<D>::uses(Measure measure) const {
    return std::find(used_.begin(), used_.end(), measure) != used_.end();
}

template <int D>
Truth PartMeasures<D>::truth_of(std::size_t view, std::span<const std::uint32_t> kept, const Scene<D>& part,
                                const CellComplex<D>& cells, Seen& seen) {
    const bool deep = uses(Measure::zeta) || uses(Measure::fused);
    const bool by_cell =
        uses(Measure::mis_ranked) || uses(Measure::unreached) || uses(Measure::cell_oracle) || uses(Measure::key_rank);
    const View<D>& from = lab_.views[views_[view]];
    if constexpr (D == 3) {
        const auto image_of_part = [&]() -> IdImage {
            if (whole_) {
                IdImage image = whole_->images[view];
                bool same = true;
                for (const std::uint32_t id : kept) same &= whole_->kept[id] != 0;
                std::vector<std::uint32_t> number(lab_.scene->primitives.size(), none);
                for (std::uint32_t i = 0; i < kept.size(); ++i) number[kept[i]] = i;
                for (std::uint32_t& id : image.ids) {
                    if (id == none) continue;
                    id = number[id];
                    same &= id != none;
                }
                if (same) return image;
            }
            ++drawn_;
            return std::move(draw_ids_(part, from, image_size<3>(lab_.settings.reference_size), 1).front());
        };
        IdImage image = deep ? IdImage{} : image_of_part();
        if (!deep) {
            seen.images.push_back(image);
            for (std::uint32_t& id : seen.images.back().ids)
                if (id != none) id = kept[id];
        }
        if (!deep && by_cell)
            return {image_reference(std::move(image), part, cells, from),
                    std::make_shared<std::vector<std::uint32_t>>(part.primitives.size())};
        if (!deep) {
            Truth truth{{}, std::make_shared<std::vector<std::uint32_t>>(part.primitives.size())};
            Reference& reference = truth.reference;
            reference.pixels = pixels_of(image, part.primitives.size());
            reference.visible.resize(part.primitives.size());
            for (std::size_t i = 0; i < part.primitives.size(); ++i) {
                reference.visible[i] = reference.pixels[i] > 0;
                reference.count += reference.visible[i];
            }
            reference.image = std::move(image);
            return truth;
        }
        ++drawn_;
    }
    const CellComplex<D>* const on[] = {&cells};
    return std::move(make_truths<D>(part, on, from, lab_.settings.reference_size, draw_ids_, deep).front());
}

template <int D>
Values PartMeasures<D>::measure(std::span<const std::uint32_t> kept, const Scene<D>& part) {
    const auto seen = std::make_shared<Seen>();
    seen->kept.resize(lab_.scene->primitives.size());
    for (const std::uint32_t id : kept) seen->kept[id] = 1;
    const CellComplex<D> cells = build_cells(part, settings_);
    const auto count = static_cast<std::uint32_t>(part.primitives.size());
    const Method<D>& method = variant_.method;
    const std::uint32_t k = method.budgeted ? std::min(count, budget_.primitives(count)) : count;
    const bool inversions = uses(Measure::mis_ranked) || uses(Measure::unreached);
    Values values;
    std::vector<std::uint8_t> visible, rendered, wrong;
    for (std::size_t view = 0; view < views_.size(); ++view) {
        const std::size_t at = views_[view];
        Truth truth = truth_of(view, kept, part, cells, *seen);
        const Services services = known_services(std::make_shared<std::vector<std::uint8_t>>(truth.reference.visible),
                                                 lab_.settings.reference_size);
        Problem<D> problem = make_problem(method, variant_.parameters, part, cells, lab_.views[at], none, services);
        problem.budget = k;
        problem.history = frame_history<D>(method, problem, lab_.before[at]);
        const WholeRun run = whole_run<D>(method, problem, truth.reference, inversions, draw_ids_);
        const auto best = uses(Measure::cell_oracle) && method.orders_cells() ? cell_oracle<D>(truth.reference, problem)
                                                                              : std::nullopt;
        const auto now = rendered_by(run, cut_at(run, k).met, count);
        const auto wrong_now = wrong_by(run, truth.reference.image, now);
        values = frame_numbers(run, truth, k, now, wrong_now, best);
        if (view > 0) {
            if (const auto share = pop(visible, rendered, truth.reference.visible, now)) values[Measure::pop] = *share;
            values[Measure::flip] = difference(wrong, wrong_now);
            values[Measure::visible_change] = 1 - jaccard(visible, truth.reference.visible);
        }
        visible = std::move(truth.reference.visible);
        rendered = now;
        wrong = wrong_now;
    }
    last_ = seen->images.size() == views_.size() ? seen : nullptr;
    return values;
}

template class PartMeasures<2>;
template class PartMeasures<3>;

}  // namespace sightline::lab
