// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/read_ply.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/scene/read/cut_polygon.h"
#include "core/scene/read/ply_header.h"

namespace sightline {

namespace {

/// The file ends too early.
struct PlyEnds {};

/// Values as words; a line for each row of an element, but values may stand on more lines than one.
class PlyText {
public:
    PlyText(std::string_view file, std::size_t at) : file_(file), at_(at) {}

    double take(PlyType) {
        const std::string_view word = next();
        const std::optional<double> value = number_in_file(word);
        if (!value) throw error("\"" + one_line(word, 40) + "\" is no number");
        return *value;
    }
    void skip(PlyType, std::uint64_t values) {
        for (; values > 0; --values) next();
    }
    void end_row() {
        const std::size_t end = std::min(file_.find_first_of(std::string_view("\r\n"), at_), file_.size());
        if (std::string_view rest = file_.substr(at_, end - at_); extra_ == 0 && !next_word(rest).empty()) extra_ = at_;
        at_ = end;
    }
    /// So many values need that much at least.
    std::uint64_t bytes(std::uint64_t values, PlyType) const { return 2 * values - (values > 0); }
    std::uint64_t left() const { return file_.size() - at_; }
    std::size_t at() const { return at_; }
    void go_to(std::size_t at) { at_ = at; }
    InputError error(const std::string& reason) const { return error_at(file_, at_, reason); }
    std::string warning() const {
        return extra_ == 0 ? "" : error_at(file_, extra_, "holds more values than the header announces").what();
    }

private:
    std::string_view next() {
        while (at_ < file_.size() && is_blank(file_[at_])) ++at_;
        const std::size_t from = at_;
        while (at_ < file_.size() && !is_blank(file_[at_])) ++at_;
        if (from == at_) throw PlyEnds();
        return file_.substr(from, at_ - from);
    }
    std::string_view file_;
    std::size_t at_, extra_ = 0;
};

template <bool big_endian>
class PlyBinary {
public:
    PlyBinary(std::string_view file, std::size_t at) : file_(file), at_(at) {}

    double take(PlyType type) {
        switch (type) {
            case PlyType::int8:
                return value<std::int8_t>();
            case PlyType::uint8:
                return value<std::uint8_t>();
            case PlyType::int16:
                return value<std::int16_t>();
            case PlyType::uint16:
                return value<std::uint16_t>();
            case PlyType::int32:
                return value<std::int32_t>();
            case PlyType::uint32:
                return value<std::uint32_t>();
            case PlyType::int64:
                return static_cast<double>(value<std::int64_t>());
            case PlyType::uint64:
                return static_cast<double>(value<std::uint64_t>());
            case PlyType::float32:
                return value<float>();
            default:
                return value<double>();
        }
    }
    void skip(PlyType type, std::uint64_t values) {
        if (values > left() / bytes_of_type(type)) throw PlyEnds();
        at_ += values * bytes_of_type(type);
    }
    void end_row() {}
    std::uint64_t bytes(std::uint64_t values, PlyType type) const { return values * bytes_of_type(type); }
    std::uint64_t left() const { return file_.size() - at_; }
    std::size_t at() const { return at_; }
    void go_to(std::size_t at) { at_ = at; }
    InputError error(const std::string& reason) const { return InputError(reason); }
    std::string warning() const { return {}; }

private:
    template <typename T>
    T value() {
        if (left() < sizeof(T)) throw PlyEnds();
        char bytes[sizeof(T)];
        std::memcpy(bytes, file_.data() + at_, sizeof(T));
        if (big_endian) std::reverse(bytes, bytes + sizeof(T));
        at_ += sizeof(T);
        T result;
        std::memcpy(&result, bytes, sizeof(T));
        return result;
    }
    std::string_view file_;
    std::size_t at_;
};

bool is_read(const PlyElement& element) { return element.name == "face" || element.name == "tristrips"; }

/// "ends before the 8 vertices and 12 faces that it announces"
InputError too_short(const PlyHeader& header) {
    std::string what;
    for (const PlyElement& element : header.elements) {
        if (element.count == 0 || (element.name != "vertex" && !is_read(element))) continue;
        what += (what.empty() ? "" : " and ") + std::to_string(element.count) + " ";
        what += element.name == "vertex" ? "vertices" : element.name == "face" ? "faces" : "triangle strips";
    }
    return InputError("ends before the " + (what.empty() ? "elements" : what) + " that it announces");
}

/// Reads what the header announces from `Values`, of one of the formats.
template <typename Values>
class PlyReader {
public:
    PlyReader(std::string_view file, const PlyHeader& header, const ShareDone& progress)
        : file_(file), header_(header), progress_(progress), values_(file, header.bytes), cutter_(file.size()) {}

    ParsedMesh read() {
        check();
        try {
            std::vector<std::size_t> begin;
            std::uint64_t triangles = 0;
            for (const PlyElement& element : header_.elements) {
                begin.push_back(values_.at());
                if (element.name == "vertex" && is_used_)
                    read_vertices(element);
                else if (is_read(element))
                    triangles += count_triangles(element);
                else if (&element != &header_.elements.back())
                    skip(element);
            }
            check_memory(triangles, points_.size());
            mesh_.triangles.reserve(triangles);
            for (std::size_t i = 0; i < begin.size(); ++i) {
                values_.go_to(begin[i]);
                if (is_read(header_.elements[i])) make_triangles(header_.elements[i]);
            }
        } catch (const PlyEnds&) {
            throw too_short(header_);
        }
        if (short_faces_ > 0)
            mesh_.warnings.push_back(counted(short_faces_, "face") + " of fewer than 3 corners " +
                                     (short_faces_ == 1 ? "is" : "are") + " left out");
        if (const std::string warning = values_.warning(); !warning.empty()) mesh_.warnings.push_back(warning);
        return std::move(mesh_);
    }

private:
    /// Refuses what the header alone shows to be wrong.
    void check() {
        std::uint64_t least = 0;
        for (const PlyElement& element : header_.elements) {
            std::uint64_t row = 0;
            for (const PlyProperty& property : element.properties) {
                row += values_.bytes(1, property.is_list ? property.counts : property.type);
            }
            if (row > 0 && element.count > (values_.left() - least) / row) throw too_short(header_);
            least += element.count * row;
            if (element.count == 0) continue;
            const bool indices = element.has_indices();
            if (is_read(element)) {
                if (!indices) throw InputError("its element " + element.name + " has no list vertex_indices");
                is_used_ = true;
            } else if (indices) {
                unread_ = &element;
            }
        }
        if (unread_) {
            const std::string words =
                "its element " + one_line(unread_->name, 40) + " holds indices of vertices and is not read";
            if (!is_used_) throw InputError(words);
            mesh_.warnings.push_back(words);
        }
        if (is_used_ && !header_.find("vertex")) throw InputError("has faces and no vertices");
    }

    void tell(std::uint64_t row, double from, double to) {
        if (row % 65536 != 0 || !progress_) return;
        progress_(from + (to - from) * static_cast<double>(values_.at()) / static_cast<double>(file_.size()));
    }

    /// The number before a list.
    std::uint64_t take_count(const PlyElement& element, std::uint64_t row, const PlyProperty& property) {
        const double count = values_.take(property.counts);
        if (!(count >= 0 && count == std::floor(count)))
            throw values_.error(row_name(element, row) + " has a list of " + short_number(count) + " values");
        if (count > static_cast<double>(values_.left())) throw PlyEnds();
        const auto whole = static_cast<std::uint64_t>(count);
        if (values_.bytes(whole, property.type) > values_.left()) throw PlyEnds();
        return whole;
    }
    static std::string row_name(const PlyElement& element, std::uint64_t row) {
        return one_line(element.name, 40) + " " + std::to_string(row);
    }
    void skip_property(const PlyElement& element, std::uint64_t row, const PlyProperty& property) {
        values_.skip(property.type, property.is_list ? take_count(element, row, property) : 1);
    }
    void skip(const PlyElement& element) {
        if (element.properties.empty()) return;
        for (std::uint64_t row = 0; row < element.count; ++row, tell(row, 0, 0.5)) {
            for (const PlyProperty& property : element.properties) skip_property(element, row, property);
            values_.end_row();
        }
    }

    void read_vertices(const PlyElement& element) {
        std::vector<int> axes(element.properties.size(), 3);
        mesh_.single_precision = true;
        for (int axis = 0; axis < 3; ++axis) {
            const std::string name(1, "xyz"[axis]);
            const std::size_t property = element.find(name);
            if (property == axes.size() || element.properties[property].is_list)
                throw InputError("its vertices have no " + name);
            axes[property] = axis;
            const bool floats = element.properties[property].type == PlyType::float32;
            mesh_.single_precision = mesh_.single_precision && floats && header_.format != PlyFormat::text;
        }
        check_memory(0, element.count);
        points_.resize(element.count);
        for (std::uint64_t row = 0; row < element.count; ++row, tell(row, 0, 0.5)) {
            for (std::size_t i = 0; i < axes.size(); ++i) {
                const PlyProperty& property = element.properties[i];
                if (axes[i] < 3)
                    points_[row][axes[i]] = values_.take(property.type);
                else
                    skip_property(element, row, property);
            }
            values_.end_row();
        }
    }

    /// Calls use(row, corners) for each row, where `corners` is how many indices come next, all of which it takes.
    template <typename Use>
    void each_list(const PlyElement& element, double from, double to, const Use& use) {
        const std::size_t indices = element.indices();
        for (std::uint64_t row = 0; row < element.count; ++row, tell(row, from, to)) {
            for (std::size_t i = 0; i < element.properties.size(); ++i) {
                const PlyProperty& property = element.properties[i];
                if (i == indices)
                    use(row, take_count(element, row, property), property.type);
                else
                    skip_property(element, row, property);
            }
            values_.end_row();
        }
    }

    std::uint64_t count_triangles(const PlyElement& element) {
        std::uint64_t triangles = 0;
        const bool strips = element.name == "tristrips";
        each_list(element, 0, 0.5, [&](std::uint64_t, std::uint64_t corners, PlyType type) {
            if (!strips) {
                triangles += std::max<std::uint64_t>(corners, 2) - 2;
                return values_.skip(type, corners);
            }
            for (std::uint64_t length = 0; corners > 0; --corners) {
                length = values_.take(type) < 0 ? 0 : length + 1;
                triangles += length > 2;
            }
        });
        return triangles;
    }

    const Vec<3>& point(const PlyElement& element, std::uint64_t row, double index) const {
        if (index >= 0 && index < static_cast<double>(points_.size()) && index == std::floor(index))
            return points_[static_cast<std::size_t>(index)];
        throw values_.error(row_name(element, row) + " refers to vertex " + number_text(index) + " of " +
                            std::to_string(points_.size()));
    }

    void make_triangles(const PlyElement& element) {
        if (element.name == "tristrips")
            return each_list(element, 0.5, 1, [&](std::uint64_t row, std::uint64_t corners, PlyType type) {
                strip(element, row, corners, type);
            });
        each_list(element, 0.5, 1, [&](std::uint64_t row, std::uint64_t corners, PlyType type) {
            corners_.clear();
            for (std::uint64_t i = 0; i < corners; ++i) corners_.push_back(point(element, row, values_.take(type)));
            short_faces_ += corners < 3;
            if (!cutter_.cut(corners_, mesh_.triangles))
                throw values_.error(row_name(element, row) + ", of " + std::to_string(corners) +
                                    " corners, takes too long to be cut");
        });
    }

    void strip(const PlyElement& element, std::uint64_t row, std::uint64_t corners, PlyType type) {
        Primitive<3> last{};
        for (std::uint64_t length = 0; corners > 0; --corners) {
            const double index = values_.take(type);
            if (index < 0) {
                length = 0;
                continue;
            }
            last = {last[1], last[2], point(element, row, index)};
            if (++length < 3) continue;
            mesh_.triangles.push_back(length % 2 == 1 ? last : Primitive<3>{last[1], last[0], last[2]});
        }
    }

    std::string_view file_;
    const PlyHeader& header_;
    const ShareDone& progress_;
    Values values_;
    PolygonCutter cutter_;
    ParsedMesh mesh_;
    bool is_used_ = false;  ///< the vertices are
    const PlyElement* unread_ = nullptr;
    std::vector<Vec<3>> points_, corners_;
    std::size_t short_faces_ = 0;
};

}  // namespace

ParsedMesh read_ply(std::string_view bytes, const ShareDone& progress) {
    bytes = without_mark(bytes);
    const PlyHeader header = ply_header(bytes);
    switch (header.format) {
        case PlyFormat::text:
            return PlyReader<PlyText>(bytes, header, progress).read();
        case PlyFormat::big_endian:
            return PlyReader<PlyBinary<true>>(bytes, header, progress).read();
        default:
            return PlyReader<PlyBinary<false>>(bytes, header, progress).read();
    }
}

}  // namespace sightline
