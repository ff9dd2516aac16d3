// A scene under measurement: its cells on each tessellation that the methods ask for, and the views of its path.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"
#include "core/space/cell_complex.h"
#include "lab/measure/study.h"

namespace sightline::lab {

template <int D>
struct LabScene {
    std::string name;  ///< as the study says
    MethodTables tables;
    std::shared_ptr<const Scene<D>> scene;
    Settings settings;  ///< of the catalogue and the study; method and budget aside
    std::array<std::optional<CellComplex<D>>, tessellation_count> cells;  ///< by Tessellation
    std::array<double, tessellation_count> build_seconds{};               ///< of cells, with the primitives assigned
    std::string path;
    std::vector<std::uint32_t> frames;           ///< of the path, those that are measured
    std::vector<View<D>> views;                  ///< one per measured frame
    std::vector<std::optional<View<D>>> before;  ///< the one before each of these on the path; none: it is the first
    std::vector<ViewSpec<D>> specs;              ///< the same as they are written down
    std::uint64_t listed = 0;                    ///< hash of the files that methods render from; 0: there are none

    const CellComplex<D>& on(Tessellation tessellation) const { return *cells[static_cast<std::size_t>(tessellation)]; }
    Settings settings_for(const MethodChoice& choice) const {
        Settings s = settings;
        s.method = choice.variant;
        s.tessellation = choice.tessellation;
        return s;
    }
    /// The method with the parameters of the settings and its own.
    Variant<D> variant_for(const MethodChoice& choice) const {
        return make_variant<D>(tables.of<D>(), choice.variant, settings.parameters);
    }
};

/// Loads and tessellates. Throws InputError for a scene, a path or a setting that does not exist.
template <int D>
LabScene<D> load_lab_scene(const std::string& name, const std::string& path, const Study& study,
                           const Progress& progress = {});

/// Throws what load_lab_scene would throw for a scene or path that does not exist or cannot be read, without cells.
template <int D>
void check_scene(const std::string& name, const std::vector<std::string>& paths, const Study& study);

/// Scene, path and error bound in words, with a hash of the primitives and views themselves: files may change.
template <int D>
std::string checkpoint_key(const LabScene<D>& lab);

/// The frames of a path of the scene by its id, of a file, of "start" (the start view alone) or of "turn": the start
/// view's eye, which looks once all round in 8 frames. Empty: "test", where the scene has it, else "turn". With a part
/// behind it, as in "street:60-67", those frames alone. Throws InputError for what is not there.
template <int D>
FlightPath<D> find_path(const Scene<D>& scene, const std::string& name);

}  // namespace sightline::lab
