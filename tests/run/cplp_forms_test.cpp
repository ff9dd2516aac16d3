// The forms of cPLP's rounds: the gem's image of ids, mended and printed, its tiles, a budget of both phases.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>

#include "core/base/error.h"
#include "core/methods/cells/cell_rules.h"
#include "core/methods/cells/rounds.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/scene_view.h"
#include "core/session/start_settings.h"
#include "tests/run/cplp_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using test::CplpCase;
using test::random_cplp_case;

template <int D>
const Method<D>& cplp() {
    return find_method<D>(method_table<D>(), "cplp");
}

template <int D>
test::Recorded<D> recorded(const CplpCase<D>& made, const char* text) {
    return test::record_all(cplp<D>(), made.problem(text));
}

/// Of all rounds.
template <int D>
double bytes(const Run<D>& run, std::string_view name) {
    double sum = 0;
    for (const Field<D>& field : run.fields())
        for (std::uint32_t round = 1; field.name == name && round <= run.steps(); ++round)
            sum += field.value(run, {round, Kind::round}).value_or(0);
    return sum;
}

/// What rounds found out, step by step; returns how many there were.
template <int D>
std::uint32_t rounds_keep_their_word(const test::Recorded<D>& all, std::size_t pixels) {
    std::vector<std::uint8_t> hidden(all.run->problem().cells->cell_count()), seen(hidden.size());
    std::uint32_t rounds = 0;
    for (std::uint32_t step = 1; step <= all.timeline.size(); ++step) {
        if (all.timeline.steps[step - 1].item.kind != Kind::round) continue;
        ++rounds;
        for (const Change& change : all.timeline.changes_of(step)) {
            const Rule rule{change.rule};
            if (rule == Rule::tile_off) continue;
            EXPECT_FALSE(hidden[change.id] && rule != Rule::kept && rule != Rule::reenqueued)
                << "what is hidden stays hidden";
            if (rule == Rule::tested_hidden) hidden[change.id] = 1;
            if (rule == Rule::tested_seen) {
                seen[change.id] = 1;
                EXPECT_LT(change.via, pixels) << "a witness";
            }
            if (rule == Rule::projected_now) {
                EXPECT_TRUE(seen[change.id]);
            }
        }
    }
    EXPECT_LE(rounds, std::max<std::size_t>(1, hidden.size()));
    return rounds;
}

template <int D>
void tiles_change_nothing(std::uint64_t seed, int count) {
    Random random(seed);
    double with = 0, without = 0;
    std::size_t off = 0;
    for (int i = 0; i < count; ++i) {
        SCOPED_TRACE(i);
        CplpCase<D> made = random_cplp_case<D>(random);
        if constexpr (D == 3) made.size = {200, 150};
        const std::size_t pixels = D == 2 ? 512 : 200 * 150;
        const auto tiles = recorded(made, "cplp test=item"), whole = recorded(made, "cplp test=item tiles=off");
        const auto query = recorded(made, "cplp");
        const auto a = tiles.run->met(), b = whole.run->met();
        ASSERT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
        rounds_keep_their_word(tiles, pixels);
        rounds_keep_their_word(whole, pixels);
        rounds_keep_their_word(query, pixels);
        with += bytes(*tiles.run, "bytes_read");
        without += bytes(*tiles.run, "bytes_whole");
        ASSERT_EQ(bytes(*whole.run, "bytes_read"), bytes(*whole.run, "bytes_whole"));
        ASSERT_EQ(bytes(*tiles.run, "bytes_whole"), bytes(*whole.run, "bytes_whole"));
        for (const Change& change : tiles.timeline.changes) off += Rule{change.rule} == Rule::tile_off;
    }
    EXPECT_GT(off, 50u);
    EXPECT_LT(with, without);
}

TEST(CplpForms, InThePlaneTilesChangeNothing) { tiles_change_nothing<2>(86, test::soak_count(200)); }
TEST(CplpForms, InSpaceTilesChangeNothing) { tiles_change_nothing<3>(87, test::soak_count(40)); }

/// Visible at a pixel and not rendered.
template <int D>
std::size_t missed(const CplpCase<D>& made, const Run<D>& run) {
    const auto rendered = rendered_mask(run.met(), made.scene.primitives.size());
    std::vector<std::uint8_t> counted(rendered.size());
    std::size_t count = 0;
    for (const std::uint32_t id : test::exact_ids(made).ids)
        if (id != none && !rendered[id] && !std::exchange(counted[id], 1)) ++count;
    return count;
}

template <int D>
CplpCase<D> gallery_case(const char* id, std::initializer_list<const char*> settings) {
    CplpCase<D> made;
    const CatalogueRow<D>& row = *find_in_catalogue<D>(id);
    made.settings = catalogue_settings<D>(id);
    for (const char* assignment : settings) apply_setting(made.settings, assignment);
    if constexpr (D == 2) {
        made.scene = make_scene(row);
        made.size = {2048, 0};
    } else {
        made.scene = make_scene(row, 10'000);
        made.size = {200, 150};
    }
    made.view = scene_view(row.view, made.scene, made.size);
    made.cells = build_cells(made.scene, made.settings);
    return made;
}

/// The lines that are lit where a cell is lost, and their values; all losses of the run.
template <int D>
std::map<std::string, std::size_t> losing_lines(const test::Recorded<D>& all) {
    std::map<std::string, std::size_t> lines;
    for (std::uint32_t step = 1; step <= all.timeline.size(); ++step) {
        const Step& record = all.timeline.steps[step - 1];
        if (record.item.kind != Kind::round) continue;
        const auto changes = all.timeline.changes_of(step);
        std::uint32_t substep = 3;
        for (const Change& change : changes) {
            if (!is_test(change)) continue;
            CodePlace place{&record, step, changes, 0, substep++};
            if (Rule{change.rule} != Rule::lost || change.via == none) continue;
            for (const CodeLine& line : all.run->code(place))
                if (line.lit) {
                    EXPECT_NE(line.values.find("lost"), std::string::npos) << line.values;
                    ++lines[line.source];
                }
        }
    }
    return lines;
}

template <int D>
void printed_listing_misses(const CplpCase<D>& made, const std::string& first, std::string_view line) {
    const auto mended = recorded(made, ("cplp test=item first=" + first).c_str()),
               printed = recorded(made, ("cplp test=item listing=printed first=" + first).c_str());
    EXPECT_EQ(missed(made, *mended.run), 0u);
    EXPECT_EQ(guarantee_words(cplp<D>(), *mended.run), "conservative at this resolution");
    EXPECT_GT(missed(made, *printed.run), 0u);
    EXPECT_TRUE(printed.run->finished());
    EXPECT_EQ(guarantee_words(cplp<D>(), *printed.run), "approximate");
    const auto lines = losing_lines(printed);
    std::size_t at_line = 0;
    for (const auto& [source, count] : lines)
        if (source.find(line) != source.npos) at_line += count;
    EXPECT_GT(at_line, 0u);
    for (std::uint32_t cell = 0; cell < made.cells.cell_count(); ++cell)
        if (const Verdict why = printed.run->why_not(cell_item(cell)); why.reason == "lost") return;
    ADD_FAILURE() << "no cell says that it was lost";
}

TEST(CplpForms, ThePrintedListingLosesAWallBehindTheThicketInThePlane) {
    printed_listing_misses(gallery_case<2>("thicket", {"budget=5%", "tessellation=tree"}), "layers", "glDepthMask");
    printed_listing_misses(gallery_case<2>("thicket", {"budget=10%"}), "published", "glDepthMask");
}
TEST(CplpForms, ThePrintedListingLosesAWallBehindTheThicketInSpace) {
    const auto made = gallery_case<3>("thicket", {"budget=5%", "tessellation=tree"});
    printed_listing_misses(made, "published", "glDepthMask");
    printed_listing_misses(made, "published", "read_active");
}
TEST(CplpForms, ThePrintedListingCannotTellMoreThan255CellsApart) {
    const auto made = gallery_case<3>("lattice", {"budget=30%"});
    std::size_t most = 0;
    const auto all = recorded(made, "cplp first=layers test=item listing=printed");
    for (const Step& step : all.timeline.steps) most = std::max<std::size_t>(most, step.after.front_size);
    EXPECT_GT(most, 255u);
    printed_listing_misses(made, "layers", "GLubyte");
}

TEST(CplpForms, ColoursOfOneByteAreReadAsPrinted) {
    EXPECT_EQ(as_printed_colour(0), 0u);
    EXPECT_EQ(as_printed_colour(254), 254u);
    EXPECT_EQ(as_printed_colour(255), none) << "number 256 is background";
    EXPECT_EQ(as_printed_colour(256), 0u) << "and 257 the first";
}

template <int D>
void total_holds(std::uint64_t seed, int count) {
    Random random(seed);
    int cut = 0, complete = 0;
    for (int i = 0; i < count; ++i) {
        SCOPED_TRACE(i);
        const CplpCase<D> made = random_cplp_case<D>(random);
        const std::string total = std::to_string(random.below(60));
        for (const char* form : {"", " test=item", " draws=winners"}) {
            const auto all = recorded(made, ("cplp budget_counts=each_once total=" + total + form).c_str());
            ASSERT_LE(all.run->counters().spent, std::stoul(total)) << form;
            ASSERT_TRUE(all.run->finished());
            if (all.run->misses() == Misses::may) {
                ++cut;
                ASSERT_EQ(guarantee_words(cplp<D>(), *all.run), "conservative, cut short by the budget");
                ASSERT_EQ(all.run->counters().spent, std::stoul(total)) << form;
                ASSERT_EQ(OwnRun<D>(all.run)->run(1), Stop::budget);
            } else {
                ++complete;
                ASSERT_EQ(missed(made, *all.run), 0u);
            }
        }
    }
    EXPECT_GT(cut, count / 4);
    EXPECT_GT(complete, count / 4);
}
TEST(CplpForms, InThePlaneBothPhasesKeepToTheirTotal) { total_holds<2>(88, test::soak_count(60)); }
TEST(CplpForms, InSpaceBothPhasesKeepToTheirTotal) { total_holds<3>(89, test::soak_count(20)); }

TEST(CplpForms, ATotalIsPrimitivesOrAShare) {
    Random random(90);
    const CplpCase<2> made = random_cplp_case<2>(random);
    EXPECT_THROW(made.problem("cplp total=16ms"), InputError);
    EXPECT_THROW(made.problem("cplp total=-1"), InputError);
    EXPECT_NO_THROW(made.problem("cplp total=5%"));
}

}  // namespace
}  // namespace sightline
