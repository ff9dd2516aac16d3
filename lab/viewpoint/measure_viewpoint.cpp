// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/viewpoint/measure_viewpoint.h"

#include <unistd.h>

#include <array>
#include <filesystem>

#include "core/base/error.h"
#include "core/methods/by_viewpoint/table_file.h"
#include "core/scene/read/load.h"
#include "core/scene/scene_view.h"
#include "core/session/settings_table.h"
#include "core/space/builders.h"
#include "lab/measure/lab_scene.h"
#include "lab/measure/study_options.h"
#include "lab/report/say.h"

namespace sightline::lab {

namespace {

namespace fs = std::filesystem;

/// Azimuths and elevations of tables whose sizes are compared.
constexpr auto compared_intervals =
    std::to_array<std::array<std::uint32_t, 2>>({{4, 1}, {8, 1}, {8, 3}, {16, 3}, {16, 7}});

/// Of larger tables no more is worked out than what the path needs.
constexpr std::size_t most_entries = 10'000, most_to_compare = 2500;

/// Views for the cost model: some of the path, and as many of entries from all over the table.
std::vector<View<3>> views_to_fit(const std::vector<View<3>>& of_path, const ViewpointTable<3>& table,
                                  std::size_t count) {
    std::vector<View<3>> views;
    for (const std::size_t frame : spread_frames(of_path.size(), (count + 1) / 2)) views.push_back(of_path[frame]);
    const Analyst<3> analyst(table.problem());
    for (const std::size_t place : spread_frames(table.size(), count / 2))
        views.push_back(scene_view(analyst.views(table.region_of(place), table.interval_of(place)).front(),
                                   *table.problem().scene, table.problem().image));
    return views;
}

/// Empty where no technique asks for cells.
CellComplex<3> cells_for(const Scene<3>& scene, const Variant<3>& by_viewpoint, const MethodTables& tables,
                         const Settings& settings) {
    for (const std::string& text : split_variants(by_viewpoint.parameters.text(techniques_row())))
        if (make_variant<3>(tables.in_3d, text).method.needs.cells) return build_cells(scene, settings);
    return {};
}

std::size_t bytes_as_a_file(const ViewpointTable<3>& table, const std::string& file) {
    if (!file.empty()) {
        write_table(table, file);
        return fs::file_size(file);
    }
    const fs::path passing = fs::temp_directory_path() / ("sightline-table-" + std::to_string(getpid()) + ".json");
    write_table(table, passing);
    const std::size_t bytes = fs::file_size(passing);
    fs::remove(passing);
    return bytes;
}

class Measurement {
public:
    Measurement(const SceneOnPath& where, const ViewpointOptions& options, const MethodTables& tables,
                LabGraphics& graphics)
        : options_(options),
          tables_(tables),
          graphics_(graphics),
          variant_(make_variant<3>(tables.in_3d, options.method)) {
        if (variant_.method.id != by_viewpoint_id)
            throw InputError("--method: '" + variant_.text + "' is not by-viewpoint");
        say("reading " + where.scene);
        const SceneName name = parse_scene(where.scene);
        if (name.dimension == 2) throw InputError("'" + where.scene + "' is 2D: lab viewpoint measures 3D");
        scene_ = std::make_shared<const Scene<3>>(load_scene<3>(name.name));
        const FlightPath<3> path = find_path(*scene_, where.path);
        made_.scene = where.scene;
        made_.path = path.id;
        made_.read = scene_;
        made_.primitives = scene_->primitives.size();
        made_.scene_bytes = scene_->primitives.size() * sizeof(Primitive<3>);
        for (const std::size_t frame :
             spread_frames(path.frames.size(), options.frames ? options.frames : path.frames.size())) {
            made_.frames.push_back(static_cast<std::uint32_t>(frame));
            views_.push_back(scene_view(path.frames[frame], *scene_, options.image));
        }
        Settings settings;
        settings.reference_size = options.image;
        cells_ = cells_for(*scene_, variant_, tables, settings);
        if (variant_.method.needs.boxes) cells_.boxes->of(*scene_);
    }

    std::optional<ViewpointScene> all() {
        if (options_.calibrates && !calibrate()) return std::nullopt;
        if (!options_.table.empty() && fs::exists(options_.table))
            variant_.parameters.set(table_file_row(), options_.table);
        made_.table = table_of(variant_.parameters);
        made_.method = variant_.text;
        made_.fill.known_before = made_.table->known();
        const bool is_small = made_.table->size() <= most_entries;
        if (options_.fills && is_small) fill();
        if (!options_.table.empty() || (options_.fills && is_small))
            made_.fill.file_bytes = bytes_as_a_file(*made_.table, options_.table);
        if (options_.sizes && made_.table->size() <= most_to_compare) compare_sizes();
        if (interrupted()) return std::nullopt;
        WalkTools tools{graphics_.time_drawing(options_.image), graphics_.draw_ids(), options_.repeats,
                        [&](std::size_t done) {
                            say("frame " + std::to_string(done) + " of " + std::to_string(views_.size()));
                            return !interrupted();
                        }};
        made_.walk = walk_by_viewpoint(variant_, *made_.table, scene_, cells_, views_, tools);
        if (!options_.table.empty()) made_.fill.file_bytes = bytes_as_a_file(*made_.table, options_.table);
        if (interrupted()) return std::nullopt;
        return std::move(made_);
    }

private:
    std::shared_ptr<const ViewpointTable<3>> table_of(const Parameters& parameters) const {
        Services services;
        services.image = options_.image;
        return viewpoint_table<3>(tables_.in_3d,
                                  {scene_.get(), &cells_, views_.front(), none, parameters, nullptr, services});
    }

    bool calibrate() {
        const auto table = table_of(variant_.parameters);
        const auto views = views_to_fit(views_, *table, options_.fit_views);
        const auto samples =
            cost_samples(table->problem(), views, scene_, graphics_.time_drawing(options_.image), options_.repeats,
                         [&](std::size_t done) {
                             say("fitting: view " + std::to_string(done) + " of " + std::to_string(views.size()));
                             return !interrupted();
                         });
        if (interrupted()) return false;
        for (const CostReading reading : {CostReading::max_of_sums, CostReading::sum_of_max})
            made_.fits.push_back(fit(samples, table->problem().options.size(), reading));
        variant_ = make_variant<3>(tables_.in_3d,
                                   variant_.text + " " + parameters_text(made_.best_fit(), table->problem().options));
        return true;
    }

    double fill_all(const ViewpointTable<3>& table) const {
        const Stopwatch clock;
        table.fill(options_.threads, [&](std::size_t known) {
            if (known % 16 == 0) say("entry " + std::to_string(known) + " of " + std::to_string(table.size()));
            return !interrupted();
        });
        return clock.milliseconds() / 1000;
    }

    void fill() {
        made_.fill.seconds = fill_all(*made_.table);
        made_.fill.merged = merged_size(*made_.table);
    }

    void compare_sizes() {
        for (const auto& [azimuths, elevations] : compared_intervals) {
            if (interrupted()) return;
            Parameters parameters = variant_.parameters;
            parameters.set(azimuths_row(), std::to_string(azimuths));
            parameters.set(elevations_row(), std::to_string(elevations));
            parameters.set(table_file_row(), "");
            const auto table = table_of(parameters);
            TableSize& size = made_.sizes.emplace_back();
            size.azimuths = azimuths;
            size.elevations = elevations;
            size.intervals = table->directions().count();
            size.seconds = table->known() < table->size() ? fill_all(*table) : made_.fill.seconds;
            size.merged = merged_size(*table);
            size.file_bytes = bytes_as_a_file(*table, "");
        }
    }

    const ViewpointOptions& options_;
    const MethodTables& tables_;
    LabGraphics& graphics_;
    Variant<3> variant_;
    std::shared_ptr<const Scene<3>> scene_;
    CellComplex<3> cells_;
    std::vector<View<3>> views_;
    ViewpointScene made_;
};

}  // namespace

std::optional<ViewpointScene> measure_viewpoint(const SceneOnPath& where, const ViewpointOptions& options,
                                                const MethodTables& tables, LabGraphics& graphics) {
    return Measurement(where, options, tables, graphics).all();
}

}  // namespace sightline::lab
