// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/read_obj.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <deque>
#include <unordered_map>

#include "core/base/index.h"
#include "core/base/text.h"
#include "core/scene/read/cut_polygon.h"

namespace sightline {

namespace {

constexpr std::string_view passed_over[] = {"v",   "f",      "fo",     "vt",       "vn",       "vp",       "l",
                                            "p",   "o",      "g",      "s",        "mg",       "mtllib",   "usemtl",
                                            "lod", "usemap", "maplib", "bevel",    "c_interp", "d_interp", "shadow_obj",
                                            "",    "ctech",  "stech",  "trace_obj"};
constexpr std::string_view free_form[] = {"cstype", "deg",  "bmat", "step", "curv", "curv2", "surf",
                                          "parm",   "trim", "hole", "scrv", "sp",   "end",   "con",
                                          "bsp",    "bzp",  "cdc",  "cdp",  "res"};

template <std::size_t N>
bool is_one_of(const std::string_view (&words)[N], std::string_view word) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

/// The lines of an OBJ file, those joined that a backslash continues.
class ObjLines {
public:
    explicit ObjLines(std::string_view text)
        : text_(text), end_(text.find('\n') == text.npos && text.find('\r') != text.npos ? '\r' : '\n') {}

    bool next(std::string_view& line) {
        at_ = next_;
        if (next_ >= text_.size()) return false;
        line = one();
        is_joined_ = false;
        if (!continues(line)) return true;
        joined_.clear();
        is_joined_ = true;
        for (bool more = true; more;) {
            more = continues(line);
            joined_ += more ? line.substr(0, line.rfind('\\')) : line;
            joined_ += ' ';
            if (more) line = next_ < text_.size() ? one() : std::string_view();
        }
        line = joined_;
        return true;
    }
    std::size_t at() const { return at_; }
    bool is_joined() const { return is_joined_; }  ///< the line is not part of the text

private:
    std::string_view one() {
        const auto* const found =
            static_cast<const char*>(std::memchr(text_.data() + next_, end_, text_.size() - next_));
        const std::size_t end = found ? static_cast<std::size_t>(found - text_.data()) : text_.size();
        const std::string_view line = text_.substr(next_, end - next_);
        next_ = end + 1;
        return line;
    }
    /// Comments do not go on.
    static bool continues(std::string_view line) {
        while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
        if (!line.ends_with('\\')) return false;
        std::string_view rest = line;
        if (next_word(rest).starts_with('#')) return false;
        return line.find(" #") == line.npos && line.find("\t#") == line.npos;
    }

    std::string_view text_;
    char end_;
    std::size_t at_ = 0, next_ = 0;
    bool is_joined_ = false;
    std::string joined_;
};

/// The next word that is no comment.
std::string_view next_obj_word(std::string_view& line) {
    const std::string_view word = next_word(line);
    if (!word.starts_with('#')) return word;
    line = {};
    return {};
}

/// `corner#comment`: a word may end where a comment begins.
std::string_view before_comment(std::string_view word) { return word.substr(0, word.find('#')); }

class ObjReader {
public:
    ObjReader(std::string_view text, const ShareDone& progress)
        : text_(text), progress_(progress), cutter_(text.size()) {}

    ParsedMesh read() {
        count();
        read_vertices();
        read_faces();
        return std::move(mesh_);
    }

private:
    InputError error(const ObjLines& lines, const std::string& reason) const {
        return error_at(text_, lines.at(), reason);
    }
    /// Share `from` to `to` of the work is this pass.
    void tell(const ObjLines& lines, double from, double to) {
        if (++told_ % 65536 != 0 || !progress_) return;
        progress_(from + (to - from) * static_cast<double>(lines.at()) / static_cast<double>(text_.size()));
    }
    static std::string times(std::size_t lines) {
        return lines > 1 ? "; " + std::to_string(lines) + " such lines are left out" : "; it is left out";
    }

    void count() {
        ObjLines lines(text_);
        std::uint64_t triangles = 0;
        std::size_t short_faces = 0, first_short = 0, surfaces = 0, first_surface = 0, strange = 0, first_strange = 0;
        std::string_view surface;
        for (std::string_view line; lines.next(line); tell(lines, 0, 0.2)) {
            const std::string_view word = next_obj_word(line);
            if (word == "v") {
                ++vertices_;
            } else if (word == "f" || word == "fo") {
                std::uint64_t corners = 0;
                for (std::string_view corner; !(corner = next_obj_word(line)).empty(); ++corners)
                    if (corner.find('#') != corner.npos) line = {};
                if (corners >= 3) triangles += corners - 2;
                if (corners < 3 && short_faces++ == 0) first_short = lines.at();
            } else if (word == "o") {
                has_objects_ = true;
            } else if (word == "g") {
                has_groups_ = true;
            } else if (is_one_of(free_form, word)) {
                if (surfaces++ == 0)
                    first_surface = lines.at(), surface = *std::find(std::begin(free_form), std::end(free_form), word);
            } else if (!is_one_of(passed_over, word)) {
                if (strange++ == 0) first_strange = lines.at(), stranger_ = one_line(word, 40);
            }
        }
        const std::string curved = "free-form curves and surfaces (" + std::string(surface) + ") are not read";
        const std::string begins = "\"" + stranger_ + "\" begins no line of an OBJ file";
        if (triangles == 0 && strange > 0) throw error_at(text_, first_strange, begins);
        if (triangles == 0 && surfaces > 0) throw error_at(text_, first_surface, curved + ", and it holds no faces");
        const auto warn = [&](std::size_t at, const std::string& words) {
            mesh_.warnings.push_back(error_at(text_, at, words).what());
        };
        if (surfaces > 0) warn(first_surface, curved);
        if (strange > 0) warn(first_strange, begins + times(strange));
        if (short_faces > 0) warn(first_short, "a face has fewer than 3 corners" + times(short_faces));
        check_memory(triangles, vertices_);
        mesh_.triangles.reserve(triangles);
        if (has_objects_ || has_groups_) mesh_.objects.of.reserve(triangles);
    }

    void read_vertices() {
        points_.reserve(vertices_);
        ObjLines lines(text_);
        for (std::string_view line; lines.next(line); tell(lines, 0.2, 0.6))
            if (next_obj_word(line) == "v") points_.push_back(vertex(lines, line));
    }

    Vec<3> vertex(const ObjLines& lines, std::string_view line) const {
        std::array<double, 4> numbers{0, 0, 0, 1};
        std::size_t count = 0;
        for (std::string_view word; !(word = next_obj_word(line)).empty(); ++count) {
            std::optional<double> value = number_in_file(word);
            if (!value && word.find('#') != word.npos) {  // not one of 1.#QNAN
                value = number_in_file(before_comment(word));
                line = {};
            }
            if (!value) throw error(lines, "\"" + one_line(word, 40) + "\" is no number");
            if (count < 4) numbers[count] = *value;
        }
        if (count < 3) throw error(lines, "a vertex needs three numbers");
        const Vec<3> point(numbers[0], numbers[1], numbers[2]);
        return count == 4 && numbers[3] != 1 ? point / numbers[3] : point;
    }

    void read_faces() {
        ObjLines lines(text_);
        std::size_t before = 0;  // vertices that stand before the line
        for (std::string_view line; lines.next(line); tell(lines, 0.6, 1)) {
            const std::string_view word = next_obj_word(line);
            if (word == "v")
                ++before;
            else if (word == "f" || word == "fo")
                read_face(lines, line, before);
            else if (word == (has_objects_ ? "o" : "g"))
                object_ = object(line, lines.is_joined());
        }
    }

    void read_face(const ObjLines& lines, std::string_view line, std::size_t before) {
        corners_.clear();
        for (std::string_view word; !(word = next_obj_word(line)).empty();) {
            if (word.find('#') != word.npos) line = {};
            corners_.push_back(points_[corner(lines, before_comment(word), before)]);
        }
        if (!cutter_.cut(corners_, mesh_.triangles))
            throw error(lines, "a face of " + std::to_string(corners_.size()) + " corners takes too long to be cut");
        if (!has_objects_ && !has_groups_) return;
        if (object_ == none) object_ = object({}, false);
        mesh_.objects.of.resize(mesh_.triangles.size(), object_);
    }

    /// The vertex that "3", "3/1/2" or "-1//5" names.
    std::size_t corner(const ObjLines& lines, std::string_view word, std::size_t before) const {
        long long number = 0;
        const auto [end, wrong] = std::from_chars(word.data(), word.data() + word.size(), number);
        const bool whole = wrong != std::errc::invalid_argument && (end == word.data() + word.size() || *end == '/');
        if (!whole ||
            word.substr(static_cast<std::size_t>(end - word.data())).find_first_not_of("/-0123456789") != word.npos)
            throw error(lines, "\"" + one_line(word, 40) + "\" is no corner of a face");
        const auto there = static_cast<long long>(number < 0 ? before : points_.size());
        if (wrong != std::errc() || number == 0 || number > there || number < -there)
            throw error(lines, "a face refers to vertex " + one_line(word.substr(0, word.find('/')), 30) + " of " +
                                   std::to_string(there));
        return static_cast<std::size_t>(number < 0 ? there + number : number - 1);
    }

    /// Of this name, which `line` holds.
    std::uint32_t object(std::string_view line, bool joined) {
        while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
        while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
        if (line.empty() && !has_objects_) line = "default";  // the format's name for it
        if (joined) line = kept_.emplace_back(line);
        const auto [at, fresh] = objects_.try_emplace(line, static_cast<std::uint32_t>(mesh_.objects.names.size()));
        if (fresh) mesh_.objects.names.emplace_back(line);
        return at->second;
    }

    std::string_view text_;
    const ShareDone& progress_;
    ParsedMesh mesh_;
    std::size_t vertices_ = 0, told_ = 0;
    bool has_objects_ = false, has_groups_ = false;
    std::string stranger_;
    std::vector<Vec<3>> points_, corners_;
    PolygonCutter cutter_;
    std::uint32_t object_ = none;
    std::deque<std::string> kept_;
    std::unordered_map<std::string_view, std::uint32_t> objects_;
};

}  // namespace

ParsedMesh read_obj(std::string_view bytes, const ShareDone& progress) {
    return ObjReader(without_mark(bytes), progress).read();
}

}  // namespace sightline
