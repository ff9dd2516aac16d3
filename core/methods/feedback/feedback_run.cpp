// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/feedback/feedback_run.h"

#include <algorithm>
#include <cmath>

#include "core/methods/transmittance/light.h"
#include "core/raster/image_plane.h"
#include "core/run/make_steps.h"
#include "core/scene/view.h"

namespace sightline {

namespace {

/// Per node, that of the largest primitive in it.
template <int D>
std::vector<float> largest_sizes(const Scene<D>& scene, const BoxTree<D>& tree) {
    std::vector<float> largest(tree.nodes.size(), 0);
    for (std::size_t node = tree.nodes.size(); node-- > 0;) {
        const typename BoxTree<D>::Node& at = tree.nodes[node];
        if (at.first_child != none) {
            largest[node] = std::max(largest[at.first_child], largest[at.first_child + 1]);
            continue;
        }
        for (const std::uint32_t primitive : tree.primitives_of(static_cast<std::uint32_t>(node)))
            largest[node] = std::max(largest[node], static_cast<float>(primitive_size(scene.primitives[primitive])));
    }
    return largest;
}

/// What the primitive fills of what the eye sees, for a small one.
double angle_of_primitive(const Vec<2>& eye, const Primitive<2>& segment) {
    const Vec<2> along = segment[1] - segment[0], away = (segment[0] + segment[1]) * 0.5 - eye;
    return std::abs(cross(along, away)) / glm::dot(away, away);
}
double angle_of_primitive(const Vec<3>& eye, const Primitive<3>& t) {
    const Vec<3> across = glm::cross(t[1] - t[0], t[2] - t[0]), away = (t[0] + t[1] + t[2]) / 3.0 - eye;
    const double squared = glm::dot(away, away);
    return 0.5 * std::abs(glm::dot(across, away)) / (squared * std::sqrt(squared));
}

/// That of the image, over its pixels: as if all were as far from the eye as the middle one.
double angle_of_pixel(const View<2>& view, const ImageSize& size) {
    if (view.all_round) return 6.283185307179586 / size.width;
    const Vec<2> middle = (view.corners[0] + view.corners[1]) * 0.5 - view.eye;
    return glm::length(view.corners[1] - view.corners[0]) / glm::length(middle) / size.width;
}
double angle_of_pixel(const View<3>& view, const ImageSize& size) {
    const auto& c = view.corners;
    const Vec<3> middle = (c[0] + c[2]) * 0.5 - view.eye;
    return glm::length(glm::cross(c[1] - c[0], c[3] - c[0])) / glm::dot(middle, middle) / size.width / size.height;
}

ImageSize reduced(const ImageSize& size, double detail) {
    const auto part = [&](int pixels) { return std::max(1, static_cast<int>(pixels * detail + 0.5)); };
    return {part(size.width), size.height > 0 ? part(size.height) : size.height};
}

}  // namespace

const ParameterRow& detail_row() {
    static const ParameterRow row =
        number_row("detail", "0.5", 0.01, 1, "[0.01, 1]", "TVCG 7, TR 6",
                   "the width of the picture that boxes are tested against, as a share of the reference's; 1: exact");
    return row;
}

template <int D>
FeedbackRun<D>::FeedbackRun(const Problem<D>& problem) : Run<D>(problem) {
    begin_boxes();
}

template <int D>
bool FeedbackRun<D>::restart(const Problem<D>& problem) {
    this->begin(problem);
    begin_boxes();
    return true;
}

template <int D>
void FeedbackRun<D>::begin_boxes() {
    const Problem<D>& problem = this->problem_;
    pixels_ = problem.parameters.template choice<Maximise>(maximise_row()) == Maximise::pixels;
    const double detail = problem.parameters.number(detail_row());
    const ImageSize reference = image_size<D>(problem.services.image);
    reduced_ = detail < 1;
    pixel_angle_ = angle_of_pixel(problem.view, reference);
    small_problem_ = problem;
    small_problem_.services.image = reduced(reference, detail);
    tree_ = &problem.boxes();
    if (pixels_)
        largest_ = problem.cells->made->template of<std::vector<float>>(
            "largest of boxes", [&] { return largest_sizes(*problem.scene, *tree_); });
    marks_.begin(tree_->nodes.size());
    front_.clear();
    tests_ = 0;
    for (auto* const list : {&ready_, &small_, &lost_, &late_, &thin_, &covered_}) list->clear();
    ready_next_ = thin_next_ = covered_next_ = 0;
    is_late_ = false;
    screen_.forget();
    shown_.clear();
    shown_refreshed_ = 0;
    if (!tree_->nodes.empty()) enqueue(0, nullptr);
}

template <int D>
double FeedbackRun<D>::key_of(std::uint32_t node) const {
    const double squared = squared_distance(tree_->nodes[node].box, this->problem_.view.eye);
    return pixels_ ? squared / std::sqrt(std::max<double>((*largest_)[node], 1e-300)) : squared;
}

template <int D>
void FeedbackRun<D>::enqueue(std::uint32_t node, Recorder* recorder) {
    const Mark mark{key_of(node), this->counters_.next_stamp, CellState::enqueued};
    if (recorder)
        recorder->changed({node, Kind::node}, marks_[node], static_cast<std::uint8_t>(FeedbackRule::enqueued));
    marks_.set(node, mark);
    front_.push({mark.key, mark.stamp, node});
    ++this->counters_.next_stamp;
    ++this->counters_.front_size;
}

template <int D>
bool FeedbackRun<D>::late_left() const {
    if (thin_next_ < thin_.size() || covered_next_ < covered_.size()) return true;
    return is_late_ ? this->counters_.offset < late_.size() : !small_.empty() || !lost_.empty();
}

template <int D>
bool FeedbackRun<D>::finished() const {
    return this->counters_.spent >= this->problem_.budget ||
           (this->counters_.front_size == 0 && ready_next_ == ready_.size() && !late_left());
}

template <int D>
Stop FeedbackRun<D>::run(std::uint32_t steps, Recorder* recorder) {
    return make_steps(this->steps_, steps, this->counters_, recorder, [&] { return step(recorder); });
}

template <int D>
Stop FeedbackRun<D>::step(Recorder* recorder) {
    Counters& counters = this->counters_;
    if (counters.spent >= this->problem_.budget) return Stop::budget;
    if (ready_next_ < ready_.size()) {
        render_ready();
        return Stop::none;
    }
    const Front::Entry* const top = front_.top([](const Front::Entry&) { return true; });
    if (!top) return render_late(recorder);
    const Front::Entry entry = *top;
    front_.pop();
    --counters.front_size;
    if (this->steps_ % refresh == 0) {
        sync();
        shown_refreshed_ = static_cast<std::uint32_t>(shown_.size());
        screen_.refresh();
    }
    ++this->steps_;
    if (recorder) {
        const Front::Entry* const second = front_.top([](const Front::Entry&) { return true; });
        recorder->popped({entry.id, Kind::node}, {entry.key, entry.stamp, CellState::projected},
                         second ? Item{second->id, Kind::node} : Item{}, second ? second->key : 0);
    }
    pop(entry, recorder);
    return Stop::none;
}

template <int D>
void FeedbackRun<D>::sync() {
    screen_.show(small_problem_, shown_, shown_refreshed_);
}

template <int D>
void FeedbackRun<D>::pop(const Front::Entry& entry, Recorder* recorder) {
    const std::uint32_t node = entry.id;
    const typename BoxTree<D>::Node& at = tree_->nodes[node];
    sync();
    ++tests_;
    const BoxSight sight = screen_.look(at.box);
    const bool leaf = at.first_child == none;
    const FeedbackRule rule = sight == BoxSight::outside  ? rule_without_pixels(node)
                              : sight == BoxSight::hidden ? FeedbackRule::covered
                              : leaf                      ? FeedbackRule::drawn
                                                          : FeedbackRule::opened;
    const Mark before{entry.key, entry.stamp, CellState::enqueued};
    Mark after = before;
    after.state = rule == FeedbackRule::outside                                     ? CellState::unseen
                  : rule == FeedbackRule::covered || rule == FeedbackRule::too_thin ? CellState::hidden
                                                                                    : CellState::projected;
    marks_.set(node, after);
    if (recorder) recorder->changed({node, Kind::node}, before, static_cast<std::uint8_t>(rule));
    if (rule == FeedbackRule::covered) covered_.push_back(node);
    if (rule == FeedbackRule::too_thin) thin_.push_back(node);
    if (rule == FeedbackRule::opened) {
        enqueue(at.first_child, recorder);
        enqueue(at.first_child + 1, recorder);
    }
    if (rule == FeedbackRule::drawn) draw(node, recorder);
}

/// It may lie in view all the same, between the centres of pixels, or where rounding hides it.
template <int D>
FeedbackRule FeedbackRun<D>::rule_without_pixels(std::uint32_t node) const {
    const auto corners = tree_->nodes[node].box.corners();
    return in_view(this->problem_.view, std::span<const Vec<D>>(corners)) ? FeedbackRule::too_thin
                                                                          : FeedbackRule::outside;
}

template <int D>
void FeedbackRun<D>::draw(std::uint32_t node, Recorder* recorder) {
    found_.clear();
    const auto primitives = tree_->primitives_of(node);
    tree_->tell_facing(node, this->problem_.view.eye, facing_);
    for (std::size_t i = 0; i < primitives.size(); ++i)
        if (facing_[i] == SideSeen::seen ||
            (facing_[i] == SideSeen::unsure && turns_a_seen_side(this->problem_, primitives[i])))
            found_.push_back(primitives[i]);
    if (found_.empty()) return;
    const auto won = screen_.draw(found_);
    for (std::size_t i = 0; i < found_.size(); ++i) {
        if (won[i]) shown_.emplace_back(found_[i], false);
        if (!won[i] && !(reduced_ && is_bare(found_[i]))) {
            lost_.push_back(found_[i]);
        } else if (pixels_ && is_small(found_[i])) {
            small_.push_back(found_[i]);
            if (recorder)
                recorder->changed(primitive_item(found_[i]), {}, static_cast<std::uint8_t>(FeedbackRule::postponed));
        } else {
            ready_.push_back(found_[i]);
        }
    }
    screen_.met(static_cast<std::uint32_t>(shown_.size()));
    render_ready();
}

template <int D>
bool FeedbackRun<D>::render_ready() {
    for (; ready_next_ < ready_.size(); ++ready_next_)
        if (!this->meet(ready_[ready_next_], true)) return false;
    ready_.clear();
    ready_next_ = 0;
    return true;
}

template <int D>
bool FeedbackRun<D>::is_small(std::uint32_t primitive) const {
    return angle_of_primitive(this->problem_.view.eye, this->problem_.primitives()[primitive]) <
           few_pixels * pixel_angle_;
}

/// Whether nothing that is drawn covers it, as far as a look at its middle tells.
template <int D>
bool FeedbackRun<D>::is_bare(std::uint32_t primitive) const {
    const Primitive<D>& p = this->problem_.primitives()[primitive];
    if constexpr (D == 2) {
        Box<2> box;
        for (const Vec<2>& corner : p) box.add(corner);
        return screen_.look(box) == BoxSight::seen;
    } else {
        const Vec<3> middle = image_plane(this->problem_.view).project((p[0] + p[1] + p[2]) / 3.0);
        if (!(middle.z > 0)) return false;
        const DepthImage& image = screen_.image().image();
        const double x = std::floor((middle.x / middle.z + 1) * 0.5 * image.width),
                     y = std::floor((1 - middle.y / middle.z) * 0.5 * image.height);
        if (!(x >= 0 && y >= 0 && x < image.width && y < image.height)) return false;
        return nearness_1 / middle.z >=
               static_cast<double>(image.nearness[image.index(static_cast<int>(x), static_cast<int>(y))]);
    }
}

/// What the picture shows most of first; what was covered since comes last of them.
template <int D>
void FeedbackRun<D>::begin_late() {
    is_late_ = true;
    if (!small_.empty()) {
        sync();
        std::vector<std::uint32_t> pixels(this->problem_.primitives().size());
        for (const std::uint32_t id : screen_.image().image().ids)
            if (id != none) ++pixels[id];
        std::stable_sort(small_.begin(), small_.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return pixels[a] > pixels[b]; });
    }
    late_ = small_;
    late_.insert(late_.end(), lost_.begin(), lost_.end());
}

template <int D>
Stop FeedbackRun<D>::render_late(Recorder* recorder) {
    Counters& counters = this->counters_;
    if (!is_late_) begin_late();
    const bool few_left = counters.offset < small_.size();
    if (!few_left && thin_next_ < thin_.size()) return render_box(thin_[thin_next_++], recorder);
    if (counters.offset < late_.size()) {
        ++this->steps_;
        if (recorder) recorder->popped({}, {});
        const std::size_t last = few_left && !thin_.empty() ? small_.size() : late_.size();
        const std::size_t end = std::min<std::size_t>(last, counters.offset + batch);
        ready_.assign(late_.begin() + counters.offset, late_.begin() + static_cast<std::ptrdiff_t>(end));
        counters.offset = static_cast<std::uint32_t>(end);
        render_ready();
        return Stop::none;
    }
    if (covered_next_ == covered_.size()) return Stop::front_empty;
    return render_box(covered_[covered_next_++], recorder);
}

template <int D>
Stop FeedbackRun<D>::render_box(std::uint32_t node, Recorder* recorder) {
    ++this->steps_;
    Mark mark = marks_[node];
    if (recorder) {
        recorder->popped({node, Kind::node}, {mark.key, mark.stamp, CellState::projected});
        recorder->changed({node, Kind::node}, mark, static_cast<std::uint8_t>(FeedbackRule::late));
    }
    mark.state = CellState::projected;
    marks_.set(node, mark);
    const auto primitives = tree_->primitives_of(node);
    ready_.assign(primitives.begin(), primitives.end());
    render_ready();
    return Stop::none;
}

template <int D>
std::size_t FeedbackRun<D>::memory_bytes() const {
    const std::size_t lists = ready_.capacity() + small_.capacity() + lost_.capacity() + late_.capacity() +
                              thin_.capacity() + covered_.capacity() + shown_.capacity();
    return marks_.memory_bytes() + this->drawn_.memory_bytes() + lists * sizeof(std::uint32_t);
}

template <int D>
std::uint64_t FeedbackRun<D>::hash() const {
    Hash hash;
    for (std::uint32_t node = 0; node < marks_.size(); ++node) add_mark(hash, marks_[node]);
    add_run(hash, *this);
    for (std::size_t i = ready_next_; i < ready_.size(); ++i) hash.add(ready_[i]);
    for (const auto* const list : {&small_, &lost_})
        for (const std::uint32_t primitive : *list) hash.add(primitive);
    for (const Met shown : shown_) hash.add(shown.bits());
    hash.add(shown_refreshed_);
    return hash.value();
}

template <int D>
Misses FeedbackRun<D>::misses() const {
    if (this->counters_.front_size > 0 || ready_next_ < ready_.size()) return Misses::may;
    if (!late_left()) return Misses::none;
    // With a picture as fine as the reference, what is left was covered or won no pixel.
    const bool shown = small_.empty() || (is_late_ && this->counters_.offset >= small_.size());
    return !reduced_ && shown ? Misses::none_at_this_resolution : Misses::may;
}

template <int D>
Method<D> feedback_method() {
    Method<D> row{
        "tri-z", "depth feedback",
        "nearest first against a small picture of what is drawn: what that covers is postponed",
        [](const Problem<D>& problem) -> std::unique_ptr<Run<D>> { return std::make_unique<FeedbackRun<D>>(problem); }};
    row.pops = Kind::node;
    row.needs.cells = false;
    row.needs.boxes = true;
    row.needs.image = true;
    row.parameters = {&maximise_row(), &detail_row()};
    return row;
}

template class FeedbackRun<2>;
template class FeedbackRun<3>;
template Method<2> feedback_method<2>();
template Method<3> feedback_method<3>();

}  // namespace sightline
