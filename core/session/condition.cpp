// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/condition.h"

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/measure/wrong_region.h"
#include "core/methods/cells/cell_rules.h"

namespace sightline {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

template <int D>
const Step& last(const Session<D>& s) {
    return s.timeline().steps[s.position() - 1];
}

template <int D>
std::uint32_t last_popped(const Session<D>& s) {
    return id_of(last(s).item, Kind::cell);
}

template <int D>
std::uint32_t rendered_in_step(const Session<D>& s) {
    return last(s).after.drawn() - s.timeline().before(s.position()).drawn();
}

template <int D>
std::size_t visible_in_step(const Session<D>& s) {
    return visible_rendered(s.reference(), s.timeline().met_in(s.position(), s.met()));
}

template <int D>
double count_rules(const Session<D>& s, std::initializer_list<Rule> rules) {
    double count = 0;
    if (last(s).item.kind != Kind::cell) return count;
    for (const Change& change : s.timeline().changes_of(s.position()))
        for (const Rule rule : rules) count += Rule{change.rule} == rule;
    return count;
}

/// 0: none; 1: mis-ranked; 2: unreached.
template <int D>
double inversion(const Session<D>& s) {
    const auto found = s.inversion_at(s.position());
    return !found ? 0 : found->kind == Inversion::Kind::mis_ranked ? 1 : 2;
}

template <int D>
double largest_wrong(const Session<D>& s) {
    const IdImage& exact = s.reference().image;
    const auto& wrong = s.wrong_mask();
    return wrong.empty() ? no_value
                         : static_cast<double>(largest_region(wrong, exact.width, exact.height)) /
                               static_cast<double>(wrong.size());
}

template <int D>
double objects_begun(const Session<D>& s) {
    const Objects& objects = s.objects();
    std::vector<std::uint8_t> begun(objects.names.size(), 0);
    for_rendered(s.met(), [&](std::uint32_t primitive) { begun[objects.of[primitive]] = 1; });
    for (const StandIn& stand_in : s.traversal().stand_ins()) begun[stand_in.object] = 1;
    return static_cast<double>(std::count(begun.begin(), begun.end(), 1));
}

template <int D>
const std::vector<RecordField<D>>& fields() {
    using S = const Session<D>&;
    static const std::vector<RecordField<D>> table{
        {"step", "number of the step", [](S s) -> double { return s.position(); }},
        {"cell", "number of the cell that was popped",
         [](S s) -> double { return last_popped(s) == none ? no_value : last_popped(s); }},
        {"node", "number of the box that was popped, of a method that walks boxes",
         [](S s) -> double { return last(s).item.kind == Kind::node ? last(s).item.id : no_value; }},
        {"rho", "its key: accumulated solidity, or the key of another method",
         [](S s) -> double { return last(s).item && last(s).item.kind != Kind::primitive ? last(s).key : no_value; }},
        {"count", "|A|, the primitives in it",
         [](S s) -> double { return last_popped(s) == none ? no_value : s.cells().count(last_popped(s)); }},
        {"runner_up", "the key of the next cell in the front",
         [](S s) -> double { return last(s).runner_up ? last(s).runner_up_key : no_value; }},
        {"visible_share", "share of what is visible inside the cell (2D: angle, 3D: pixels); 0: hidden",
         [](S s) -> double { return last_popped(s) == none ? no_value : s.reference().cell_share[last_popped(s)]; }},
        {"rendered_now", "primitives rendered in this step", [](S s) -> double { return rendered_in_step(s); }},
        {"visible_now", "visible primitives among them",
         [](S s) -> double { return static_cast<double>(visible_in_step(s)); }},
        {"hidden_now", "hidden primitives among them",
         [](S s) -> double {
             return static_cast<double>(rendered_in_step(s)) - static_cast<double>(visible_in_step(s));
         }},
        {"rendered", "primitives rendered so far", [](S s) -> double { return s.counters().drawn(); }},
        {"front", "cells in the front after the step", [](S s) -> double { return s.counters().front_size; }},
        {"enqueued", "neighbours put into the front", [](S s) { return count_rules(s, {Rule::enqueued}); }},
        {"reenqueued", "neighbours in the front that got a new key",
         [](S s) { return count_rules(s, {Rule::reenqueued}); }},
        {"unseen", "neighbours found outside the view", [](S s) { return count_rules(s, {Rule::marked_unseen}); }},
        {"penalties", "neighbours whose new key carries a penalty",
         [](S s) -> double { return s.penalised_facets(s.position()).size(); }},
        {"inversion", "1: mis-ranked, 2: unreached, 0: none", [](S s) { return inversion(s); }},
        {"coverage", "share of the visible set rendered so far",
         [](S s) { return coverage(s.reference(), s.visible_rendered()).value_or(no_value); }},
        {"wrong_pixels", "share of the exact image's pixels whose primitive is not rendered so far",
         [](S s) -> double { return s.wrong_pixels(); }},
        {"wrong_region", "share of the pixels in the largest wrong region", [](S s) { return largest_wrong(s); }},
        {"objects", "objects of which something is rendered so far", [](S s) { return objects_begun(s); }},
    };
    return table;
}

}  // namespace

template <int D>
std::span<const RecordField<D>> record_fields() {
    return fields<D>();
}

template <int D>
std::vector<Field<D>> own_fields(std::span<const Field<D>> of_method) {
    std::vector<Field<D>> own;
    for (const Field<D>& field : of_method)
        if (std::none_of(fields<D>().begin(), fields<D>().end(),
                         [&](const RecordField<D>& known) { return known.name == field.name; }))
            own.push_back(field);
    return own;
}

namespace {

template <int D>
std::vector<std::string_view> own_names(std::span<const Field<D>> of_method) {
    std::vector<std::string_view> names;
    for (const Field<D>& field : own_fields(of_method)) names.push_back(field.name);
    return names;
}

/// Of what the last step popped; NaN where the run has no such field or the item no such number.
template <int D>
double own_value(const Session<D>& s, std::string_view name) {
    for (const Field<D>& field : s.traversal().fields())
        if (field.name == name) return field.value(s.traversal(), last(s).item).value_or(no_value);
    return no_value;
}

constexpr std::string_view of_object = "object:", of_primitive = "primitive:";

template <int D>
Formula formula_of(const std::string& text, std::span<const std::string_view> own) {
    std::string formula = text;
    for (const std::string_view word : {"step", "cell"})
        if (text.starts_with(std::string(word) + ":"))
            formula = std::string(word) + " == " + text.substr(word.size() + 1);
    std::vector<std::string_view> names;
    for (const RecordField<D>& field : fields<D>()) names.push_back(field.name);
    names.insert(names.end(), own.begin(), own.end());
    return Formula(formula, names, "condition", text);
}

}  // namespace

template <int D>
Condition<D>::Condition(std::string_view text, std::span<const Field<D>> of_method)
    : text_(text), own_(own_names(of_method)) {
    if (text.starts_with(of_object)) {
        object_ = text.substr(of_object.size());
        if (object_.empty()) throw InputError("condition: write object:NAME");
    } else if (text.starts_with(of_primitive)) {
        const auto primitive = parse_whole(text.substr(of_primitive.size()));
        if (!primitive) throw InputError("condition: write primitive:N, with a number");
        primitive_ = *primitive;
    } else {
        formula_ = formula_of<D>(text_, own_);
    }
}

template <int D>
bool Condition<D>::holds(const Session<D>& session) const {
    if (session.position() == 0) return false;
    if (!formula_) {
        bool found = false;
        const Objects* const objects = object_.empty() ? nullptr : &session.objects();
        for_rendered(session.timeline().met_in(session.position(), session.met()), [&](std::uint32_t p) {
            found = found || (objects ? objects->names[objects->of[p]] == object_ : p == primitive_);
        });
        return found;
    }
    const std::size_t known = fields<D>().size();
    std::vector<double> values(known + own_.size());
    for (const std::size_t i : formula_->used())
        values[i] = i < known ? fields<D>()[i].value(session) : own_value(session, own_[i - known]);
    return formula_->holds(values);
}

template <int D>
std::optional<Condition<D>> condition_here(const Session<D>& session, std::string_view text) {
    try {
        return condition_for(session, text);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

template <int D>
Stop run_until(Session<D>& session, const Condition<D>& condition) {
    return session.run_until([&](const Session<D>& s) { return condition.holds(s); });
}

template <int D>
std::vector<std::uint32_t> matches(const Session<D>& session, const Condition<D>& condition) {
    std::vector<std::uint32_t> steps;
    Session<D> walker = copy_at(session, 0);
    for (std::uint32_t step = 1; step <= session.recorded(); ++step) {
        walker.seek(step);
        if (condition.holds(walker)) steps.push_back(step);
    }
    return steps;
}

template std::span<const RecordField<2>> record_fields<2>();
template std::span<const RecordField<3>> record_fields<3>();
template std::vector<Field<2>> own_fields<2>(std::span<const Field<2>>);
template std::vector<Field<3>> own_fields<3>(std::span<const Field<3>>);
template class Condition<2>;
template class Condition<3>;
template std::optional<Condition<2>> condition_here<2>(const Session<2>&, std::string_view);
template std::optional<Condition<3>> condition_here<3>(const Session<3>&, std::string_view);
template Stop run_until<2>(Session<2>&, const Condition<2>&);
template Stop run_until<3>(Session<3>&, const Condition<3>&);
template std::vector<std::uint32_t> matches<2>(const Session<2>&, const Condition<2>&);
template std::vector<std::uint32_t> matches<3>(const Session<3>&, const Condition<3>&);

}  // namespace sightline
