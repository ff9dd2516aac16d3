// The sessions of the panes, one or two, and what the options of their pictures share.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/draw/cell_number.h"
#include "core/draw/draw_list.h"
#include "shell/desk/conceal.h"
#include "shell/desk/workbench.h"

namespace sightline {

template <int D>
class SideBySide {
public:
    /// The bench must live longer.
    explicit SideBySide(const Workbench<D>& bench) : bench_(bench) {}

    std::size_t count() const { return bench_.other ? 2 : 1; }
    const Session<D>& operator[](std::size_t pane) const { return pane == 0 ? bench_.session : bench_.other->session; }
    /// Before anything of a frame is asked for. A new revision says that the sessions may have changed.
    void update(std::uint64_t revision);
    /// Whether a cell's number means the same in both; true without a second session.
    bool same_cells() const { return same_cells_; }

    /// Those of PictureOptions or PictureOptions3 that do not depend on where the picture stands. The differences are
    /// good until the next update.
    template <typename Options>
    Options options(std::size_t pane) {
        Options options;
        options.heat_range = heat_range(pane);
        options.differences = differences_[pane];
        if (pane == 0) {
            options.facet = facet();
            options.choice = !asks_for_cell(bench_);
            if (const std::uint32_t cell = concealed_cell(bench_); cell != none) options.concealed = cell;
        }
        return options;
    }

private:
    /// The heat map's range, which stays while one steps.
    struct HeatRange {
        std::uint64_t run = 0;
        CellNumber what = CellNumber::none;
        const Session<D>* of = nullptr;
        std::optional<std::array<double, 2>> range;
    };
    const std::optional<std::array<double, 2>>& heat_range(std::size_t pane);
    std::optional<std::uint32_t> facet() const;

    const Workbench<D>& bench_;
    std::array<HeatRange, 2> heat_;
    std::array<std::vector<Differs>, 2> differences_;
    bool same_cells_ = true;
    std::uint64_t revision_ = 0;
};

/// What the colours of the cells mean; nothing without a range.
template <int D>
std::optional<ColourBar> colour_bar(const Session<D>& session, const std::optional<std::array<double, 2>>& range);

}  // namespace sightline
