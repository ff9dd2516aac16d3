// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/objects.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "core/base/hash.h"
#include "core/base/index.h"
#include "core/base/text.h"

namespace sightline {

namespace {

constexpr std::size_t longest_name = 120;

/// Sets of primitives that are joined pair by pair.
class Union {
public:
    explicit Union(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    /// The smaller number stays the root, so that a root is the first primitive of its part.
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace

void tidy(Objects& objects) {
    std::vector<std::uint8_t> used(objects.names.size(), 0);
    for (const std::uint32_t object : objects.of) used[object] = 1;
    std::vector<std::uint32_t> number(objects.names.size(), none);
    std::vector<std::string> names;
    std::unordered_set<std::string> taken;
    std::unordered_map<std::string, std::size_t> times;
    for (std::size_t i = 0; i < objects.names.size(); ++i) {
        if (!used[i]) continue;
        std::string name = one_line(objects.names[i], longest_name);
        if (name.empty()) name = "unnamed";
        const std::string base = name;
        while (!taken.insert(name).second) name = base + " (" + std::to_string(++times[base] + 1) + ")";
        number[i] = static_cast<std::uint32_t>(names.size());
        names.push_back(std::move(name));
    }
    for (std::uint32_t& object : objects.of) object = number[object];
    objects.names = std::move(names);
}

template <int D>
Objects connected_parts(const std::vector<std::array<Vec<D>, D>>& primitives) {
    const auto corner = [&](std::size_t k) { return primitives[k / D][k % D] + 0.0; };  // -0 becomes +0
    std::size_t size = 16;
    while (size < primitives.size() * D * 2) size *= 2;
    std::vector<std::uint64_t> slots(size, 0);  // one more than the number of a corner; 0: free
    Union parts(primitives.size());
    for (std::size_t k = 0; k < primitives.size() * D; ++k) {
        const Vec<D> point = corner(k);
        Hash hash;
        for (int i = 0; i < D; ++i) hash.add(point[i]);
        std::size_t at = hash.value() & (size - 1);
        while (slots[at] != 0 && corner(slots[at] - 1) != point) at = (at + 1) & (size - 1);
        if (slots[at] == 0)
            slots[at] = k + 1;
        else
            parts.join(static_cast<std::uint32_t>(k / D), static_cast<std::uint32_t>((slots[at] - 1) / D));
    }
    Objects objects;
    objects.of.resize(primitives.size());
    for (std::uint32_t i = 0; i < primitives.size(); ++i) {
        const std::uint32_t first = parts.root(i);  // no later than i
        if (first == i) objects.names.push_back("part " + std::to_string(objects.names.size() + 1));
        objects.of[i] = first == i ? static_cast<std::uint32_t>(objects.names.size() - 1) : objects.of[first];
    }
    return objects;
}

std::uint32_t object_named(const Objects& objects, std::string_view name) {
    const auto found = std::find(objects.names.begin(), objects.names.end(), name);
    return found == objects.names.end() ? none : static_cast<std::uint32_t>(found - objects.names.begin());
}

ObjectRows primitives_of_objects(const Objects& objects) {
    ObjectRows rows;
    rows.first.assign(objects.names.size() + 1, 0);
    for (const std::uint32_t object : objects.of) ++rows.first[object + 1];
    std::partial_sum(rows.first.begin(), rows.first.end(), rows.first.begin());
    rows.ids.resize(objects.of.size());
    std::vector<std::uint32_t> next(rows.first.begin(), rows.first.end() - 1);
    for (std::uint32_t i = 0; i < objects.of.size(); ++i) rows.ids[next[objects.of[i]]++] = i;
    return rows;
}

template Objects connected_parts<2>(const std::vector<std::array<Vec<2>, 2>>&);
template Objects connected_parts<3>(const std::vector<std::array<Vec<3>, 3>>&);

}  // namespace sightline
