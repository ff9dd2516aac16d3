// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/read_stl.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/base/text.h"
#include "core/scene/read/cut_polygon.h"

namespace sightline {

namespace {

constexpr std::size_t stl_head = 84, stl_facet = 50;

std::uint32_t stl_number(const char* bytes) {
    std::uint32_t value = 0;
    for (int i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
}

std::size_t stl_bytes(std::string_view file) { return stl_head + stl_facet * std::size_t{stl_number(&file[80])}; }

bool is_stl_text(std::string_view file) {
    std::string_view rest = file;
    if (in_small_letters(next_word(rest)) != "solid") return false;
    if (file.size() >= stl_head && file.size() == stl_bytes(file)) return false;
    if (const std::size_t line = rest.find_first_of("\r\n"); line != rest.npos) {
        std::string_view after = rest.substr(line);
        const std::string word = in_small_letters(next_word(after));
        if (word == "facet" || word == "endsolid" || word.empty()) return true;
    }
    for (std::string_view word; !(word = next_word(rest)).empty();)  // all on one line, or an unfinished text
        if (std::any_of(word.begin(), word.end(), [](unsigned char c) { return c < 0x20; })) return false;
    return true;
}

ParsedMesh read_binary_stl(std::string_view file, const ShareDone& progress) {
    const std::string_view head = file.substr(0, stl_head);
    const bool words =
        std::all_of(head.begin(), head.end(), [](char c) { return is_blank(c) || (c >= ' ' && c <= '~'); });
    if (file.size() < stl_head || words)
        throw InputError("is no STL file: neither \"solid\" nor a binary header begins it");
    const std::uint32_t count = stl_number(&file[80]);
    if (file.size() < stl_bytes(file))
        throw InputError("ends before the " + counted(count, "facet") + " that it announces");
    check_memory(count, 0);
    ParsedMesh mesh;
    mesh.single_precision = true;
    mesh.triangles.resize(count);
    const char* at = file.data() + stl_head;
    for (std::uint32_t i = 0; i < count; ++i, at += stl_facet) {
        if (i % 65536 == 0 && progress) progress(static_cast<double>(i) / count);
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t axis = 0; axis < 3; ++axis)
                mesh.triangles[i][c][static_cast<int>(axis)] =
                    std::bit_cast<float>(stl_number(at + 12 * (c + 1) + 4 * axis));
    }
    const std::size_t tail = file.size() - stl_bytes(file);
    if (tail >= stl_facet) {
        const std::string after =
            std::to_string(tail) + " bytes follow the " + counted(count, "facet") + " that it announces";
        if (count == 0) throw InputError(after);
        mesh.warnings.push_back(after);
    }
    return mesh;
}

class StlText {
public:
    StlText(std::string_view file, const ShareDone& progress)
        : file_(file), progress_(progress), cutter_(file.size()) {}

    ParsedMesh read() {
        // A facet has three corners and some words: counted before anything is taken.
        std::uint64_t corners = 0;
        for (std::string_view rest = file_, word; !(word = next_word(rest)).empty();)
            corners += word.size() == 6 && in_small_letters(word) == "vertex";
        check_memory(corners / 3, 0);
        mesh_.triangles.reserve(corners / 3);
        while (read_solid()) {
        }
        if (mesh_.objects.names.size() < 2) mesh_.objects = {};
        return std::move(mesh_);
    }

private:
    std::size_t at() const { return file_.size() - rest_.size(); }
    InputError error(const std::string& reason) const { return error_at(file_, at(), reason); }
    std::string next() { return in_small_letters(next_word(rest_)); }
    [[noreturn]] void refuse(const std::string& word) const {
        throw word.empty() ? InputError("ends in the middle of a facet")
                           : error("\"" + one_line(word, 40) + "\" is out of place in an STL file");
    }
    void expect(std::string_view wanted) {
        if (const std::string word = next(); word != wanted) refuse(word);
    }
    std::string_view rest_of_line() {
        const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return line;
    }

    bool read_solid() {
        const std::string word = next();
        if (word.empty()) return false;
        if (word != "solid") refuse(word);
        // The name ends with the line, or, where all stands on one line, before its first facet.
        std::string_view line = rest_of_line(), before = line;
        while (!before.empty()) {
            std::string_view from = before;
            const std::string part = in_small_letters(next_word(before));
            if (part != "facet" && part != "endsolid") continue;
            if (before.empty()) break;  // a name
            rest_ = file_.substr(static_cast<std::size_t>(from.data() - file_.data()));
            line = line.substr(0, static_cast<std::size_t>(from.data() - line.data()));
            break;
        }
        while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
        while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
        mesh_.objects.names.emplace_back(line);
        for (std::string inner = next(); inner != "endsolid"; inner = next()) {
            if (inner.empty()) {
                mesh_.warnings.push_back("ends before \"endsolid\": facets may be missing");
                return false;
            }
            if (inner != "facet") refuse(inner);
            read_facet();
        }
        rest_of_line();
        return true;
    }

    void read_facet() {
        std::string word = next();
        if (word == "normal")
            for (int i = 0; i < 4 && (i == 0 || word != "outer"); ++i) word = next();
        if (word != "outer") refuse(word);
        expect("loop");
        corners_.clear();
        for (word = next(); word == "vertex"; word = next()) {
            Vec<3>& corner = corners_.emplace_back();
            for (int axis = 0; axis < 3; ++axis) {
                const std::string_view number = next_word(rest_);
                const std::optional<double> value = number_in_file(number);
                if (!value) throw error("\"" + one_line(number, 40) + "\" is no number");
                corner[axis] = *value;
            }
        }
        if (word != "endloop") refuse(word);
        expect("endfacet");
        if (corners_.size() < 3) throw error("a facet has " + counted(corners_.size(), "corner"));
        if (!cutter_.cut(corners_, mesh_.triangles)) throw error("a facet takes too long to be cut into triangles");
        mesh_.objects.of.resize(mesh_.triangles.size(), static_cast<std::uint32_t>(mesh_.objects.names.size() - 1));
        if (++facets_ % 16384 == 0 && progress_)
            progress_(static_cast<double>(at()) / static_cast<double>(file_.size()));
    }

    std::string_view file_, rest_ = file_;
    const ShareDone& progress_;
    PolygonCutter cutter_;
    ParsedMesh mesh_;
    std::vector<Vec<3>> corners_;
    std::size_t facets_ = 0;
};

}  // namespace

ParsedMesh read_stl(std::string_view bytes, const ShareDone& progress) {
    bytes = without_mark(bytes);
    return is_stl_text(bytes) ? StlText(bytes, progress).read() : read_binary_stl(bytes, progress);
}

}  // namespace sightline
