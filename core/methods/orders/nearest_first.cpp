// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/orders/nearest_first.h"

namespace sightline {

namespace {

/// About as many are sorted at a time, so that they stay in a cache.
constexpr std::size_t shell_size = 1024;

/// Where x lies among `count` parts, for x of a part or more outside too; the last for what is no number.
std::uint32_t part_of(double x, std::uint32_t count) {
    return x < count ? x > 0 ? static_cast<std::uint32_t>(x) : 0 : count - 1;
}

}  // namespace

// Rounding is monotone, so a centroid in a box is never nearer than the box, and what is farther never lies in an
// earlier shell.

template <int D>
double NearestFirst<D>::least_distance2(const Box<D>& box) const {
    Vec<D> d(0);
    for (int i = 0; i < D; ++i) d[i] = std::max({box.min[i] - eye_[i], eye_[i] - box.max[i], 0.0});
    return glm::dot(d, d);
}

template <int D>
std::uint32_t NearestFirst<D>::shell_of(double distance2) const {
    return part_of((distance2 - low_) * shells_per_unit_, shell_count_);
}

template <int D>
void NearestFirst<D>::begin(const Problem<D>& problem) {
    groups_ = &centroid_groups_of(*problem.cells, *problem.scene);
    eye_ = problem.view.eye;
    if constexpr (D == 3) filter_ = ShownFilter(problem.view, groups_->triangles);
    const auto group_count = static_cast<std::uint32_t>(groups_->boxes.size());
    std::vector<double> least;
    least.reserve(group_count);
    low_ = std::numeric_limits<double>::infinity();
    double high = 0;
    for (const Box<D>& box : groups_->boxes) {
        least.push_back(least_distance2(box));
        const Vec<D> far = glm::max(glm::abs(box.min - eye_), glm::abs(box.max - eye_));
        low_ = std::min(low_, least.back());
        high = std::max(high, glm::dot(far, far));
    }
    shell_ = 0;
    shell_count_ = static_cast<std::uint32_t>(groups_->primitives.size() / shell_size + 1);
    shells_per_unit_ = shell_count_ / (high - low_);
    if (!std::isfinite(shells_per_unit_)) {  // all at one distance
        shells_per_unit_ = 0;
        shell_count_ = 1;
    }
    if (shells_.size() < shell_count_) shells_.resize(shell_count_);
    for (std::vector<Entry>& shell : shells_) shell.clear();
    group_begin_.assign(shell_count_ + 1, 0);
    for (const double distance2 : least) ++group_begin_[shell_of(distance2) + 1];
    for (std::size_t i = 1; i < group_begin_.size(); ++i) group_begin_[i] += group_begin_[i - 1];
    by_shell_.resize(group_count);
    ends_.assign(group_begin_.begin(), group_begin_.end() - 1);
    for (std::uint32_t group = 0; group < group_count; ++group) by_shell_[ends_[shell_of(least[group])]++] = group;
}

/// Its primitives go to their shells.
template <int D>
void NearestFirst<D>::open(std::uint32_t group) {
    const std::size_t first = std::size_t{group} * CentroidGroups<D>::group_size;
    const auto primitives = groups_->group(group);
    ShownFilter::Four shown;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        if constexpr (D == 3)
            if (i % 4 == 0) shown = filter_.of_four(&groups_->triangles.rows()[first + i]);
        const Vec<D> d = groups_->centroids[first + i] - eye_;
        const double distance2 = glm::dot(d, d);
        shells_[shell_of(distance2)].push_back({distance2, primitives[i], shown.at(i % 4)});
    }
}

template <int D>
bool NearestFirst<D>::extend(std::vector<std::uint32_t>& order, std::vector<Showing>& shown) {
    const std::size_t before = order.size();
    for (; shell_ < shell_count_ && order.size() == before; ++shell_) {
        for (std::uint32_t i = group_begin_[shell_]; i < group_begin_[shell_ + 1]; ++i) open(by_shell_[i]);
        std::vector<Entry>& entries = shells_[shell_];
        sort(entries, shell_);
        for (const Entry& entry : entries) {
            order.push_back(entry.primitive);
            shown.push_back(entry.shown);
        }
        entries.clear();
    }
    return order.size() > before;
}

/// Those of a shell: into as many parts of one width as there are entries, then each to its place among its nearest.
template <int D>
void NearestFirst<D>::sort(std::vector<Entry>& entries, double shell) {
    const auto by_order = [](const Entry& a, const Entry& b) { return a.before(b); };
    const auto count = static_cast<std::uint32_t>(entries.size());
    const auto place_of = [&](const Entry& entry) {
        return part_of(((entry.distance2 - low_) * shells_per_unit_ - shell) * count, count);
    };
    if (count < 2) return;
    ends_.assign(count + 1, 0);
    for (const Entry& entry : entries) ++ends_[place_of(entry) + 1];
    std::uint32_t most = 0;
    for (std::size_t i = 1; i < ends_.size(); ++i) {
        most = std::max(most, ends_[i]);
        ends_[i] += ends_[i - 1];
    }
    if (most > 64) return std::sort(entries.begin(), entries.end(), by_order);
    sorted_.resize(count);
    for (const Entry& entry : entries) sorted_[ends_[place_of(entry)]++] = entry;
    for (std::size_t i = 1; i < count; ++i) {
        const Entry entry = sorted_[i];
        std::size_t hole = i;
        for (; hole > 0 && entry.before(sorted_[hole - 1]); --hole) sorted_[hole] = sorted_[hole - 1];
        sorted_[hole] = entry;
    }
    entries.swap(sorted_);
}

template <int D>
std::size_t NearestFirst<D>::memory_bytes() const {
    std::size_t bytes = (group_begin_.capacity() + by_shell_.capacity() + ends_.capacity()) * sizeof(std::uint32_t) +
                        sorted_.capacity() * sizeof(Entry);
    for (const std::vector<Entry>& shell : shells_) bytes += shell.capacity() * sizeof(Entry);
    return bytes;
}

template class NearestFirst<2>;
template class NearestFirst<3>;

}  // namespace sightline
