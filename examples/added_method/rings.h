// A method of one's own that pops no cells: rings about the eye, each twice as wide as the one before.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/run/method.h"

/// One step is a round: it renders, in the order of the scene, what has its centroid within the next ring. It keeps no
/// marks, so that the timeline goes back by keyframes.
template <int D>
class Rings final : public sightline::Run<D> {
public:
    explicit Rings(const sightline::Problem<D>& problem) : sightline::Run<D>(problem) {
        for (const sightline::Primitive<D>& p : problem.primitives()) {
            sightline::Vec<D> sum(0);
            for (const auto& corner : p) sum += corner;
            const sightline::Vec<D> d = sum / double(D) - problem.view.eye;
            squares_.push_back(glm::dot(d, d));
            left_ += 1;
        }
        first_ = squares_.empty() ? 0 : *std::min_element(squares_.begin(), squares_.end()) * 4;
    }

    sightline::Stop run(std::uint32_t steps, sightline::Recorder* recorder) override {
        const std::uint64_t end = std::uint64_t{this->steps_} + steps;
        while (this->steps_ < end) {
            if (finished()) return left_ == 0 && !in_round_ ? sightline::Stop::front_empty : sightline::Stop::budget;
            if (!in_round_) {  // else the budget ended inside this one, and it goes on
                inner_ = outer_;
                outer_ = this->steps_ == 0 ? first_ : std::max(4 * outer_, 1e-300);
                this->counters_.offset = 0;
                in_round_ = true;
                if (recorder) recorder->popped({this->steps_, sightline::Kind::round}, {std::sqrt(outer_)});
                ++this->steps_;
            }
            in_round_ = !render_ring();
            if (recorder) recorder->finished(this->counters_);
        }
        return sightline::Stop::steps;
    }
    bool finished() const override {
        return this->counters_.spent >= this->problem_.budget || (left_ == 0 && !in_round_);
    }
    std::unique_ptr<sightline::Run<D>> clone() const override { return std::make_unique<Rings>(*this); }
    std::size_t memory_bytes() const override {
        return squares_.capacity() * sizeof(double) + this->drawn_.memory_bytes();
    }
    std::uint64_t hash() const override {
        sightline::Hash hash;
        hash.add(outer_);
        add_run(hash, *this);
        return hash.value();
    }
    std::string popped_words(const sightline::Step& step) const override {
        return "round " + std::to_string(step.item.id + 1);
    }

private:
    /// False when the budget ended inside it.
    bool render_ring() {
        std::uint32_t& next = this->counters_.offset;
        for (; next < squares_.size(); ++next) {
            const bool inside = squares_[next] <= outer_ && (this->steps_ == 1 || squares_[next] > inner_);
            if (!inside) continue;
            if (!this->meet(next, true)) return false;
            --left_;
        }
        return true;
    }

    std::vector<double> squares_;  ///< per primitive: distance of its centroid from the eye, squared
    double first_ = 0;             ///< of the first ring, squared
    double inner_ = 0, outer_ = 0;
    std::size_t left_ = 0;  ///< primitives that no ring has reached
    bool in_round_ = false;
};

template <int D>
sightline::Method<D> rings_method() {
    sightline::Method<D> method{"rings", "rings", "primitives ring by ring about the eye",
                                [](const sightline::Problem<D>& problem) -> std::unique_ptr<sightline::Run<D>> {
                                    return std::make_unique<Rings<D>>(problem);
                                }};
    method.pops = sightline::Kind::round;
    method.needs.cells = false;
    method.parameters = {&sightline::culled_cost_row()};
    return method;
}
