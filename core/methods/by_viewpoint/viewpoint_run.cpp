// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/by_viewpoint/viewpoint_run.h"

#include <algorithm>

#include "core/base/number.h"

namespace sightline {

template <int D>
ViewpointRun<D>::ViewpointRun(const Problem<D>& problem, std::shared_ptr<const ViewpointTable<D>> table)
    : Run<D>(problem), table_(std::move(table)), runs_(table_->problem().options.size()) {
    look_up();
}

template <int D>
ViewpointRun<D>::ViewpointRun(const ViewpointRun& other)
    : Run<D>(other),
      table_(other.table_),
      place_(other.place_),
      chosen_(other.chosen_),
      before_(other.before_),
      looked_up_(other.looked_up_),
      runs_(other.runs_.size()) {
    runs_[chosen_] = other.runs_[chosen_];
}

template <int D>
bool ViewpointRun<D>::restart(const Problem<D>& problem) {
    const ViewpointProblem<D>& of = table_->problem();
    const double fov = problem.view.all_round ? 360 : problem.view.fov;
    if (of.scene != problem.scene || of.cells != problem.cells || of.fov != fov || of.image != problem.services.image ||
        of.parameters != problem.parameters)
        return false;
    this->begin(problem);
    looked_up_ = false;
    look_up();
    return true;
}

template <int D>
void ViewpointRun<D>::look_up() {
    const Problem<D>& problem = this->problem_;
    const ViewpointProblem<D>& of = table_->problem();
    place_ = table_->place(problem.view);
    const Entry& entry = table_->at(place_);
    before_ = none;
    if (problem.history)
        for (std::uint32_t i = 0; i < of.options.size(); ++i)
            if (of.options[i].text == problem.history->technique) before_ = i;
    chosen_ = before_ == none || pays_to_switch(entry, before_, of.choice) ? entry.chosen : before_;
    const Variant<D>& option = of.options[chosen_];
    // What another technique left tells this one nothing.
    const auto history = chosen_ == before_ ? problem.history : nullptr;
    runs_[chosen_].start(make_problem<D>(option.method, option.parameters, *problem.scene, *problem.cells, problem.view,
                                         problem.budget, problem.services, history),
                         option.method.start);
}

template <int D>
Stop ViewpointRun<D>::run(std::uint32_t steps, Recorder* recorder) {
    if (steps == 0) return Stop::steps;
    if (!looked_up_) {
        looked_up_ = true;
        if (recorder) {
            recorder->popped({table_->region_of(place_), Kind::region}, {0, look_up_stamp, CellState::projected});
            recorder->finished(this->counters());
        }
        if (steps != none && --steps == 0) return Stop::steps;
    }
    return runs_[chosen_]->run(steps, recorder);
}

template <int D>
void ViewpointRun<D>::set_budget(std::uint32_t budget) {
    Run<D>::set_budget(budget);
    runs_[chosen_]->set_budget(budget);
}

template <int D>
bool ViewpointRun<D>::move(Direction direction, const Step& step, std::span<Change> changes, const Counters& before) {
    if (!is_look_up(step)) return runs_[chosen_]->move(direction, step, changes, before);
    looked_up_ = direction == Direction::forward;
    return true;
}

template <int D>
std::uint32_t ViewpointRun<D>::substeps(const Step& step, std::span<const Change> changes) const {
    return is_look_up(step) ? 1 : inner().substeps(step, changes);
}

template <int D>
void ViewpointRun<D>::rewind_to(Step& step, std::vector<Change>& changes, const Counters& before,
                                std::uint32_t substep) {
    runs_[chosen_]->rewind_to(step, changes, before, substep);
}

template <int D>
std::size_t ViewpointRun<D>::memory_bytes() const {
    std::size_t bytes = 0;
    for (const OwnRun<D>& run : runs_)
        if (run) bytes += run->memory_bytes();
    return bytes;
}

template <int D>
std::uint64_t ViewpointRun<D>::hash() const {
    Hash hash;
    hash.add(place_);
    hash.add(chosen_);
    hash.add(looked_up_);
    hash.add(inner().hash());
    return hash.value();
}

template <int D>
Mark ViewpointRun<D>::mark(const Item& item) const {
    if (item.kind != Kind::region || !this->problem_.scene->rooms.empty()) return inner().mark(item);
    const bool here = looked_up_ && item.id == table_->region_of(place_);
    return here ? Mark{0, 0, CellState::projected} : Mark{};
}

template <int D>
std::shared_ptr<const FrameHistory> ViewpointRun<D>::next_history() const {
    FrameHistory history;
    if (const auto of_technique = inner().next_history()) history = *of_technique;
    history.technique = table_->problem().options[chosen_].text;
    return std::make_shared<const FrameHistory>(std::move(history));
}

/// Techniques are no items: what was looked at stands in the words of the step and in viewpoint().
template <int D>
std::vector<Considered> ViewpointRun<D>::considered(const Step& step, std::span<const Change> changes,
                                                    int digits) const {
    if (is_look_up(step)) return {};
    return inner().considered(step, changes, digits);
}

template <int D>
std::string ViewpointRun<D>::popped_words(const Step& step) const {
    if (!is_look_up(step)) return inner().popped_words(step);
    const ViewpointProblem<D>& p = table_->problem();
    std::string words = table_->regions().words(table_->region_of(place_)) + ", " +
                        table_->directions().words(table_->interval_of(place_)) + ": " + p.options[chosen_].text;
    const Entry& entry = *table_->find(place_);
    std::string others;
    for (std::uint32_t i = 0; i < p.options.size(); ++i)
        if (i != chosen_)
            others += (others.empty() ? "" : ", ") + p.options[i].text + " " + short_number(entry.facts.costs[i].ms());
    words += " is expected to take " + short_number(entry.facts.costs[chosen_].ms()) + " ms" +
             (others.empty() ? "" : " (" + others + ")");
    if (keeps_the_last())
        words += ", as before: changing to " + p.options[table_->find(place_)->chosen].text + " would not pay";
    return words;
}

template <int D>
std::vector<CodeLine> ViewpointRun<D>::code(const CodePlace& place) const {
    if (place.step && !is_look_up(*place.step)) return inner().code(place);
    const ViewpointProblem<D>& p = table_->problem();
    const Entry& entry = *table_->find(place_);
    const bool done = place.step != nullptr;
    std::vector<CodeLine> lines;
    lines.push_back({"find the region that holds the eye", 0, !done,
                     done ? table_->regions().words(table_->region_of(place_)) : "", "DAS 3.2"});
    lines.push_back({"find the interval that holds the direction", 0, false,
                     done ? table_->directions().words(table_->interval_of(place_)) : "", "DAS 3.2, fig. 1"});
    lines.push_back({"α ← table[region, interval]", 0, false, done ? p.options[entry.chosen].text : "", "DAS fig. 2"});
    std::string values;
    if (done && before_ != none && before_ != entry.chosen)
        values = short_number(p.choice.switch_ms) + " / " + std::to_string(p.choice.valid_frames) + " + " +
                 short_number(entry.facts.costs[entry.chosen].ms()) + (keeps_the_last() ? " ≥ " : " < ") +
                 short_number(entry.facts.costs[before_].ms()) + " ms";
    lines.push_back(
        {"unless t_select / valid_frames + t(α) < t(β of the last frame): α ← β", 0, false, values, "DAS 3"});
    lines.push_back({"do as α does", 0, done, done ? p.options[chosen_].text : "", "DAS 3.2"});
    return lines;
}

template <int D>
std::optional<ViewpointFact<D>> ViewpointRun<D>::viewpoint() const {
    const ViewpointProblem<D>& p = table_->problem();
    const Entry& entry = *table_->find(place_);
    const auto technique_at = [&](std::size_t place) {
        const Entry* const known = table_->find(place);
        return known ? known->chosen : none;
    };
    ViewpointFact<D> fact;
    fact.region_here = table_->region_of(place_);
    fact.interval_here = table_->interval_of(place_);
    fact.region = table_->regions().words(fact.region_here);
    fact.interval = table_->directions().words(fact.interval_here);
    std::vector<std::string> titles;
    for (std::size_t i = 0; i < p.options.size(); ++i) {
        const OptionCost& cost = entry.facts.costs[i];
        fact.techniques.push_back({p.options[i].text, cost.cull_ms, cost.draw_ms, cost.drawn});
        titles.push_back(p.options[i].text);
    }
    fact.chosen = entry.chosen;
    fact.done = chosen_;
    fact.decisions = decisions(entry, p.choice, titles);
    const std::size_t intervals = table_->directions().count();
    for (std::uint32_t region = 0; region < table_->regions().count(); ++region)
        fact.map.push_back({table_->regions().box(region), technique_at(region * intervals + fact.interval_here),
                            table_->regions().is_room(region)});
    for (std::uint32_t interval = 0; interval < intervals; ++interval)
        fact.rose.push_back({table_->directions().azimuth(interval), table_->directions().elevation(interval),
                             technique_at(fact.region_here * intervals + interval)});
    fact.occluders = entry.facts.candidates;
    fact.known = table_->known();
    fact.entries = table_->size();
    return fact;
}

template class ViewpointRun<2>;
template class ViewpointRun<3>;

}  // namespace sightline
