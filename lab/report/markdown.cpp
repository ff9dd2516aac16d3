// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/markdown.h"

#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/quote.h"
#include "lab/report/claims.h"
#include "lab/report/gem_table.h"
#include "lab/report/page.h"
#include "lab/report/papers_tables.h"
#include "lab/report/report.h"
#include "lab/report/study_charts.h"
#include "lab/report/time_table.h"
#include "lab/report/winners.h"

namespace sightline::lab {

namespace {

std::string table_rows_of(const Group& group) {
    std::string text =
        "| method | cells | budget | coverage % | worst | oracle % | wrong pixels % | worst | largest region % | "
        "popping % | r of key and share | ms |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const Row* row : group.rows) {
        const auto share = [&](Measure m) { return per_cent(summary(*row, m)); };
        text += "| " + markdown_escaped(method_text(row->method)) + " | " + std::to_string(row->cells) + " | " +
                markdown_escaped(row->budget) + " | " + share(Measure::coverage) + " | " +
                per_cent(worst(*row, Measure::coverage)) + " | " + share(Measure::oracle) + " | " +
                share(Measure::wrong) + " | " + per_cent(worst(*row, Measure::wrong)) + " | " + share(Measure::blob) +
                " | " + share(Measure::pop) + " | " + number(summary(*row, Measure::key_rank)) + " | " +
                number(summary(*row, Measure::total_ms)) + " |\n";
    }
    return text;
}

std::string claims_of(const std::vector<Claim>& claims) {
    std::string text = "\n## What the papers say, and what we find\n\n| they | we | |\n|---|---|---|\n";
    for (const Claim& claim : claims) {
        text +=
            "| " +
            markdown_escaped(claim.text + " (" + claim.source + (claim.test.empty() ? "" : "; " + claim.test) + ")") +
            " | ";
        for (std::size_t i = 0; i < claim.regimes.size(); ++i)
            text += (i > 0 ? "<br>" : "") + markdown_escaped(regime_text(claim, claim.regimes[i]));
        const bool holds = judgement(claim) == Judgement::holds;
        text += " | " + (holds ? verdict_text(claim) : "**" + verdict_text(claim) + "**") + " |\n";
    }
    return text + "\n" + claims_note + "\n";
}

}  // namespace

void write_markdown(const Results& results, const std::string& command, const std::filesystem::path& file) {
    const Conditions& c = results.conditions;
    std::string text = "# Results\n\nMade by\n\n```sh\n" + command + "\n```\n\non " +
                       markdown_escaped(c.date + ": " + c.machine + "; " + c.build + "; " + c.renderer) +
                       ". Times hold for this machine only; everything else is the same everywhere except for single "
                       "pixels. [Measuring](measuring.md) says what each number is and how to read the charts.\n";
    if (const std::vector<Claim> claims = judge_claims(results); !claims.empty()) text += claims_of(claims);
    if (const TextTable table = winners_table(results); !table.rows.empty())
        text += "\n## Who wins where\n\n" + winners_text(results) + "\n\n" + markdown(table);
    if (const std::vector<Table1Row> table = table_1(results); !table.empty())
        text += "\n## Table 1 of the papers\n\n" + std::string(table_1_caption) + "\n\n" + markdown(text_table(table));
    if (const TextTable table = gem_table(results); !table.rows.empty())
        text += "\n## The gem's power plant\n\n" + std::string(gem_caption) + "\n\n" + markdown(table);
    if (const std::vector<PreprocessingRow> table = preprocessing(results); !table.empty())
        text += "\n## Preprocessing\n\n" + std::string(preprocessing_caption) + "\n\n" + markdown(text_table(table));
    if (!results.flights.empty())
        text += "\n## Budgets in time\n\n" + std::string(budget_caption) + "\n\n" + markdown(budget_table(results));
    if (!results.wrong_flights.empty())
        text += "\n## Budgets in wrong pixels\n\n" + std::string(wrong_budget_caption) + "\n\n" +
                markdown(wrong_budget_table(results));
    const std::filesystem::path images = file.parent_path() / "images";
    std::filesystem::create_directories(images);
    for (const Group& group : groups(results)) {
        const Row& first = *group.rows.front();
        text += "\n## " + markdown_escaped(group.scene + ", path " + group.path) + "\n\n" +
                std::to_string(first.primitives) + " primitives, " + std::to_string(first.frames.size()) +
                " frames, reference: " + markdown_escaped(first.reference) + ".\n\n";
        for (const Measure measure : {Measure::wrong, Measure::coverage}) {
            const std::string stem =
                file_stem("results-" + group.scene + "-" + group.path + "-" + std::string(measure_row(measure).id));
            write_chart(trade_off(group, measure), images / stem);
            for (const char* const other : {".gp", ".png", ".pdf"}) std::filesystem::remove(images / (stem + other));
            text += "![Time per frame and " + std::string(measure_row(measure).title) +
                    " of each method and budget](images/" + stem + ".svg)\n";
        }
        text += "\n" + table_rows_of(group) + "\n" + time_caption + "\n\n" + markdown(time_table(group));
    }
    write_file(file, text);
}

}  // namespace sightline::lab
