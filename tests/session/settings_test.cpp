// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/excerpt.h"
#include "core/session/settings_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/random.h"
#include "core/methods/method_table.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

/// The numeric fields' ranges as the design fixes them.
struct Range {
    double low, high;
    bool low_open = false, high_open = false;
    bool whole = false;
};
const std::map<std::string_view, Range> ranges{
    {"error_bound", {0, 1, true}},
    {"jitter", {0, 0.5, false, true}},
    {"penalty_amount", {0, 1e6}},
    {"zoom", {0.01, 1000}},
    {"seed", {0, 0x1p64, false, true, true}},
    {"shrink", {0.05, 1}},
    {"leaf_capacity", {1, 1e6, false, false, true}},
    {"opacity_tolerance", {0, 1, false, true}},
    {"slice_at", {0, 1}},
    {"around", {0, 1000, false, false, true}},
    {"occluder_share", {0, 1}},
    {"opacity", {0, 1}},
    {"worth", {0, 1e6}},
    {"refresh", {1, 1e6, false, false, true}},
    {"detail", {0.01, 1}},
    {"occluder_count", {1, 1024, false, false, true}},
    {"shadows", {1, 256, false, false, true}},
    {"threshold", {1e-6, 100}},
    {"leaf", {1, 4096, false, false, true}},
    {"workers", {0, 64, false, false, true}},
    {"pixel_error", {0, 1e6}},
    {"frame_ms", {0, 1e6}},
    {"vertex_ns", {0, 1e6}},
    {"pixel_ns", {0, 1e6}},
    {"grid", {0, 64, false, false, true}},
    {"azimuths", {3, 64, false, false, true}},
    {"elevations", {1, 31, false, false, true}},
    {"samples", {1, 1000, false, false, true}},
    {"allotted_ms", {0, 1e6}},
    {"few", {1, 10000, false, false, true}},
    {"few_cover", {0, 1}},
    {"switch_ms", {0, 1e6}},
    {"valid_frames", {1, 1000000, false, false, true}},
};

const std::set<std::string_view> any_number{"zoom_x", "zoom_y"};

std::vector<std::string> words_of(const SettingRow& row) {
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin <= row.values.size();) {
        const std::size_t end = std::min(row.values.find(" | ", begin), row.values.size());
        words.emplace_back(row.values.substr(begin, end - begin));
        begin = end + 3;
    }
    return words;
}

std::vector<std::string> good_values(const SettingRow& row, Random& random) {
    if (row.name == "method") {
        std::vector<std::string> ids;
        for (const Method<2>& method : method_table<2>()) ids.emplace_back(method.id);
        return ids;
    }
    if (row.name == "first") return {"published", "layers", "published on_reenqueue=min"};
    if (row.name == "techniques") return {"view; boxes", "view", "view; hom; boxes refresh=16"};
    if (row.name == "cull_times") return {"view 40/8", "view 40/8; boxes refresh=16 300/60.5"};
    if (row.name == "total") return {"500", "0", "5%", "unlimited"};
    if (row.name == "file" || row.name == "along" || row.name == "table")  // of a file that is there
        return {SIGHTLINE_SOURCE_DIR "/README.md", SIGHTLINE_SOURCE_DIR "/run"};
    if (row.name == "key") return {"content", "content+hops", "min(angle, 1) * handed_on", "2"};
    if (row.name == "budget") return {"500", "0", "5%", "0.125%", "100%", "16ms", "0.5ms", "unlimited"};
    if (row.name == "reference_size") return {"auto", "1", "8192", "16777216", "1x1", "8192x8192", "640x480"};
    if (any_number.contains(row.name))
        return {"0", "-2.5", "1.7976931348623157e+308", "-1e-300", number_text(random.uniform(-1e6, 1e6))};
    const auto range = ranges.find(row.name);
    if (range == ranges.end()) return words_of(row);
    const Range& r = range->second;
    if (r.whole)
        return {std::to_string(static_cast<int>(r.low)),
                row.name == "seed" ? "18446744073709551615" : std::to_string(static_cast<int>(r.high)),
                row.name == "seed" ? std::to_string(1 + random.below(16777216))
                                   : std::to_string(static_cast<std::uint32_t>(std::max(r.low, 1.0)) +
                                                    random.below(static_cast<std::uint32_t>(r.high - r.low)))};
    std::vector<std::string> values;
    for (int i = 0; i < 50; ++i) values.push_back(number_text(random.uniform(std::max(r.low, 1e-9), r.high)));
    if (!r.low_open) values.push_back(number_text(r.low));
    if (!r.high_open) values.push_back(number_text(r.high));
    return values;
}

TEST(Settings, EveryRowReadsBackWhatItWasGiven) {
    Random random(1);
    const Settings defaults;
    for (const SettingRow& row : settings_table()) {
        std::set<std::string> seen;
        for (const std::string& value : good_values(row, random)) {
            Settings settings;
            row.set(settings, value);
            EXPECT_EQ(row.get(settings), value) << row.name;
            seen.insert(row.get(settings));
            // One row writes one field: put back, the struct is the default again.
            row.set(settings, row.get(defaults));
            EXPECT_EQ(settings, defaults) << row.name << " changes another field too";
        }
        EXPECT_GE(seen.size(), 2u) << row.name << " has nothing to choose from";
        EXPECT_EQ(&setting_row(row.name), &row);
    }
}

TEST(Settings, EveryFieldOfTheStructHasARow) {
    // All rows at another value: a field without a row would be the only one that keeps its default.
    Random random(2);
    Settings changed;
    const Settings defaults;
    for (const SettingRow& row : settings_table())
        for (const std::string& value : good_values(row, random))
            if (value != row.get(defaults)) {
                row.set(changed, value);
                break;
            }
    // Copy back all fields of the table: nothing may be left over.
    Settings back = changed;
    for (const SettingRow& row : settings_table()) {
        EXPECT_NE(row.get(changed), row.get(defaults)) << row.name;
        row.set(back, row.get(defaults));
    }
    EXPECT_EQ(back, defaults);
    // As many names as the structs have fields, or this does not compile.
    const auto& [t1, t2, t3, t4, t5, t6, t7, t8, t9, t10] = static_cast<const TessellationSettings&>(changed);
    static_cast<void>(t1);
    const auto& [p1, p2, p3, p4, p5, p6, p7, p8, p9, p10, p11, p12, p13, p14, p15, p16, p17, p18, p19, p20, p21, p22,
                 p23, p24, p25, p26, p27, p28, p29, p30, p31, p32, p33, p34, p35] =
        static_cast<const PictureSettings&>(changed);
    static_cast<void>(p1);
    constexpr std::size_t own = 8;  // two_sided, up, degrees, auto, method, budget, reference_size, reference
    EXPECT_EQ(settings_table().size(), 10u + 35u + own + all_parameters().size());
}

TEST(Settings, NamesDefaultsAndWordsAreThoseOfTheDesign) {
    struct Row {
        const char *name, *standard, *printed, *values;  // `printed`: in prototype-2d and paper-3d
    };
    const Row design[] = {
        {"view_vector", "eye", "camera", "eye | camera"},
        {"transfer_sign", "clamp", "signed", "clamp | signed | abs"},
        {"on_reenqueue", "replace", "replace", "replace | min | max"},
        {"penalty", "multiply", "multiply", "multiply | add | none"},
        {"penalty_amount", "2", "2", nullptr},
        {"star_shaped", "on", nullptr, "off | on"},
        {"error_bound", "0.05", "0.3", "(0, 1]"},
        {"border", "inflated", "inflated", "inflated | none"},
        {"jitter", "0.02", "0.1", "[0, 0.5)"},
        {"solidity_scale", "max", "max", "max | p95"},
        {"outside_view", "unseen", "enqueue", "unseen | enqueue"},
        {"culled_cost", "free", "free", "free | charged"},
        {"neighbours_before_break", "yes", "no", "no | yes"},
        {"reference_size", "auto", nullptr, nullptr},
        {"reference", "opengl", nullptr, "opengl | software"},
        {"seeds", "one", "one", "one | hull"},
        {"budget_counts", "each_once", "each_once", "each_once | per_cell"},
        {"own_content", "off", "off", "off | on"},
        {"empty_leaves", "keep", "keep", "keep | drop | merge"},
        {"split_for", "vertices", "vertices", "vertices | opacity"},
        {"opacity_tolerance", "0.1", "0.1", "[0, 1)"},
        {"leaf_capacity", "1", "1", "[1, 1000000]"},
        {"neighbours", "facet", "facet", "facet | touching"},
        {"tessellation", "delaunay", "delaunay", "delaunay | tree | kd"},
    };
    Settings prototype, paper;
    for (Settings* settings : {&prototype, &paper}) {  // a preset leaves the cells alone
        settings->error_bound = 0.3;
        settings->jitter = 0.1;
    }
    apply_preset(prototype, "prototype-2d");
    apply_preset(paper, "paper-3d");
    EXPECT_EQ(setting_row("star_shaped").get(prototype), "off") << "as the 2D program of TR";
    EXPECT_EQ(setting_row("star_shaped").get(paper), "on");
    for (const Row& row : design) {
        const SettingRow& ours = setting_row(row.name);
        EXPECT_EQ(ours.get(Settings{}), row.standard) << row.name;
        if (row.printed) {
            EXPECT_EQ(ours.get(prototype), row.printed) << row.name;
            EXPECT_EQ(ours.get(paper), row.printed) << row.name;
        }
        if (row.values) {
            EXPECT_EQ(ours.values, row.values) << row.name;
        }
    }
    EXPECT_EQ(setting_row("method").get(Settings{}), "published");
    EXPECT_EQ(setting_row("palette").values, "default | paper | print");
}

TEST(Settings, EachRowSaysWhatItInvalidates) {
    const std::map<std::string_view, Invalidates> expected{{"two_sided", Invalidates::scene},
                                                           {"up", Invalidates::scene},
                                                           {"degrees", Invalidates::scene},
                                                           {"tessellation", Invalidates::tessellation},
                                                           {"error_bound", Invalidates::tessellation},
                                                           {"border", Invalidates::tessellation},
                                                           {"jitter", Invalidates::tessellation},
                                                           {"seed", Invalidates::tessellation},
                                                           {"leaf_capacity", Invalidates::tessellation},
                                                           {"empty_leaves", Invalidates::tessellation},
                                                           {"neighbours", Invalidates::tessellation},
                                                           {"split_for", Invalidates::tessellation},
                                                           {"opacity_tolerance", Invalidates::tessellation},
                                                           {"reference_size", Invalidates::reference},
                                                           {"reference", Invalidates::reference},
                                                           {"palette", Invalidates::picture},
                                                           {"label", Invalidates::picture},
                                                           {"zoom", Invalidates::picture},
                                                           {"zoom_x", Invalidates::picture},
                                                           {"zoom_y", Invalidates::picture},
                                                           {"method", Invalidates::traversal},
                                                           {"budget", Invalidates::traversal},
                                                           {"auto", Invalidates::traversal},
                                                           {"seeds", Invalidates::traversal},
                                                           {"penalty", Invalidates::traversal}};
    for (const auto& [name, what] : expected) EXPECT_EQ(setting_row(name).invalidates, what) << name;
    Random random(3);
    EXPECT_EQ(difference({}, {}), Invalidates::picture);
    for (const SettingRow& row : settings_table())
        for (const std::string& value : good_values(row, random)) {
            Settings changed;
            row.set(changed, value);
            const Invalidates expected_difference = changed == Settings{} ? Invalidates::picture : row.invalidates;
            EXPECT_EQ(difference({}, changed), expected_difference) << row.name << "=" << value;
            EXPECT_EQ(difference(changed, {}), expected_difference) << row.name << "=" << value;
            Settings more = changed;
            more.two_sided = Switch::on;
            EXPECT_EQ(difference(Settings{}, more), Invalidates::scene) << "the strongest counts";
        }
}

TEST(Settings, BadValuesNameFieldValueAndWhatIsAllowedAndChangeNothing) {
    const auto check = [](const SettingRow& row, const std::string& value) {
        const bool may_be_a_field =
            (row.name == "heat" || row.name == "label") && !value.empty() &&
            std::all_of(value.begin(), value.end(), [](char c) { return c >= 'a' && c <= 'z'; });
        if (may_be_a_field) return;     // a session knows the fields: tests/draw/cell_number_test.cpp
        if (row.name == "key") return;  // an expression: tests/run/formula_method_test.cpp
        if (row.name == "file" || row.name == "along") return;  // tests/lab/lab_sets_test.cpp
        if (row.name == "table") return;                        // a file: tests/run/by_viewpoint_test.cpp
        Settings settings;
        settings.jitter = 0.25;
        const Settings before = settings;
        try {
            apply_setting(settings, std::string(row.name) + "=" + value);
            ADD_FAILURE() << row.name << " takes '" << value << "'";
        } catch (const InputError& error) {
            const std::string what = error.what();
            EXPECT_EQ(what.find('\n'), std::string::npos) << what;
            EXPECT_NE(what.find(row.name), std::string::npos) << what;
            EXPECT_NE(what.find(value), std::string::npos) << what;
            if (row.name == "reference_size") {
                EXPECT_NE(what.find("auto"), std::string::npos) << what;
            } else if (row.name == "budget" || row.name == "total") {
                EXPECT_NE(what.find("unlimited"), std::string::npos) << what;
            } else if (!ranges.contains(row.name)) {
                EXPECT_NE(what.find(row.values), std::string::npos) << what;
            } else  // e.g. "(0, 1]"
                EXPECT_NE(what.find(std::string(1, row.values[0]) + number_text(ranges.at(row.name).low) + ", "),
                          std::string::npos)
                    << what;
        }
        EXPECT_EQ(settings, before) << row.name << "=" << value;
        EXPECT_THROW(row.set(settings, value), InputError);
        EXPECT_EQ(settings, before) << row.name << "=" << value;
    };
    Random random(4);
    for (const SettingRow& row : settings_table()) {
        if (row.name == "method" || row.name == "first" || row.name == "techniques")
            continue;  // any text; a session refuses unknown ids
        if (!any_number.contains(row.name)) check(row, "-1");
        for (const char* value : {"", "nonsense", "NaN", "inf", "1e999", " 1", "1 ", "0x10", "1,5"}) check(row, value);
        if (row.name == "reference_size")
            for (const char* value : {"0", "16777217", "0x5", "8193x1", "1x8193", "1x", "x1", "1X1", "1x1x1"})
                check(row, value);
        const auto range = ranges.find(row.name);
        if (range == ranges.end()) {
            if (row.name != "budget" && row.name != "total" && row.name != "reference_size" &&
                !any_number.contains(row.name))  // words are not cut, not joined, not in capitals
                for (std::string word : words_of(row)) {
                    check(row, word + "x");
                    word[0] = static_cast<char>(std::toupper(word[0]));
                    check(row, word);
                }
            continue;
        }
        const Range& r = range->second;
        if (r.whole) {
            check(row, "1.5");
            check(row, row.name == "seed" ? "18446744073709551616" : std::to_string(static_cast<int>(r.high) + 1));
            if (r.low > 0) check(row, "0");
        } else {
            check(row, number_text(std::nextafter(r.high, 1e9)));
            check(row, number_text(std::nextafter(r.low, -1e9)));
            if (r.low_open) check(row, number_text(r.low));
            if (r.high_open) check(row, number_text(r.high));
        }
    }
}

TEST(Settings, UnknownNamesListTheKnownOnes) {
    Settings settings;
    for (const char* assignment : {"nonsense=1", "=1"}) try {
            apply_setting(settings, assignment);
            ADD_FAILURE() << assignment;
        } catch (const InputError& error) {
            for (const SettingRow& row : settings_table())
                EXPECT_NE(std::string(error.what()).find(row.name), std::string::npos) << row.name;
        }
    for (const char* assignment : {"jiter", "Jitter", " jitter"})
        test::expect_input_error([&] { apply_setting(settings, std::string(assignment) + "=0.1"); },
                                 "setting '" + std::string(assignment) + "' does not exist; did you mean jitter?");
    test::expect_input_error([&] { apply_setting(settings, "jitter"); }, "setting 'jitter': write FIELD=VALUE");
    test::expect_input_error([&] { apply_preset(settings, "lettre"); },
                             "preset 'lettre' does not exist; there are default, prototype-2d, paper-3d");
    EXPECT_EQ(settings, Settings{});
}

TEST(Settings, PresetsSetAllThatTheOtherOnesTouch) {
    // Going from any preset to any other must not leave traces of the first.
    for (const Preset& first : presets())
        for (const Preset& second : presets()) {
            Settings both, one;
            apply_preset(both, first.id);
            apply_preset(both, second.id);
            apply_preset(one, second.id);
            EXPECT_EQ(both, one) << first.id << " then " << second.id;
        }
    Settings standard;
    apply_preset(standard, "default");
    EXPECT_EQ(standard, Settings{});
    // A preset leaves what it does not name.
    Settings kept;
    kept.palette = Palette::paper;
    kept.budget = parse_budget("7");
    apply_preset(kept, "paper-3d");
    EXPECT_EQ(kept.palette, Palette::paper);
    EXPECT_EQ(budget_text(kept.budget), "7");
}

TEST(Budget, TextReadsBackToTheSameBudget) {
    Random random(5);
    for (int i = 0; i < 20000; ++i) {
        std::string text;
        switch (random.below(5)) {
            case 0:
                text = std::to_string(random.below(std::uint64_t{1} << random.below(50)));
                break;
            case 1:
                text = number_text(random.unit() * 100) + "%";
                break;
            case 2:
                text = number_text(std::pow(10, random.uniform(-12, 2))) + "%";
                break;
            case 3:
                text = number_text(std::pow(10, random.uniform(-6, 6))) + "ms";
                break;
            default:
                text = number_text(static_cast<double>(random.below(10001)) / 100) + "%";
        }
        const Budget budget = parse_budget(text);
        ASSERT_EQ(parse_budget(budget_text(budget)), budget) << text << " -> " << budget_text(budget);
    }
    for (const char* text : {"500", "0", "5%", "0.5%", "12.34%", "100%", "0%", "16ms", "0.5ms", "unlimited"})
        EXPECT_EQ(budget_text(parse_budget(text)), text);
}

TEST(Budget, CountsPrimitives) {
    EXPECT_EQ(parse_budget("5%").primitives(1000), 50u);
    EXPECT_EQ(parse_budget("5%").primitives(29), 1u);
    EXPECT_EQ(parse_budget("5%").primitives(31), 2u) << "rounded, not cut";
    EXPECT_EQ(parse_budget("0.001%").primitives(10), 1u) << "no share is nothing at all";
    EXPECT_EQ(parse_budget("0%").primitives(10), 0u);
    EXPECT_EQ(parse_budget("100%").primitives(12345), 12345u);
    EXPECT_EQ(parse_budget("500").primitives(10), 500u);
    EXPECT_EQ(parse_budget("0").primitives(10), 0u);
    for (const char* text : {"unlimited", "16ms", "4294967295", "1e300"})
        EXPECT_EQ(parse_budget(text).primitives(10), 0xffffffffu) << text;
}

TEST(Budget, RefusesWhatIsNone) {
    for (const std::string text :
         {"",    "%",   "ms",   "-1",    "-5%",  "-1ms", "100.1%", "1.5", "five", "5 %",  " 5",     "5%%",       "5s",
          "nan", "inf", "nan%", "1e999", "0x10", "+-5",  "--5",    "1e",  "5ms%", "5m s", "5\n500", "unlimited "})
        try {
            parse_budget(text);
            ADD_FAILURE() << "takes '" << text << "'";
        } catch (const InputError& error) {
            EXPECT_EQ(std::string(error.what()).find("budget '" + excerpt(text) + "': "), 0u) << error.what();
            EXPECT_NE(std::string(error.what()).find("16ms"), std::string::npos) << error.what();
        }
}

TEST(Number, TextReadsBackToTheSameDouble) {
    Random random(6);
    for (int i = 0; i < 20000; ++i) {
        const double value = std::bit_cast<double>(random.bits());
        if (!std::isfinite(value)) continue;
        const auto read = parse_number(number_text(value));
        ASSERT_TRUE(read);
        ASSERT_EQ(std::bit_cast<std::uint64_t>(*read), std::bit_cast<std::uint64_t>(value));
    }
    EXPECT_EQ(parse_number("+5"), 5);
    for (const char* bad : {"", "+", "-", "+-5", "++5", "1.2.3", "nan", "inf", "-inf", "1e999", "5 ", " 5", "5e", ","})
        EXPECT_FALSE(parse_number(bad)) << bad;
}

TEST(Number, ShortNumbersKeepTheirDigits) {
    Random random(7);
    for (int i = 0; i < 20000; ++i) {
        const double value = (random.below(2) ? 1 : -1) * std::pow(10, random.uniform(-12, 12));
        const int digits = 1 + static_cast<int>(random.below(15));
        const std::string text = short_number(value, digits);
        const auto read = parse_number(text);
        ASSERT_TRUE(read) << text;
        // Digits before the point are never dropped, so the error is at most half a unit of the last digit.
        ASSERT_LE(std::abs(*read - value), std::abs(value) * std::pow(10, 1 - digits) * 0.5000001)
            << value << " -> " << text;
        ASSERT_EQ(text.find_first_of("eE") != std::string::npos, std::abs(value) >= 1e7 || std::abs(value) < 1e-4)
            << text;
        ASSERT_LE(text.size(), 24u) << text;
    }
    EXPECT_EQ(short_number(0), "0");
    EXPECT_EQ(short_number(0.25), "0.25");
    EXPECT_EQ(short_number(2), "2");
    EXPECT_EQ(short_number(0.36049), "0.36");
    EXPECT_EQ(short_number(1234567), "1234567");
    EXPECT_EQ(short_number(-0.5), "-0.5");
}

}  // namespace
}  // namespace sightline
