// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/export/handout.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/session/state_file.h"
#include "core/session/substep.h"
#include "shell/desk/open.h"

namespace sightline {

namespace {

/// Nothing where the project has no lesson of that name, which is so for those of a lecturer's own.
std::optional<Lesson> lesson_named(const std::string& id, int dimension) {
    for (Lesson& lesson : read_lessons(lessons_of_the_project()))
        if (lesson.id == id && lesson.dimension == dimension) return std::move(lesson);
    return std::nullopt;
}

/// The lesson as it stood; its part is not opened again, for the state is what it came to.
template <int D>
std::optional<Teaching> teaching_of(const nlohmann::json& handout) {
    if (!handout.contains("lesson")) return std::nullopt;
    std::optional<Lesson> lesson = lesson_named(handout["lesson"].get<std::string>(), D);
    if (!lesson) return std::nullopt;
    Teaching teaching{std::move(*lesson), 0, 0, {}, {}, {}, {}};
    teaching.part = std::min(handout.value("part", std::size_t{0}), teaching.lesson.parts.size() - 1);
    teaching.presses = std::min(handout.value("presses", std::size_t{0}), teaching.now().beats.size());
    return teaching;
}

}  // namespace

template <int D>
bool carries_lesson(const Workbench<D>& bench) {
    if (!bench.teaching) return false;
    const Lesson& given = bench.teaching->lesson;
    const auto known = lesson_named(given.id, D);
    return known && known->folder == given.folder && known->parts.size() == given.parts.size();
}

template <int D>
std::string handout_text(const Workbench<D>& bench) {
    const auto* const other = bench.other ? &bench.other->session : nullptr;
    std::string text = state_json<D>(bench.session, bench.figure, other, bench.other ? bench.other->align : Align::step,
                                     Carry::what_no_generator_makes);
    nlohmann::ordered_json handout{{"panel", bench.desk.right}};
    if (bench.substep) handout["substep"] = *bench.substep;
    if (carries_lesson(bench)) {
        handout["lesson"] = bench.teaching->lesson.id;
        handout["part"] = bench.teaching->part;
        handout["presses"] = bench.teaching->presses;
    }
    return text.insert(text.rfind('}'), ", \"handout\": " + handout.dump());
}

template <int D>
void open_handout(Workbench<D>& bench, const std::string& text, const std::string& name) {
    nlohmann::json handout;
    std::optional<Teaching> teaching;
    try {
        const auto json = nlohmann::json::parse(text);
        if (json.is_object() && json.contains("handout")) handout = json["handout"];
        teaching = teaching_of<D>(handout);
    } catch (const nlohmann::json::exception&) {
        throw input_error(name, "", "not a hand-out");
    }
    open_state_text(bench, text, name);
    bench.teaching = std::move(teaching);
    bench.desk.projector_panel = bench.teaching ? bench.teaching->now().panel : "";
    if (handout.contains("panel") && handout["panel"].is_string()) bench.desk.right = handout["panel"];
    if (handout.contains("substep") && handout["substep"].is_number_unsigned() && bench.session.position() > 0)
        bench.substep = std::min(handout["substep"].get<std::uint32_t>(),
                                 substep_count(bench.session, bench.session.position()) - 1);
}

#define SIGHTLINE_INSTANTIATE(D)                               \
    template std::string handout_text<D>(const Workbench<D>&); \
    template bool carries_lesson<D>(const Workbench<D>&);      \
    template void open_handout<D>(Workbench<D>&, const std::string&, const std::string&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
