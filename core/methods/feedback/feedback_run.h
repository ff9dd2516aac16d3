// Boxes against a small picture of what is drawn so far: what that covers is postponed, not dropped.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/transmittance/transmittance_parameters.h"
#include "core/run/front.h"
#include "core/run/marks.h"
#include "core/run/method.h"
#include "core/run/screen.h"

namespace sightline {

/// The width of the picture as a share of the reference's.
const ParameterRow& detail_row();

/// Change::rule.
enum class FeedbackRule : std::uint8_t {
    enqueued,   ///< a half of the popped box: now in the front
    outside,    ///< the popped box: lies outside the view
    covered,    ///< the popped box: nothing in it lies before what is drawn; postponed
    opened,     ///< the popped box: its halves come into the front
    drawn,      ///< the popped box: its primitives are drawn into the picture, and those that show are rendered
    postponed,  ///< a primitive that shows at few pixels, with maximise=pixels: it waits until the front is empty
    late,       ///< the box was postponed; the front is empty: its primitives in view are rendered
    too_thin,   ///< the popped box: in view, but covers no pixel of the picture; postponed
};
inline constexpr auto feedback_rule_words = std::to_array<std::string_view>(
    {"enqueued", "outside the view", "covered: postponed", "may be seen: opened", "may be seen: drawn",
     "postponed: few pixels", "rendered late", "no pixel in the small picture: postponed"});

/// `tri-z`. Items are boxes of the tree, nearest first; with maximise=pixels, squared distance over the square root of
/// the largest size in the box. A box that may be seen is opened, or drawn: its primitives that win a pixel of the
/// picture are rendered, and those that are too small to win one where nothing covers them. When the front is empty
/// there follow, batch by batch, what was postponed for its few pixels, the most pixels first; boxes that cover no
/// pixel of the picture; batch by batch what was drawn and won none; and boxes that were covered. Boxes come nearest
/// first. So the order has all that is in view.
template <int D>
class FeedbackRun final : public Run<D> {
public:
    using Run<D>::mark;

    explicit FeedbackRun(const Problem<D>& problem);

    bool restart(const Problem<D>&) override;
    Stop run(std::uint32_t steps, Recorder*) override;
    bool finished() const override;
    std::unique_ptr<Run<D>> clone() const override { return std::make_unique<FeedbackRun>(*this); }
    std::size_t memory_bytes() const override;
    std::uint64_t hash() const override;
    Mark mark(const Item& item) const override { return item.kind == Kind::node ? marks_[item.id] : Mark{}; }
    std::vector<std::pair<Item, Mark>> front() const override { return waiting_items(marks_, Kind::node); }
    Misses misses() const override;
    bool postpones() const override { return true; }
    ImageSize deciding_size() const override { return small_problem_.services.image; }
    std::span<const std::uint32_t> drawn_ahead() const override { return small_; }
    const BoxTree<D>* boxes() const override { return tree_; }
    std::uint64_t tests() const override { return tests_; }

    std::string_view rule_words(std::uint8_t rule) const override { return feedback_rule_words[rule]; }
    std::string popped_words(const Step&) const override;
    Verdict why_not(const Item&) const override;
    std::optional<KeyExplanation> key_terms(const Item&, int digits) const override;
    std::vector<CodeLine> code(const CodePlace&) const override;

private:
    /// Boxes between two refreshes of what they are tested against: four cost no more than one and say as much as all.
    static constexpr std::uint32_t refresh = 4;
    static constexpr std::uint32_t batch = 32;
    /// With maximise=pixels, what covers fewer pixels of the reference is postponed.
    static constexpr double few_pixels = 64;

    void begin_boxes();
    void enqueue(std::uint32_t node, Recorder*);
    double key_of(std::uint32_t node) const;
    Stop step(Recorder*);
    void pop(const Front::Entry& entry, Recorder*);
    void draw(std::uint32_t node, Recorder*);
    FeedbackRule rule_without_pixels(std::uint32_t node) const;
    Stop render_box(std::uint32_t node, Recorder*);
    /// Renders what is ready; false where the budget ends it.
    bool render_ready();
    /// The front is empty: what was postponed, in batches.
    void begin_late();
    Stop render_late(Recorder*);
    bool late_left() const;
    bool is_small(std::uint32_t primitive) const;
    bool is_bare(std::uint32_t primitive) const;
    void sync();
    bool is_thin(std::uint32_t node) const;
    Verdict why_postponed(std::uint32_t primitive) const;

    const BoxTree<D>* tree_ = nullptr;
    Problem<D> small_problem_;  ///< with the size of the picture
    bool pixels_ = false;       ///< maximise=pixels
    bool reduced_ = false;      ///< the picture has fewer pixels than the reference
    double pixel_angle_ = 0;    ///< of the middle pixel of the reference: radians, 3D: steradians
    std::shared_ptr<const std::vector<float>> largest_;  ///< per node, for maximise=pixels

    Marks marks_;
    Front front_;
    std::uint64_t tests_ = 0;
    std::vector<std::uint32_t> ready_;  ///< to be rendered at once; [ready_next_, end) are left
    std::size_t ready_next_ = 0;
    std::vector<std::uint32_t> small_, lost_;  ///< postponed; drawn without winning a pixel
    bool is_late_ = false;
    std::vector<std::uint32_t> late_;  ///< small_ and lost_ in the order in which they are rendered
    /// Boxes that cover no pixel, and boxes that were covered, as they left the front: nearest first. From `next` on
    /// they are left.
    std::vector<std::uint32_t> thin_, covered_;
    std::size_t thin_next_ = 0, covered_next_ = 0;

    Screen<D> screen_;
    std::vector<Met> shown_;             ///< what the picture shows, in order
    std::uint32_t shown_refreshed_ = 0;  ///< and what boxes are tested against
    std::vector<SideSeen> facing_;       ///< scratch
    std::vector<std::uint32_t> found_;
};

extern template class FeedbackRun<2>;
extern template class FeedbackRun<3>;

template <int D>
Method<D> feedback_method();

}  // namespace sightline
