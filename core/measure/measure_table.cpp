// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/measure_table.h"

namespace sightline {

namespace {

namespace rows {
using enum Measure;
constexpr std::array<MeasureRow, measure_count> table{{
    {budget, "budget", "budget", "primitives", "k: how many primitives the frame may render", "TVCG 3"},
    {rendered, "rendered", "rendered", "primitives", "|T|: primitives rendered, each once", "TVCG 4.1"},
    {visible, "visible", "visible", "primitives", "|V|: primitives that are really visible", "TVCG 4.4"},
    {coverage, "coverage", "coverage", "share", "|V ∩ T| / |V|; none where |V| = 0", "TVCG 3", Better::higher, false,
     true},
    {coverage_px, "coverage_px", "coverage by pixels", "share",
     "pixels of the exact image that show a rendered primitive / pixels that show one at all", "TVCG fig. 15",
     Better::higher, false, true},
    {oracle, "oracle", "oracle", "share", "min(1, k / |V|): the best that any k primitives can do", "TVCG 3"},
    {cell_oracle, "cell_oracle", "cell oracle", "share",
     "coverage of whole cells in order of decreasing visible share, cut at k: a good order of cells",
     "docs/measuring.md"},
    {wrong, "wrong", "wrong pixels", "share",
     "pixels whose primitive (where levels of detail are drawn: whose object) differs from that of the exact image / "
     "all pixels",
     "TVCG 3, fig. 14", Better::lower,
     false, true},
    {blob, "blob", "largest wrong region", "share",
     "pixels of the largest 4-connected region of wrong pixels / all pixels", "docs/measuring.md", Better::lower, false,
     true},
    {k95, "k95", "budget for 95 %", "share",
     "smallest |T| with coverage >= 0.95, over |S|; none where no budget reaches it", "docs/measuring.md",
     Better::lower},
    {efficiency, "efficiency", "efficiency", "share", "|V ∩ T| / |T|; none where |T| = 0", "docs/measuring.md",
     Better::higher},
    {emitted_over_visible, "emitted_over_visible", "drawn over V", "times", "|T| / |V|; none where |V| = 0",
     "docs/measuring.md", Better::lower},
    {mis_ranked, "mis_ranked", "mis-ranked inversions", "steps",
     "hidden cells projected while a visible one waited in the front", "docs/measuring.md", Better::lower},
    {unreached, "unreached", "unreached inversions", "steps",
     "hidden cells projected while a visible one was still clean and none waited in the front", "docs/measuring.md",
     Better::lower},
    {zeta, "zeta", "mean layering number", "layers",
     "mean ζ of the rendered primitives that a ray hits (3D: within the first 8 layers)", "TVCG 3", Better::lower},
    {fused, "fused", "hidden only jointly", "share",
     "hidden primitives that no single one hides / those hidden by any (3D: of what the first 8 layers show, a lower "
     "bound)",
     "TVCG 1, 2"},
    {steps, "steps", "steps", "steps", "pops, or batches of primitives", "TVCG fig. 4"},
    {zero_keys, "zero_keys", "steps with key 0", "share",
     "steps that popped a cell with key 0, so that the order of entry alone decided / steps; none without cells",
     "docs/algorithm.md, keys of 0"},
    {key_rank, "key_rank", "rank correlation of key and share", "r",
     "Spearman's, of the key of each popped cell with its visible share: -1 where the lower key always shows more; none "
     "with fewer than three cells, or where all keys or all shares are equal",
     "TVCG 7", Better::lower},
    {front, "front", "largest front", "cells", "most cells in the front after any step", "TVCG 4.2"},
    {tested, "tested", "tested", "tests",
     "cells, boxes or other parts that the run held against what is drawn, to see whether they are hidden",
     "gem, find_visible_front", Better::lower},
    {rounds, "rounds", "rounds", "rounds", "rounds of cPLP until nothing visible was missing; none for other methods",
     "gem, conservative_finish"},
    {pop, "pop", "popping", "share",
     "|{p in V and V': rendered in exactly one of the frames}| / |V ∩ V'|, where V' is that of the previous frame",
     "docs/measuring.md", Better::lower, false, true},
    {flip, "flip", "flipping pixels", "share",
     "pixels that are wrong in exactly one of this frame and the previous one / all pixels", "docs/measuring.md",
     Better::lower, false, true},
    {visible_change, "visible_change", "change of the exact set", "share", "1 - |V ∩ V'| / |V ∪ V'|",
     "docs/measuring.md"},
    {traverse_ms, "traverse_ms", "traversal", "ms",
     "starting and running the method, without recording; perfect, which is told V, is not timed", "TVCG 5.2",
     Better::lower, true, true},
    {upload_ms, "upload_ms", "upload", "ms", "sending the list of triangles to OpenGL, up to glFinish",
     "docs/measuring.md", Better::lower, true},
    {draw_ms, "draw_ms", "drawing", "ms", "drawing them, lit, at the reference size, up to glFinish", "TVCG 5.2",
     Better::lower, true},
    {total_ms, "total_ms", "time per frame", "ms", "traversal + upload + drawing; of perfect upload + drawing",
     "TVCG 5.2", Better::lower, true, true},
    {over_exact, "over_exact", "time over that of V", "times",
     "time per frame / that of drawing exactly V (method perfect) in the same frame; none where that was not timed",
     "docs/measuring.md", Better::neither, true},
    {traverse_error, "traverse_error_ms", "error of the traversal", "ms",
     "s / √r of the r repeats, where s is their standard deviation", "docs/measuring.md", Better::neither, true},
    {upload_error, "upload_error_ms", "error of the upload", "ms", "s / √r of the r repeats", "docs/measuring.md",
     Better::neither, true},
    {draw_error, "draw_error_ms", "error of the drawing", "ms", "s / √r of the r repeats", "docs/measuring.md",
     Better::neither, true},
    {total_error, "total_error_ms", "error of the time per frame", "ms",
     "root of the sum of the squares of the three errors", "docs/measuring.md", Better::neither, true},
}};
}  // namespace rows
using rows::table;

}  // namespace

std::span<const MeasureRow> measure_table() { return table; }

const MeasureRow& measure_row(Measure measure) { return table[static_cast<std::size_t>(measure)]; }

std::optional<Measure> error_of(Measure time) {
    using enum Measure;
    switch (time) {
        case traverse_ms:
            return traverse_error;
        case upload_ms:
            return upload_error;
        case draw_ms:
            return draw_error;
        case total_ms:
            return total_error;
        default:
            return std::nullopt;
    }
}

}  // namespace sightline
