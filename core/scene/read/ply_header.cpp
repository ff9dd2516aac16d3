// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/ply_header.h"

#include <charconv>
#include <optional>

#include "core/base/text.h"
#include "core/scene/read/parsed_mesh.h"

namespace sightline {

namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};

constexpr TypeName type_names[] = {
    {"char", PlyType::int8},       {"int8", PlyType::int8},      {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},     {"short", PlyType::int16},    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},   {"uint16", PlyType::uint16},  {"int", PlyType::int32},
    {"int32", PlyType::int32},     {"uint", PlyType::uint32},    {"uint32", PlyType::uint32},
    {"int64", PlyType::int64},     {"uint64", PlyType::uint64},  {"float", PlyType::float32},
    {"float32", PlyType::float32}, {"double", PlyType::float64}, {"float64", PlyType::float64}};

class PlyHeaderReader {
public:
    explicit PlyHeaderReader(std::string_view file) : file_(file) {}

    PlyHeader read() {
        if (const std::string first = in_small_letters(word_of(next_line())); first != "ply")
            throw refuse("is not \"ply\", so this is no PLY file");
        bool has_format = false;
        for (;;) {
            std::string_view line = next_line();
            const std::string_view word = next_word(line);
            if (word == "end_header") break;
            if (word.empty() || word == "comment" || word == "obj_info") continue;
            if (word == "format") {
                format(next_word(line));
                has_format = true;
            } else if (word == "element") {
                element(line);
            } else if (word == "property") {
                property(line);
            } else {
                throw refuse("\"" + one_line(word, 40) + "\" begins no line of a PLY header");
            }
        }
        if (!has_format) throw InputError("its header does not say whether it is text or binary");
        header_.bytes = next_;
        return std::move(header_);
    }

private:
    InputError refuse(const std::string& reason) const { return error_at(file_, at_, reason); }
    static std::string_view word_of(std::string_view line) { return next_word(line); }

    std::string_view next_line() {
        at_ = next_;
        const std::size_t end = file_.find_first_of(std::string_view("\r\n"), at_);
        if (end == file_.npos && at_ > 0) throw InputError("its header does not end");
        const std::string_view line = file_.substr(at_, end == file_.npos ? end : end - at_);
        next_ = std::min(line.size() + at_ + 1, file_.size());
        // Every line ends as the first does: what follows the header may begin with anything.
        if (at_ == 0) wide_ = file_.substr(line.size()).starts_with("\r\n");
        if (wide_ && next_ < file_.size() && file_[next_ - 1] == '\r' && file_[next_] == '\n') ++next_;
        return line;
    }

    void format(std::string_view word) {
        if (word == "ascii")
            header_.format = PlyFormat::text;
        else if (word == "binary_little_endian")
            header_.format = PlyFormat::little_endian;
        else if (word == "binary_big_endian")
            header_.format = PlyFormat::big_endian;
        else
            throw refuse("\"" + one_line(word, 40) + "\" is no format of PLY");
    }

    void element(std::string_view line) {
        PlyElement element;
        element.name = next_word(line);
        const std::string_view count = next_word(line);
        const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (error != std::errc() || end != count.data() + count.size() || element.count > 1'000'000'000'000)
            throw refuse("\"" + one_line(count, 40) + "\" is no number of elements");
        if (header_.find(element.name)) throw refuse("the element " + one_line(element.name, 40) + " stands twice");
        header_.elements.push_back(std::move(element));
    }

    void property(std::string_view line) {
        if (header_.elements.empty()) throw refuse("a property stands before the first element");
        PlyProperty property{};
        std::string_view word = next_word(line);
        property.is_list = word == "list";
        if (property.is_list) {
            property.counts = type(next_word(line));
            word = next_word(line);
        }
        property.type = type(word);
        property.name = next_word(line);
        header_.elements.back().properties.push_back(std::move(property));
    }

    PlyType type(std::string_view word) const {
        for (const TypeName& row : type_names)
            if (word == row.name) return row.type;
        throw refuse("\"" + one_line(word, 40) + "\" is no type of PLY");
    }

    std::string_view file_;
    std::size_t at_ = 0, next_ = 0;
    bool wide_ = false;
    PlyHeader header_;
};

}  // namespace

std::size_t bytes_of_type(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        default:
            return 8;
    }
}

std::size_t PlyElement::find(std::string_view wanted) const {
    std::size_t i = 0;
    while (i < properties.size() && properties[i].name != wanted) ++i;
    return i;
}

std::size_t PlyElement::indices() const {
    std::size_t i = 0;
    while (i < properties.size() && !(properties[i].is_list && properties[i].name.starts_with("vertex_ind"))) ++i;
    return i;
}

const PlyElement* PlyHeader::find(std::string_view element) const {
    for (const PlyElement& candidate : elements)
        if (candidate.name == element) return &candidate;
    return nullptr;
}

PlyHeader ply_header(std::string_view file) { return PlyHeaderReader(file).read(); }

}  // namespace sightline
