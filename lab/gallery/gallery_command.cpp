// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/quote.h"
#include "core/base/text.h"
#include "core/session/state_file.h"
#include "lab/command.h"
#include "lab/gallery/gallery_report.h"
#include "lab/measure/conditions.h"
#include "lab/measure/study_options.h"
#include "lab/report/remaining.h"
#include "lab/report/say.h"

namespace sightline::lab {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Asked {
    std::vector<std::string> ids;
    std::vector<std::string> also;
    MethodTables tables;
    bool list = false;
    std::string out, json;
};

template <int D>
std::string name_of(const GalleryRow<D>& row) {
    return std::to_string(D) + "d:" + row.id;
}

/// By its id, with or without dimension, or by its scene as the viewers know it.
template <int D>
bool is_named(const std::string& id, const GalleryRow<D>& row) {
    return id == row.id || id == name_of(row) || id == row.scene;
}

template <int D>
bool is_asked(const Asked& asked, const GalleryRow<D>& row) {
    return asked.ids.empty() ||
           std::any_of(asked.ids.begin(), asked.ids.end(), [&](const std::string& id) { return is_named(id, row); });
}

void check_ids(const Asked& asked) {
    for (const std::string& id : asked.ids) {
        const auto names = [&](const auto& rows) {
            return std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return is_named(id, row); });
        };
        if (!names(gallery<2>()) && !names(gallery<3>()))
            throw InputError("the gallery has no scene '" + id + "' (--list lists them)");
    }
}

template <int D>
std::string heading(const GalleryRow<D>& row) {
    return name_of(row) + " (D " + std::to_string(row.number) + "): " + row.look;
}

std::string bound_text(const Expectation& e) {
    return std::string(e.bound == Bound::at_least ? "at least " : "at most ") + short_number(e.threshold);
}

void print(const Verdict& verdict) {
    const Expectation& e = *verdict.expectation;
    std::string line = "  " + std::string(verdict_word(verdict));
    line.resize(12, ' ');
    std::cout << line << verdict.subject << ": ";
    if (verdict.kind == Verdict::Kind::pending) {
        std::cout << "skipped, there is no such method yet; will be tested for " << e.measure << " " << bound_text(e)
                  << "\n";
        return;
    }
    std::cout << e.measure << " " << (std::isnan(verdict.value) ? "none" : short_number(verdict.value)) << ", "
              << bound_text(e) << ": " << e.means << "\n";
    if (verdict.kind != Verdict::Kind::surprise) return;
    if (e.expect == Expect::pending)
        std::cout << "            was pending, but the method exists now: add what is expected of it\n";
    else
        std::cout << "            was expected to " << (e.expect == Expect::pass ? "pass" : "fail") << "\n";
}

template <int D>
Json row_json(const GalleryRow<D>& row, std::span<const Verdict> verdicts) {
    Json json{{"id", name_of(row)}, {"number", row.number}, {"scene", row.scene}, {"look", row.look}};
    json["expectations"] = Json::array();
    for (const Verdict& verdict : verdicts) {
        const Expectation& e = *verdict.expectation;
        static constexpr const char* expects[] = {"pass", "fail", "pending"};
        static constexpr const char* kinds[] = {"expected", "surprise", "pending", "asked"};
        json["expectations"].push_back({{"subject", verdict.subject},
                                        {"measure", e.measure},
                                        {"value", std::isfinite(verdict.value) ? Json(verdict.value) : Json(nullptr)},
                                        {"bound", e.bound == Bound::at_least ? "at least" : "at most"},
                                        {"threshold", e.threshold},
                                        {"expected", expects[static_cast<std::size_t>(e.expect)]},
                                        {"verdict", kinds[static_cast<std::size_t>(verdict.kind)]},
                                        {"means", e.means}});
    }
    return json;
}

/// The state file and the pictures, into the folder that was asked for.
template <int D>
void write_files(const GalleryRow<D>& row, const Asked& asked, LabGraphics& graphics, GalleryEntry& entry) {
    const Session<D> session = gallery_session(row, D == 3 ? graphics.draw_ids() : DrawIds{}, asked.tables.of<D>());
    const std::string stem = std::string(row.id) + "-" + std::to_string(D) + "d";
    const fs::path file = fs::path(asked.out) / (stem + ".json");
    write_file(file.string(), state_json(session));
    entry.command = "./run viewer" + std::to_string(D) + "d --state " + shell_quoted(file.string());
    entry.title = session.scene().title;
    entry.lesson = session.scene().lesson;
    entry.pictures = draw_gallery_pictures(session, fs::path(asked.out) / "pictures", stem, graphics);
}

template <int D>
void list(const Asked& asked, int number) {
    for (const GalleryRow<D>& row : gallery<D>())
        if (row.number == number && is_asked(asked, row)) std::cout << heading(row) << "\n";
}

template <int D>
void measure(const Asked& asked, int number, LabGraphics& graphics, std::size_t scenes, Remaining& remaining,
             std::vector<GalleryEntry>& entries, Json& json) {
    for (const GalleryRow<D>& row : gallery<D>()) {
        if (row.number != number || !is_asked(asked, row)) continue;
        say(name_of(row) + ": scene " + std::to_string(entries.size() + 1) + " of " + std::to_string(scenes) +
            remaining.text());
        GalleryEntry entry{name_of(row), D, number, "", "", row.look, {}, {}, ""};
        entry.verdicts = measure_row(row, D == 3 ? graphics.draw_ids() : DrawIds{}, asked.tables.of<D>(), asked.also);
        if (!asked.out.empty()) write_files(row, asked, graphics, entry);
        say("");
        std::cout << heading(row) << "\n";
        for (const Verdict& verdict : entry.verdicts) print(verdict);
        if (!entry.command.empty()) std::cout << "  " << entry.command << "\n";
        json.push_back(row_json(row, entry.verdicts));
        entries.push_back(std::move(entry));
        remaining.done(1);
    }
}

template <int D>
std::size_t count_asked(const Asked& asked) {
    const auto rows = gallery<D>();
    return static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.end(), [&](const GalleryRow<D>& row) { return is_asked(asked, row); }));
}

/// In words; asks for OpenGL only where it drew something.
std::string conditions(const Asked& asked, LabGraphics& graphics) {
    const Conditions here = conditions_here("{}", count_asked<3>(asked) > 0 ? graphics.description() : "");
    return "Measured " + here.date + " on " + here.machine + "; " + here.build +
           (here.renderer.empty() ? "" : "; " + here.renderer) +
           ". V is exact in 2D, an item buffer of 512x384 in 3D. No number depends on a clock.";
}

}  // namespace

int gallery_command(int argc, const char* const* argv, const MethodTables& tables) {
    CLI::App app{"Measures the scenes in which methods fail, and says which methods pass and which do not.",
                 "lab gallery"};
    Asked asked;
    app.add_option("SCENE", asked.ids,
                   "ids of gallery scenes, with 2d: or 3d: before one for that dimension only; default: all");
    app.add_flag("--list", asked.list, "list the scenes and what to look at, and measure nothing");
    app.add_option(
        "--out", asked.out,
        "folder for gallery.html, a page to hand out, and for a state file per scene, which a viewer opens at "
        "the step that goes wrong");
    app.add_option("--also", asked.also,
                   "another method, with or without parameters, tested on all that published is tested on; may be "
                   "given several times")
        ->allow_extra_args(false);
    app.add_option("--json", asked.json, "write the measured values to this file");
    if (!parse(app, argc, argv)) return 0;
    asked.tables = tables;
    for (const std::string& method : asked.also) parse_method(method, tables);  // throws for what does not exist
    check_ids(asked);
    if (!asked.out.empty() && !asked.list) fs::create_directories(asked.out);
    if (asked.list) {
        for (int number = 1; number <= gallery_numbers; ++number) {
            list<2>(asked, number);
            list<3>(asked, number);
        }
        return 0;
    }
    LabGraphics graphics;
    const std::size_t scenes = count_asked<2>(asked) + count_asked<3>(asked);
    Remaining remaining(static_cast<double>(scenes));
    std::vector<GalleryEntry> entries;
    Json json = Json::array();
    for (int number = 1; number <= gallery_numbers; ++number) {
        measure<2>(asked, number, graphics, scenes, remaining, entries, json);
        measure<3>(asked, number, graphics, scenes, remaining, entries, json);
    }
    if (!asked.json.empty()) write_file(asked.json, json.dump(1) + "\n");
    if (!asked.out.empty()) {
        const fs::path file = fs::path(asked.out) / "gallery.html";
        write_file(file, gallery_page(entries, conditions(asked, graphics)));
        std::cout << "Written: " << one_line(file.string(), 4096) << ", state files, pictures/\n";
    }
    const GalleryCounts counts = count(entries);
    std::cout << counts_text(counts) << "\n";
    return counts.surprises > 0 ? 1 : 0;
}

}  // namespace sightline::lab
