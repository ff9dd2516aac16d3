// --settings FILE: what one program found out, the viewers take.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/settings_file.h"
#include "tests/viewer2d/viewer2d_support.h"

namespace sightline {
namespace {

using namespace test;

class SettingsOption : public Viewer2dRun {};

TEST_F(SettingsOption, IsWhatSetWouldDoAndGoesBeforeIt) {
    write("coarse.json", write_settings({"error_bound=0.2", "penalty=add"}, "the knee"));
    const Json asked = stats({"rooms", "--set", "error_bound=0.2", "--set", "penalty=add"});
    const Json file = stats({"rooms", "--settings", "coarse.json"});
    EXPECT_EQ(file["state_hash"], asked["state_hash"]);
    EXPECT_NE(file["cells"], stats({"rooms"})["cells"]);
    // A preset goes before it, --method, --budget and --set behind it, whatever their order.
    write("more.json", write_settings({"seeds=hull", "method=layers", "budget=9"}, ""));
    const Json mixed = stats(
        {"rooms", "--set", "error_bound=0.3", "--settings", "more.json", "--preset", "prototype-2d", "--budget", "11"});
    const Json plain = stats({"rooms", "--preset", "prototype-2d", "--set", "seeds=hull", "--set", "method=layers",
                              "--set", "error_bound=0.3", "--set", "budget=11"});
    EXPECT_EQ(mixed["state_hash"], plain["state_hash"]);
    EXPECT_EQ(mixed["method"], "layers");
    EXPECT_EQ(mixed["rendered"], 11);
    // On top of a state file too.
    good({"rooms", "--do", "step 3; save s.json"});
    EXPECT_EQ(stats({"--state", "s.json", "--settings", "more.json"})["method"], "layers");
}

TEST_F(SettingsOption, RefusesWhatIsNone) {
    write("none.json", "{}");
    write("text.json", "error_bound=0.2");
    write("unknown.json", R"({"format": "sightline-settings", "version": 1, "settings": {"eror_bound": "0.2"}})");
    write("range.json", R"({"format": "sightline-settings", "version": 1, "settings": {"error_bound": 7}})");
    bad({"rooms", "--settings", "none.json", "--stats", "s.json"}, "none.json: format");
    bad({"rooms", "--settings", "text.json", "--stats", "s.json"}, "text.json: not JSON");
    bad({"rooms", "--settings", "unknown.json", "--stats", "s.json"}, "eror_bound");
    bad({"rooms", "--settings", "range.json", "--stats", "s.json"}, "error_bound");
    bad({"rooms", "--settings", "missing.json", "--stats", "s.json"}, "missing.json");
    bad({"rooms", "--settings"}, "--settings");
}

class SettingsOption3 : public Viewer2dRun {
protected:
    SettingsOption3() {
        program = "viewer3d";
        path = SIGHTLINE_VIEWER3D;
    }
};

TEST_F(SettingsOption3, IsTakenByTheViewerOfThreeDimensions) {
    write("coarse.json", write_settings({"error_bound=0.25", "method=layers"}, ""));
    good({"bottleneck", "--settings", "coarse.json", "--set", "reference_size=160x120", "--do", "save s.json"});
    const Json state = Json::parse(read("s.json"));
    EXPECT_EQ(state["settings"]["error_bound"], "0.25");
    EXPECT_EQ(state["settings"]["method"], "layers");
    bad({"bottleneck", "--settings", "missing.json", "--stats", "s2.json"}, "missing.json");
}

}  // namespace
}  // namespace sightline
