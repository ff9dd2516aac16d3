// The format: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/gltf_document.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>

#include "core/base/file.h"
#include "core/base/percent.h"
#include "core/base/text.h"
#include "core/base/utf8_mark.h"
#include "core/scene/read/file_kind.h"

namespace sightline {

namespace {

enum Component { int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125, float32 = 5126 };

constexpr std::uint64_t largest_file = std::uint64_t{1} << 32;

std::size_t size_of(std::size_t type) {
    return type == int8 || type == uint8                    ? 1
           : type == int16 || type == uint16                ? 2
           : type == uint32 || type == std::size_t{float32} ? 4
                                                            : 0;
}

template <typename T>
double number_at(const char* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return static_cast<double>(value);
}

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    std::uint32_t value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

int components_of(const std::string& type) {
    constexpr std::pair<std::string_view, int> types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                          {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    for (const auto& [name, count] : types)
        if (type == name) return count;
    return 0;
}

/// Required extensions that may be left aside: they change neither triangles nor where these are.
bool is_harmless(std::string_view extension) {
    for (const std::string_view begin : {"KHR_materials_", "ADOBE_materials_", "EXT_texture_", "KHR_texture_",
                                         "MSFT_texture_", "KHR_lights_", "EXT_lights_", "KHR_xmp"})
        if (extension.starts_with(begin)) return true;
    for (const std::string_view known :
         {"KHR_mesh_quantization", "KHR_node_visibility", "KHR_animation_pointer", "KHR_techniques_webgl",
          "MSFT_packing_normalRoughnessMetallic", "MSFT_packing_occlusionRoughnessMetallic", "EXT_mesh_features",
          "EXT_structural_metadata", "EXT_feature_metadata", "CESIUM_primitive_outline", "KHR_audio_emitter"})
        if (extension == known) return true;
    return false;
}

const Json nothing = Json::array();

}  // namespace

// -------------------------------------------------------------------- numbers

double GltfNumbers::decoded(const char* from) const {
    const double value = type_ == int8     ? number_at<std::int8_t>(from)
                         : type_ == uint8  ? number_at<std::uint8_t>(from)
                         : type_ == int16  ? number_at<std::int16_t>(from)
                         : type_ == uint16 ? number_at<std::uint16_t>(from)
                         : type_ == uint32 ? number_at<std::uint32_t>(from)
                                           : number_at<float>(from);
    if (!normalized_) return value;
    const double most = type_ == int8 ? 127 : type_ == uint8 ? 255 : type_ == int16 ? 32767 : 65535;
    return std::max(value / most, -1.0);
}

double GltfNumbers::at(std::size_t i, int c) const {
    const std::size_t offset = static_cast<std::size_t>(c) * size_of(static_cast<std::size_t>(type_));
    if (!sparse_.empty())
        if (const auto found = sparse_.find(i); found != sparse_.end()) return decoded(found->second + offset);
    return bytes_ ? decoded(bytes_ + i * stride_ + offset) : 0;
}

GltfNumbers GltfDocument::numbers(std::size_t accessor) {
    const std::string at = "/accessors/" + std::to_string(accessor);
    const Json& of = element("accessors", accessor, at);
    GltfNumbers numbers;
    numbers.count = required(of, "count", at);
    const std::size_t type = required(of, "componentType", at);
    if (size_of(type) == 0) fail(at, "componentType " + std::to_string(type) + " is none of glTF");
    numbers.type_ = static_cast<int>(type);
    numbers.components = components_of(text(of, "type"));
    if (numbers.components == 0) fail(at, "type \"" + text(of, "type") + "\" is none of glTF");
    const auto normalized = of.find("normalized");
    numbers.normalized_ = normalized != of.end() && *normalized == true && type != uint32 && type != float32;
    numbers.whole = type != float32 && !numbers.normalized_;
    const std::size_t size = size_of(type) * static_cast<std::size_t>(numbers.components);
    if (of.contains("bufferView")) numbers.bytes_ = placed(of, at, numbers.count, size, numbers.stride_, false);
    const auto sparse = of.find("sparse");
    if (sparse == of.end() || !sparse->is_object()) {
        if (!numbers.bytes_ && numbers.count > 0) fail(at, "has no data: neither bufferView nor sparse");
        return numbers;
    }
    const std::string inner = at + "/sparse";
    const std::size_t count = required(*sparse, "count", inner);
    if (!sparse->contains("indices") || !sparse->contains("values")) fail(inner, "has no indices or no values");
    const Json &indices = (*sparse)["indices"], &values = (*sparse)["values"];
    GltfNumbers places;
    const std::size_t index_type = required(indices, "componentType", inner + "/indices");
    if (index_type != uint8 && index_type != uint16 && index_type != uint32)
        fail(inner + "/indices", "componentType " + std::to_string(index_type) + " is no index");
    places.type_ = static_cast<int>(index_type);
    places.bytes_ = placed(indices, inner + "/indices", count, size_of(index_type), places.stride_, true);
    std::size_t stride = 0;
    const char* const data = placed(values, inner + "/values", count, size, stride, true);
    for (std::size_t i = 0; i < count; ++i)
        numbers.sparse_[static_cast<std::size_t>(places.at(i, 0))] = data + i * stride;
    return numbers;
}

/// Where the elements of an accessor lie; all of them are in the buffer.
const char* GltfDocument::placed(const Json& of, const std::string& at, std::size_t count, std::size_t size,
                                 std::size_t& stride, bool packed) {
    const std::span<const char> bytes = view(required(of, "bufferView", at), at, stride);
    if (stride == 0 || packed) stride = size;
    const std::size_t offset = whole(of, "byteOffset", at).value_or(0);
    if (count > 0 && (offset > bytes.size() || size > bytes.size() - offset ||
                      (count - 1) > (bytes.size() - offset - size) / std::max<std::size_t>(stride, 1)))
        fail(at, "its " + std::to_string(count) + " elements do not fit into the " + std::to_string(bytes.size()) +
                     " bytes of its bufferView");
    return bytes.data() + (count > 0 ? offset : 0);
}

std::span<const char> GltfDocument::view(std::size_t index, const std::string& asked_by, std::size_t& stride) {
    const std::string at = "/bufferViews/" + std::to_string(index);
    const Json& of = element("bufferViews", index, asked_by);
    const std::string_view bytes = buffer(required(of, "buffer", at));
    const std::size_t offset = whole(of, "byteOffset", at).value_or(0), length = required(of, "byteLength", at);
    if (offset > bytes.size() || length > bytes.size() - offset)
        fail(at, "its " + std::to_string(length) + " bytes at " + std::to_string(offset) +
                     " lie beyond the end of its buffer (" + std::to_string(bytes.size()) + " bytes)");
    stride = whole(of, "byteStride", at).value_or(0);
    return {bytes.data() + offset, length};
}

// -------------------------------------------------------------------- buffers

std::optional<std::string> from_base64(std::string_view text) {
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t word = 0;
    int digits = 0;
    for (const char c : text) {
        const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                          : c >= 'a' && c <= 'z' ? c - 'a' + 26
                          : c >= '0' && c <= '9' ? c - '0' + 52
                          : c == '+'             ? 62
                          : c == '/'             ? 63
                                                 : -1;
        if (c == '=') break;
        if (digit < 0) return std::nullopt;
        word = word << 6 | static_cast<std::uint32_t>(digit);
        if (++digits % 4 != 0) continue;
        for (int shift = 16; shift >= 0; shift -= 8) bytes += static_cast<char>(word >> shift & 0xff);
    }
    if (digits % 4 == 2) bytes += static_cast<char>(word >> 4 & 0xff);
    if (digits % 4 == 3) {
        bytes += static_cast<char>(word >> 10 & 0xff);
        bytes += static_cast<char>(word >> 2 & 0xff);
    }
    return bytes;
}

std::string_view GltfDocument::buffer(std::size_t index) {
    const std::string at = "/buffers/" + std::to_string(index);
    const Json& of = element("buffers", index, at);
    const std::size_t announced = required(of, "byteLength", at);
    const auto held = [&](std::string_view bytes) {
        if (bytes.size() < announced)
            fail(at, "has " + std::to_string(bytes.size()) + " of the " + std::to_string(announced) +
                         " bytes that it announces");
        return bytes.substr(0, announced);
    };
    if (!of.contains("uri")) {
        if (index != 0 || !has_chunk_) fail(at, "has no data: no uri");
        return held(chunk_);
    }
    if (const auto found = buffers_.find(index); found != buffers_.end()) return held(found->second);
    const std::string uri = text(of, "uri");
    std::string bytes;
    if (uri.starts_with("data:")) {
        const std::size_t comma = uri.find(',');
        const bool coded = comma != std::string::npos && std::string_view(uri).substr(0, comma).ends_with(";base64");
        std::optional<std::string> decoded =
            coded ? from_base64(std::string_view(uri).substr(comma + 1)) : std::nullopt;
        if (!decoded) fail(at, "its data: is not in base64");
        bytes = std::move(*decoded);
    } else {
        if (uri.find("://") != std::string::npos)
            fail(at, "lies at " + one_line(uri, 60) + ": only files beside the model are read");
        namespace fs = std::filesystem;
        const fs::path folder = fs::path(path_).parent_path();
        std::error_code error;
        const fs::path plain = folder / percent_decoded(uri), raw = folder / uri;
        try {
            bytes = read_file(fs::exists(plain, error) || !fs::exists(raw, error) ? plain : raw, largest_file);
        } catch (const InputError& refused) {
            fail(at, refused.what());
        }
    }
    total_ += bytes.size();
    return held(buffers_[index] = std::move(bytes));
}

// ------------------------------------------------------------------- the file

GltfDocument::GltfDocument(const std::string& path, const std::string& name, const std::string& place)
    : path_(path), name_(name), place_(place) {
    file_ = read_file(path, largest_file);
    total_ = file_.size();
    if (const std::string kind = kind_behind(path); !kind.empty())
        fail("", "is not glTF as its extension " + ending_of(path) + " says (it begins like " + kind + ")");
    std::string_view json = file_;
    if (json.starts_with("glTF")) {
        if (json.size() < 20) fail("", "ends in its header");
        if (word_at(json, 4) == 1) {
            version_2_ = false;
            return;
        }
        const std::size_t length = std::min<std::size_t>(word_at(json, 8), json.size());
        if (length < word_at(json, 8))
            fail("", "has " + std::to_string(json.size()) + " of the " + std::to_string(word_at(json, 8)) +
                         " bytes that it announces");
        std::string_view rest = json.substr(12, std::max<std::size_t>(length, 12) - 12);
        json = {};
        for (int chunk = 0; rest.size() >= 8; ++chunk) {
            const std::size_t size = word_at(rest, 0);
            if (size > rest.size() - 8) fail("", "its chunk " + std::to_string(chunk) + " ends beyond the file");
            const std::string_view type = rest.substr(4, 4), data = rest.substr(8, size);
            if (chunk == 0 && type == "JSON") json = data;
            if (chunk == 1 && type == std::string_view("BIN\0", 4)) {
                chunk_ = data;
                has_chunk_ = true;
            }
            rest.remove_prefix(8 + size);
        }
        if (json.empty()) fail("", "its first chunk is no JSON");
    }
    json = without_mark(json);
    while (json.ends_with('\0')) json.remove_suffix(1);  // some writers fill up with zeros
    root_ = parse_json(json, place.empty() ? name : name + ": " + place);
    if (!root_.is_object()) fail("", std::string("expected an object, found ") + json_kind(root_));
    check_version();
    if (version_2_) check_extensions();
}

void GltfDocument::check_version() {
    const auto asset = root_.find("asset");
    const std::string version = asset != root_.end() && asset->is_object() ? text(*asset, "version") : "";
    if (version.empty() || version.starts_with("1")) {  // version 1 knew files without it
        version_2_ = false;
        return;
    }
    if (!version.starts_with("2.")) fail("/asset/version", "is glTF " + one_line(version, 20) + "; 2 is supported");
    const std::string least = text(*asset, "minVersion");
    if (!least.empty() && least != "2.0")
        fail("/asset/minVersion", "needs a reader of glTF " + one_line(least, 20) + "; 2.0 is supported");
}

void GltfDocument::check_extensions() const {
    for (const Json& extension : list("extensionsRequired")) {
        if (!extension.is_string()) fail("/extensionsRequired", "expected names");
        const std::string name = extension.get<std::string>();
        if (!is_harmless(name))
            fail("/extensionsRequired", "needs the extension " + one_line(name, 60) + ", which is not supported");
    }
}

// -------------------------------------------------------------------- members

void GltfDocument::fail(const std::string& at, const std::string& reason) const {
    throw input_error(name_, place_.empty() || at.empty() ? place_ + at : place_ + ": " + at, reason);
}

const Json& GltfDocument::list(const char* of) const {
    const auto found = root_.find(of);
    if (found == root_.end()) return nothing;
    if (!found->is_array()) fail(std::string("/") + of, std::string("expected an array, found ") + json_kind(*found));
    return *found;
}

const Json& GltfDocument::element(const char* of, std::size_t index, const std::string& asked_by) const {
    const Json& all = list(of);
    if (index >= all.size())
        fail(asked_by, std::string("/") + of + "/" + std::to_string(index) + " does not exist: there are " +
                           std::to_string(all.size()));
    if (!all[index].is_object())
        fail(std::string("/") + of + "/" + std::to_string(index),
             std::string("expected an object, found ") + json_kind(all[index]));
    return all[index];
}

std::optional<std::size_t> GltfDocument::whole(const Json& object, const char* key, const std::string& at) const {
    const auto found = object.is_object() ? object.find(key) : object.end();
    if (!object.is_object() || found == object.end()) return std::nullopt;
    constexpr double most = 0x1p53;
    const double value = found->is_number() ? found->get<double>() : -1;
    if (!(value >= 0 && value <= most) || value != std::floor(value))
        fail(at + "/" + key, "expected a whole number from 0");
    return static_cast<std::size_t>(value);
}

std::size_t GltfDocument::required(const Json& object, const char* key, const std::string& at) const {
    const auto value = whole(object, key, at);
    if (!value) fail(at, std::string("\"") + key + "\" is missing");
    return *value;
}

std::optional<std::vector<double>> GltfDocument::finite(const Json& object, const char* key, std::size_t count,
                                                        const std::string& at) const {
    const auto found = object.find(key);
    if (found == object.end()) return std::nullopt;
    if (!found->is_array() || found->size() != count)
        fail(at + "/" + key, "expected an array of " + std::to_string(count) + " numbers");
    std::vector<double> values;
    for (const Json& value : *found) {
        if (!value.is_number() || !std::isfinite(value.get<double>())) fail(at + "/" + key, "expected finite numbers");
        values.push_back(value.get<double>());
    }
    return values;
}

std::vector<std::size_t> GltfDocument::indices(const Json& object, const char* key, const std::string& at) const {
    const auto found = object.find(key);
    std::vector<std::size_t> values;
    if (found == object.end()) return values;
    if (!found->is_array()) fail(at + "/" + key, std::string("expected an array, found ") + json_kind(*found));
    for (const Json& value : *found) {
        if (!value.is_number_unsigned()) fail(at + "/" + key, "expected whole numbers from 0");
        values.push_back(value.get<std::size_t>());
    }
    return values;
}

std::string GltfDocument::text(const Json& object, const char* key) const {
    const auto found = object.find(key);
    return found == object.end() || !found->is_string() ? "" : found->get<std::string>();
}

}  // namespace sightline
