// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/label_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sightline {

namespace {

bool share_room(const Box<2>& a, const Box<2>& b) {
    return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

struct Leader {
    Vec<2> from{}, to{};
};

bool runs_through(const Leader& line, const Box<2>& box) {
    double enter = 0, leave = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double d = line.to[axis] - line.from[axis], low = box.min[axis] - line.from[axis],
                     high = box.max[axis] - line.from[axis];
        if (d == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        enter = std::max(enter, std::min(low / d, high / d));
        leave = std::min(leave, std::max(low / d, high / d));
    }
    return enter <= leave;
}

bool lines_cross(const Leader& p, const Leader& q) {
    const auto side = [](const Leader& line, const Vec<2>& at) {
        const Vec<2> d = line.to - line.from, e = at - line.from;
        return d.x * e.y - d.y * e.x;
    };
    return (side(p, q.from) > 0) != (side(p, q.to) > 0) && (side(q, p.from) > 0) != (side(q, p.to) > 0);
}

/// Boxes by the tiles of a grid that they touch.
class TakenPlaces {
public:
    explicit TakenPlaces(const Box<2>& frame)
        : low_(frame.min),
          columns_(count(frame.extent().x)),
          rows_(count(frame.extent().y)),
          tiles_(columns_ * rows_) {}

    /// The first box that shares room with this one.
    const Box<2>* at(const Box<2>& box) const {
        const Box<2>* found = nullptr;
        visit(box, [&](std::size_t tile) {
            for (const Box<2>& other : tiles_[tile])
                if (!found && share_room(box, other)) found = &other;
        });
        return found;
    }
    void take(const Box<2>& box) {
        visit(box, [&](std::size_t tile) { tiles_[tile].push_back(box); });
        all_.push_back(box);
    }
    const std::vector<Box<2>>& all() const { return all_; }

private:
    static constexpr double side = 64;
    static std::size_t count(double extent) {
        return static_cast<std::size_t>(std::clamp(std::ceil(extent / side), 1.0, 512.0));
    }
    template <typename F>
    void visit(const Box<2>& box, F f) const {
        const auto tile = [](double at, std::size_t most) {
            return static_cast<std::size_t>(std::clamp(at / side, 0.0, static_cast<double>(most - 1)));
        };
        const std::size_t x1 = tile(box.max.x - low_.x, columns_), y1 = tile(box.max.y - low_.y, rows_);
        for (std::size_t y = tile(box.min.y - low_.y, rows_); y <= y1; ++y)
            for (std::size_t x = tile(box.min.x - low_.x, columns_); x <= x1; ++x) f(y * columns_ + x);
    }

    Vec<2> low_;
    std::size_t columns_, rows_;
    std::vector<std::vector<Box<2>>> tiles_;
    std::vector<Box<2>> all_;
};

/// Where a label may stand, in shares of its room: at its point, or else a little beside it. The order is fixed.
constexpr std::array<std::array<double, 2>, 13> shifts{{{0, 0},
                                                        {0, -0.5},
                                                        {0, 0.5},
                                                        {-0.5, 0},
                                                        {0.5, 0},
                                                        {0, -1},
                                                        {0, 1},
                                                        {-1, 0},
                                                        {1, 0},
                                                        {-0.7, -0.7},
                                                        {0.7, -0.7},
                                                        {-0.7, 0.7},
                                                        {0.7, 0.7}}};

/// Of so many places, evenly spread over the frame, one is sought for a label that must move.
constexpr double places_to_try = 4000;
/// Points by which a leader may be longer before a label takes its next form.
constexpr double form_cost = 12;

class Pass {
public:
    Pass(std::span<const Label> labels, const LabelGround& ground, std::span<const Box<2>> taken, LabelMemory* memory)
        : labels_(labels), ground_(ground), memory_(memory), places_(ground.frame) {
        for (const Box<2>& box : taken) places_.take(box);
    }

    std::vector<StandingLabel> run() {
        std::vector<std::size_t> must, later;
        for (std::size_t i = 0; i < labels_.size(); ++i)
            if (!labels_[i].yields) must.push_back(i);
        if (ground_.keep_apart)
            std::stable_sort(must.begin(), must.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
        for (const std::size_t i : must) {
            const ShownLabel* const before = remembered(labels_[i]);
            if (!within_room(i, before ? before->shift : 0) && ground_.keep_apart && !labels_[i].fixed) move(i);
        }
        for (std::size_t i = 0; i < labels_.size(); ++i) {
            if (!labels_[i].yields) continue;
            if (const ShownLabel* const before = remembered(labels_[i]))
                within_room(i, before->shift);
            else
                later.push_back(i);
        }
        for (const std::size_t i : later) within_room(i, 0);
        if (memory_) {
            std::sort(shown_.begin(), shown_.end());
            *memory_ = std::move(shown_);
        }
        return std::move(standing_);
    }

private:
    /// Labels whose place says most come first.
    int rank(std::size_t i) const {
        const Label& label = labels_[i];
        return label.fixed ? 0 : label.disc ? 1 : label.leader ? 2 : 3;
    }

    const ShownLabel* remembered(const Label& label) const {
        if (!memory_) return nullptr;
        const auto found = std::lower_bound(memory_->begin(), memory_->end(), ShownLabel{label.at.x, label.at.y, 0});
        return found != memory_->end() && found->x == label.at.x && found->y == label.at.y ? &*found : nullptr;
    }

    std::optional<Vec<2>> anchor_of(const Label& label) const {
        const Vec<2> anchor = ground_.to_paper(label.at), slack(ground_.slack);
        const Box<2> frame{ground_.frame.min - slack, ground_.frame.max + slack};
        return frame.contains(anchor) ? std::optional(anchor) : std::nullopt;
    }

    /// What leads from a box to its anchor, or to the border of what lies over that.
    std::optional<Leader> leader(const Box<2>& box, const Vec<2>& anchor) const {
        if (box.contains(anchor)) return std::nullopt;
        Leader line{leader_start(box, anchor), anchor};
        if (const Box<2>* over = places_.at({anchor, anchor})) {
            const Vec<2> rim(ground_.pt);
            line.to = leader_start({over->min - rim, over->max + rim}, line.from);
        }
        return line;
    }

    bool is_free(const Box<2>& box) const {
        if (places_.at(box)) return false;
        return std::none_of(leaders_.begin(), leaders_.end(), [&](const Leader& l) { return runs_through(l, box); });
    }
    bool is_clear(const Leader& line, bool may_cross) const {
        if (!may_cross &&
            std::any_of(leaders_.begin(), leaders_.end(), [&](const Leader& l) { return lines_cross(l, line); }))
            return false;
        return std::none_of(places_.all().begin(), places_.all().end(),
                            [&](const Box<2>& box) { return runs_through(line, box); });
    }

    void stand(std::size_t i, std::size_t form, const Vec<2>& anchor, const Box<2>& box, bool with_leader,
               std::size_t shift) {
        const auto line = with_leader ? leader(box, anchor) : std::nullopt;
        standing_.push_back({i, form, anchor, line ? line->to : anchor, box, line.has_value()});
        if (line) leaders_.push_back(*line);
        places_.take(box);
        if (memory_) shown_.push_back({labels_[i].at.x, labels_[i].at.y, shift});
    }

    /// From this one of its places on; false where none is free.
    bool within_room(std::size_t i, std::size_t first) {
        const Label& label = labels_[i];
        const auto anchor = anchor_of(label);
        if (!anchor) return true;  // it has no place to begin with
        const auto size = ground_.size(label, 0);
        if (!size) return true;
        const double room = label.room > 0 ? ground_.to_paper(label.at + Vec<2>(label.room, 0)).x - anchor->x : 0;
        const std::size_t count = room > ground_.least_room ? shifts.size() : 1;  // less would not help
        const Vec<2> offset = Vec<2>(label.offset_pt.x, -label.offset_pt.y) * ground_.pt;
        if (!is_finite<2>(*anchor + offset)) return true;
        const bool tested = label.yields || ground_.keep_apart;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t shift = (first + k) % count;
            const Vec<2> to = *anchor + Vec<2>(shifts[shift][0], shifts[shift][1]) * room;
            const Box<2> box = label_box(label, to + offset, *size, ground_.frame);
            if (tested && !(ground_.keep_apart ? is_free(box) : !places_.at(box))) continue;
            if (ground_.keep_apart && label.leader)
                if (const auto line = leader(box, *anchor); line && !is_clear(*line, false)) continue;
            stand(i, 0, *anchor, box, label.leader, shift);
            return true;
        }
        return false;
    }

    /// To the free place from which the leader is shortest, in its first form if that is not much farther.
    void move(std::size_t i) {
        const Label& label = labels_[i];
        const Vec<2> anchor = *anchor_of(label), room = ground_.frame.extent();
        const double step = std::max(2 * ground_.pt, std::sqrt(room.x * room.y / places_to_try));
        const double least = 5 * ground_.pt;  // so long that one sees where it leads
        struct Place {
            double cost;
            std::size_t form;
            Box<2> box;
        };
        std::vector<Place> places;
        for (std::size_t form = 0; const auto size = ground_.size(label, form); ++form) {
            const Vec<2> extent = label_box(label, ground_.frame.centre(), *size, ground_.frame).extent();
            for (double y = ground_.frame.min.y; y + extent.y <= ground_.frame.max.y; y += step)
                for (double x = ground_.frame.min.x; x + extent.x <= ground_.frame.max.x; x += step) {
                    const Box<2> box{{x, y}, Vec<2>(x, y) + extent};
                    const double length = glm::length(anchor - glm::clamp(anchor, box.min, box.max));
                    if (length >= least)
                        places.push_back({length + static_cast<double>(form) * form_cost * ground_.pt, form, box});
                }
        }
        std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.cost < b.cost; });
        for (const bool may_cross : {false, true})
            for (const Place& place : places) {
                if (!is_free(place.box)) continue;
                if (const auto line = leader(place.box, anchor); !line || !is_clear(*line, may_cross)) continue;
                return stand(i, place.form, anchor, place.box, true, 0);
            }
    }

    std::span<const Label> labels_;
    const LabelGround& ground_;
    LabelMemory* memory_;
    TakenPlaces places_;
    std::vector<Leader> leaders_;
    std::vector<StandingLabel> standing_;
    LabelMemory shown_;
};

}  // namespace

std::vector<StandingLabel> stand_labels(std::span<const Label> labels, const LabelGround& ground,
                                        std::span<const Box<2>> taken, LabelMemory* memory) {
    return Pass(labels, ground, taken, memory).run();
}

}  // namespace sightline
