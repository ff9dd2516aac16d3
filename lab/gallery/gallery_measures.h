// What the gallery measures: functions of a scene, a view, a method and its settings.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/measure/frame_numbers.h"
#include "core/run/method.h"
#include "core/scene/make/car_parts.h"
#include "core/scene/scene.h"
#include "core/session/settings.h"

namespace sightline::lab {

/// A scene of the gallery with what measurements share: cells by what makes them, exact images by view.
template <int D>
class GalleryScene {
public:
    /// `parts`: per primitive, for the measures that split by part.
    GalleryScene(std::shared_ptr<const Scene<D>> scene, DrawIds draw_ids, std::vector<CarPart> parts = {});

    const Scene<D>& scene() const { return *scene_; }
    const CellComplex<D>& cells(const Settings& settings);
    View<D> view(const ViewSpec<D>& spec, const Settings& settings) const;
    Truth truth(const ViewSpec<D>& spec, const Settings& settings);
    const DrawIds& draw_ids() const { return draw_ids_; }
    std::span<const CarPart> parts() const { return parts_; }

private:
    struct Built {
        Settings settings;
        CellComplex<D> cells;
    };
    std::shared_ptr<const Scene<D>> scene_;
    DrawIds draw_ids_;
    std::vector<CarPart> parts_;
    std::list<Built> built_;
};

/// What is measured.
template <int D>
struct Probe {
    GalleryScene<D>& at;
    std::span<const Method<D>> methods;
    Settings settings;     ///< with method and budget
    ViewSpec<D> view, to;  ///< `to`: the end of a walk
};

template <int D>
struct GalleryMeasure {
    std::string_view id;
    std::string_view unit;     ///< "share" is of 1
    std::string_view formula;  ///< for people
    double (*of)(const Probe<D>&);
};

/// Those that the table of frame measures (core/measure/measure_table.h) does not have.
template <int D>
std::span<const GalleryMeasure<D>> gallery_measures();

/// A measure of either table. Throws InputError for an id that neither has.
template <int D>
double measured(const Probe<D>& probe, std::string_view id);

}  // namespace sightline::lab
