// A glTF 2.0 file as its JSON and its buffers, and the numbers in them. Pulls in nlohmann-json, so only .cpp files
// include it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/json_input.h"
#include "core/geometry/vec.h"

namespace sightline {

/// Numbers of an accessor, read where they are asked for: files share one array of vertices among many primitives.
class GltfNumbers {
public:
    std::size_t count = 0;  ///< of elements
    int components = 0;     ///< of an element: 3 for a vector
    bool whole = false;     ///< the numbers are whole ones, not fractions: fit to be indices

    /// Component c of element i < count. As the format says, whole numbers that stand for fractions are divided.
    double at(std::size_t i, int c) const;
    Vec<3> vector(std::size_t i) const { return {at(i, 0), at(i, 1), at(i, 2)}; }

private:
    friend class GltfDocument;
    double decoded(const char* from) const;
    int type_ = 0;
    bool normalized_ = false;
    const char* bytes_ = nullptr;  ///< nullptr: all zero
    std::size_t stride_ = 0;
    std::unordered_map<std::size_t, const char*> sparse_;
};

/// The file checked as far as all of it goes: the version, and that it requires no extension that changes what is read
/// here without being known. Buffers are read when they are needed; only regular files are opened. All throw
/// InputError "name: place: /accessors/3: reason".
class GltfDocument {
public:
    GltfDocument(const std::string& path, const std::string& name, const std::string& place);
    GltfDocument(const GltfDocument&) = delete;
    GltfDocument& operator=(const GltfDocument&) = delete;

    /// False: glTF 1, which is another format.
    bool is_version_2() const { return version_2_; }
    const Json& root() const { return root_; }
    /// The list of that name; empty where the file has none.
    const Json& list(const char* of) const;
    const Json& element(const char* list, std::size_t index, const std::string& asked_by) const;
    GltfNumbers numbers(std::size_t accessor);
    std::size_t bytes() const { return total_; }  ///< of the file and of the buffers that were read

    [[noreturn]] void fail(const std::string& at, const std::string& reason) const;
    /// A member that is a whole number from 0.
    std::optional<std::size_t> whole(const Json& object, const char* key, const std::string& at) const;
    std::size_t required(const Json& object, const char* key, const std::string& at) const;
    /// Members that are that many finite numbers; nothing where there is none.
    std::optional<std::vector<double>> finite(const Json& object, const char* key, std::size_t count,
                                              const std::string& at) const;
    /// A member that is a list of whole numbers; empty where there is none.
    std::vector<std::size_t> indices(const Json& object, const char* key, const std::string& at) const;
    std::string text(const Json& object, const char* key) const;  ///< empty where it is none

private:
    void check_version();
    void check_extensions() const;
    std::string_view buffer(std::size_t index);
    std::span<const char> view(std::size_t index, const std::string& at, std::size_t& stride);
    const char* placed(const Json& of, const std::string& at, std::size_t count, std::size_t size, std::size_t& stride,
                       bool packed);

    std::string path_, name_, place_;
    std::string file_;
    std::string_view chunk_;  ///< of the binary container, in file_
    bool has_chunk_ = false, version_2_ = true;
    Json root_;
    std::unordered_map<std::size_t, std::string> buffers_;
    std::size_t total_ = 0;
};

/// The bytes of "data:…;base64,…"; nothing where the text is no base64.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace sightline
