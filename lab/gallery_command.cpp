// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/file.h"
#include "core/number.h"
#include "lab/command.h"
#include "lab/gallery.h"
#include "lab/lab_graphics.h"
#include "lab/study_options.h"

namespace sightline::lab {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Counts {
    std::size_t scenes = 0, expectations = 0, pending = 0, surprises = 0;
};

struct Asked {
    std::vector<std::string> ids;
    bool list = false;
    std::string out, json;
};

template <int D>
std::string name_of(const GalleryRow<D>& row) {
    return std::to_string(D) + "d:" + row.id;
}

template <int D>
bool is_asked(const Asked& asked, const GalleryRow<D>& row) {
    return asked.ids.empty() || std::any_of(asked.ids.begin(), asked.ids.end(),
                                            [&](const std::string& id) { return id == row.id || id == name_of(row); });
}

void check_ids(const Asked& asked) {
    for (const std::string& id : asked.ids) {
        const auto names = [&](const auto& rows) {
            return std::any_of(rows.begin(), rows.end(),
                               [&](const auto& row) { return id == row.id || id == name_of(row); });
        };
        if (!names(gallery<2>()) && !names(gallery<3>()))
            throw InputError("the gallery has no scene '" + id + "' (--list lists them)");
    }
}

std::string bound_text(const Expectation& e) {
    return std::string(e.bound == Bound::at_least ? "at least " : "at most ") + short_number(e.threshold);
}

const char* word(const Verdict& verdict) {
    if (verdict.kind == Verdict::Kind::pending) return "pending";
    if (verdict.kind == Verdict::Kind::surprise) return "SURPRISE";
    return verdict.passed ? "passes" : "fails";
}

void print(const Verdict& verdict) {
    const Expectation& e = *verdict.expectation;
    std::string line = "  " + std::string(word(verdict));
    line.resize(12, ' ');
    std::cout << line << e.subject << ": ";
    if (verdict.kind == Verdict::Kind::pending) {
        std::cout << "skipped, there is no such method yet; will be held to " << e.measure << " " << bound_text(e)
                  << "\n";
        return;
    }
    std::cout << e.measure << " " << (std::isnan(verdict.value) ? "none" : short_number(verdict.value)) << ", "
              << bound_text(e) << ": " << e.means << "\n";
    if (verdict.kind != Verdict::Kind::surprise) return;
    if (e.expect == Expect::pending)
        std::cout << "            was pending, but it exists now: say what is expected of it\n";
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
        static constexpr const char* kinds[] = {"expected", "surprise", "pending"};
        json["expectations"].push_back({{"subject", e.subject},
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

template <int D>
void write_state(const GalleryRow<D>& row, const Asked& asked, const DrawIds& draw_ids) {
    const fs::path file = fs::path(asked.out) / (std::string(row.id) + "-" + std::to_string(D) + "d.json");
    write_file(file.string(), gallery_state(row, draw_ids));
    std::cout << "  ./run viewer" << D << "d --state " << file.string() << "\n";
}

template <int D>
void show(const Asked& asked, int number, LabGraphics& graphics, Counts& counts, Json& json) {
    for (const GalleryRow<D>& row : gallery<D>()) {
        if (row.number != number || !is_asked(asked, row)) continue;
        std::cout << name_of(row) << " (D " << number << "): " << row.look << "\n";
        if (asked.list) continue;
        const DrawIds draw_ids = D == 3 ? graphics.draw_ids() : DrawIds{};
        const std::vector<Verdict> verdicts = measure_row(row, draw_ids);
        for (const Verdict& verdict : verdicts) {
            print(verdict);
            counts.pending += verdict.kind == Verdict::Kind::pending;
            counts.surprises += verdict.kind == Verdict::Kind::surprise;
        }
        ++counts.scenes;
        counts.expectations += verdicts.size();
        if (!asked.out.empty()) write_state(row, asked, draw_ids);
        json.push_back(row_json(row, verdicts));
    }
}

}  // namespace

int gallery_command(int argc, const char* const* argv) {
    CLI::App app{"Measures the scenes in which methods fail, and says who passes and who does not.", "lab gallery"};
    Asked asked;
    app.add_option("SCENE", asked.ids,
                   "ids of the gallery, 2d: or 3d: before one for that dimension only; default: all");
    app.add_flag("--list", asked.list, "lists the scenes with what to look at, measures nothing");
    app.add_option("--out", asked.out, "folder for a state file per scene, which a viewer opens where it goes wrong");
    app.add_option("--json", asked.json, "writes what was measured to this file");
    if (!parse(app, argc, argv)) return 0;
    check_ids(asked);
    if (!asked.out.empty()) fs::create_directories(asked.out);
    LabGraphics graphics;
    Counts counts;
    Json json = Json::array();
    for (int number = 1; number <= gallery_numbers; ++number) {
        show<2>(asked, number, graphics, counts, json);
        show<3>(asked, number, graphics, counts, json);
    }
    if (asked.list) return 0;
    if (!asked.json.empty()) write_file(asked.json, json.dump(1) + "\n");
    std::cout << counts.scenes << " scenes, " << counts.expectations << " expectations, " << counts.pending
              << " pending, " << counts.surprises << " surprises\n";
    return counts.surprises > 0 ? 1 : 0;
}

}  // namespace sightline::lab
