// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/winners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lab/report/page.h"

namespace sightline::lab {

namespace {

constexpr std::array shares{0.05, 0.01, 0.005, 0.001, 0.0001, 0.0};

std::string row_text(const Row& row) {
    return method_text(row.method) + (row.budget == "unlimited" ? "" : " " + row.budget) + ": " +
           number(summary(row, Measure::total_ms));
}

std::string share_text(double share) {
    return share > 0 ? "at most " + per_cent(share) + " % wrong" : std::string("none wrong");
}

/// Whether times hold upload and drawing, which are taken in 3D where there is OpenGL.
bool is_drawn(const Row& row) { return !std::isnan(summary(row, Measure::draw_ms)); }

/// "traversal + upload + drawing, milliseconds, median over frames"
std::string times_text(const std::vector<Group>& all) {
    bool drawn = false, traversed = false;
    for (const Group& group : all)
        for (const Row* row : group.rows)
            if (!std::isnan(summary(*row, Measure::total_ms)) && row->method.variant != exactly_v)
                (is_drawn(*row) ? drawn : traversed) = true;
    return std::string(!drawn      ? "traversal alone, since no drawing is timed"
                       : traversed ? "traversal + upload + drawing; where no drawing is timed, traversal alone"
                                   : "traversal + upload + drawing") +
           "; milliseconds, median over frames";
}

/// How often each method wins, and how many scenes have no winner.
struct Wins {
    std::vector<std::pair<std::string, int>> of{};  ///< most wins first
    int none = 0;
    bool all_cut_short = true, all_whole = true;  ///< by a budget
};

Wins count_wins(const std::vector<Group>& all, double share) {
    Wins wins;
    for (const Group& group : all) {
        const Row* const first = winner(group, share).first;
        if (!first) {
            ++wins.none;
            continue;
        }
        (first->budget == "unlimited" ? wins.all_cut_short : wins.all_whole) = false;
        const std::string id = first->method.id();
        const auto at = std::find_if(wins.of.begin(), wins.of.end(), [&](const auto& one) { return one.first == id; });
        if (at == wins.of.end())
            wins.of.emplace_back(id, 1);
        else
            ++at->second;
    }
    std::stable_sort(wins.of.begin(), wins.of.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    return wins;
}

/// "at most 5 % wrong: tri 3, layers 2"
std::string wins_text(const Wins& wins, double share) {
    std::string text = share_text(share) + ": ";
    for (const auto& [id, count] : wins.of)
        text += (text.ends_with(": ") ? "" : ", ") + id + " " + std::to_string(count);
    if (wins.none > 0) text += (wins.of.empty() ? "nobody " : ", nobody ") + std::to_string(wins.none);
    return text;
}

/// Scenes and paths on which anything was timed that leaves few enough pixels wrong.
std::vector<Group> groups_with_winner(const Results& results) {
    std::vector<Group> all = groups(results);
    std::erase_if(all, [](const Group& group) { return !winner(group, shares.front()).first; });
    return all;
}

}  // namespace

Winner winner(const Group& group, double most_wrong) {
    Winner found;
    const auto faster = [](const Row* row, const Row* than) {
        return !than || summary(*row, Measure::total_ms) < summary(*than, Measure::total_ms);
    };
    const auto counts = [&](const Row* row) {
        return row->method.variant != exactly_v && !std::isnan(summary(*row, Measure::total_ms)) &&
               summary(*row, Measure::wrong) <= most_wrong;
    };
    for (const Row* row : group.rows)
        if (counts(row) && faster(row, found.first)) found.first = row;
    for (const Row* row : group.rows)
        if (counts(row) && row->method.id() != found.first->method.id() && faster(row, found.second))
            found.second = row;
    return found;
}

TextTable winners_table(const Results& results) {
    TextTable table{{"scene, path"}, {}};
    for (const double share : shares) table.head.push_back(share_text(share));
    for (const Group& group : groups_with_winner(results)) {
        std::vector<std::string> cells{group.scene + ", " + group.path};
        for (const double share : shares) {
            const Winner at = winner(group, share);
            cells.push_back(!at.first ? "–" : row_text(*at.first) + (at.second ? "; " + row_text(*at.second) : ""));
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

std::string winners_text(const Results& results) {
    const std::vector<Group> all = groups_with_winner(results);
    const Wins most = count_wins(all, shares.front()), fewest = count_wins(all, shares.back());
    std::string text =
        "The method and budget that leave no more than such a share of the pixels wrong (mean over frames) in the "
        "least "
        "total time (" +
        times_text(all) +
        "), and after it the fastest other method. Only methods and budgets that were measured count. How many scenes "
        "and paths each wins, " +
        wins_text(most, shares.front()) + "; " + wins_text(fewest, shares.back()) + ".";
    if (!most.of.empty() && !fewest.of.empty() && most.all_cut_short && fewest.all_whole)
        text +=
            " A budget wins only where a few pixels may be wrong: most pixels belong to few primitives, and the last "
            "wrong ones to small primitives here and there, which an order brings late, among many hidden ones.";
    return text;
}

}  // namespace sightline::lab
