// What the colours, lines and numbers of pictures mean, row by row.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/draw/draw_list.h"
#include "core/draw/solid_list.h"
#include "core/session/note.h"
#include "core/session/settings.h"

namespace sightline {

/// Which styles pictures show inside their worlds, gathered one picture after the other.
struct UsedStyles {
    struct Solid {
        bool faces = false, edges = false;  ///< as faces or triangles, as edges
    };
    std::vector<std::uint8_t> looks;  ///< per Look
    std::vector<Solid> solids;        ///< per SolidLook
    std::vector<Style> others;        ///< those beyond the looks that a legend names
    struct OtherSolid {
        SolidStyle style;
        Solid use;
    };
    std::vector<OtherSolid> other_solids;
    std::string_view key_title{};  ///< what the method calls the key of a cell
};
/// Takes time in proportion to the shapes.
void add_used(const DrawList& list, UsedStyles& used);
void add_used(const SolidList& solid, UsedStyles& used);

/// Their rows, in a fixed order, and the callouts among the notes.
std::vector<LegendRow> legend_rows(const UsedStyles& used, const Settings& settings, std::span<const Note<2>> notes);
std::vector<LegendRow> legend_rows(const UsedStyles& used, const Settings& settings, std::span<const Note<3>> notes);

/// What the callouts say.
template <int D>
std::vector<LegendRow> callout_rows(std::span<const Note<D>> notes);

/// The rows of a legend without room: five, those that are needed first, and all that nothing else explains.
std::vector<LegendRow> short_legend(std::vector<LegendRow> rows);

/// The same for pictures that stand beside each other; `key_title` as in UsedStyles.
std::vector<LegendRow> legend_rows(std::span<const DrawList* const> lists, const Settings& settings,
                                   std::string_view key_title, std::span<const Note<2>> notes);
/// `solids` are what lies under the lists.
std::vector<LegendRow> legend_rows(std::span<const DrawList* const> lists, std::span<const SolidList* const> solids,
                                   const Settings& settings, std::string_view key_title,
                                   std::span<const Note<3>> notes);

}  // namespace sightline
