// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/explain.h"
#include "core/session/settings_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/base/number.h"
#include "core/methods/cells/seed_cells.h"
#include "core/methods/plp/published.h"
#include "core/session/headline.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

/// Every number of an explanation, to compare two of them.
std::vector<double> numbers(const StepExplanation& e) {
    std::vector<double> all{double(e.step),     double(e.cell),      e.key,
                            double(e.stamp),    double(e.runner_up), e.runner_up_key,
                            double(e.rendered), double(e.visible),   e.visible_share};
    for (const Considered& f : e.looked_at) {
        all.insert(all.end(), {double(f.from.id), double(f.item.id), double(f.via.id), double(f.rule), f.before.key,
                               double(f.before.stamp), double(f.before.state), double(f.key.has_value())});
        if (f.key)
            for (const Term& t : f.key->terms) all.push_back(t.value);
    }
    return all;
}

TEST(Explain, AStepsTermsAreTheKeysThatTheStateHas) {
    Random random(41);
    std::array<int, 7> rules{};
    int penalised = 0;
    for (int i = 0; i < test::soak_count(300); ++i) {
        const test::Start start = test::random_cell_start(random);
        Session<2> session = start.session();
        std::vector<std::vector<double>> told;
        for (;;) {
            const auto before = test::marks(session);
            const auto front = test::sorted_front(before);
            if (session.step() != Stop::none) break;
            const auto after = test::marks(session);
            const StepExplanation e = explain_step(session, session.position());
            told.push_back(numbers(e));
            ASSERT_EQ(e.step, session.position());
            ASSERT_EQ(e.cell, front.front().id);
            ASSERT_EQ(e.key, front.front().key);
            ASSERT_EQ(e.stamp, front.front().stamp);
            ASSERT_EQ(e.runner_up, front.size() > 1 ? front[1].id : none);
            if (front.size() > 1) {
                ASSERT_EQ(e.runner_up_key, front[1].key);
            }
            ASSERT_EQ(after[e.cell].state, CellState::projected);
            std::set<std::uint32_t> explained{e.cell};
            for (const Considered& f : e.looked_at) {
                ++rules[f.rule];
                ASSERT_EQ(f.from.id, e.cell);
                if (f.item.id == none) {
                    ASSERT_EQ(Rule{f.rule}, Rule::border);
                    continue;
                }
                explained.insert(f.item.id);
                const Mark &was = before[f.item.id], &is = after[f.item.id];
                ASSERT_EQ(f.before, was);
                switch (Rule{f.rule}) {
                    case Rule::enqueued:
                    case Rule::reenqueued:
                        ASSERT_EQ(was.state, Rule{f.rule} == Rule::enqueued ? CellState::clean : CellState::enqueued);
                        ASSERT_EQ(is.state, CellState::enqueued);
                        ASSERT_TRUE(f.key);
                        ASSERT_EQ(f.key->key, is.key) << "scene " << i << " step " << e.step;
                        break;
                    case Rule::kept:
                        ASSERT_EQ(was.state, CellState::enqueued);
                        ASSERT_EQ(is, was);
                        ASSERT_TRUE(f.key);
                        if (start.settings.method == "published") {  // the computed key lost
                            if (test::choice<OnReenqueue>(start.settings, on_reenqueue_row()) == OnReenqueue::min) {
                                ASSERT_GE(f.key->key, was.key);
                            } else {
                                ASSERT_LE(f.key->key, was.key);
                            }
                        }
                        break;
                    case Rule::marked_unseen:
                        ASSERT_EQ(was.state, CellState::clean);
                        ASSERT_EQ(is.state, CellState::unseen);
                        break;
                    case Rule::unseen:
                        ASSERT_EQ(was.state, CellState::unseen);
                        ASSERT_EQ(is, was);
                        break;
                    default:
                        ASSERT_EQ(Rule{f.rule}, Rule::projected);
                        ASSERT_EQ(was.state, CellState::projected);
                        ASSERT_EQ(is, was);
                }
                if (!f.key) continue;
                penalised += f.key->penalised;
                if (start.settings.method != "published") {
                    ASSERT_EQ(test::term(*f.key, "layer_a"), e.key);
                    continue;
                }
                // What the formula line shows adds up.
                const auto term = [&](std::string_view name) { return test::term(*f.key, name); };
                ASSERT_EQ(term("rho_a"), e.key);
                ASSERT_EQ(term("unpenalised"), term("density") + term("weight") * term("rho_a"));
                if (!f.key->penalised) {
                    ASSERT_EQ(f.key->key, term("unpenalised"));
                }
            }
            // Nothing else changed.
            for (std::uint32_t cell = 0; cell < before.size(); ++cell)
                if (!explained.contains(cell)) {
                    ASSERT_EQ(after[cell], before[cell]);
                }
        }
        // Later, and after walks, a step is explained as it was then.
        for (int walk = 0; walk < 3 && !told.empty(); ++walk) {
            for (std::uint32_t step = 1; step <= session.position(); ++step)
                ASSERT_EQ(numbers(explain_step(session, step)), told[step - 1]) << "scene " << i << " step " << step;
            session.seek(static_cast<std::uint32_t>(random.below(told.size() + 1)));
        }
    }
    for (const int count : rules) EXPECT_GT(count, 0);
    EXPECT_GT(penalised, 100);
}

TEST(Explain, ACellsChainLeadsFromASeedToItsKey) {
    Random random(42);
    std::size_t longest = 0, clean_reasons = 0, kept = 0;
    for (int i = 0; i < test::soak_count(200); ++i) {
        const test::Start start = test::random_cell_start(random);
        Session<2> session = start.session();
        session.seek(static_cast<std::uint32_t>(random.below(60)));
        if (random.below(2)) session.seek(static_cast<std::uint32_t>(random.below(session.position() + 1)));
        const auto marks = test::marks(session);
        const auto front = test::sorted_front(marks);
        const auto seeds = seed_cells(session.problem());
        const auto entries = session.traversal().front();
        ASSERT_EQ(entries.size(), front.size());
        for (std::size_t k = 0; k < front.size(); ++k) {
            ASSERT_EQ(entries[k].first.id, front[k].id);
            ASSERT_EQ(entries[k].second.key, front[k].key);
            ASSERT_EQ(entries[k].second.stamp, front[k].stamp);
        }
        std::vector<StepExplanation> steps;
        for (std::uint32_t step = 1; step <= session.position(); ++step) steps.push_back(explain_step(session, step));
        const int digits = steps.empty() ? 3 : steps.back().digits;
        for (std::uint32_t cell = 0; cell < marks.size(); ++cell) {
            const CellExplanation e = explain_cell(session, cell);
            ASSERT_EQ(e.cell, cell);
            ASSERT_EQ(e.mark, marks[cell]);
            ASSERT_EQ(e.visible_share, session.reference().cell_share[cell]);
            const auto place = std::find_if(front.begin(), front.end(), [&](const auto& f) { return f.id == cell; });
            ASSERT_EQ(e.rank, place == front.end() ? 0u : static_cast<std::uint32_t>(place - front.begin()) + 1);
            ASSERT_EQ(!e.verdict, marks[cell].state == CellState::projected);
            ASSERT_EQ(e.projected_at > 0, marks[cell].state == CellState::projected);
            if (e.projected_at > 0) {
                ASSERT_LE(e.projected_at, session.position());
                ASSERT_EQ(session.timeline().steps[e.projected_at - 1].item.id, cell);
            }
            const bool touched = marks[cell].state == CellState::projected || marks[cell].state == CellState::enqueued;
            const bool is_seed = std::find(seeds.begin(), seeds.end(), cell) != seeds.end();
            if (!touched || e.chain.empty()) {
                ASSERT_TRUE(e.chain.empty());
                ASSERT_EQ(touched, is_seed) << "only a seed is touched without an update";
                if (touched) {
                    ASSERT_EQ(marks[cell].key, 0);
                }
                clean_reasons += !touched;
            } else {
                longest = std::max(longest, e.chain.size());
                const std::uint32_t first = e.chain.front().update.from.id;
                ASSERT_TRUE(std::find(seeds.begin(), seeds.end(), first) != seeds.end());
                ASSERT_EQ(e.chain.back().update.item.id, cell);
                ASSERT_EQ(e.chain.back().update.key->key, marks[cell].key);
                for (std::size_t k = 0; k < e.chain.size(); ++k) {
                    const ChainLink& link = e.chain[k];
                    ASSERT_EQ(session.timeline().steps[link.step - 1].item.id, link.update.from.id);
                    // The link's own key is the solidity that the next one hands on.
                    ASSERT_EQ(link.update.key->terms.front().value,
                              k == 0 ? marks[first].key : e.chain[k - 1].update.key->key);
                    if (k == 0) continue;
                    ASSERT_EQ(e.chain[k - 1].update.item.id, link.update.from.id);
                    ASSERT_LT(e.chain[k - 1].step, link.step);
                }
            }
            // Reached: every key that any step computed for it.
            std::size_t found = 0;
            for (const StepExplanation& step : steps)
                for (const Considered& facet : step.looked_at) {
                    if (facet.item.id != cell || !facet.key) continue;
                    ASSERT_LT(found, e.reached.size());
                    ASSERT_EQ(e.reached[found].step, step.step);
                    ASSERT_EQ(e.reached[found].update.via.id, facet.via.id);
                    ASSERT_EQ(e.reached[found].update.rule, facet.rule);
                    ASSERT_EQ(e.reached[found].update.key->key, facet.key->key);
                    ASSERT_EQ(e.reached[found].update.before, facet.before);
                    kept += Rule{facet.rule} == Rule::kept;
                    ++found;
                }
            ASSERT_EQ(e.reached.size(), found);
            ASSERT_EQ(e.digits, digits);

            const auto text = rows(e);
            for (const std::string& row : text) ASSERT_TRUE(!row.empty() && row.find('\n') == std::string::npos) << row;
            const bool more = found > 1;
            // The chain from its end, which decides; what is about nothing beside it in one line.
            const auto parts = chain_parts(e.chain);
            double largest = 0;
            for (const ChainLink& link : e.chain) largest = std::max(largest, link.update.key->key);
            std::size_t end = e.chain.size();
            for (const ChainPart& part : parts) {
                ASSERT_EQ(part.first + part.count, end);
                ASSERT_TRUE(part.count == 1 || end < e.chain.size());
                end = part.first;
                for (std::size_t k = 0; part.count > 1 && k < part.count; ++k)
                    ASSERT_LE(e.chain[part.first + k].update.key->key, largest / 100);
            }
            ASSERT_EQ(end, 0u);
            ASSERT_EQ(text.size(), 1 + !!e.verdict + parts.size() + (more ? 1 + found : 0));
            if (!e.chain.empty()) {
                ASSERT_TRUE(text[1 + !!e.verdict].ends_with(e.chain.back().update.key->formula()));
            }
            for (std::size_t k = 0; more && k < found; ++k) {
                const std::string& row = text[text.size() - found + k];
                ASSERT_EQ(row.find("    step " + std::to_string(e.reached[k].step) + ": cell "), 0u) << row;
                const auto rule = e.reached[k].update.words;
                ASSERT_NE(row.find(rule), std::string::npos) << row;
            }
        }
    }
    EXPECT_GT(longest, 5u);
    EXPECT_GT(kept, 100u);
    EXPECT_GT(clean_reasons, 100u);
}

TEST(Explain, SentencesTellTheTwoKeysApartOrSayTie) {
    Random random(43);
    int ties = 0, alone = 0, apart = 0;
    for (int i = 0; i < test::soak_count(200); ++i) {
        const test::Start start = test::random_cell_start(random);
        Session<2> session = start.session();
        while (session.step() == Stop::none) {
            const StepExplanation e = explain_step(session, session.position());
            const std::string text = sentence(e);
            ASSERT_EQ(text.find("Step " + std::to_string(e.step) + ": cell " + std::to_string(e.cell) + " "), 0u);
            ASSERT_EQ(text.back(), '.');
            const bool tie = e.runner_up != none && e.runner_up_key == e.key;
            ASSERT_EQ(text.find("tie, older stamp wins") != std::string::npos, tie) << text;
            ASSERT_EQ(text.find("alone in the front") != std::string::npos, e.runner_up == none) << text;
            if (e.runner_up != none) {
                ASSERT_NE(text.find("cell " + std::to_string(e.runner_up) + " "), std::string::npos) << text;
            }
            if (e.runner_up != none && !tie) {
                // "has the lowest key, X; the runner-up is cell C with Y": X and Y must read as different numbers.
                const std::size_t x = text.find("key, ") + 5, y = text.find(" with ") + 6;
                const std::string first = text.substr(x, text.find(';', x) - x);
                const std::string second = text.substr(y, text.find(';', y) - y);
                ASSERT_TRUE(parse_number(first) && parse_number(second)) << text;
                ASSERT_LT(*parse_number(first), *parse_number(second)) << text;
                ++apart;
            }
            ASSERT_NE(text.find("rendered " + std::to_string(e.rendered) + " primitive"), std::string::npos) << text;
            const auto lines = rows(e);
            ASSERT_EQ(lines.size(), e.looked_at.size() + 1);
            ASSERT_EQ(lines.front(), text);
            ASSERT_EQ(e.digits, e.runner_up == none ? 3 : separating_digits(e.key, e.runner_up_key));
            for (std::size_t k = 0; k < e.looked_at.size(); ++k)
                if (e.looked_at[k].key) {
                    const std::string wanted = e.looked_at[k].key->formula();
                    ASSERT_NE(lines[k + 1].find(wanted), std::string::npos) << lines[k + 1];
                }
            ties += tie;
            alone += e.runner_up == none;
        }
    }
    EXPECT_GT(ties, 20);
    EXPECT_GT(alone, 20);
    EXPECT_GT(apart, 100);
}

TEST(Explain, SeparatingDigitsAreTheFewestThatDo) {
    Random random(44);
    for (int i = 0; i < test::soak_count(20000); ++i) {
        const double a = (random.below(2) ? 1 : -1) * std::pow(10, random.uniform(-8, 8));
        double b = a * (1 + std::pow(10, random.uniform(-16, 1)));
        if (random.below(20) == 0) b = std::nextafter(a, 1e300);
        if (random.below(50) == 0) b = 0;
        if (a == b) continue;
        const int digits = separating_digits(a, b);
        ASSERT_NE(short_number(a, digits), short_number(b, digits)) << a << " " << b;
        ASSERT_EQ(separating_digits(b, a), digits);
        for (int fewer = 3; fewer < digits; ++fewer)
            ASSERT_EQ(short_number(a, fewer), short_number(b, fewer)) << a << " " << b;
    }
    EXPECT_EQ(separating_digits(0.5, 0.5), 3);
    EXPECT_EQ(separating_digits(0.25, 0.2501), 4);
}

// Also across a facet that turns away, through which nothing of it comes.
TEST(Explain, LightNamesWhatTheCellBeforeHas) {
    Random random(45);
    int turned_away = 0;
    for (int i = 0; i < test::soak_count(30); ++i) {
        test::Start start = test::random_start(random);
        start.settings.method = "flux";
        Session<2> session = start.session();
        session.run();
        for (std::uint32_t n = 1; n <= session.position(); ++n) {
            const StepExplanation step = explain_step(session, n);
            for (const Considered& c : step.looked_at) {
                if (!c.key) continue;
                ASSERT_NEAR(test::term(*c.key, "handed_on"), 1 - step.key, 1e-12) << "step " << n;
                turned_away += test::term(*c.key, "share") == 0;
            }
        }
    }
    EXPECT_GT(turned_away, 20);
}

TEST(Explain, LightAndSizeMakeTheKeyOfTri) {
    Random random(47);
    for (const char* const transport : {"facets", "corners"}) {
        int dark = 0, keys = 0;
        for (int i = 0; i < test::soak_count(30); ++i) {
            test::Start start = test::random_start(random);
            start.settings.method = "tri";
            apply_setting(start.settings, std::string("transport=") + transport);
            const bool pixels = i % 2 == 0;
            if (pixels) apply_setting(start.settings, "maximise=pixels");
            Session<2> session = start.session();
            session.run();
            for (std::uint32_t n = 1; n <= session.position(); ++n) {
                for (const Considered& c : explain_step(session, n).looked_at) {
                    if (!c.key || !(c.key->key > 0)) continue;
                    const double light = test::term(*c.key, "transmittance"),
                                 size = test::term(*c.key, "apparent_size");
                    if (std::string_view(transport) == "corners") {
                        ASSERT_LE(test::term(*c.key, "corner_least"), light + 1e-12);
                        ASSERT_GE(test::term(*c.key, "corner_most"), light - 1e-12);
                    }
                    const double taken = std::max(light, 0x1p-20);
                    ASSERT_NEAR(c.key->key * taken * (pixels ? size : std::sqrt(size)), 1, 1e-9);
                    const std::string words = c.key->formula();
                    EXPECT_EQ(words.find(", at least ") != std::string::npos, light < 0x1p-20) << words;
                    dark += light < 0x1p-20;
                    ++keys;
                }
            }
        }
        EXPECT_GT(keys, 500) << transport;
        EXPECT_GT(dark, 10) << transport;
    }
}

TEST(Explain, TheShadeOfFluxIsWhatItsCornersLack) {
    Random random(48);
    int keys = 0;
    for (int i = 0; i < test::soak_count(30); ++i) {
        test::Start start = test::random_start(random);
        start.settings.method = "flux";
        apply_setting(start.settings, "transport=corners");
        Session<2> session = start.session();
        session.run();
        for (std::uint32_t n = 1; n <= session.position(); ++n)
            for (const Considered& c : explain_step(session, n).looked_at) {
                if (!c.key) continue;
                ASSERT_EQ(c.key->key, 1 - test::term(*c.key, "transmittance"));
                ++keys;
            }
    }
    EXPECT_GT(keys, 500);
}

TEST(Explain, TheBannerSaysWhatBecameOfABox) {
    Random random(46);
    test::Start start = test::random_start(random);
    start.settings.method = "tri-z";
    Session<2> session = start.session();
    session.run();
    ASSERT_GT(session.position(), 0u);
    const StepExplanation step = explain_step(session, 1);
    ASSERT_FALSE(step.looked_at.empty());
    EXPECT_EQ(step_line(step, false, "Left"), "Left, step 1: node 0, " + std::string(step.looked_at.front().words) +
                                                  "; " + std::to_string(step.rendered) + " drawn.");
}

TEST(Explain, TheFormulaShowsEveryTerm) {
    SolidityTerms terms;
    terms.handed_on = 0.25;
    terms.count = 3;
    terms.content = 0.5;
    terms.angle = 0.75;
    terms.unpenalised = 0.6875;
    terms.key = 1.375;
    terms.star_tested = true;
    Settings settings;
    const auto formula = [&] { return explain_solidity(terms, PlpParameters(settings.parameters), 4).formula(); };
    EXPECT_EQ(formula(), "ρ = 0.5 + 0.75 · 0.25 = 0.6875");
    terms.star_shaped = false;
    EXPECT_EQ(formula(), "ρ = 0.5 + 0.75 · 0.25 = 0.6875, × 2 (not star-shaped) = 1.375");
    apply_setting(settings, "penalty=add");
    EXPECT_EQ(formula(), "ρ = 0.5 + 0.75 · 0.25 = 0.6875, + 2 (not star-shaped) = 1.375");
}

}  // namespace
}  // namespace sightline
