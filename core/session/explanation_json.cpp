// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/explanation_json.h"

#include <nlohmann/json.hpp>

namespace sightline {

namespace {

using ExplanationJson = nlohmann::ordered_json;

ExplanationJson step_or_null(std::uint32_t step) { return step > 0 ? ExplanationJson(step) : ExplanationJson(nullptr); }

ExplanationJson outcome_json(const Outcome& outcome) {
    ExplanationJson json{{"step", step_or_null(outcome.step)}};
    if (outcome.culled) json["outside_view"] = true;
    if (outcome.step == 0) json["stop"] = stop_words[static_cast<std::size_t>(outcome.stop)];
    json["steps"] = outcome.steps;
    return json;
}

ExplanationJson links_json(const std::vector<ChainLink>& links) {
    ExplanationJson json = ExplanationJson::array();
    for (const ChainLink& link : links)
        json.push_back({{"step", link.step},
                        {"from", link.update.from.id},
                        {"to", link.update.item.id},
                        {"rule", link.update.words},
                        {"key", link.update.key->key},
                        {"formula", link.update.key->formula()}});
    return json;
}

template <int D>
ExplanationJson head_json(const Session<D>& session) {
    const Settings& settings = session.settings();
    return {{"scene", session.scene().id},
            {"seed", session.scene().seed},
            {"method", variant_of(session.method(), settings.parameters).text},
            {"budget", budget_text(settings.budget)},
            {"cells", session.cells().cell_count()},
            {"step", session.position()}};
}

void add_changes(ExplanationJson& json, const Counterfactuals& all) {
    json["outcome"] = outcome_json(all.now);
    json["changes"] = ExplanationJson::array();
    for (const auto& [change, outcome] : all.changes) {
        ExplanationJson row{{"change", change}};
        row.update(outcome_json(outcome));
        json["changes"].push_back(std::move(row));
    }
}

}  // namespace

template <int D>
std::string explanation_json(const Session<D>& session, const CellExplanation& e, const Counterfactuals& changes) {
    ExplanationJson json = head_json(session);
    json["cell"] = e.cell;
    json["state"] = cell_state_words[static_cast<std::size_t>(e.mark.state)];
    if (e.mark.state == CellState::projected || e.mark.state == CellState::enqueued) json["key"] = e.mark.key;
    json["projected_at"] = step_or_null(e.projected_at);
    json["rank"] = step_or_null(e.rank);
    json["visible_share"] = e.visible_share;
    if (e.verdict) {
        json["verdict"] = {{"reason", e.verdict.reason}, {"sentence", e.verdict.sentence}};
        if (e.verdict.about) json["verdict"][std::string(kind_word(e.verdict.about.kind))] = e.verdict.about.id;
    }
    if (e.lost) {
        json["lost"] = {{"key", e.lost->key},
                        {"step", e.lost->step},
                        {"taken", e.lost->taken},
                        {"instead", e.lost->instead},
                        {"lost_in", e.lost->lost_in}};
        if (e.lost->with_min) json["lost"]["with_min"] = outcome_json(*e.lost->with_min);
    }
    json["chain"] = links_json(e.chain);
    json["reached"] = links_json(e.reached);
    add_changes(json, changes);
    return json.dump(2) + "\n";
}

template <int D>
std::string explanation_json(const Session<D>& session, const PrimitiveExplanation& e, const Counterfactuals& changes) {
    ExplanationJson json = head_json(session);
    json["primitive"] = e.primitive;
    json["visible"] = e.visible;
    json["visible_share"] = e.sight.share;
    if (e.sight.unseen != Unseen::no) json["unseen"] = word(e.sight.unseen);
    if (D == 3) {
        json["pixels"] = e.sight.pixels;
        json["seen_pixels"] = e.sight.seen_pixels;
        if (e.sight.seen_pixels > 0) json["seen_box"] = e.sight.seen_box;
    }
    for (const VisiblePiece& piece : e.sight.pieces) {
        const auto point = [&](const Vec<2>& p) {
            return ExplanationJson{p.x + session.scene().origin.x, p.y + session.scene().origin.y};
        };
        json["seen"].push_back({point(piece.from), point(piece.to)});
    }
    json["hidden_by"] = ExplanationJson::array();
    for (const Hider& hider : e.sight.hiders)
        json["hidden_by"].push_back({{"primitive", hider.primitive}, {"share", hider.share}});
    json["met_at"] = step_or_null(e.met_at);
    if (e.culled) json["outside_view"] = true;
    json["held_by"] = e.cells;
    add_changes(json, changes);
    return json.dump(2) + "\n";
}

template std::string explanation_json<2>(const Session<2>&, const CellExplanation&, const Counterfactuals&);
template std::string explanation_json<3>(const Session<3>&, const CellExplanation&, const Counterfactuals&);
template std::string explanation_json<2>(const Session<2>&, const PrimitiveExplanation&, const Counterfactuals&);
template std::string explanation_json<3>(const Session<3>&, const PrimitiveExplanation&, const Counterfactuals&);

}  // namespace sightline
