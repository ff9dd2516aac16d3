// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/read_off.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/scene/read/cut_polygon.h"

namespace sightline {

namespace {

class OffReader {
public:
    OffReader(std::string_view file, const ShareDone& progress)
        : file_(file), progress_(progress), cutter_(file.size()) {}

    ParsedMesh read() {
        read_header();
        // Vertices take at least three numbers and a blank each, faces two.
        const std::uint64_t left = file_.size() - at_ + 2;
        if (vertices_ > left / 6 || faces_ > left / 2 || 6 * vertices_ + 2 * faces_ > left) throw too_short();
        has_rows_ = count_rows() >= vertices_ + faces_;
        check_memory(0, vertices_);
        points_.reserve(vertices_);
        for (std::uint64_t i = 0; i < vertices_; ++i) read_vertex();
        const std::uint64_t triangles = count_triangles();
        check_memory(triangles, vertices_);
        mesh_.triangles.reserve(triangles);
        for (std::uint64_t i = 0; i < faces_; ++i) read_face(i);
        if (short_faces_ > 0)
            mesh_.warnings.push_back(counted(short_faces_, "face") + " of fewer than 3 corners " +
                                     (short_faces_ == 1 ? "is" : "are") + " left out");
        return std::move(mesh_);
    }

private:
    InputError error(const std::string& reason) const { return error_at(file_, word_at_, reason); }
    InputError too_short() const {
        return InputError("ends before the " + std::to_string(vertices_) + " vertices and " + std::to_string(faces_) +
                          " faces that it announces");
    }
    void skip_line() { at_ = std::min(file_.find_first_of("\r\n", at_), file_.size()); }
    /// Empty at the end.
    std::string_view next() {
        for (;;) {
            while (at_ < file_.size() && is_blank(file_[at_])) ++at_;
            if (at_ == file_.size() || file_[at_] != '#') break;
            skip_line();
        }
        word_at_ = at_;
        while (at_ < file_.size() && !is_blank(file_[at_]) && file_[at_] != '#') ++at_;
        return file_.substr(word_at_, at_ - word_at_);
    }
    /// Whether a number follows on this line.
    bool goes_on() const {
        std::size_t at = at_;
        while (at < file_.size() && (file_[at] == ' ' || file_[at] == '\t')) ++at;
        return at < file_.size() && !is_blank(file_[at]) && file_[at] != '#';
    }
    double take() {
        const std::string_view word = next();
        if (word.empty()) throw too_short();
        const std::optional<double> value = number_in_file(word);
        if (!value) throw error("\"" + one_line(word, 40) + "\" is no number");
        return *value;
    }
    std::uint64_t take_count() {
        const std::string_view word = next();
        const std::optional<double> value = number_in_file(word);
        if (!value || !(*value >= 0 && *value < 1e12) || *value != std::floor(*value))
            throw error("\"" + one_line(word, 40) + "\" is no number of vertices, faces or corners");
        return static_cast<std::uint64_t>(*value);
    }

    void read_header() {
        std::string keyword = in_small_letters(next());
        if (!keyword.ends_with("off")) {
            if (!number_in_file(keyword)) throw error("begins with neither OFF nor a number of vertices");
            at_ = word_at_;
        } else {
            keyword.resize(keyword.size() - 3);
            if (keyword.starts_with("st")) keyword.erase(0, 2), passed_ += 2;
            if (keyword.starts_with('c')) keyword.erase(0, 1), passed_ += 4;
            if (keyword.starts_with('n')) keyword.erase(0, 1), passed_ += 3;
            if (!keyword.empty()) throw error("OFF with other than three coordinates a vertex is not read");
            const std::size_t after = at_;
            if (in_small_letters(next()) == "binary") throw error("binary OFF is not read");
            at_ = after;
        }
        vertices_ = take_count();
        const bool one_line = goes_on();
        faces_ = take_count();
        // The number of edges; some leave it out at the end of the line.
        if (!one_line || goes_on()) take_count();
        skip_comment();
    }
    void skip_comment() {
        if (!goes_on() && at_ < file_.size() && !is_blank(file_[at_])) skip_line();
    }

    /// Lines that hold something.
    std::uint64_t count_rows() {
        const std::size_t begin = at_;
        std::uint64_t rows = 0;
        for (; !next().empty(); ++rows) skip_line();
        at_ = begin;
        return rows;
    }
    void end_row() {
        if (has_rows_) skip_line();
        tell();
    }
    void tell() {
        if (++told_ % 65536 == 0 && progress_) progress_(static_cast<double>(at_) / static_cast<double>(file_.size()));
    }

    void read_vertex() {
        Vec<3>& point = points_.emplace_back();
        for (int axis = 0; axis < 3; ++axis) point[axis] = take();
        for (int i = 0; i < passed_ && !has_rows_; ++i) take();
        end_row();
    }
    std::uint64_t count_triangles() {
        const std::size_t begin = at_;
        std::uint64_t triangles = 0;
        for (std::uint64_t i = 0; i < faces_; ++i) {
            const std::uint64_t corners = take_count();
            if (corners > file_.size() - at_) throw too_short();
            triangles += std::max<std::uint64_t>(corners, 2) - 2;
            for (std::uint64_t c = 0; c < corners; ++c)
                if (next().empty()) throw too_short();
            if (has_rows_) skip_line();
        }
        at_ = begin;
        return triangles;
    }
    void read_face(std::uint64_t face) {
        const std::uint64_t corners = take_count();
        corners_.clear();
        for (std::uint64_t i = 0; i < corners; ++i) {
            const double index = take();
            if (!(index >= 0 && index < static_cast<double>(vertices_)) || index != std::floor(index))
                throw error("face " + std::to_string(face) + " refers to vertex " +
                            one_line(file_.substr(word_at_, at_ - word_at_), 30) + " of " + std::to_string(vertices_));
            corners_.push_back(points_[static_cast<std::size_t>(index)]);
        }
        short_faces_ += corners < 3;
        if (!cutter_.cut(corners_, mesh_.triangles))
            throw error("a face of " + std::to_string(corners) + " corners takes too long to be cut");
        end_row();
    }

    std::string_view file_;
    const ShareDone& progress_;
    PolygonCutter cutter_;
    std::size_t at_ = 0, word_at_ = 0, told_ = 0, short_faces_ = 0;
    std::uint64_t vertices_ = 0, faces_ = 0;
    int passed_ = 0;         ///< numbers behind those of a vertex
    bool has_rows_ = false;  ///< each vertex and face stands on a line of its own
    ParsedMesh mesh_;
    std::vector<Vec<3>> points_, corners_;
};

}  // namespace

ParsedMesh read_off(std::string_view bytes, const ShareDone& progress) {
    return OffReader(without_mark(bytes), progress).read();
}

}  // namespace sightline
