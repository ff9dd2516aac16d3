// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/mesh_text.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/scene/clean.h"
#include "core/scene/read/file_kind.h"

namespace sightline {

namespace {

constexpr std::string_view blanks = " \t\r\n\f\v";

/// The next word of the line, which loses it; empty at the end.
std::string_view next_word(std::string_view& line) {
    const std::size_t from = std::min(line.find_first_not_of(blanks), line.size());
    const std::size_t to = std::min(line.find_first_of(blanks, from), line.size());
    const std::string_view word = line.substr(from, to - from);
    line.remove_prefix(to);
    return word;
}

std::optional<double> number(std::string_view word) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return {};
    return value;
}

/// Calls `use(line)` for each line, its end included, until it returns false.
template <typename Use>
void each_line(const std::string& path, const Use& use) {
    std::ifstream file(path, std::ios::binary);
    std::string pending;
    std::vector<char> block(std::size_t{1} << 20);
    while (file) {
        file.read(block.data(), static_cast<std::streamsize>(block.size()));
        std::string_view fresh(block.data(), static_cast<std::size_t>(file.gcount()));
        for (std::size_t end; (end = fresh.find('\n')) != std::string_view::npos; fresh.remove_prefix(end + 1)) {
            if (!use(pending.empty() ? fresh.substr(0, end + 1) : std::string_view(pending.append(fresh, 0, end + 1))))
                return;
            pending.clear();
        }
        pending += fresh;
    }
    if (!pending.empty()) use(pending);
}

enum class Line { other, header, vertex, face };

/// Tells what the lines of a file hold; is fed with all of them in order.
class Layout {
public:
    explicit Layout(const std::string& ending) : ending_(ending), in_header_(is_counted()) {}

    bool is_counted() const { return ending_ == ".off" || ending_ == ".ply"; }

    /// `line` loses what stands before the numbers of a vertex.
    Line classify(std::string_view& line) {
        std::string_view rest = line;
        const std::string_view word = next_word(rest);
        if (!is_counted()) {
            if (word != (ending_ == ".obj" ? "v" : "vertex")) return Line::other;
            line = rest;
            return Line::vertex;
        }
        if (in_header_) {
            ending_ == ".off" ? off_header(line) : ply_header(word, rest);
            return Line::header;
        }
        if (word.empty() || (ending_ == ".off" && word[0] == '#')) return Line::other;
        ++seen_;
        return seen_ <= vertices_ ? Line::vertex : Line::face;
    }

    /// Whether the header is over and its vertices begin with x, y and z as text.
    bool is_clear() const { return clear_ && counts_known_ && !in_header_; }
    bool is_binary() const { return binary_; }
    bool is_empty() const { return is_counted() && counts_known_ && !in_header_ && (vertices_ == 0 || faces_ == 0); }
    /// Why `bytes` after the header are too few, or the lines so far.
    std::string why_too_short(std::uint64_t bytes) const {
        if (!is_counted()) return {};
        if (foreign_) return "line 1: is not \"ply\", so this is no PLY file";
        if (in_header_) return "its header does not end";
        const double least = binary_ ? least_bytes_ : vertices_ + faces_;
        if (least <= (binary_ ? static_cast<double>(bytes) : seen_)) return {};
        return "ends before the " + std::to_string(static_cast<std::uint64_t>(vertices_)) + " vertices and " +
               std::to_string(static_cast<std::uint64_t>(faces_)) + " faces that it announces";
    }

private:
    void off_header(std::string_view line) {
        std::string_view word = next_word(line);
        if (word == "OFF" || word == "COFF" || word == "NOFF") word = next_word(line);
        if (word.empty() || word[0] == '#') return;
        vertices_ = count(word);
        faces_ = count(next_word(line));
        in_header_ = false;
    }
    void ply_header(std::string_view word, std::string_view rest) {
        const std::string_view second = next_word(rest), third = next_word(rest), fourth = next_word(rest);
        if (header_lines_++ == 0) foreign_ = word != "ply" && word != "PLY";
        if (word == "format") binary_ = second != "ascii";
        if (word == "element") {
            ++elements_;
            if (elements_ == 1) clear_ = second == "vertex";
            of_this_element_ = count(third);
            (elements_ == 1 ? vertices_ : faces_) += of_this_element_;
        }
        if (word == "property") {
            const bool list = second == "list", face = list && next_word(rest).starts_with("vertex_ind");
            if (elements_ == 1 && columns_ < 3)
                clear_ = clear_ && third == std::string_view("xyz").substr(columns_++, 1);
            least_bytes_ +=
                of_this_element_ * (face ? size_of(third) + 3 * size_of(fourth) : size_of(list ? third : second));
        }
        if (word == "end_header") in_header_ = false;
    }
    double count(std::string_view word) {
        const std::optional<double> value = number(word);
        const bool sound = value && *value >= 0 && *value < 1e12;
        counts_known_ = counts_known_ && sound;
        return sound ? *value : 0;
    }
    /// Of a PLY type. A face has three corners at least; other lists may be empty.
    static double size_of(std::string_view type) {
        for (const std::string_view eight : {"double", "float64", "int64", "uint64"})
            if (type == eight) return 8;
        for (const std::string_view four : {"float", "float32", "int", "int32", "uint", "uint32"})
            if (type == four) return 4;
        return type.find("16") != type.npos || type.find("short") != type.npos ? 2 : 1;
    }

    std::string ending_;
    bool in_header_, clear_ = true, counts_known_ = true, binary_ = false, foreign_ = false;
    double vertices_ = 0, faces_ = 0, seen_ = 0, of_this_element_ = 0, least_bytes_ = 0;
    std::size_t header_lines_ = 0, elements_ = 0, columns_ = 0;
};

/// The three coordinates that `line` begins with, which it loses.
std::optional<Vec<3>> take_point(std::string_view& line) {
    Vec<3> point;
    for (int i = 0; i < 3; ++i) {
        const std::optional<double> value = number(next_word(line));
        if (!value) return {};
        point[i] = *value;
    }
    return point;
}

/// Whether OBJ's optional fourth number divides the others.
bool is_homogeneous(std::string_view rest) {
    const std::string_view fourth = next_word(rest);
    return !fourth.empty() && next_word(rest).empty() && number(fourth) != 1.0;
}

/// Where most of a heap of points lies: a sample of at most 8192, evenly spread over those that were added.
class Whereabouts {
public:
    void add(const Vec<3>& point) {
        if (seen_++ % every_ != 0) return;
        sample_.push_back(point);
        if (sample_.size() < 8192) return;
        for (std::size_t i = 0; i < sample_.size() / 2; ++i) sample_[i] = sample_[2 * i];
        sample_.resize(sample_.size() / 2);
        every_ *= 2;
    }
    /// As origin_for() of a box, without the tenth of the points that lies farthest off on either side.
    Vec<3> origin() {
        Vec<3> middle(0);
        double width = 0;
        for (int i = 0; i < 3 && !sample_.empty(); ++i) {
            std::sort(sample_.begin(), sample_.end(), [i](const Vec<3>& a, const Vec<3>& b) { return a[i] < b[i]; });
            const double low = sample_[sample_.size() / 10][i],
                         high = sample_[sample_.size() - 1 - sample_.size() / 10][i];
            middle[i] = low / 2 + high / 2;
            width = std::max(width, high - low);
        }
        for (int i = 0; i < 3; ++i) middle[i] = origin_for(middle[i], width);
        return middle;
    }

private:
    std::vector<Vec<3>> sample_;
    std::uint64_t seen_ = 0, every_ = 1;
};

std::string moved_text(const std::string& path, const std::string& ending, const Vec<3>& shift, std::uint64_t size) {
    std::string text;
    text.reserve(size + size / 8);
    Layout layout(ending);
    each_line(path, [&](std::string_view whole) {
        std::string_view line = whole;
        std::optional<Vec<3>> point;
        if (layout.classify(line) == Line::vertex) {
            text += whole.substr(0, whole.size() - line.size());
            point = take_point(line);
        }
        for (int i = 0; point && i < 3; ++i) {
            char digits[40];
            const auto [end, error] =
                std::to_chars(digits, digits + sizeof digits, static_cast<float>((*point)[i] - shift[i]));
            (text += ' ').append(digits, end);
        }
        text += point ? line : whole;
        return true;
    });
    return text;
}

}  // namespace

MeshText prepare_mesh_text(const std::string& path) {
    const std::string ending = ending_of(path);
    if (ending != ".obj" && ending != ".off" && ending != ".ply" && ending != ".stl") return {};

    Layout layout(ending);
    Whereabouts places;
    bool clear = true;
    std::uint64_t size = 0, header = 0;
    each_line(path, [&](std::string_view line) {
        size += line.size();
        const Line kind = layout.classify(line);
        if (kind == Line::header) header = size;
        if (kind == Line::header && layout.is_binary()) return true;
        if (layout.is_binary()) return false;
        if (kind != Line::vertex || !clear) return true;
        const std::optional<Vec<3>> point = take_point(line);
        clear = point && !(ending == ".obj" && is_homogeneous(line));
        if (point && is_finite(*point)) places.add(*point);
        return true;
    });
    std::error_code no_error;
    const std::uint64_t bytes = std::filesystem::file_size(path, no_error);
    MeshText result;
    result.error = layout.why_too_short(bytes - header);
    result.empty = layout.is_empty();
    if (!result.error.empty() || layout.is_binary() || !clear || (layout.is_counted() && !layout.is_clear()))
        return result;
    result.shift = places.origin();
    if (result.shift != Vec<3>(0)) result.text = moved_text(path, ending, result.shift, size);
    return result;
}

std::string why_no_obj(const std::string& path) {
    constexpr std::string_view known[] = {"v", "vt", "vn", "vp", "f", "l", "p", "o", "g", "s", "mtllib", "usemtl"};
    std::size_t lines = 0;
    std::string why;
    each_line(path, [&](std::string_view line) {
        ++lines;
        const std::string_view word = next_word(line);
        if (word.empty() || word[0] == '#' || std::find(std::begin(known), std::end(known), word) != std::end(known))
            return true;
        why = "line " + std::to_string(lines) + ": \"" + one_line(word, 40) + "\" begins no line of an OBJ file";
        return false;
    });
    return why;
}

}  // namespace sightline
