// A cell in a few words: the key by the name that its method has for it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/cell_words.h"

#include <gtest/gtest.h>

#include "core/base/number.h"
#include "core/scene/make/catalogue.h"

namespace sightline {
namespace {

TEST(CellWords, NameTheKeyAsTheMethodDoes) {
    const CatalogueRow<2>& row = *find_in_catalogue("bottleneck");
    const auto scene = std::make_shared<const Scene<2>>(make_scene(row));
    for (const auto& [method, name] : {std::pair{"published", "accumulated solidity ρ"},
                                       {"layers", "layer"},
                                       {"flux", "shade 1 − T"},
                                       {"tri", "key by light and size"},
                                       {"extinction", "optical depth from the eye"}}) {
        Settings settings;
        settings.error_bound = row.error_bound;
        settings.method = method;
        Session<2> session(scene, row.view, settings);
        session.run(20);
        std::size_t with_key = 0;
        for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
            const Mark mark = session.mark(cell);
            const bool has_key = mark.state == CellState::enqueued || mark.state == CellState::projected;
            const std::string told = cell_words(session, cell);
            const std::string key = ", " + std::string(name) + " = " + short_number(mark.key) + ",";
            ASSERT_EQ(told.find(key) != std::string::npos, has_key) << told;
            with_key += has_key;
        }
        EXPECT_GT(with_key, 20u) << method;
    }
}

}  // namespace
}  // namespace sightline
