// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "core/base/error.h"
#include "core/run/drawn_levels.h"
#include "core/session/explanation_json.h"
#include "core/session/report.h"
#include "python/convert.h"
#include "python/script_session.h"

namespace sightline {

namespace py = pybind11;

namespace {

/// A step in the array of all.
struct StepRow {
    std::uint8_t kind;
    std::uint32_t id;
    double key;
    std::uint32_t runner_up;
    double runner_up_key;
    std::uint32_t rendered, front;
};

template <int D>
py::array_t<StepRow> step_rows(const Session<D>& session) {
    std::vector<StepRow> rows;
    for (std::uint32_t step = 1; step <= session.position(); ++step) {
        const Step& s = session.timeline().steps[step - 1];
        rows.push_back({static_cast<std::uint8_t>(s.item.kind), s.item.id, s.key, s.runner_up.id, s.runner_up_key,
                        s.after.drawn(), s.after.front_size});
    }
    return array_of(std::move(rows));
}

void check_index(std::size_t index, std::size_t count, const char* what) {
    if (index >= count)
        throw py::index_error("there is no " + std::string(what) + " " + std::to_string(index) + ": there are " +
                              std::to_string(count));
}
template <int D>
void check_step(const Session<D>& session, std::uint32_t step) {
    if (step < 1 || step > session.position())
        throw py::index_error("step " + std::to_string(step) + " is not made: there are 1 to " +
                              std::to_string(session.position()));
}

py::object item_or_none(const Item& item) {
    return item ? py::object(py::make_tuple(std::string(kind_word(item.kind)), item.id)) : py::object(py::none());
}

template <int D>
py::dict step_record(const Session<D>& session, std::uint32_t step) {
    check_step(session, step);
    const StepExplanation e = explain_step(session, step);
    const Step& made = session.timeline().steps[step - 1];
    py::dict record;
    record["step"] = step;
    record["item"] = item_or_none(made.item);
    record["key"] = e.key;
    record["runner_up"] = item_or_none(made.runner_up);
    record["runner_up_key"] = made.runner_up ? py::object(py::float_(made.runner_up_key)) : py::object(py::none());
    record["rendered"] = array_of(rendered_ids(session.timeline().met_in(step, session.met())));
    record["visible"] = e.visible;
    record["visible_share"] = e.visible_share;
    py::list looked_at;
    for (const Considered& c : e.looked_at) {
        py::dict row;
        row["item"] = item_or_none(c.item);
        row["via"] = item_or_none(c.via);
        row["rule"] = c.words;
        if (c.key) {
            row["key"] = c.key->key;
            row["formula"] = c.key->formula();
            py::dict terms;
            for (const Term& term : c.key->terms) {
                const py::str name{std::string(term.name)};
                if (term.words.empty())
                    terms[name] = term.value;
                else if (term.words == "true" || term.words == "false" || term.words == "null")
                    terms[name] = from_json(term.words);
                else
                    terms[name] = term.words;
            }
            row["terms"] = terms;
        }
        looked_at.append(row);
    }
    record["looked_at"] = looked_at;
    record["sentence"] = sentence(e);
    return record;
}

template <int D>
std::vector<std::uint32_t> visible_ids(const Session<D>& session, bool also_rendered) {
    const std::vector<std::uint8_t>& visible = session.reference().visible;
    std::vector<std::uint8_t> out(visible.size());
    if (!also_rendered) out = found_mask(session.traversal());
    std::vector<std::uint32_t> ids;
    for (std::size_t i = 0; i < visible.size(); ++i)
        if (visible[i] && !out[i]) ids.push_back(static_cast<std::uint32_t>(i));
    return ids;
}

template <int D>
py::array_t<double> field_of(const Session<D>& session, const std::string& name) {
    std::string known;
    for (const Field<D>& field : session.traversal().fields()) {
        known += (known.empty() ? "" : ", ") + std::string(field.name);
        if (field.name != name) continue;
        std::vector<double> values(session.cells().cell_count());
        for (std::uint32_t cell = 0; cell < values.size(); ++cell)
            values[cell] =
                field.value(session.traversal(), cell_item(cell)).value_or(std::numeric_limits<double>::quiet_NaN());
        return array_of(std::move(values));
    }
    throw InputError("the method " + std::string(session.method().id) + " has no field " + name +
                     (known.empty() ? "" : ": it has " + known));
}

/// What explanation_json() says, with the sentences that people read and without what was not asked for.
template <int D, typename Explanation>
py::object explained(const Session<D>& session, const Explanation& e, std::vector<std::string> sentences,
                     const Item& item, bool changes) {
    const Counterfactuals all = changes ? counterfactuals(session, item) : Counterfactuals{};
    py::dict said = from_json(explanation_json(session, e, all));
    if (changes) {
        for (std::string& row : rows(all)) sentences.push_back(std::move(row));
    } else {
        said.attr("pop")("outcome");
        said.attr("pop")("changes");
    }
    said["sentences"] = sentences;
    return said;
}

template <int D>
py::object cell_explained(const Session<D>& session, std::size_t cell, bool changes) {
    check_index(cell, session.cells().cell_count(), "cell");
    const auto id = static_cast<std::uint32_t>(cell);
    const CellExplanation e = explain_cell(session, id);
    return explained(session, e, rows(e), cell_item(id), changes);
}

template <int D>
py::object primitive_explained(const Session<D>& session, std::size_t primitive, bool changes) {
    check_index(primitive, session.scene().primitives.size(), "primitive");
    const auto id = static_cast<std::uint32_t>(primitive);
    const PrimitiveExplanation e = explain_primitive(session, id);
    py::object said = explained(session, e, rows(session, e), primitive_item(id), changes);
    const Objects& objects = session.objects();
    said["object"] = objects.names[objects.of[primitive]];
    return said;
}

template <int D>
std::vector<std::uint8_t> states_of(const Session<D>& session) {
    std::vector<std::uint8_t> states(session.cells().cell_count());
    for (std::uint32_t cell = 0; cell < states.size(); ++cell)
        states[cell] = static_cast<std::uint8_t>(session.mark(cell).state);
    return states;
}

}  // namespace

template <int D>
void bind_results(py::class_<ScriptSession<D>>& session) {
    using Self = ScriptSession<D>;
    if constexpr (D == 2) PYBIND11_NUMPY_DTYPE(StepRow, kind, id, key, runner_up, runner_up_key, rendered, front);

    // What a run changes is taken as it is now, into memory that the array takes over.
    session
        .def_property_readonly(
            "rendered", [](const Self& self) { return array_of(rendered_ids(self.session.met())); },
            "ids of the primitives rendered so far, in order")
        .def(
            "rendered_in",
            [](const Self& self, std::uint32_t step) {
                check_step(self.session, step);
                return array_of(rendered_ids(self.session.timeline().met_in(step, self.session.met())));
            },
            py::arg("step"))
        .def_property_readonly(
            "visible", [](const Self& self) { return array_of(visible_ids(self.session, true)); },
            "ids of the primitives of the visible set, rising")
        .def_property_readonly(
            "missed", [](const Self& self) { return array_of(visible_ids(self.session, false)); },
            "those of them that are not rendered so far")
        .def_property_readonly(
            "coverage",
            [](const Self& self) { return coverage(self.session.reference(), self.session.visible_rendered()); },
            "share of the visible primitives that is rendered; None: nothing is visible")
        .def_property_readonly(
            "reference", [](const Self& self) { return self.session.reference().name; }, "what says what is visible")
        .def_property_readonly(
            "guarantee", [](const Self& self) { return self.session.guarantee(); },
            "\"approximate\", \"conservative\", … of this run, here")
        .def_property_readonly(
            "steps", [](const Self& self) { return step_rows(self.session); },
            "the steps made, an array with fields kind, id, key, runner_up, runner_up_key, rendered, front; rendered "
            "and front are totals after the step")
        .def(
            "record", [](const Self& self, std::uint32_t step) { return step_record(self.session, step); },
            py::arg("step"), "one step made: all that it looked at, with the terms of each key")
        .def_property_readonly(
            "fields",
            [](const Self& self) {
                std::vector<std::string> names;
                for (const Field<D>& field : self.session.traversal().fields()) names.emplace_back(field.name);
                return names;
            },
            "numbers that the method gives to cells")
        .def(
            "field", [](const Self& self, const std::string& name) { return field_of(self.session, name); },
            py::arg("name"), "one of them per cell; nan where a cell has none")
        .def_property_readonly(
            "cell_states", [](const Self& self) { return array_of(states_of(self.session)); },
            "per cell an index into sightline.cell_states")
        .def_property_readonly(
            "visible_shares", [](const Self& self) { return array_of(self.session.reference().cell_share); },
            "per cell the part of what is visible that lies inside it; 0: hidden")
        .def(
            "explain_cell",
            [](const Self& self, std::size_t cell, bool changes) {
                return cell_explained(self.session, cell, changes);
            },
            py::arg("cell"), py::kw_only(), py::arg("changes") = false,
            "where it stands and why; changes: also what one other parameter would do, a run each")
        .def(
            "explain_primitive",
            [](const Self& self, std::size_t primitive, bool changes) {
                return primitive_explained(self.session, primitive, changes);
            },
            py::arg("primitive"), py::kw_only(), py::arg("changes") = false,
            "whether it is seen, what hides it, when the run meets it")
        .def(
            "stats", [](const Self& self) { return from_json(stats_json(self.session, self.last_stop)); },
            "what --stats writes")
        .def(
            "trace", [](const Self& self) { return from_json(trace_json(self.session)); }, "what --trace writes")
        .def_property_readonly(
            "conditions", [](const Self& self) { return conditions(self.session); }, "of these numbers, in one line");
    if constexpr (D == 3)
        session
            .def_property_readonly(
                "wrong_pixels", [](const Self& self) { return self.session.wrong_pixels(); },
                "share of the pixels that show another triangle than the exact image")
            .def_property_readonly(
                "pixels", [](const Self& self) { return array_of(self.session.reference().pixels); },
                "per triangle, how many pixels show it");
}

template void bind_results<2>(py::class_<ScriptSession<2>>&);
template void bind_results<3>(py::class_<ScriptSession<3>>&);

}  // namespace sightline
