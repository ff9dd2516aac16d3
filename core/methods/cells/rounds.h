// The rounds that complete a run of cells (cPLP, the gem): test the front against what is drawn, project what is seen.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "core/raster/item_image.h"
#include "core/run/screen.h"

namespace sightline {

/// How a round tests the front: each cell by itself, or all drawn into one image of ids, as the gem does.
enum class FrontTest : std::uint8_t { query, item };
template <>
inline constexpr auto words<FrontTest> = std::to_array<std::string_view>({"query", "item"});
/// The gem's form with its faults mended, or as it is printed.
enum class Listing : std::uint8_t { mended, printed };
template <>
inline constexpr auto words<Listing> = std::to_array<std::string_view>({"mended", "printed"});

/// What decides in rounds.
struct RoundForm {
    FrontTest test = FrontTest::query;
    Listing listing = Listing::mended;
    bool tiles = true;           ///< tiles in which no id shows are read no more
    bool only_winners = false;   ///< of a cell's primitives those that win a pixel are rendered
    std::uint32_t total = none;  ///< primitives that both phases together may spend

    /// Substeps of a round: 0 draws the depth image, 1 has the front before it is tested, or drawn into the image of
    /// ids, which 2 then reads; from here on substep i tests cell i of the front; the last one also projects those that
    /// are seen.
    std::uint32_t first_test_substep() const { return test == FrontTest::item ? 3 : 2; }
    bool printed() const { return test == FrontTest::item && listing == Listing::printed; }
};

template <int D>
struct Rounds {
    RoundForm form{};
    std::uint32_t done = 0;
    std::uint32_t met_before = 0;        ///< the first of them
    std::vector<std::uint8_t> hidden{};  ///< per cell: tested and hidden; what is drawn only comes nearer, so it stays
    std::vector<std::uint32_t> round_of{};   ///< per cell: the round that projected it; 0: none
    std::vector<std::uint32_t> winners{};    ///< of the cell that is being projected
    std::vector<std::uint32_t> last_read{};  ///< per tile: the last round that read it; 0: the next one will
    std::vector<std::pair<std::uint32_t, std::uint32_t>> lost{};  ///< round and cell (Listing::printed)
    Screen<D> screen{};

    void begin(const RoundForm& how, std::size_t cell_count, const TileGrid& grid) {
        form = how;
        done = met_before = 0;
        hidden.assign(cell_count, 0);
        round_of.assign(cell_count, 0);
        last_read.assign(form.test == FrontTest::item ? grid.count() : 0, 0);
        lost.clear();
        screen.forget();
    }
    bool reads(std::uint32_t tile, std::uint32_t round) const {
        return last_read[tile] == 0 || last_read[tile] >= round;
    }
    // What a round did to a tile or a cell: done again, or undone, the last first.
    void put_tile(std::uint32_t tile, std::uint32_t round, bool forward) { last_read[tile] = forward ? round : 0; }
    void put_lost(std::uint32_t cell, std::uint32_t round, bool forward) {
        if (forward)
            lost.emplace_back(round, cell);
        else
            lost.pop_back();
    }
};

/// Ids as the gem reads them, 32 bits a pixel.
inline constexpr std::uint32_t bytes_per_id = 4;

/// As the gem packs the place of a cell in the front into a colour and reads it back: `j & 0xFF00` is cut to a byte of
/// zero, so that of the number, which counts from 1, its lowest byte is left. none: it reads as background.
constexpr std::uint32_t as_printed_colour(std::uint32_t place) {
    const std::uint32_t read = (place + 1) & 0xff;
    return read == 0 ? none : read - 1;
}

}  // namespace sightline
