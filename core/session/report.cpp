// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/number.h"
#include "core/session/explain.h"
#include "core/truth/item_buffer.h"

namespace sightline {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson or_null(const std::optional<double>& value) { return value ? OrderedJson(*value) : OrderedJson(nullptr); }
OrderedJson or_null(std::uint32_t id) { return id == none ? OrderedJson(nullptr) : OrderedJson(id); }

/// What the budget amounts to in primitives: the whole scene when it does not limit them.
template <int D>
std::uint32_t budget_in_primitives(const Session<D>& session) {
    const auto total = static_cast<std::uint32_t>(session.scene().primitives.size());
    return std::min(session.settings().budget.primitives(total), total);
}

OrderedJson other_reference(const Session<2>& session) {
    const View<2> view = make_view(session.culling_view());
    // An all-round view has four image lines of equal width.
    int width = image_size<2>(session.settings().reference_size).width;
    if (view.all_round) width = std::max(4, width / 4 * 4);
    const ItemBuffer buffer = item_buffer(session.scene().primitives, view, width);
    Reference reference;
    reference.visible = visible_in(buffer, session.scene().primitives.size());
    reference.count = static_cast<std::size_t>(std::count(reference.visible.begin(), reference.visible.end(), 1));
    const State<2>& state = session.state();
    const auto touched = std::span(state.touched).first(state.touched_count);
    const std::size_t found = visible_rendered<2>(reference, touched);
    std::vector<std::uint8_t> rendered(reference.visible.size());
    for (const std::uint32_t entry : touched)
        if (!(entry & State<2>::culled_bit)) rendered[entry] = 1;
    const auto wrong = std::count_if(buffer.ids.begin(), buffer.ids.end(),
                                     [&](std::uint32_t id) { return id != no_primitive && !rendered[id]; });
    return {{"reference", "item buffer " + std::to_string(width)},
            {"visible", reference.count},
            {"visible_rendered", found},
            {"coverage", or_null(coverage(reference, found))},
            {"oracle", or_null(oracle(reference, budget_in_primitives(session)))},
            {"wrong_pixels", static_cast<double>(wrong) / static_cast<double>(buffer.ids.size())}};
}

}  // namespace

template <int D>
std::string stats_json(const Session<D>& session, Stop stop) {
    const Scene<D>& scene = session.scene();
    const Reference& reference = session.reference();
    const State<D>& state = session.state();
    std::array<std::size_t, 4> cells_in{};
    for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell)
        ++cells_in[static_cast<std::size_t>(state.mark(cell).state)];
    const auto inversions = session.inversions();
    const auto up_to_now = [&](Inversion::Kind kind) {
        return std::count_if(inversions.begin(), inversions.end(),
                             [&](const Inversion& i) { return i.step <= session.position() && i.kind == kind; });
    };
    const auto mis_ranked = up_to_now(Inversion::Kind::mis_ranked), unreached = up_to_now(Inversion::Kind::unreached);
    std::uint32_t wasted = 0;
    for (const Inversion& inversion : inversions) wasted += inversion.step <= session.position() ? inversion.wasted : 0;
    const std::size_t found = session.visible_rendered();
    const Times& ms = session.times();
    OrderedJson json{
        {"scene", scene.id},
        {"title", scene.title},
        {"seed", scene.seed},
        {"scene_hash", hash_text(scene_hash(scene))},
        {"method", session.settings().method},
        {"approximate", session.method().guarantee == Guarantee::approximate},
        {"tessellation", words<Tessellation>[static_cast<std::size_t>(session.settings().tessellation)]},
        {"cells", session.cells().cell_count()},
        {"primitives", scene.primitives.size()},
        {"unassigned", session.cells().unassigned},
        {"references", session.cells().cell_primitives.size()},
        {"rho_max", session.cells().rho_max},
        {"budget", budget_in_primitives(session)},
        {"steps", session.position()},
        {"projected", cells_in[static_cast<std::size_t>(CellState::projected)]},
        {"enqueued", cells_in[static_cast<std::size_t>(CellState::enqueued)]},
        {"unseen", cells_in[static_cast<std::size_t>(CellState::unseen)]},
        {"rendered", state.rendered_count},
        {"visible", reference.count},
        {"visible_rendered", found},
        {"coverage", or_null(coverage(reference, found))},
        {"oracle", or_null(oracle(reference, budget_in_primitives(session)))},
        {"cell_oracle", or_null(cell_oracle(reference, session.frame()))},
        {"inversions", mis_ranked + unreached},
        {"mis_ranked", mis_ranked},
        {"unreached", unreached},
        {"wasted", wasted},
        {"reference", reference.name},
        {"eye_on", reference.eye_on},
        {"stop", stop_words[static_cast<std::size_t>(stop)]},
        {"state_hash", hash_text(session.hash())},
        {"ms",
         {{"read", ms.read},
          {"tessellate", ms.tessellate},
          {"assign", ms.assign},
          {"reference", ms.reference},
          {"traverse", ms.traverse},
          {"draw", ms.draw}}},
        {"memory_bytes",
         {{"scene", scene.primitives.size() * sizeof(Primitive<D>)},
          {"tessellation", session.cells().memory_bytes()},
          {"references", session.cells().reference_memory_bytes()},
          {"timeline", session.timeline().memory_bytes()}}},
        {"dropped",
         {{"degenerate", scene.dropped.degenerate},
          {"duplicate", scene.dropped.duplicate},
          {"not_finite", scene.dropped.not_finite}}},
    };
    if constexpr (D == 2)
        json["item_buffer"] = other_reference(session);
    else
        json["wrong_pixels"] = wrong_pixels(reference, std::span(state.touched).first(state.touched_count));
    return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

template <int D>
std::string trace_json(const Session<D>& session) {
    OrderedJson steps = OrderedJson::array();
    for (std::uint32_t step = 1; step <= session.position(); ++step) {
        const StepExplanation e = explain_step(session, step);
        const StepRecord& record = session.timeline().steps[step - 1];
        OrderedJson row{{"step", step},
                        {"cell", or_null(e.cell)},
                        {"key", e.key},
                        {"stamp", e.stamp},
                        {"runner_up", or_null(e.runner_up)},
                        {"runner_up_key", e.runner_up == none ? OrderedJson(nullptr) : OrderedJson(e.runner_up_key)},
                        {"visible_share", e.visible_share},
                        {"rendered_now", e.rendered},
                        {"visible_now", e.visible},
                        {"rendered", record.rendered_count},
                        {"front", record.front_size}};
        OrderedJson primitives = OrderedJson::array();
        for (std::uint32_t i = session.timeline().touched_before(step); i < record.touched_count; ++i)
            if (const std::uint32_t entry = session.state().touched[i]; !(entry & State<D>::culled_bit))
                primitives.push_back(entry);
        row["primitives"] = std::move(primitives);
        OrderedJson facets = OrderedJson::array();
        for (const FacetExplanation& f : e.facets) {
            OrderedJson facet{{"neighbour", or_null(f.neighbour)},
                              {"rule", rule_words[static_cast<std::size_t>(f.rule)]},
                              {"state_before", cell_state_words[static_cast<std::size_t>(f.before.state)]},
                              {"key_before", f.before.key}};
            if (f.terms)
                facet["terms"] = {
                    {"rho_a", f.terms->rho_a},
                    {"count", f.terms->count},
                    {"density", f.terms->density},
                    {"alignment", f.terms->alignment},
                    {"weight", f.terms->weight},
                    {"star_shaped", f.terms->star_tested ? OrderedJson(f.terms->star_shaped) : OrderedJson(nullptr)},
                    {"unpenalised", f.terms->unpenalised},
                    {"key", f.terms->key}};
            facets.push_back(std::move(facet));
        }
        row["facets"] = std::move(facets);
        steps.push_back(std::move(row));
    }
    const OrderedJson json{{"format", "sightline-trace"},
                           {"version", 1},
                           {"conditions", conditions(session)},
                           {"seed_cell", or_null(session.state().seed)},
                           {"state_hash", hash_text(session.hash())},
                           {"steps", std::move(steps)}};
    return json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

template <int D>
std::string conditions(const Session<D>& session) {
    constexpr const char* primitives = D == 2 ? " segments" : " triangles";
    const Settings& settings = session.settings();
    const Scene<D>& scene = session.scene();
    std::string text = scene.title.empty() ? scene.id : scene.title;
    if (scene.source == "generated") text += " (" + scene.id + ", seed " + std::to_string(scene.seed) + ")";
    text += ", " + std::to_string(scene.primitives.size()) + primitives + ". Method " + settings.method + " (" +
            (session.method().guarantee == Guarantee::approximate ? "approximate" : "conservative") + "), " +
            std::to_string(session.cells().cell_count()) + " " +
            (settings.tessellation == Tessellation::delaunay ? "Delaunay"
             : D == 2                                        ? "quadtree"
                                                             : "octree") +
            " cells, budget " + budget_text(settings.budget);
    if (settings.budget.kind == Budget::Kind::share)
        text += " = " + std::to_string(budget_in_primitives(session)) + primitives;
    return text + ".";
}

template std::string stats_json<2>(const Session<2>&, Stop);
template std::string stats_json<3>(const Session<3>&, Stop);
template std::string trace_json<2>(const Session<2>&);
template std::string trace_json<3>(const Session<3>&);
template std::string conditions<2>(const Session<2>&);
template std::string conditions<3>(const Session<3>&);

}  // namespace sightline
