// One probe of a reduction: the measures of a frame of a part of a scene, and no more than is asked for.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/measure/measure_table.h"
#include "core/truth/truth.h"
#include "lab/measure/lab_scene.h"

namespace sightline::lab {

/// Measures parts of a scene in the last view of a LabScene, and in the one before where a measure compares the two.
/// Values are those of measure_path, bit for bit; measures that are not `used` are left out where they take time. In 3D
/// an exact image is drawn again only where something that it shows was taken away: what is hidden changes nothing.
template <int D>
class PartMeasures {
public:
    PartMeasures(const LabScene<D>& lab, const MethodChoice& method, const Budget& budget, std::vector<Measure> used,
                 const DrawIds& draw_ids);

    /// Of a part, by ascending indices into the scene, given also as a scene of its own.
    Values measure(std::span<const std::uint32_t> kept, const Scene<D>& part);
    /// The part measured last is the one of which others are parts from now on.
    void take() { whole_ = last_; }
    std::size_t images_drawn() const { return drawn_; }

private:
    /// An exact image per view, ids being those of the whole scene, and what it was drawn of.
    struct Seen {
        std::vector<std::uint8_t> kept;
        std::vector<IdImage> images;
    };
    bool uses(Measure measure) const;
    Truth truth_of(std::size_t view, std::span<const std::uint32_t> kept, const Scene<D>& part,
                   const CellComplex<D>& cells, Seen& seen);

    const LabScene<D>& lab_;
    MethodChoice choice_;
    Variant<D> variant_;
    Settings settings_;
    Budget budget_;
    std::vector<Measure> used_;
    DrawIds draw_ids_;
    std::vector<std::size_t> views_;  ///< of the LabScene
    std::shared_ptr<const Seen> whole_, last_;
    std::size_t drawn_ = 0;
};

}  // namespace sightline::lab
