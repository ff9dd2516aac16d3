// All primitives of a scene, nearest centroid first, sorted no farther than they are asked for.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/problem.h"
#include "core/space/centroid_groups.h"

namespace sightline {

/// A value: a copy goes on by itself.
template <int D>
class NearestFirst {
public:
    /// From anew, with the memory that it has. The scene and the cells of the problem outlive it.
    void begin(const Problem<D>& problem);

    /// Appends the next ones to the order, by the squared distance of their centroids from the eye and then by number,
    /// and what is known of each: whether the view shows it. False: all are in it.
    bool extend(std::vector<std::uint32_t>& order, std::vector<Showing>& shown);

    std::size_t memory_bytes() const;

private:
    struct Entry {
        double distance2;
        std::uint32_t primitive;
        Showing shown;
        bool before(const Entry& other) const {
            return distance2 < other.distance2 || (distance2 == other.distance2 && primitive < other.primitive);
        }
    };

    std::uint32_t shell_of(double distance2) const;
    double least_distance2(const Box<D>& box) const;
    void open(std::uint32_t group);
    void sort(std::vector<Entry>& entries, double low);

    const CentroidGroups<D>* groups_ = nullptr;
    Vec<D> eye_{};
    ShownFilter filter_;
    /// Squared distances are cut into shells of one width; the first begins at `low`.
    double low_ = 0, shells_per_unit_ = 0;
    std::vector<std::vector<Entry>> shells_;
    std::vector<std::uint32_t> group_begin_, by_shell_;  ///< the groups that begin in each shell, in rows
    std::uint32_t shell_ = 0, shell_count_ = 0;          ///< the next one
    std::vector<Entry> sorted_;                          ///< scratch
    std::vector<std::uint32_t> ends_;                    ///< scratch
};

extern template class NearestFirst<2>;
extern template class NearestFirst<3>;

}  // namespace sightline
