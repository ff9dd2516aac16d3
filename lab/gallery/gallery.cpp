// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/gallery/gallery.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "core/base/error.h"
#include "core/scene/read/load.h"
#include "core/session/condition.h"
#include "core/session/settings_table.h"
#include "core/session/start_settings.h"
#include "lab/gallery/gallery_measures.h"

namespace sightline::lab {

namespace {

/// The first word of a subject, and what it sets.
struct Subject {
    std::string id;
    std::vector<std::string> settings;
};

Subject parse_subject(const char* text) {
    std::istringstream words(text);
    Subject subject;
    words >> subject.id;
    for (std::string word; words >> word;) subject.settings.push_back(word);
    return subject;
}

template <int D>
bool is_method(std::span<const Method<D>> table, const std::string& id) {
    return std::any_of(table.begin(), table.end(), [&](const Method<D>& method) { return method.id == id; });
}

bool needs_no_method(const std::string& id) { return id == "loader" || id == "cells" || id == "reference"; }

/// Exact images of this size tell the gallery's scenes apart, and two cores draw them all within a minute.
constexpr const char* reference_3d = "reference_size=512x384";

template <int D>
Settings settings_of(const GalleryRow<D>& row, const Subject& subject) {
    Settings settings = catalogue_settings<D>(row.scene);
    if (D == 3) apply_setting(settings, reference_3d);
    for (const char* assignment : row.settings) apply_setting(settings, assignment);
    if (!needs_no_method(subject.id)) settings.method = subject.id;
    for (const std::string& assignment : subject.settings) apply_setting(settings, assignment);
    return settings;
}

template <int D>
std::shared_ptr<const Scene<D>> scene_of(const GalleryRow<D>& row) {
    return std::make_shared<const Scene<D>>(load_scene<D>(row.scene));
}

template <int D>
ViewSpec<D> view_of(const GalleryRow<D>& row, const Scene<D>& scene) {
    return row.view ? *row.view : scene.start_view.value();
}

/// The one to look at.
template <int D>
const Expectation& shown(const GalleryRow<D>& row) {
    for (const Expect wanted : {Expect::fail, Expect::pass})
        for (const Expectation& expectation : row.expectations)
            if (expectation.expect == wanted) return expectation;
    throw InputError(std::string(row.id) + ": nothing is measured");
}

/// Lines of a caption are at most this long, so that they fit beside the border of a picture.
constexpr std::size_t caption_columns = 44;
constexpr double caption_line_pt = 11;

/// Notes, one below the other, at the last cell or at the point looked at, shown in this step only.
template <int D>
void add_caption(Session<D>& session, const std::string& text) {
    std::vector<std::string> lines(1);
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (!lines.back().empty() && lines.back().size() + word.size() >= caption_columns) lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + word;
    }
    Note<D> note;
    note.point = session.culling_view().look_at;
    if (const std::uint32_t cell = last_cell(session); cell != none) {
        note.anchor = Note<D>::Anchor::cell;
        note.index = cell;
    }
    note.first_step = note.last_step = session.position();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        note.text = lines[i];
        note.offset_pt.y = 12 + caption_line_pt * static_cast<double>(lines.size() - 1 - i);
        session.notes.push_back(note);
    }
}

}  // namespace

bool passes(const Expectation& expectation, double value) {
    return expectation.bound == Bound::at_least ? value >= expectation.threshold : value <= expectation.threshold;
}

Verdict judge(const Expectation& expectation, bool known, double value) {
    Verdict verdict{Verdict::Kind::expected, &expectation, value, passes(expectation, value), expectation.subject};
    if (!known || expectation.expect == Expect::pending)
        verdict.kind =
            known || expectation.expect != Expect::pending ? Verdict::Kind::surprise : Verdict::Kind::pending;
    else if (verdict.passed != (expectation.expect == Expect::pass) || std::isnan(value))
        verdict.kind = Verdict::Kind::surprise;
    return verdict;
}

const char* verdict_word(const Verdict& verdict) {
    if (verdict.kind == Verdict::Kind::pending) return "pending";
    if (verdict.kind == Verdict::Kind::surprise) return "SURPRISE";
    return verdict.passed ? "passes" : "fails";
}

template <int D>
std::vector<Verdict> measure_row(const GalleryRow<D>& row, const DrawIds& draw_ids, std::span<const Method<D>> methods,
                                 std::span<const std::string> also) {
    const auto scene = scene_of(row);
    const ViewSpec<D> view = view_of(row, *scene);
    GalleryScene<D> at(scene, draw_ids, row.parts ? row.parts(*scene) : std::vector<CarPart>{});
    const auto value_of = [&](const Subject& subject, const Expectation& expectation) {
        const Probe<D> probe{at, methods, settings_of(row, subject), view, row.to.value_or(view)};
        return measured(probe, expectation.measure);
    };
    std::vector<Verdict> verdicts;
    for (const Expectation& expectation : row.expectations) {
        const Subject subject = parse_subject(expectation.subject);
        const bool known = needs_no_method(subject.id) || is_method<D>(methods, subject.id);
        const double value = known ? value_of(subject, expectation) : std::numeric_limits<double>::quiet_NaN();
        verdicts.push_back(judge(expectation, known, value));
        if (verdicts.back().subject != "published") continue;
        for (const std::string& variant : also) {
            const double other = value_of(parse_subject(variant.c_str()), expectation);
            verdicts.push_back({Verdict::Kind::asked, &expectation, other, passes(expectation, other), variant});
        }
    }
    return verdicts;
}

template <int D>
Session<D> gallery_session(const GalleryRow<D>& row, const DrawIds& draw_ids, std::span<const Method<D>> methods) {
    const auto scene = scene_of(row);
    Settings settings = settings_of(row, parse_subject(shown(row).subject));
    settings.inset = Inset::missed;
    Session<D> session(scene, view_of(row, *scene), settings, methods, draw_ids);
    if (*row.until == 0)
        session.run();
    else if (run_until(session, condition_for(session, row.until)) != Stop::breakpoint)
        throw WorkError(std::string(row.id) + ": '" + row.until + "' never holds");
    session.bookmarks.push_back({session.position(), row.look});
    session.selected_cell = last_cell(session);
    add_caption(session, row.look);
    return session;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                                   \
    template std::vector<Verdict> measure_row<D>(const GalleryRow<D>&, const DrawIds&, std::span<const Method<D>>, \
                                                 std::span<const std::string>);                                    \
    template Session<D> gallery_session<D>(const GalleryRow<D>&, const DrawIds&, std::span<const Method<D>>);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline::lab
