// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/counterfactual.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/number.h"

namespace sightline {

namespace {

/// Has it come, and if so was it met outside the view?
template <int D>
bool has_come(const Run<D>& run, const Item& item, bool& culled) {
    if (item.kind == Kind::cell) return run.mark(item).state == CellState::projected;
    if (!run.drawn().has(item.id)) return false;
    const auto met = run.met();
    const auto found = std::find_if(met.rbegin(), met.rend(), [&](const Met m) { return m.primitive() == item.id; });
    culled = found != met.rend() && found->culled();
    return true;
}

/// Runs of one method that use the same memory.
template <int D>
class Runner {
public:
    explicit Runner(const Session<D>& session) : method_(session.method()) {}

    Outcome operator()(const Problem<D>& problem, const Item& item) {
        run_.start(problem, method_.start);
        Outcome outcome;
        for (;;) {
            const Stop stop = run_->run(1);
            outcome.steps = run_->steps();
            if (has_come(*run_, item, outcome.culled)) {
                outcome.step = outcome.steps;
                return outcome;
            }
            if (stop == Stop::steps) continue;
            outcome.stop = stop;
            return outcome;
        }
    }

private:
    Method<D> method_;
    OwnRun<D> run_;
};

/// The session's; a budget in milliseconds is what the run that it ended had spent.
template <int D>
Problem<D> problem_of(const Session<D>& session) {
    Problem<D> problem = session.problem();
    if (session.settings().budget.kind == Budget::Kind::milliseconds && session.time_stop() != none &&
        session.time_stop() <= session.recorded())
        problem.budget = session.timeline().after(session.time_stop()).spent;
    return problem;
}

/// A whole one has no half of 1.
bool takes(const ParameterRow& row, const std::string& value) {
    try {
        row.read(row, value);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

/// Other values of a parameter, each one step away from what it is.
std::vector<std::string> other_values(const ParameterRow& row, const Parameters& parameters) {
    std::vector<std::string> values;
    const std::string_view now = parameters.text(row);
    for (const std::string_view word : row.words)
        if (word != now) values.emplace_back(word);
    if (row.words.empty() && row.low < row.high) {
        const double number = parameters.number(row);
        for (const double other : {number / 2, number * 2})
            if (other != number && takes(row, number_text(other))) values.push_back(number_text(other));
    }
    return values;
}

bool sooner(const Alternative& a, const Alternative& b) {
    if ((a.outcome.step > 0) != (b.outcome.step > 0)) return a.outcome.step > 0;
    return a.outcome.step < b.outcome.step;
}

}  // namespace

template <int D>
Outcome outcome_with(const Session<D>& session, const Item& item, const ParameterRow& row, std::string_view value) {
    Problem<D> problem = problem_of(session);
    problem.parameters.set(row, value);
    return Runner<D>(session)(problem, item);
}

template <int D>
Counterfactuals counterfactuals(const Session<D>& session, const Item& item, bool seeds) {
    const Problem<D> problem = problem_of(session);
    Runner<D> run(session);
    Counterfactuals all{item, run(problem, item), {}};
    for (const ParameterRow* row : session.method().parameters)
        for (const std::string& value : other_values(*row, problem.parameters)) {
            Problem<D> changed = problem;
            changed.parameters.set(*row, value);
            all.changes.push_back({std::string(row->name) + "=" + value, run(changed, item)});
        }
    if (problem.budget < problem.primitives().size()) {
        Problem<D> changed = problem;
        changed.budget = none;
        all.changes.push_back({"budget=unlimited", run(changed, item)});
    }
    if (seeds && item.kind == Kind::primitive && session.method().needs.cells)
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            TessellationSettings settings = session.settings();
            if (seed == settings.seed) continue;
            settings.seed = seed;
            const CellComplex<D> cells = build_cells(session.scene(), settings);
            Problem<D> changed = problem;
            changed.cells = &cells;
            all.changes.push_back({"seed=" + std::to_string(seed), Runner<D>(session)(changed, item)});
        }
    std::stable_sort(all.changes.begin(), all.changes.end(), sooner);
    return all;
}

template <int D>
std::uint64_t most_steps(const Session<D>& session) {
    std::uint64_t runs = 2;
    for (const ParameterRow* row : session.method().parameters)
        runs += other_values(*row, session.problem().parameters).size();
    const bool limited = session.problem().budget < session.scene().primitives.size();
    // Without a budget at most every cell; other methods take no more steps than there are primitives.
    const std::uint64_t whole =
        session.method().orders_cells() ? session.cells().cell_count() : session.scene().primitives.size();
    return limited && session.finished() ? runs * session.recorded() + whole : runs * whole;
}

bool differs(const Outcome& a, const Outcome& b) { return a.step != b.step || a.culled != b.culled; }

std::string outcome_words(const Outcome& outcome) {
    const std::string steps = std::to_string(outcome.steps) + (outcome.steps == 1 ? " step" : " steps");
    if (outcome.step > 0) return "step " + std::to_string(outcome.step) + (outcome.culled ? ", outside the view" : "");
    return outcome.stop == Stop::budget ? "not within the budget, " + steps : "never, the run ends after " + steps;
}

std::vector<std::string> rows(const Counterfactuals& all) {
    std::vector<std::string> text{"With one setting changed (now: " + outcome_words(all.now) + "):"};
    std::string same;
    for (const auto& [change, outcome] : all.changes) {
        if (differs(outcome, all.now))
            text.push_back("  " + change + ": " + outcome_words(outcome));
        else
            same += (same.empty() ? "" : ", ") + change;
    }
    if (!same.empty()) text.push_back("  no difference: " + same);
    return text;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                             \
    template Outcome outcome_with<D>(const Session<D>&, const Item&, const ParameterRow&, std::string_view); \
    template Counterfactuals counterfactuals<D>(const Session<D>&, const Item&, bool);                       \
    template std::uint64_t most_steps<D>(const Session<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
