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

/// One member: all of them in one pair of braces compile to several times as much.
void put(OrderedJson& json, const char* name, OrderedJson value) { json[name] = std::move(value); }

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
    OrderedJson json;
    put(json, "scene", scene.id);
    put(json, "title", scene.title);
    put(json, "seed", scene.seed);
    put(json, "scene_hash", hash_text(scene_hash(scene)));
    put(json, "method", session.settings().method);
    put(json, "approximate", session.traversal().misses() == Misses::may);
    put(json, "guarantee", session.guarantee());
    put(json, "tessellation", words<Tessellation>[static_cast<std::size_t>(session.settings().tessellation)]);
    put(json, "cells", session.cells().cell_count());
    put(json, "primitives", scene.primitives.size());
    put(json, "unassigned", session.cells().unassigned);
    put(json, "references", session.cells().cell_primitives.size());
    put(json, "rho_max", session.cells().rho_max);
    put(json, "budget", budget_in_primitives(session));
    put(json, "steps", session.position());
    put(json, "zero_key_share", or_null(zero_key_share(session.traversal())));
    put(json, "projected", cells_in[static_cast<std::size_t>(CellState::projected)]);
    put(json, "enqueued", cells_in[static_cast<std::size_t>(CellState::enqueued)]);
    put(json, "unseen", cells_in[static_cast<std::size_t>(CellState::unseen)]);
    put(json, "rendered", session.counters().drawn());
    put(json, "visible", reference.count);
    put(json, "visible_rendered", found);
    put(json, "coverage", or_null(coverage(reference, found)));
    put(json, "oracle", or_null(oracle(reference, budget_in_primitives(session))));
    put(json, "cell_oracle", or_null(cell_oracle(reference, session.problem())));
    put(json, "inversions", mis_ranked + unreached);
    put(json, "mis_ranked", mis_ranked);
    put(json, "unreached", unreached);
    put(json, "wasted", wasted);
    put(json, "reference", reference.name);
    put(json, "eye_on", reference.eye_on);
    put(json, "stop", stop_words[static_cast<std::size_t>(stop)]);
    put(json, "state_hash", hash_text(session.hash()));
    OrderedJson times, bytes, dropped;
    put(times, "read", ms.read);
    put(times, "tessellate", ms.tessellate);
    put(times, "assign", ms.assign);
    put(times, "reference", ms.reference);
    put(times, "traverse", ms.traverse);
    put(times, "draw", ms.draw);
    put(json, "ms", std::move(times));
    put(bytes, "scene", scene.primitives.size() * sizeof(Primitive<D>));
    put(bytes, "tessellation", session.cells().memory_bytes());
    put(bytes, "references", session.cells().reference_memory_bytes());
    put(bytes, "timeline", session.timeline().memory_bytes());
    put(json, "memory_bytes", std::move(bytes));
    put(dropped, "degenerate", scene.dropped.degenerate);
    put(dropped, "duplicate", scene.dropped.duplicate);
    put(dropped, "not_finite", scene.dropped.not_finite);
    put(json, "dropped", std::move(dropped));
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
        OrderedJson row;
        put(row, "step", step);
        put(row, "cell", or_null(e.cell));
        put(row, "key", e.key);
        put(row, "stamp", e.stamp);
        put(row, "runner_up", or_null(e.runner_up));
        put(row, "runner_up_key", e.runner_up == none ? OrderedJson(nullptr) : OrderedJson(e.runner_up_key));
        put(row, "visible_share", e.visible_share);
        put(row, "rendered_now", e.rendered);
        put(row, "visible_now", e.visible);
        put(row, "rendered", after.drawn());
        put(row, "front", after.front_size);
        if (e.item && e.cell == none) row["item"] = {{"kind", kind_word(e.item.kind)}, {"id", e.item.id}};
        row["primitives"] = rendered_ids(session.timeline().met_in(step, session.met()));
        OrderedJson facets = OrderedJson::array();
        for (const Considered& c : e.looked_at) {
            OrderedJson facet;
            put(facet, "neighbour", c.item ? OrderedJson(c.item.id) : OrderedJson(nullptr));
            put(facet, "rule", c.words);
            put(facet, "state_before", cell_state_words[static_cast<std::size_t>(c.before.state)]);
            put(facet, "key_before", c.before.key);
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
        text += counted(session.cells().cell_count(), settings.tessellation == Tessellation::delaunay ? "Delaunay cell"
                                                      : settings.tessellation == Tessellation::kd     ? "kd-tree cell"
                                                      : D == 2                                        ? "quadtree cell"
                                                                                                      : "octree cell");
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
