// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/measure/drawn_image.h"
#include "core/session/condition.h"
#include "core/session/explain.h"
#include "core/space/box_tree.h"
#include "core/truth/truth.h"

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
    Reference reference;
    reference.image = session.reference().image;
    reference.pixels = session.reference().pixels;
    for (const std::uint32_t pixels : reference.pixels) reference.visible.push_back(pixels > 0);
    reference.count = static_cast<std::size_t>(std::count(reference.visible.begin(), reference.visible.end(), 1));
    const std::size_t found = visible_found(reference, session.traversal());
    return {{"reference", "item buffer " + std::to_string(reference.image.width)},
            {"visible", reference.count},
            {"visible_rendered", found},
            {"coverage", or_null(coverage(reference, found))},
            {"oracle", or_null(oracle(reference, budget_in_primitives(session)))},
            {"wrong_pixels", session.wrong_pixels()}};
}

/// By name; a word in place of a number is JSON as it stands, else a text.
OrderedJson terms_json(const KeyExplanation& key) {
    OrderedJson json = OrderedJson::object();
    for (const Term& term : key.terms) {
        if (term.words.empty()) {
            const bool whole = term.value >= 0 && term.value < 4294967296.0 && term.name == "count";
            json[std::string(term.name)] =
                whole ? OrderedJson(static_cast<std::uint32_t>(term.value)) : OrderedJson(term.value);
            continue;
        }
        OrderedJson word = OrderedJson::parse(term.words, nullptr, false);
        json[std::string(term.name)] = word.is_discarded() ? OrderedJson(term.words) : std::move(word);
    }
    return json;
}

}  // namespace

template <int D>
std::string stats_json(const Session<D>& session, Stop stop) {
    const Scene<D>& scene = session.scene();
    const Reference& reference = session.reference();
    std::array<std::size_t, cell_state_words.size()> cells_in{};
    for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell)
        ++cells_in[static_cast<std::size_t>(session.mark(cell).state)];
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
        {"approximate", session.traversal().misses() == Misses::may},
        {"guarantee", session.guarantee()},
        {"tessellation", words<Tessellation>[static_cast<std::size_t>(session.settings().tessellation)]},
        {"cells", session.cells().cell_count()},
        {"primitives", scene.primitives.size()},
        {"unassigned", session.cells().unassigned},
        {"references", session.cells().cell_primitives.size()},
        {"rho_max", session.cells().rho_max},
        {"budget", budget_in_primitives(session)},
        {"steps", session.position()},
        {"zero_key_share", or_null(zero_key_share(session.traversal()))},
        {"projected", cells_in[static_cast<std::size_t>(CellState::projected)]},
        {"enqueued", cells_in[static_cast<std::size_t>(CellState::enqueued)]},
        {"unseen", cells_in[static_cast<std::size_t>(CellState::unseen)]},
        {"rendered", session.counters().drawn()},
        {"visible", reference.count},
        {"visible_rendered", found},
        {"coverage", or_null(coverage(reference, found))},
        {"oracle", or_null(oracle(reference, budget_in_primitives(session)))},
        {"cell_oracle", or_null(cell_oracle(reference, session.problem()))},
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
        json["wrong_pixels"] = session.wrong_pixels();
    return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

template <int D>
std::string trace_json(const Session<D>& session) {
    OrderedJson steps = OrderedJson::array();
    const std::vector<Field<D>> own = own_fields(session.traversal().fields());
    Session<D> walker = copy_at(session, 0);
    for (std::uint32_t step = 1; step <= session.position(); ++step) {
        const StepExplanation e = explain_step(session, step);
        const Counters& after = session.timeline().after(step);
        OrderedJson row{{"step", step},
                        {"cell", or_null(e.cell)},
                        {"key", e.key},
                        {"stamp", e.stamp},
                        {"runner_up", or_null(e.runner_up)},
                        {"runner_up_key", e.runner_up == none ? OrderedJson(nullptr) : OrderedJson(e.runner_up_key)},
                        {"visible_share", e.visible_share},
                        {"rendered_now", e.rendered},
                        {"visible_now", e.visible},
                        {"rendered", after.drawn()},
                        {"front", after.front_size}};
        if (e.item && e.cell == none) row["item"] = {{"kind", kind_word(e.item.kind)}, {"id", e.item.id}};
        row["primitives"] = rendered_ids(session.timeline().met_in(step, session.met()));
        OrderedJson facets = OrderedJson::array();
        for (const Considered& c : e.looked_at) {
            OrderedJson facet{{"neighbour", c.item ? OrderedJson(c.item.id) : OrderedJson(nullptr)},
                              {"rule", c.words},
                              {"state_before", cell_state_words[static_cast<std::size_t>(c.before.state)]},
                              {"key_before", c.before.key}};
            if (c.key) facet["terms"] = terms_json(*c.key);
            facets.push_back(std::move(facet));
        }
        row["facets"] = std::move(facets);
        if (!own.empty()) {
            walker.seek(step);
            for (const Field<D>& field : own)
                row["fields"][std::string(field.name)] = or_null(field.value(walker.traversal(), e.item));
        }
        steps.push_back(std::move(row));
    }
    const OrderedJson json{{"format", "sightline-trace"},
                           {"version", 1},
                           {"conditions", conditions(session)},
                           {"seed_cell", or_null(seed_cell(session))},
                           {"state_hash", hash_text(session.hash())},
                           {"steps", std::move(steps)}};
    return json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

template <int D>
std::string conditions(const Session<D>& session) {
    const Settings& settings = session.settings();
    const Scene<D>& scene = session.scene();
    std::string text = scene.title.empty() ? scene.id : scene.title;
    if (scene.source == "generated") text += " (" + scene.id + ", seed " + std::to_string(scene.seed) + ")";
    text += ", " + counted(scene.primitives.size(), D == 2 ? "segment" : "triangle") + ". Method " + settings.method +
            " (" + session.guarantee() + "), ";
    if (session.method().pops == Kind::node)
        text += counted(session.traversal().boxes()->nodes.size(), "node") + " of a box tree";
    else
        text += std::to_string(session.cells().cell_count()) + " " +
                (settings.tessellation == Tessellation::delaunay ? "Delaunay"
                 : settings.tessellation == Tessellation::kd     ? "kd-tree"
                 : D == 2                                        ? "quadtree"
                                                                 : "octree") +
                " cells";
    text += ", budget " + budget_text(settings.budget);
    if (settings.budget.kind == Budget::Kind::share)
        text += " = " + counted(budget_in_primitives(session), D == 2 ? "segment" : "triangle");
    return text + ".";
}

template std::string stats_json<2>(const Session<2>&, Stop);
template std::string stats_json<3>(const Session<3>&, Stop);
template std::string trace_json<2>(const Session<2>&);
template std::string trace_json<3>(const Session<3>&);
template std::string conditions<2>(const Session<2>&);
template std::string conditions<3>(const Session<3>&);

}  // namespace sightline
