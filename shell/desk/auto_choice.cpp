// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/auto_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_input.h"
#include "core/base/machine.h"
#include "core/base/number.h"
#include "core/base/stopwatch.h"
#include "core/measure/recommend.h"
#include "core/measure/trade_off.h"
#include "core/session/settings_table.h"
#include "core/truth/software_ids.h"
#include "shell/desk/change.h"
#include "shell/desk/frames_to_measure.h"

namespace sightline {

namespace {

constexpr const char* file_format = "sightline-auto";
constexpr std::uint64_t most_bytes = 1 << 20;
constexpr std::size_t most_kept = 200, measured_frames = 4;
/// What drawing counts where it cannot be timed.
constexpr double guessed_ms = 0.001;

/// An array of {key, …}; empty where the file is not there or not ours.
Json read_choices(const std::filesystem::path& file) {
    std::error_code error;
    if (file.empty() || !std::filesystem::exists(file, error)) return Json::array();
    try {
        const Json root = parse_json(read_file(file, most_bytes), file.string());
        if (root.is_object() && root.value("format", "") == file_format && root.contains("choices") &&
            root["choices"].is_array())
            return root["choices"];
    } catch (const InputError&) {
    } catch (const Json::exception&) {
    }
    return Json::array();
}

bool has_key(const Json& entry, const std::string& key) {
    return entry.is_object() && entry.contains("key") && entry["key"] == key;
}

template <int D>
std::vector<FrameToMeasure<D>> frames_of(const Workbench<D>& bench) {
    const auto& chosen = bench.flight.path.frames;
    const auto& paths = bench.session.scene().paths;
    const auto& all = !chosen.empty() || paths.empty() ? chosen : paths.front().frames;
    return frames_to_measure(all, bench.session.culling_view(), measured_frames);
}

template <int D>
std::string path_name(const Workbench<D>& bench) {
    if (!bench.flight.path.frames.empty()) return "path " + bench.flight.path.id;
    const auto& paths = bench.session.scene().paths;
    return paths.empty() ? "the view" : "path " + paths.front().id;
}

/// What the bench's methods offer on these cells.
template <int D>
TradeOffTask<D> task_of(const Workbench<D>& bench, Tessellation tessellation, bool cells_only,
                        const std::optional<Budget>& budget) {
    const Session<D>& session = bench.session;
    Settings settings = session.settings();
    TradeOffTask<D> task{session.shared_scene(), session.shared_cells(), settings.reference_size};
    if (settings.tessellation != tessellation) {
        settings.tessellation = tessellation;
        task.cells = std::make_shared<const CellComplex<D>>(build_cells(session.scene(), settings));
    }
    add_frames(task, frames_of(bench));
    task.variants = auto_methods(bench, cells_only);
    task.budget = budget;
    if (budget) task.before.clear();  // a first frame renders most, and is not to be cut short either
    task.draw_ids = drawing_of(settings.reference, bench.graphics.draw_ids);
    if (D == 3 && bench.graphics.time_drawing) task.time_drawing = bench.graphics.time_drawing(settings.reference_size);
    return task;
}

template <int D>
void add_offers(const TradeOffStudy<D>& study, Tessellation tessellation, std::vector<Offer>& offers) {
    for (const TradeOffDot& dot : study.dots()) {
        const Variant<D>& variant = study.task().variants[dot.variant];
        const std::optional<Budget>& asked = study.task().budget;
        const std::uint32_t most = asked ? asked->primitives(study.task().scene->primitives.size()) : none;
        if (!variant.method.budgeted && std::any_of(dot.frames.begin(), dot.frames.end(), [&](const Values& frame) {
                return frame[Measure::rendered] > most;
            }))
            continue;
        double ms = study.value(dot, Measure::total_ms);
        if (!study.task().time_drawing) ms += guessed_ms * study.value(dot, Measure::rendered);
        offers.push_back({variant.text, tessellation, dot.budget, ms, study.value(dot, Measure::wrong),
                          variant.method.promise_with(variant.parameters) != Misses::may,
                          study.value(dot, Measure::total_error)});
    }
}

/// In the frames that were measured.
template <int D>
InView what_frames_show(const TradeOffStudy<D>& study) {
    std::vector<double> drawn, visible;
    for (const TradeOffDot& dot : study.dots()) {
        if (study.task().variants[dot.variant].method.id != "view") continue;
        for (const Values& frame : dot.frames) {
            drawn.push_back(frame[Measure::rendered]);
            visible.push_back(frame[Measure::visible]);
        }
    }
    return what_is_in_view(drawn, visible);
}

/// "layers on tree cells at 5%, 3.62 ms"
std::string offer_text(const std::string& method, std::string_view tessellation, const std::string& budget, double ms) {
    std::string text = method;
    if (tessellation != word(Tessellation::delaunay)) text += " on " + std::string(tessellation) + " cells";
    if (budget != "unlimited") text += " at " + budget;
    return text + ", " + short_number(ms) + " ms";
}

std::string since_words(InView what) {
    switch (what) {
        case InView::nearly_all_visible:
            return "nearly all that is in view is visible";
        case InView::nothing_visible:
            return "nothing that is in view is visible";
        case InView::nothing:
            return "nothing is in view";
        case InView::much_hidden:
            break;
    }
    return "";
}

}  // namespace

std::string auto_text(const AutoChoice& choice) {
    std::string text = "auto: " + offer_text(choice.method, choice.tessellation, choice.budget, choice.ms);
    if (choice.guessed_ms > 0) text += " with drawing as " + short_number(1000 * choice.guessed_ms) + " ms per 1000";
    text += ", " + (choice.wrong == 0 ? std::string("nothing wrong")
                                      : short_number(100 * choice.wrong) + " % of the pixels wrong");
    text += choice.frames == 1 ? ", in one frame" : ", over " + std::to_string(choice.frames) + " frames";
    if (!choice.since.empty()) text += ", since " + choice.since;
    if (!choice.close.empty()) text += "; a close call with " + choice.close;
    return text + "; measured " + choice.date;
}

std::filesystem::path auto_file() {
    const auto folder = [](const char* variable) {
        const char* const value = std::getenv(variable);
        const std::filesystem::path path = value ? value : "";
        return path.is_absolute() ? path : std::filesystem::path();
    };
    std::filesystem::path cache = folder("XDG_CACHE_HOME");
    if (cache.empty() && !folder("HOME").empty()) cache = folder("HOME") / ".cache";
    return cache.empty() ? cache : cache / "sightline" / "auto.json";
}

std::optional<AutoChoice> recall_auto(const std::filesystem::path& file, const std::string& key) {
    for (const Json& entry : read_choices(file)) {
        if (!has_key(entry, key)) continue;
        try {
            AutoChoice choice{entry.at("method"), entry.at("tessellation"), entry.at("budget"),     entry.at("ms"),
                              entry.at("wrong"),  entry.at("frames"),       entry.at("guessed_ms"), entry.at("close"),
                              entry.at("since"),  entry.at("date")};
            Settings checked;  // what an older program knew may be gone
            apply_setting(checked, "tessellation=" + choice.tessellation);
            apply_setting(checked, "budget=" + choice.budget);
            return choice;
        } catch (const Json::exception&) {
        } catch (const InputError&) {
        }
    }
    return std::nullopt;
}

void keep_auto(const std::filesystem::path& file, const std::string& key, const AutoChoice& choice) {
    if (file.empty()) return;
    Json kept = Json::array();
    kept.push_back({{"key", key},
                    {"method", choice.method},
                    {"tessellation", choice.tessellation},
                    {"budget", choice.budget},
                    {"ms", choice.ms},
                    {"wrong", choice.wrong},
                    {"frames", choice.frames},
                    {"guessed_ms", choice.guessed_ms},
                    {"close", choice.close},
                    {"since", choice.since},
                    {"date", choice.date}});
    for (const Json& entry : read_choices(file))
        if (!has_key(entry, key) && kept.size() < most_kept) kept.push_back(entry);
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) throw WorkError("cannot make the folder " + file.parent_path().string() + ": " + error.message());
    const Json root{{"format", file_format}, {"choices", kept}};
    write_file(file, root.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

template <int D>
std::string auto_key(const Workbench<D>& bench) {
    const Session<D>& session = bench.session;
    return hash_text(scene_hash(session.scene())) + ", " + path_name(bench) + ", " +
           setting_row("reference_size").get(session.settings()) + ", error bound " +
           number_text(session.settings().error_bound) + (bench.graphics.time_drawing ? ", drawn" : "") + ", " +
           machine_text();
}

template <int D>
std::vector<Variant<D>> auto_methods(const Workbench<D>& bench, bool cells_only) {
    const Parameters& parameters = bench.session.settings().parameters;
    std::vector<Variant<D>> variants;
    for (const bool cells : {false, true})
        for (const Method<D>& method : bench.methods)
            if (method.compared && !method.draws_levels && method.needs.cells == cells && (cells || !cells_only))
                variants.push_back(variant_of(method, parameters, parameters));
    return variants;
}

template <int D>
AutoChoice measure_auto(const Workbench<D>& bench, double seconds, const std::optional<Budget>& budget) {
    std::vector<Offer> offers;
    const Stopwatch clock;
    std::optional<std::size_t> of_view;
    InView shown = InView::much_hidden;
    std::array<std::size_t, 2> frames{};  // on Delaunay cells and on those of the tree
    bool timed_drawing = false;
    for (const Tessellation tessellation : {Tessellation::delaunay, Tessellation::tree}) {
        const bool first = tessellation == Tessellation::delaunay;
        TradeOffStudy<D> study(task_of(bench, tessellation, !first, budget));
        const double until = 1000 * seconds * (first ? 0.7 : 1);
        while (clock.milliseconds() < until && study.advance())
            report(bench.graphics.progress, "measuring methods",
                   (first ? 0 : 0.7) +
                       (first ? 0.7 : 0.3) * static_cast<double>(study.done()) / static_cast<double>(study.total()));
        add_offers(study, tessellation, offers);
        frames[first ? 0 : 1] = std::max<std::size_t>(study.common_views(), 1);
        timed_drawing = bool(study.task().time_drawing);
        if (first) shown = what_frames_show(study);
    }
    for (std::size_t i = 0; i < offers.size(); ++i)
        if (offers[i].variant == "view" && !std::isnan(offers[i].ms)) of_view = i;
    const bool view_will_do = shown != InView::much_hidden && of_view;
    const std::optional<std::size_t> best = view_will_do ? of_view : recommend(offers);
    if (!best) throw WorkError("auto: nothing could be measured in " + short_number(seconds) + " s");
    const Offer& offer = offers[*best];
    const std::optional<std::size_t> close = view_will_do ? std::nullopt : close_second(offers, *best);
    const auto text = [](const Offer& o) {
        return offer_text(o.variant, word(o.tessellation), budget_text(o.budget), o.ms);
    };
    return {offer.variant,
            std::string(word(offer.tessellation)),
            budget_text(budget.value_or(offer.budget)),
            offer.ms,
            offer.wrong,
            static_cast<std::uint32_t>(frames[offer.tessellation == Tessellation::delaunay ? 0 : 1]),
            timed_drawing ? 0 : guessed_ms,
            close ? text(offers[*close]) : std::string(),
            view_will_do ? since_words(shown) : std::string(),
            today_text()};
}

template <int D>
void choose_auto(Workbench<D>& bench, bool again, const Settings& wanted, const std::optional<Budget>& budget) {
    const std::string key = auto_key(bench) + (budget ? ", budget " + budget_text(*budget) : "");
    std::optional<AutoChoice> choice = again ? std::nullopt : recall_auto(bench.auto_file, key);
    if (choice) try {
            make_variant<D>(bench.methods, choice->method);
        } catch (const InputError&) {
            choice.reset();  // of another program
        }
    if (!choice) {
        choice = measure_auto(bench, 20, budget);
        try {
            keep_auto(bench.auto_file, key, *choice);
        } catch (const WorkError& error) {
            bench.say("warning: what auto found is not remembered: " + std::string(error.what()));
        }
    }
    Settings settings = wanted;
    settings.automatic = Switch::on;
    settings.method = choice->method;
    apply_setting(settings, "tessellation=" + choice->tessellation);
    apply_setting(settings, "budget=" + choice->budget);
    change_settings(bench, settings, "", SetBy::recommendation);
    bench.say(auto_text(*choice));
}

template <int D>
void change_by_hand(Workbench<D>& bench, const Settings& settings) {
    const Switch before = bench.session.settings().automatic;
    if (settings.automatic == Switch::on && before == Switch::off) return choose_auto(bench, false, settings);
    change_settings(bench, settings);
}

#define SIGHTLINE_INSTANTIATE(D)                                                                      \
    template std::string auto_key<D>(const Workbench<D>&);                                            \
    template std::vector<Variant<D>> auto_methods<D>(const Workbench<D>&, bool);                      \
    template AutoChoice measure_auto<D>(const Workbench<D>&, double, const std::optional<Budget>&);   \
    template void choose_auto<D>(Workbench<D>&, bool, const Settings&, const std::optional<Budget>&); \
    template void change_by_hand<D>(Workbench<D>&, const Settings&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
