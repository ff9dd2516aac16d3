// Where the run stands, and under which conditions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number.h"
#include "core/session/headline.h"
#include "core/session/report.h"
#include "core/session/substep.h"
#include "shell/desk/into.h"
#include "shell/desk/play.h"
#include "shell/panels/panel_table.h"

namespace sightline {

template <int D>
std::vector<Row> run_rows(const Workbench<D>& bench) {
    const ShownSession<D> shown(bench);
    const Session<D>& s = *shown;
    std::vector<Row> rows;
    const auto add = [&](std::string text, Tone tone = Tone::plain) {
        Row row;
        row.text = std::move(text);
        row.tone = tone;
        rows.push_back(std::move(row));
    };
    add(s.scene().title.empty() ? s.scene().id : s.scene().title, Tone::heading);
    if (!s.scene().lesson.empty()) add(s.scene().lesson, Tone::faint);
    add("step " + std::to_string(s.position()) + " of " + std::to_string(s.recorded()) + ", " +
        (bench.substep ? "substep " + std::to_string(*bench.substep + 1) + " of " +
                             std::to_string(substep_count(bench.session, s.position())) + ", "
                       : "") +
        std::string(transport_words[static_cast<std::size_t>(transport_state(bench))]));
    add(std::string(s.method().title) + " (" + std::string(s.method().id) + "), " + s.guarantee());
    add(std::to_string(s.counters().drawn()) + " rendered of " + std::to_string(s.scene().primitives.size()));
    add("state " + hash_text(s.hash()), Tone::faint);
    if (s.flying() && !s.has_reference()) return rows;  // a frame of a flight does not wait for it
    if (tells_truth(s)) {
        const auto share = coverage(s.reference(), s.visible_rendered());
        const auto best = oracle(s.reference(), s.counters().drawn());
        add(std::to_string(s.visible_rendered()) + " of " + std::to_string(s.reference().count) +
            " visible, coverage " + coverage_text(share) + ", oracle " + (best ? short_number(*best) : "none"));
    }
    add(conditions(s), Tone::faint);
    return rows;
}

template std::vector<Row> run_rows<2>(const Workbench<2>&);
template std::vector<Row> run_rows<3>(const Workbench<3>&);

}  // namespace sightline
