// The table of techniques by region and direction (DAS figure 2): each entry worked out when it is first asked for, or
// all of them beforehand.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/methods/by_viewpoint/analyst.h"

namespace sightline {

/// An entry is a function of the problem, its region and its interval alone, so that it is the same whoever asks first
/// and whether or not it stood in a file: the table only saves time. Any thread may ask.
template <int D>
class ViewpointTable {
public:
    explicit ViewpointTable(ViewpointProblem<D> problem);

    const ViewpointProblem<D>& problem() const { return problem_; }
    const Regions<D>& regions() const { return problem_.regions; }
    const Directions<D>& directions() const { return problem_.directions; }
    std::size_t size() const { return entries_.size(); }
    std::size_t known() const { return known_; }  ///< entries that are worked out

    /// Where the entry of a view stands: region * directions().count() + interval. Total.
    std::size_t place(const Vec<D>& eye, const Vec<D>& forward) const {
        return std::size_t{regions().at(eye)} * directions().count() + directions().at(forward);
    }
    std::size_t place(const View<D>& view) const { return place(view.eye, view.look_at - view.eye); }
    std::uint32_t region_of(std::size_t place) const {
        return static_cast<std::uint32_t>(place / directions().count());
    }
    std::uint32_t interval_of(std::size_t place) const {
        return static_cast<std::uint32_t>(place % directions().count());
    }
    /// nullptr: not worked out so far.
    const Entry* find(std::size_t place) const { return entries_[place].load(std::memory_order_acquire); }
    /// Works it out where that has not been done.
    const Entry& at(std::size_t place) const;
    /// What a file has; one that is known stays as it is.
    void put(std::size_t place, Entry entry) const;

    /// Places from `first` to before `end`.
    struct Range {
        std::size_t first = 0, end = 0;
    };
    Range all() const { return {0, size()}; }
    Range of_region(std::uint32_t region) const {
        return {std::size_t{region} * directions().count(), std::size_t{region + 1} * directions().count()};
    }
    std::size_t known(const Range& range) const;  ///< entries of it that are worked out

    /// Works out what is not known, on up to `threads` threads (0: as many as the machine has). After each entry
    /// `done(known)` says, one thread at a time, whether to go on: what is known so far stays.
    void fill(int threads, const std::function<bool(std::size_t)>& done) const { fill(threads, done, all()); }
    void fill(int threads, const std::function<bool(std::size_t)>& done, const Range& range) const;
    std::size_t memory_bytes() const;

private:
    void work_out(std::size_t place, Analyst<D>& analyst) const;

    ViewpointProblem<D> problem_;
    mutable std::mutex mutex_;
    mutable std::vector<std::atomic<const Entry*>> entries_;
    mutable std::vector<std::unique_ptr<const Entry>> owned_;
    mutable std::atomic<std::size_t> known_ = 0;
};

/// The table that the problem's parameters ask for, made once for its scene; what the file of parameter `table` holds
/// is in it. `options`: the methods that can be chosen. Throws InputError for techniques that do not exist, and for a
/// file of another scene or other parameters.
template <int D>
std::shared_ptr<const ViewpointTable<D>> viewpoint_table(std::span<const Method<D>> methods, const Problem<D>& problem);

/// How many nodes and rows are left of a table when equal neighbours are merged (DAS 7): intervals of a region that
/// choose the same technique, then eight (2D: four) boxes whose rows are equal, as an octree would have them. Unknown
/// entries are equal to nothing.
struct MergedSize {
    std::size_t regions = 0;  ///< before
    std::size_t entries = 0;
    std::size_t merged_regions = 0;
    std::size_t merged_entries = 0;  ///< runs of equal intervals
};
template <int D>
MergedSize merged_size(const ViewpointTable<D>& table);

extern template class ViewpointTable<2>;
extern template class ViewpointTable<3>;

}  // namespace sightline
