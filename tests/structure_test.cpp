// The rules of the design that no compiler checks: which layer includes which, licences, sizes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace sightline {
namespace {

namespace fs = std::filesystem;

struct Source {
    std::string path;  ///< from the root, e.g. core/space/tree.cpp
    std::vector<std::string> lines;
    std::vector<std::string> includes;  ///< what stands between the quotes or brackets
};

std::vector<std::string> includes_of(const std::vector<std::string>& lines) {
    static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"].*)");
    std::vector<std::string> found;
    std::smatch match;
    for (const std::string& line : lines)
        if (std::regex_match(line, match, include)) found.push_back(match[1]);
    return found;
}

std::vector<Source> read_sources() {
    std::vector<Source> all;
    const fs::path root = SIGHTLINE_SOURCE_DIR;
    for (const char* folder : {"core", "shell", "viewer2d", "viewer3d", "lab", "python", "web", "tests", "examples"}) {
        if (!fs::exists(root / folder)) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string ending = entry.path().extension().string();
            if (!entry.is_regular_file() || (ending != ".cpp" && ending != ".h")) continue;
            Source source{fs::relative(entry.path(), root).generic_string(), {}, {}};
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);) source.lines.push_back(line);
            source.includes = includes_of(source.lines);
            all.push_back(std::move(source));
        }
    }
    return all;
}

const std::vector<Source>& sources() {
    static const std::vector<Source> all = read_sources();
    return all;
}

bool in(const Source& source, std::string_view folder) { return source.path.starts_with(std::string(folder) + "/"); }
bool is_header(const Source& source) { return source.path.ends_with(".h"); }

/// Pairs of files are one unit: a header, and what stands behind it.
std::string unit(const std::string& path) { return path.substr(0, path.rfind('.')); }
std::string folder(const std::string& path) { return path.substr(0, path.rfind('/')); }

TEST(Structure, TheTestSeesTheSources) {
    EXPECT_GT(sources().size(), 100u);
    EXPECT_EQ(includes_of({"#include \"a/b.h\"", "  #  include <c>  // why", "// #include <d>", "include <e>"}),
              (std::vector<std::string>{"a/b.h", "c"}));
    for (const char* folder : {"core", "shell", "viewer2d", "tests"})
        EXPECT_TRUE(std::any_of(sources().begin(), sources().end(), [&](const Source& s) { return in(s, folder); }));
}

TEST(Structure, CoreKnowsNoWindow) {
    static const std::regex window("(SDL|GL/|GLES|glad|epoxy|imgui|ImGui|cairo|shell/|viewer|lab/|tests/).*");
    for (const Source& source : sources()) {
        if (!in(source, "core")) continue;
        for (const std::string& include : source.includes)
            EXPECT_FALSE(std::regex_match(include, window)) << source.path << " includes " << include;
    }
}

TEST(Structure, ProgramsAreNotIncludedFromBelow) {
    for (const Source& source : sources()) {
        if (!in(source, "shell")) continue;
        for (const std::string& include : source.includes)
            EXPECT_FALSE(include.starts_with("viewer") || include.starts_with("lab/") || include.starts_with("tests/"))
                << source.path << " includes " << include;
    }
}

TEST(Structure, CgalStaysBehindGeometryAndTheBuilders) {
    for (const Source& source : sources())
        for (const std::string& include : source.includes) {
            const bool allowed = in(source, "tests") || in(source, "web/tests") || source.path == "core/space/delaunay.cpp" ||
                                 source.path == "core/space/delaunay_3d.cpp" ||
                                 source.path == "core/geometry/rational.h" ||  // for .cpp files only
                                 (in(source, "core/geometry") && !is_header(source));
            EXPECT_TRUE(allowed || !include.starts_with("CGAL/")) << source.path << " includes " << include;
        }
}

TEST(Structure, AssimpStaysBehindTheReaders) {
    int seen = 0;
    for (const Source& source : sources())
        for (const std::string& include : source.includes) {
            if (!include.starts_with("assimp/")) continue;
            ++seen;
            EXPECT_TRUE((in(source, "core/scene/read") || in(source, "tests/benchmarks")) && !is_header(source))
                << source.path << " includes " << include;
        }
    EXPECT_GT(seen, 0);
}

TEST(Structure, JsonStaysOutOfHeaders) {
    // Four headers are for .cpp files only.
    const std::array<std::string, 4> inner{"core/base/json_input.h", "core/scene/read/parsed_scene.h",
                                           "core/scene/read/gltf_document.h", "core/session/embedded_scene.h"};
    const auto is_inner = [&](const std::string& path) {
        return std::find(inner.begin(), inner.end(), path) != inner.end();
    };
    for (const Source& source : sources()) {
        if (!is_header(source) || in(source, "tests") || is_inner(source.path)) continue;
        for (const std::string& include : source.includes)
            EXPECT_TRUE(!include.starts_with("nlohmann/") && !is_inner(include))
                << source.path << " includes " << include;
    }
}

TEST(Structure, ArrowsInCorePointDown) {
    constexpr std::array order{"base",       "process", "geometry", "scene",   "scene/make",
                               "scene/read", "space",   "raster",   "run",     "methods/cells",
                               "methods",    "truth",   "measure",  "session", "draw"};
    const auto rank = [&](const std::string& path) {  // core/FOLDER/…
        const std::size_t begin = path.find('/') + 1, end = path.rfind('/');
        std::string folder = path.substr(begin, end - begin);
        // Families know the cells that they share, and not each other; the table knows them all.
        if (folder.starts_with("methods/") && folder != "methods/cells") folder = "methods";
        const auto found = std::find(order.begin(), order.end(), folder);
        EXPECT_NE(found, order.end()) << path << " lies in a folder that the order does not name";
        return static_cast<int>(found - order.begin());
    };
    for (const Source& source : sources()) {
        if (!in(source, "core")) continue;
        for (const std::string& include : source.includes)
            if (include.starts_with("core/")) {
                EXPECT_LE(rank(include), rank(source.path)) << source.path << " includes " << include;
            }
    }
}

TEST(Structure, ArrowsInShellPointDown) {
    // Figures and GL stand side by side: neither knows the other. So do the start and the panes: what both viewers put
    // into the window, where it knows no dimension.
    const std::map<std::string, int> levels{{"figure", 0}, {"gl", 0},       {"lesson", 0}, {"desk", 1}, {"export", 2},
                                            {"panels", 3}, {"commands", 4}, {"window", 5}, {"pane", 6}, {"start", 6}};
    const auto level = [&](const std::string& path) {  // shell/FOLDER/FILE
        const auto found = levels.find(folder(path).substr(std::string("shell/").size()));
        EXPECT_NE(found, levels.end()) << path << " lies in a folder that the order does not name";
        return found == levels.end() ? -1 : found->second;
    };
    for (const Source& source : sources()) {
        if (!in(source, "shell")) continue;
        for (const std::string& include : source.includes)
            if (include.starts_with("shell/") && folder(include) != folder(source.path)) {
                EXPECT_LT(level(include), level(source.path)) << source.path << " includes " << include;
            }
    }
}

using Units = std::map<std::string, std::set<std::string>>;  ///< with what each includes

/// The units of a way that ends where it begins; empty when there is none.
std::vector<std::string> find_cycle(const Units& units) {
    std::set<std::string> done;
    std::vector<std::string> way;
    const std::function<bool(const std::string&)> closes = [&](const std::string& at) {
        if (const auto before = std::find(way.begin(), way.end(), at); before != way.end()) {
            way.erase(way.begin(), before);
            return true;
        }
        if (!done.insert(at).second) return false;
        way.push_back(at);
        if (const auto from = units.find(at); from != units.end())
            for (const std::string& next : from->second)
                if (closes(next)) return true;
        way.pop_back();
        return false;
    };
    for (const auto& [name, includes] : units)
        if (closes(name)) return way;
    return {};
}

TEST(Structure, NoArrowInsideAFolderOfTheShellRunsBackUp) {
    EXPECT_EQ(find_cycle({{"a", {"b", "c"}}, {"b", {"c"}}}), std::vector<std::string>());
    EXPECT_EQ(find_cycle({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b"}}}), (std::vector<std::string>{"b", "c"}));
    std::map<std::string, Units> folders;
    std::size_t arrows = 0;
    for (const Source& source : sources()) {
        if (!in(source, "shell")) continue;
        for (const std::string& include : source.includes)
            if (folder(include) == folder(source.path) && unit(include) != unit(source.path))
                arrows += folders[folder(source.path)][unit(source.path)].insert(unit(include)).second;
    }
    EXPECT_GT(arrows, 50u);
    for (const auto& [name, units] : folders) {
        std::string knot;
        for (const std::string& at : find_cycle(units)) knot += " -> " + at;
        EXPECT_EQ(knot, "") << name;
    }
    // The workbench stands above what it is made of, and the functions over it stand above the workbench.
    EXPECT_GT(folders["shell/desk"].at("shell/desk/workbench").size(), 5u);
}

TEST(Structure, OnlyTheWindowAndTheProgramsKnowImGuiAndOnlyTheyAndGlKnowSdlAndOpenGl) {
    // The tests drive the real window.
    static const std::regex widgets(".*imgui.*", std::regex::icase), screen("(SDL|GL/|GLES|glad|epoxy).*");
    int seen = 0;
    for (const Source& source : sources()) {
        if (in(source, "tests")) continue;
        const bool program = in(source, "viewer2d") || in(source, "viewer3d"),
                   window = in(source, "shell/window") || in(source, "shell/pane");
        for (const std::string& include : source.includes) {
            const bool widget = std::regex_match(include, widgets), drawn = std::regex_match(include, screen);
            seen += widget || drawn;
            EXPECT_TRUE(!widget || window || program) << source.path << " includes " << include;
            EXPECT_TRUE(!drawn || window || program || in(source, "shell/gl"))
                << source.path << " includes " << include;
        }
    }
    EXPECT_GT(seen, 5);
}

/// What stands in the unnamed namespaces of a file, or outside of them, as clang-format lays it out; aliases aside,
/// whose clashes do not compile.
std::set<std::string> names_of(const std::vector<std::string>& lines, bool unnamed) {
    static const std::regex type(R"(^(?:struct|class|enum class|enum) (\w+).*)");
    static const std::regex value(
        R"(^(?!using |namespace |template )\w[\w:<>,.&*()\[\] ]*?[ &*>](\w+)(?:\(| =|\{|;|\[).*)");
    std::set<std::string> names;
    bool hidden = false, text = false;  // a raw string, such as a shader
    std::smatch match;
    for (const std::string& line : lines) {
        if (text) {
            text = line.find(")\"") == std::string::npos;
            continue;
        }
        const std::size_t raw = line.find("R\"(");
        text = raw != std::string::npos && line.find(")\"", raw) == std::string::npos;
        if (line == "namespace {") hidden = true;
        if (line == "}  // namespace") hidden = false;
        if (hidden == unnamed && (std::regex_match(line, match, type) || std::regex_match(line, match, value)))
            names.insert(match[1]);
    }
    return names;
}

/// The names that a file's own headers declare, and the headers' headers.
void collect_declared(const std::vector<std::string>& includes, std::map<std::string, std::string>& declared,
                      std::set<std::string>& seen) {
    for (const std::string& include : includes)
        for (const Source& header : sources())
            if (header.path == include && seen.insert(include).second) {
                for (const std::string& name : names_of(header.lines, false)) declared.emplace(name, header.path);
                collect_declared(header.includes, declared, seen);
            }
}

TEST(Structure, SourcesThatAreCompiledTogetherHideDifferentNames) {
    const std::vector<std::string> lines{"namespace {",
                                         "struct A {",
                                         "    int b = 0;",
                                         "};",
                                         "double c(int d) {",
                                         "constexpr int e = 1;",
                                         "const std::vector<F>& g() { return h(1); }",
                                         "using J = int;",
                                         "void A::k() {",
                                         "template <int D>",
                                         "TEST(L, M) {",
                                         "}  // namespace",
                                         "int n(int o);"};
    EXPECT_EQ(names_of(lines, true), (std::set<std::string>{"A", "c", "e", "g"}));
    EXPECT_EQ(names_of(lines, false), std::set<std::string>{"n"});
    std::map<std::string, std::vector<const Source*>> together;  // a folder's twins of 3D are others
    for (const Source& source : sources()) {
        if (is_header(source) || in(source, "tests/benchmarks") || in(source, "tests/fuzz")) continue;
        const bool twin = source.path.ends_with("_3d.cpp") || source.path.ends_with("_3d_test.cpp");
        together[source.path.substr(0, source.path.rfind('/')) + (twin ? " 3D" : "")].push_back(&source);
    }
    for (const auto& [folder, all] : together) {
        std::map<std::string, std::string> taken;
        std::set<std::string> seen;
        for (const Source* source : all) collect_declared(source->includes, taken, seen);
        for (const Source* source : all)
            for (const std::string& name : names_of(source->lines, true)) {
                const auto [first, fresh] = taken.emplace(name, source->path);
                EXPECT_TRUE(fresh) << source->path << " hides " << name << ", which is a name of " << first->second;
            }
    }
}

TEST(Structure, EveryFileNamesItsLicence) {
    for (const Source& source : sources()) {
        const std::size_t top = std::min<std::size_t>(source.lines.size(), 20);
        EXPECT_TRUE(
            std::any_of(source.lines.begin(), source.lines.begin() + static_cast<std::ptrdiff_t>(top),
                        [](const std::string& line) { return line == "// SPDX-License-Identifier: GPL-3.0-or-later"; }))
            << source.path;
    }
}

TEST(Structure, FilesStayShortAndHeadersAreGuarded) {
    for (const Source& source : sources()) {
        EXPECT_LE(source.lines.size(), 500u) << source.path;
        if (!is_header(source)) continue;
        EXPECT_NE(std::find(source.lines.begin(), source.lines.end(), "#pragma once"), source.lines.end())
            << source.path;
    }
}

}  // namespace
}  // namespace sightline
