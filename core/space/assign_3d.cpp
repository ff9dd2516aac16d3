// Which cells a triangle meets. Tetrahedra: from the cell of a corner across facets; most triangles lie inside one
// cell and are done with it, the others cost what they cross. Leaves of an octree or a kd-tree: down the tree.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <string>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/base/workers.h"
#include "core/space/builders.h"
#include "core/space/triangle_test.h"

namespace sightline {

namespace {

class TetrahedronFlood {
public:
    explicit TetrahedronFlood(const CellComplex<3>& cells) : cells_(cells), reached_for_(cells.cell_count(), none) {}

    /// Forgets which cell was the last.
    void restart() { last_leaf_ = last_cell_ = none; }

    /// The cells that the triangle meets. They are linked through facets that it reaches, because both the triangle
    /// and the tessellation are convex: it does not matter where the flood begins.
    const std::vector<std::uint32_t>& cells_of(std::uint32_t primitive, const Primitive<3>& triangle) {
        found_.clear();
        if (cells_.cell_count() == 0) return found_;
        const TriangleTest test(triangle);
        const auto reach = [&](std::uint32_t cell) {
            if (reached_for_[cell] == primitive) return;
            reached_for_[cell] = primitive;
            const auto corners = cells_.corners_of(cell);
            const auto corner = [&](std::size_t i) { return cells_.points[corners[i]]; };
            const TriangleTest::Contact contact = test.with({corner(0), corner(1), corner(2), corner(3)});
            if (!contact.meets) return;
            found_.push_back(cell);
            reaches_.push_back(contact.reaches);
        };
        reaches_.clear();
        if (const std::uint32_t start = cell_of_a_corner(triangle); start != none) {
            reach(start);
        } else {
            for (const std::uint32_t cell : cells_.border_cells) reach(cell);
        }
        for (std::size_t i = 0; i < found_.size(); ++i) {
            const auto facets = cells_.facets_of(found_[i]);
            for (std::size_t f = 0; f < facets.size(); ++f)
                if (reaches_[i] >> f & 1 && facets[f].neighbour != none) reach(facets[f].neighbour);
        }
        return found_;
    }

private:
    std::uint32_t cell_of_a_corner(const Primitive<3>& triangle) {
        for (const Vec<3>& corner : triangle) {
            // Triangles that follow each other lie close together more often than not.
            const std::uint32_t leaf = cells_.tree.leaf_at(corner);
            const std::uint32_t cell = any_holding(cells_, corner, leaf == last_leaf_ ? last_cell_ : none);
            if (cell == none) continue;
            last_leaf_ = leaf;
            last_cell_ = cell;
            return cell;
        }
        return none;
    }

    const CellComplex<3>& cells_;
    std::vector<std::uint32_t> reached_for_;  ///< last primitive that tried the cell
    std::vector<std::uint32_t> found_;
    std::vector<std::uint8_t> reaches_;  ///< of the cells found, the facets that the triangle may reach
    std::uint32_t last_leaf_ = none, last_cell_ = none;
};

class TreeDescent {
public:
    explicit TreeDescent(const CellComplex<3>& cells) : tree_(cells.tree) {}

    void restart() {}
    const std::vector<std::uint32_t>& cells_of(std::uint32_t, const Primitive<3>& triangle) {
        found_.clear();
        const TriangleTest test(triangle);
        const Box<3>& root = tree_.root_box();
        descend(0, test, root.contains(test.bounds().min) && root.contains(test.bounds().max));
        return found_;
    }

private:
    /// inside: the triangle is known to lie in the node.
    void descend(std::uint32_t node, const TriangleTest& test, bool inside) {
        const Tree<3>::Node& at = tree_.nodes[node];
        if (!inside && !test.meets(at.box)) return;
        if (at.first_child == none) {
            found_.push_back(at.leaf);
            return;
        }
        const Vec<3>& middle = tree_.nodes[at.first_child].box.max;
        std::uint32_t low = 0, high = 0;  // bit i: the triangle's box reaches the lower, the upper part of split axis i
        int axes = 0;
        for (int i = 0; i < 3; ++i) {
            if (!tree_.splits(node, i)) continue;
            low |= static_cast<std::uint32_t>(test.bounds().min[i] <= middle[i]) << axes;
            high |= static_cast<std::uint32_t>(test.bounds().max[i] >= middle[i]) << axes;
            ++axes;
        }
        const std::uint32_t children = 1u << axes, all = children - 1;
        const bool one = (low ^ high) == all;
        for (std::uint32_t child = 0; child < children; ++child)
            if ((child & ~high) == 0 && (~child & all & ~low) == 0)
                descend(at.first_child + child, test, inside && one);
    }

    const Tree<3>& tree_;
    std::vector<std::uint32_t> found_;
};

[[noreturn]] void refuse_so_many(std::size_t most) {
    throw InputError("the triangles are too large for cells that fine: together they lie in more than " +
                     std::to_string(most) + " cells; take a larger error_bound");
}

/// Whether the triangles make more than `most` references, as far as a sample of at most one in 32 can tell: it says so
/// where a lower bound of their mean is too large, which errs less than once in 10^5 samples. The bound is the
/// empirical one of Audibert, Munos and Szepesvari (Theoretical Computer Science 410, 2009, theorem 1). It is for
/// numbers between 0 and a given one, which is the largest of a first few: larger ones count as that, which makes the
/// mean smaller.
template <typename Search>
bool makes_more(const CellComplex<3>& cells, const std::vector<Primitive<3>>& primitives, std::size_t most) {
    constexpr std::size_t few = 256, least = 1024;
    constexpr double confidence = 16;  // of one bound: ln(3 / 3.4e-7)
    if (primitives.size() <= few) return false;
    Search search(cells);
    Random random(1);
    std::uint32_t sampled = 0;
    const auto sample = [&] {
        const std::vector<std::uint32_t>& found = search.cells_of(sampled, primitives[random.below(primitives.size())]);
        ++sampled;
        return static_cast<double>(found.size());
    };
    const double allowed = static_cast<double>(most) / static_cast<double>(primitives.size());
    double largest = 0, sum = 0;
    while (sampled < few) {
        const double count = sample();
        largest = std::max(largest, count);
        sum += count;
    }
    if (sum < few * allowed / 4) return false;  // nowhere near; more would only cost time
    double squares = sum = 0;
    const std::size_t last = std::max(least, primitives.size() / 32);
    for (std::size_t n = 1; n <= last; ++n) {
        const double count = std::min(sample(), largest);
        sum += count;
        squares += count * count;
        if ((n & (n - 1)) != 0) continue;  // looked at when there are twice as many as before
        const double mean = sum / static_cast<double>(n);
        const double variance = std::max(0.0, squares / static_cast<double>(n) - mean * mean);
        const double error = std::sqrt(2 * variance * confidence / static_cast<double>(n)) +
                             3 * largest * confidence / static_cast<double>(n);
        if (mean - error > allowed) return true;
        if (mean + error < allowed) return false;
    }
    return false;
}

/// A search for each thread that wants one at a time.
template <typename Search>
class Searches {
public:
    explicit Searches(const CellComplex<3>& cells) : cells_(cells) {}

    std::unique_ptr<Search> take() {
        {
            const std::lock_guard lock(mutex_);
            if (!free_.empty()) {
                auto search = std::move(free_.back());
                free_.pop_back();
                return search;
            }
        }
        return std::make_unique<Search>(cells_);
    }
    void give(std::unique_ptr<Search> search) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(search));
    }

private:
    const CellComplex<3>& cells_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Search>> free_;
};

/// Parts of the triangles side by side. Each begins its search anew, so what comes out is the same from any number of
/// threads.
template <typename Search>
void assign(CellComplex<3>& cells, const std::vector<Primitive<3>>& primitives, const Progress& progress,
            std::size_t most, int threads) {
    // Making that many takes minutes, a sample seconds.
    if (makes_more<Search>(cells, primitives, most)) refuse_so_many(most);
    constexpr std::size_t part_size = std::size_t{1} << 12, at_a_time = 16;
    std::vector<std::vector<CellPrimitive>> parts((primitives.size() + part_size - 1) / part_size);
    std::vector<std::uint32_t> unassigned(parts.size());
    Searches<Search> searches(cells);
    const auto assign_part = [&](std::size_t index) {
        auto search = searches.take();
        search->restart();
        const std::size_t end = std::min(primitives.size(), (index + 1) * part_size);
        for (auto primitive = static_cast<std::uint32_t>(index * part_size); primitive < end; ++primitive) {
            const std::vector<std::uint32_t>& found = search->cells_of(primitive, primitives[primitive]);
            for (const std::uint32_t cell : found) parts[index].push_back({cell, primitive});
            unassigned[index] += found.empty();
        }
        searches.give(std::move(search));
    };
    std::size_t references = 0;
    for (std::size_t first = 0; first < parts.size(); first += at_a_time) {
        report_assigned(progress, first * part_size, primitives.size());
        const std::size_t count = std::min(at_a_time, parts.size() - first);
        run_parts(static_cast<int>(count), threads, [&](int i) { assign_part(first + static_cast<std::size_t>(i)); });
        for (std::size_t i = first; i < first + count; ++i) references += parts[i].size();
        if (references > most) refuse_so_many(most);
    }
    cells.unassigned = std::accumulate(unassigned.begin(), unassigned.end(), 0u);
    set_cell_primitives<3>(cells, parts, threads);
}

}  // namespace

void assign_primitives(CellComplex<3>& cells, const std::vector<Primitive<3>>& primitives, const Progress& progress,
                       std::size_t most, int threads) {
    if (cells.kind == Tessellation::delaunay) {
        assign<TetrahedronFlood>(cells, primitives, progress, most, threads);
    } else {
        assign<TreeDescent>(cells, primitives, progress, most, threads);
    }
}

}  // namespace sightline
