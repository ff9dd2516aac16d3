// How methods with parameters are written and read.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "core/base/error.h"
#include "core/methods/method_table.h"
#include "core/methods/plp/plp_parameters.h"
#include "core/session/settings_table.h"

namespace sightline {
namespace {

using Assignments = std::vector<std::pair<std::string, std::string>>;

TEST(Variant, IsAnIdAndAssignments) {
    EXPECT_EQ(read_variant("published"), (VariantText{"published", {}}));
    EXPECT_EQ(read_variant("  published   on_reenqueue=min "), (VariantText{"published", {{"on_reenqueue", "min"}}}));
    const VariantText quoted = read_variant("formula key=\"content + hops\" on_reenqueue='max'");
    EXPECT_EQ(quoted.assignments, (Assignments{{"key", "content + hops"}, {"on_reenqueue", "max"}}));
    EXPECT_EQ(read_variant("formula key=min(content, 1)").assignments, (Assignments{{"key", "min(content, 1)"}}));
    for (const char* const text : {"published", "published on_reenqueue=min", "formula key=\"content + hops\"",
                                   "formula key=\"min(content, 1)\" seeds=hull"})
        EXPECT_EQ(read_variant(text).text(), text);
    for (const char* const bad : {"", "  ", "published min", "published =min"})
        EXPECT_THROW(read_variant(bad), InputError) << bad;
}

TEST(Variant, ListsAreSplitOutsideQuotesAndParentheses) {
    using List = std::vector<std::string>;
    EXPECT_EQ(split_variants("published,layers, view"), (List{"published", "layers", "view"}));
    EXPECT_EQ(split_variants("published; published on_reenqueue=min"),
              (List{"published", "published on_reenqueue=min"}));
    EXPECT_EQ(split_variants("formula key=min(content,1);layers"), (List{"formula key=min(content,1)", "layers"}));
    EXPECT_EQ(split_variants("formula key='a;b'; layers"), (List{"formula key='a;b'", "layers"}));
    EXPECT_EQ(split_variants(" ; "), List{});
}

TEST(Variant, SetsTheParametersOfItsMethodAndNoOthers) {
    const Variant<2> made = make_variant<2>(method_table<2>(), "published on_reenqueue=min penalty_amount=3.0");
    EXPECT_EQ(made.text, "published on_reenqueue=min penalty_amount=3.0");
    EXPECT_EQ(made.parameters.text(on_reenqueue_row()), "min");
    EXPECT_EQ(made.parameters.number(penalty_amount_row()), 3);
    EXPECT_EQ(made.parameters.text(penalty_row()), "multiply");
    for (const char* const bad : {"layers penalty=none", "everything seeds=hull", "published on_reenqueue=never",
                                  "published penalty_amount=-1", "publishd"})
        EXPECT_THROW(make_variant<2>(method_table<2>(), bad), InputError) << bad;
    EXPECT_EQ(find_method<3>(method_table<3>(), "distance").id, "centroid") << "an alias";
}

TEST(Variant, IsWrittenWithWhatDiffersFromItsBase) {
    const Method<2>& published = find_method<2>(method_table<2>(), "published");
    Parameters base, now;
    base.set(penalty_row(), "none");
    now.set(penalty_row(), "none");
    EXPECT_EQ(variant_of(published, now, base).text, "published");
    now.set(on_reenqueue_row(), "min");
    EXPECT_EQ(variant_of(published, now, base).text, "published on_reenqueue=min");
    now.set(penalty_row(), "multiply");
    EXPECT_EQ(variant_of(published, now, base).text, "published on_reenqueue=min penalty=multiply");
    EXPECT_EQ(variant_of(published, now).text, "published on_reenqueue=min");
    EXPECT_EQ(variant_of(find_method<2>(method_table<2>(), "layers"), now).text, "layers");
}

TEST(Variant, ANameMeansTheSameRowInEveryMethod) {
    for (const Method<2>& method : method_table<2>())
        for (const ParameterRow* row : method.parameters)
            for (const ParameterRow* other : all_parameters())
                if (row->name == other->name) {
                    EXPECT_EQ(row, other) << method.id << " " << row->name;
                }
    EXPECT_TRUE(find_method<2>(method_table<2>(), "everything").parameters.empty());
    // Nor is it that of a setting: `--set` would mean either.
    std::set<std::string_view> names;
    for (const SettingRow& row : settings_table()) EXPECT_TRUE(names.insert(row.name).second) << row.name;
}

}  // namespace
}  // namespace sightline
