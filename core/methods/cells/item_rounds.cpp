// A round that draws the whole front into one image of ids and reads it by tiles: the gem's find_visible_front, mended
// or as it is printed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/cells/cell_base.h"
#include "core/methods/cells/front_image.h"

namespace sightline {

/// Those that can be seen. Mended, the nearest shows, a cell without a pixel stays in the front, and the rounds end
/// when no pixel has an id: then no cell of the front lies before what is drawn anywhere. Until then each round
/// projects at least one.
template <int D>
std::vector<std::uint32_t> CellBase<D>::test_in_one_image(Recorder* recorder) {
    Rounds<D>& rounds = *rounds_;
    const bool printed = rounds.form.printed();
    const auto waiting = front();
    std::vector<std::uint32_t> cells;
    for (const auto& [item, mark] : waiting) cells.push_back(item.id);
    const FrontImage<D> image =
        draw_front(this->problem_, rounds.screen, cells, printed ? ItemWins::last : ItemWins::nearest);

    std::vector<std::uint32_t> pixel_of(cells.size(), none);  // where its id was read first
    bool any = false;
    // A cell that the eye may lie in has no outline to draw, so it counts as seen.
    if (!printed)
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (image.shapes[i].everywhere) {
                pixel_of[i] = 0;
                any = true;
            }
    const TileGrid grid = screen_tiles(this->problem_);
    std::vector<std::uint32_t> switched_off;
    for (std::uint32_t t = 0; t < grid.count(); ++t) {
        if (!rounds.reads(t, rounds.done)) continue;
        const Tile tile = grid.tile(t);
        bool shows = false;
        for (int y = tile.top; y < tile.bottom; ++y)
            for (int x = tile.left; x < tile.right; ++x) {
                const auto pixel = static_cast<std::uint32_t>(y * grid.width + x);
                const std::uint32_t owner = image.owners[pixel];
                const std::uint32_t read = owner == none || !printed ? owner : as_printed_colour(owner);
                if (read == none) continue;
                shows = true;
                if (pixel_of[read] == none) pixel_of[read] = pixel;
            }
        any |= shows;
        if (!shows && rounds.form.tiles &&
            (printed || !tile_may_show(image.shapes, rounds.screen.image().image(), tile)))
            switched_off.push_back(t);
    }

    // Why ids were not read, for those who ask.
    std::vector<std::uint8_t> shown(recorder ? cells.size() : 0);
    if (recorder)
        for (const std::uint32_t owner : image.owners)
            if (owner != none) shown[owner] = 1;
    const auto whose_pixels = [&](std::size_t i) {
        if (shown[i]) return cells[i];
        const auto pixel = rounds.screen.seen_at(this->problem_, cells[i]);
        return pixel ? cells[image.owners[*pixel]] : none;
    };
    std::vector<std::uint32_t> seen;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        Rule rule = Rule::tested_seen;
        if (pixel_of[i] != none)
            seen.push_back(cells[i]);
        else
            rule = printed ? Rule::lost : any ? Rule::tested_without : Rule::tested_hidden;
        if (rule == Rule::tested_hidden) rounds.hidden[cells[i]] = 1;
        if (rule == Rule::lost) {
            marks_.set(cells[i], {});
            --this->counters_.front_size;
            rounds.put_lost(cells[i], rounds.done, true);
        }
        if (!recorder) continue;
        const std::uint32_t via = rule == Rule::tested_seen ? pixel_of[i] : whose_pixels(i);
        recorder->changed(waiting[i].first, waiting[i].second, static_cast<std::uint8_t>(rule), via);
    }
    for (const std::uint32_t tile : switched_off) {
        rounds.put_tile(tile, rounds.done, true);
        if (recorder) recorder->changed({tile, Kind::tile}, {}, static_cast<std::uint8_t>(Rule::tile_off));
    }
    return seen;
}

template <int D>
std::optional<double> CellBase<D>::bytes_read(const Item& round, bool whole_image) const {
    if (round.kind != Kind::round || round.id > rounds_->done || rounds_->form.test != FrontTest::item)
        return std::nullopt;
    const TileGrid grid = screen_tiles(this->problem_);
    double pixels = 0;
    for (std::uint32_t t = 0; t < grid.count(); ++t)
        if (whole_image || rounds_->reads(t, round.id)) pixels += grid.tile(t).pixels();
    return bytes_per_id * pixels;
}

template <int D>
std::vector<ReadTile> CellBase<D>::tiles() const {
    std::vector<ReadTile> tiles;
    if (!rounds_ || rounds_->done == 0 || rounds_->form.test != FrontTest::item) return tiles;
    const TileGrid grid = screen_tiles(this->problem_);
    for (std::uint32_t t = 0; t < grid.count(); ++t) tiles.push_back({grid.tile(t), rounds_->reads(t, rounds_->done)});
    return tiles;
}

template std::vector<std::uint32_t> CellBase<2>::test_in_one_image(Recorder*);
template std::vector<std::uint32_t> CellBase<3>::test_in_one_image(Recorder*);
template std::vector<ReadTile> CellBase<2>::tiles() const;
template std::vector<ReadTile> CellBase<3>::tiles() const;
template std::optional<double> CellBase<2>::bytes_read(const Item&, bool) const;
template std::optional<double> CellBase<3>::bytes_read(const Item&, bool) const;

}  // namespace sightline
