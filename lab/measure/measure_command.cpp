// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/quote.h"
#include "core/base/text.h"
#include "lab/command.h"
#include "lab/measure/left_out.h"
#include "lab/measure/out_folder.h"
#include "lab/measure/run_study.h"
#include "lab/measure/study_options.h"
#include "lab/measure/time_budget.h"
#include "lab/measure/wrong_budget.h"
#include "lab/report/chart_options.h"
#include "lab/report/markdown.h"
#include "lab/report/page.h"
#include "lab/report/report.h"
#include "lab/report/say.h"

namespace sightline::lab {

namespace {

/// To so many characters, not bytes.
std::string padded(std::string text, std::size_t width, bool left = false) {
    const auto size = static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
    if (size < width) text.insert(left ? text.size() : 0, width - size, ' ');
    return text;
}

/// The command as it was given, to the start script.
std::string typed(int argc, const char* const* argv) {
    std::string text = "./run lab";
    for (int i = 0; i < argc; ++i) text += " " + shell_quoted(argv[i]);
    return text;
}

/// "published 5% (0.3 % wrong, 12.1 ms)"
std::string in_short(const Row& row) {
    return one_line(method_text(row.method)) + (row.budget == "unlimited" ? "" : " " + one_line(row.budget)) + " (" +
           per_cent(summary(row, Measure::wrong)) + " % wrong, " + number(summary(row, Measure::total_ms)) + " ms)";
}

/// What comes out of it, a line or two for each scene and path, before the table.
void print_summary(const Results& results) {
    for (const Group& group : groups(results)) {
        const Row *safe = nullptr, *right = nullptr;
        for (const Row* row : group.rows) {
            const double ms = summary(*row, Measure::total_ms), wrong = summary(*row, Measure::wrong);
            if (row->method.variant == exactly_v) continue;
            if (!row->approximate && ms >= 0 && (!safe || ms < summary(*safe, Measure::total_ms))) safe = row;
            if (row->approximate && wrong >= 0 && (!right || wrong < summary(*right, Measure::wrong))) right = row;
        }
        std::cout << one_line(group.scene + ", path " + group.path) << ":\n";
        if (const Row* const best = best_within(group, 16)) std::cout << "  within 16 ms: " << in_short(*best) << "\n";
        if (safe) std::cout << "  fastest that never misses: " << in_short(*safe) << "\n";
        if (right) std::cout << "  fewest wrong pixels of those that may miss: " << in_short(*right) << "\n";
    }
    std::cout << "\n";
}

/// What a person wants to see at once.
void print_table(const Results& results) {
    using M = Measure;
    static constexpr std::array<std::pair<M, std::size_t>, 6> columns{{{M::emitted_over_visible, 9},
                                                                       {M::traverse_ms, 10},
                                                                       {M::upload_ms, 8},
                                                                       {M::draw_ms, 8},
                                                                       {M::total_ms, 8},
                                                                       {M::over_exact, 8}}};
    std::size_t scene = 5, method = 6;  // widths, with the headings
    for (const Row& row : results.rows) {
        scene = std::max(scene, one_line(row.scene).size());
        method = std::max(method, one_line(method_text(row.method)).size());
    }
    std::cout << padded("scene", scene + 2, true) << padded("method", method + 2, true) << padded("budget", 10)
              << padded("coverage %", 12) << padded("wrong %", 9) << padded("worst %", 9) << padded("pop %", 8)
              << padded("drawn/V", 9) << padded("traverse", 10) << padded("upload", 8) << padded("draw", 8)
              << padded("ms", 8) << padded("ms/V's", 8) << "\n";
    for (const Row& row : results.rows) {
        const auto share = [&](Measure measure) { return per_cent(summary(row, measure)); };
        std::cout << padded(one_line(row.scene), scene + 2, true)
                  << padded(one_line(method_text(row.method)), method + 2, true) << padded(one_line(row.budget), 10)
                  << padded(share(Measure::coverage), 12) << padded(share(Measure::wrong), 9)
                  << padded(per_cent(worst(row, Measure::wrong)), 9) << padded(share(Measure::pop), 8);
        for (const auto& [measure, width] : columns) std::cout << padded(number(summary(row, measure)), width);
        std::cout << "\n";
    }
    for (const WrongFlight& flight : results.wrong_flights)
        std::cout << one_line(flight.scene + ", " + flight.path + ", " + method_text(flight.method)) << ": "
                  << kept_text(flight) << "\n";
    for (const TimedFlight& flight : results.flights)
        std::cout << one_line(flight.scene + ", " + flight.path + ", " + method_text(flight.method)) << ": "
                  << per_cent(share_kept(flight)) << " % of " << flight.frames.size() << " frames within "
                  << flight.budget << " + 10 %, the worst " << number(longest_ms(flight)) << " ms\n";
}

void say_written(const std::string& out) {
    std::cout << "Written: " << one_line(out, 4096) << "/report.html, results.json, results.csv, charts/, pictures/\n";
}

/// 0 for a file that is not there.
std::uintmax_t size_of(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    return error ? 0 : size;
}

/// Numbers of a path that sees nothing look perfect.
void warn_of_empty_paths(const Results& results) {
    std::set<std::pair<std::string, std::string>> sees, all;
    for (const Row& row : results.rows) {
        all.emplace(row.scene, row.path);
        for (const Values& values : row.values)
            if (values[Measure::visible] > 0) sees.emplace(row.scene, row.path);
    }
    for (const auto& [scene, path] : all)
        if (!sees.contains({scene, path}))
            std::cerr << "lab: warning: nothing of " << one_line(scene) << " is visible in any frame of "
                      << one_line(path) << ": does the path belong to this scene?\n";
}

/// The report with its pictures; without them where a scene is not here, as on the machine that merges, or OpenGL.
void write_report_of(const Results& results, const Study& study, const std::filesystem::path& folder,
                     LabGraphics& graphics, const ChartFormat& format) {
    say("drawing the worst frames and the charts");
    const std::vector<Claim> claims = judge_claims(results);
    ReportPictures pictures;
    try {
        if (has_3d(study) && !graphics.has_opengl()) throw InputError("there is no OpenGL");
        pictures = draw_report_pictures(results, claims, study, folder / "pictures", graphics);
    } catch (const InputError& error) {
        say("");
        std::cerr << "lab: warning: the report has no pictures: " << one_line(error.what(), 1000) << "\n";
    }
    write_report(results, claims, pictures, folder, format);
}

}  // namespace

int measure_command(int argc, const char* const* argv, const MethodTables& tables) {
    CLI::App app{"Measures methods on scenes along paths: accuracy, stability and time.", "lab measure"};
    StudyOptions options;
    add_study_options(app, options);
    std::string out, shard, markdown;
    app.add_option("--out", out,
                   "folder of the results, where an interrupted study continues; default: out/lab-SCENE-PATH, a folder "
                   "for each study");
    app.add_option("--shard", shard,
                   "I/N: only every N-th pair of scene and path, from the I-th on; in out/lab-SCENE-I-of-N");
    app.add_option("--markdown", markdown,
                   "also write a documentation page, FILE.md, with its charts in images/ beside it");
    ChartFormat format;
    add_chart_options(app, format);
    if (!parse(app, argc, argv)) return 0;
    const bool of_the_papers = options.scenes.empty() && options.paths.empty();
    ask_for_claims(options);
    Study study = study_of(options, tables);
    add_baselines(study);
    StudyRun run;
    if (!shard.empty()) run.shard = parse_shard(shard);
    if (out.empty()) {
        std::vector<std::string> parts = of_the_papers ? std::vector<std::string>{"papers"} : name_parts(study);
        // Parts that run at once must not write to one folder.
        if (!shard.empty())
            parts.push_back(std::to_string(run.shard.index + 1) + "-of-" + std::to_string(run.shard.count));
        out = folder_for(folder_named("lab", parts), "frames.jsonl", study_json(study));
    }
    run.say = say;
    note_interrupts();
    run.stopped = interrupted;
    LabGraphics graphics;
    for (const std::string& line : left_out(study, !has_3d(study) || graphics.has_opengl())) warn(line);
    const std::uintmax_t before = size_of(std::filesystem::path(out) / "frames.jsonl");
    const Results results = run_study(study, out, graphics, run);
    const bool all_kept = before > 0 && before == size_of(std::filesystem::path(out) / "frames.jsonl");
    write_results(results, out, claims_json(judge_claims(results)));
    if (interrupted()) return stopped();
    if (!results.rows.empty()) {
        write_report_of(results, study, out, graphics, format);
        if (!markdown.empty()) write_markdown(results, typed(argc, argv), markdown);
    }
    say("");
    print_summary(results);
    print_table(results);
    warn_of_empty_paths(results);
    if (all_kept) std::cout << "All frames were measured before; to measure them again choose another --out.\n";
    say_written(out);
    return 0;
}

int merge_command(int argc, const char* const* argv, const MethodTables& tables) {
    CLI::App app{"Merges the parts of a study that were measured separately.", "lab merge"};
    std::vector<std::string> parts;
    std::string out = "out/lab-merged";
    app.add_option("RESULTS", parts, "folder or results.json of each part")->required();
    app.add_option("--out", out, "folder of the results")->capture_default_str();
    ChartFormat format;
    add_chart_options(app, format);
    if (!parse(app, argc, argv)) return 0;
    std::vector<Results> read;
    for (const std::string& part : parts) read.push_back(load_results(part));
    std::filesystem::create_directories(out);
    const Results all = merge(read);
    write_results(all, out, claims_json(judge_claims(all)));
    LabGraphics graphics;
    write_report_of(all, read_study(all.conditions.study, tables), out, graphics, format);
    say("");
    print_summary(all);
    print_table(all);
    say_written(out);
    return 0;
}

}  // namespace sightline::lab
