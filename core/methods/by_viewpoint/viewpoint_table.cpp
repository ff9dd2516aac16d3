// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/by_viewpoint/viewpoint_table.h"

#include <algorithm>
#include <thread>

#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/workers.h"
#include "core/methods/by_viewpoint/table_file.h"
#include "core/methods/coorg_teller/prepared.h"
#include "core/methods/levels/levels_parameters.h"
#include "core/methods/techniques.h"

namespace sightline {

namespace {

template <int D>
std::vector<std::uint32_t> leaves_of(const BoxTree<D>& tree) {
    std::vector<std::uint32_t> leaf_of(tree.primitives.size());
    for (std::uint32_t node = 0; node < tree.nodes.size(); ++node)
        if (tree.nodes[node].first_child == none)
            for (const std::uint32_t primitive : tree.primitives_of(node)) leaf_of[primitive] = node;
    return leaf_of;
}

template <int D>
ViewpointProblem<D> viewpoint_problem(std::span<const Method<D>> methods, const Problem<D>& problem) {
    const Parameters& parameters = problem.parameters;
    ViewpointProblem<D> p;
    p.scene = problem.scene;
    p.cells = problem.cells;
    p.image = problem.services.image;
    p.fov = problem.view.all_round ? 360 : problem.view.fov;
    p.parameters = parameters;
    std::vector<std::string> texts;
    for (const std::string& text : split_variants(parameters.text(techniques_row()))) {
        Variant<D> variant = make_variant<D>(methods, text, parameters);
        const Technique* const technique = find_technique(variant.method.id);
        const bool suits = !technique || suitability(*technique, *problem.scene).suits != Suits::no;
        if (!suits && !p.options.empty()) continue;  // the first is what is done where nothing else pays
        p.options.push_back(std::move(variant));
        p.cull_times.push_back(cull_time(parameters.text(cull_times_row()), p.options.back().text));
        texts.push_back(p.options.back().text);
    }
    p.choice = choice_settings(parameters);
    p.by_rule = rule_techniques(texts);
    p.cost = {parameters.number(vertex_ns_row()), parameters.number(pixel_ns_row())};
    p.reading = parameters.choice<CostReading>(cost_row());
    p.samples = static_cast<std::uint32_t>(parameters.number(samples_row()));
    const auto side = static_cast<std::uint32_t>(parameters.number(grid_row()));
    p.regions = Regions<D>(*problem.scene, side ? side : D == 2 ? 8 : 4);
    p.directions =
        Directions<D>(static_cast<std::uint32_t>(parameters.number(azimuths_row())),
                      static_cast<std::uint32_t>(parameters.number(elevations_row())), problem.scene->up_axis);
    p.leaf_of = leaves_of(problem.boxes());
    if constexpr (D == 3) p.rays.emplace(problem.scene->primitives);
    return p;
}

/// The technique of each interval of a region; none: not known.
template <int D>
std::vector<std::uint32_t> row_of(const ViewpointTable<D>& table, std::uint32_t region) {
    std::vector<std::uint32_t> row(table.directions().count(), none);
    for (std::uint32_t i = 0; i < row.size(); ++i)
        if (const Entry* entry = table.find(std::size_t{region} * row.size() + i)) row[i] = entry->chosen;
    return row;
}

std::size_t distinct(std::vector<std::uint32_t> row) {
    const auto unknown = static_cast<std::size_t>(std::count(row.begin(), row.end(), none));
    std::sort(row.begin(), row.end());
    const auto end = std::unique(row.begin(), row.end());
    const auto count = static_cast<std::size_t>(end - row.begin());
    return unknown ? count - 1 + unknown : count;
}

}  // namespace

template <int D>
ViewpointTable<D>::ViewpointTable(ViewpointProblem<D> problem)
    : problem_(std::move(problem)),
      entries_(std::size_t{problem_.regions.count()} * problem_.directions.count()),
      owned_(entries_.size()) {}

template <int D>
void ViewpointTable<D>::put(std::size_t place, Entry entry) const {
    const std::lock_guard lock(mutex_);
    if (owned_[place]) return;
    owned_[place] = std::make_unique<const Entry>(std::move(entry));
    entries_[place].store(owned_[place].get(), std::memory_order_release);
    ++known_;
}

template <int D>
void ViewpointTable<D>::work_out(std::size_t place, Analyst<D>& analyst) const {
    put(place, choose(analyst.facts(region_of(place), interval_of(place)), problem_.choice, problem_.by_rule));
}

template <int D>
const Entry& ViewpointTable<D>::at(std::size_t place) const {
    if (const Entry* entry = find(place)) return *entry;
    Analyst<D> analyst(problem_);
    work_out(place, analyst);
    return *find(place);
}

template <int D>
std::size_t ViewpointTable<D>::known(const Range& range) const {
    std::size_t count = 0;
    for (std::size_t place = range.first; place < range.end; ++place) count += find(place) != nullptr;
    return count;
}

template <int D>
void ViewpointTable<D>::fill(int threads, const std::function<bool(std::size_t)>& done, const Range& range) const {
    const int workers = threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    std::atomic<std::size_t> next = range.first;
    std::atomic<bool> stopped = false;
    std::mutex reporting;
    run_parts(workers, workers, [&](int) {
        Analyst<D> analyst(problem_);
        while (!stopped) {
            const std::size_t place = next++;
            if (place >= range.end) return;
            if (find(place)) continue;
            work_out(place, analyst);
            const std::lock_guard lock(reporting);
            if (!stopped && done && !done(known())) stopped = true;
        }
    });
}

template <int D>
std::size_t ViewpointTable<D>::memory_bytes() const {
    const std::lock_guard lock(mutex_);
    std::size_t bytes = entries_.size() * (sizeof(void*) * 2);
    for (const auto& entry : owned_)
        if (entry)
            bytes += sizeof(Entry) + entry->facts.costs.capacity() * sizeof(OptionCost) +
                     entry->facts.candidates.capacity() * sizeof(std::uint32_t);
    return bytes;
}

template <int D>
std::shared_ptr<const ViewpointTable<D>> viewpoint_table(std::span<const Method<D>> methods,
                                                         const Problem<D>& problem) {
    std::string key = "viewpoints " + std::to_string(problem.services.image.width) + "x" +
                      std::to_string(problem.services.image.height) + " " +
                      number_text(problem.view.all_round ? 360 : problem.view.fov);
    for (const auto& [name, value] : problem.parameters.values()) key += "\n" + name + "=" + value;
    using Shared = std::shared_ptr<const ViewpointTable<D>>;
    return *problem.cells->made->template of<Shared>(key, [&] {
        auto table = std::make_shared<const ViewpointTable<D>>(viewpoint_problem<D>(methods, problem));
        const std::string file(problem.parameters.text(table_file_row()));
        if (!file.empty()) read_table(*table, file);
        return Shared(table);
    });
}

template <int D>
MergedSize merged_size(const ViewpointTable<D>& table) {
    const Regions<D>& regions = table.regions();
    MergedSize size{regions.count(), table.size(), 0, 0};
    std::vector<std::vector<std::uint32_t>> rows;  // of the boxes, level by level; empty: not equal within
    for (std::uint32_t region = 0; region < regions.count(); ++region) {
        std::vector<std::uint32_t> row = row_of(table, region);
        if (regions.is_room(region)) {
            ++size.merged_regions;
            size.merged_entries += distinct(row);
        } else {
            rows.push_back(std::move(row));
        }
    }
    const auto settle = [&](const std::vector<std::uint32_t>& row) {
        if (row.empty()) return;
        ++size.merged_regions;
        size.merged_entries += distinct(row);
    };
    std::uint32_t side = regions.side();
    for (; side > 1 && side % 2 == 0; side /= 2) {
        const std::uint32_t half = side / 2, count = D == 2 ? half * half : half * half * half;
        std::vector<std::vector<std::uint32_t>> parents(count);
        for (std::uint32_t parent = 0; parent < count; ++parent) {
            const std::uint32_t x = parent % half, y = parent / half % half, z = D == 2 ? 0 : parent / half / half;
            std::vector<std::uint32_t> children;
            for (std::uint32_t i = 0; i < (1u << D); ++i)
                children.push_back(((2 * z + (i >> 2)) * side + 2 * y + (i >> 1 & 1)) * side + 2 * x + (i & 1));
            const std::vector<std::uint32_t>& first = rows[children[0]];
            const bool equal = !first.empty() && std::find(first.begin(), first.end(), none) == first.end() &&
                               std::all_of(children.begin(), children.end(),
                                           [&](std::uint32_t child) { return rows[child] == first; });
            if (equal)
                parents[parent] = first;
            else
                for (const std::uint32_t child : children) settle(rows[child]);
        }
        rows = std::move(parents);
    }
    for (const auto& row : rows) settle(row);
    return size;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                     \
    template class ViewpointTable<D>;                                                                \
    template std::shared_ptr<const ViewpointTable<D>> viewpoint_table<D>(std::span<const Method<D>>, \
                                                                         const Problem<D>&);         \
    template MergedSize merged_size<D>(const ViewpointTable<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
