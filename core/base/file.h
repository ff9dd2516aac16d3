// Whole files in and out.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace sightline {

/// Writes to a temporary name beside the target and renames: no half-written file is ever seen. Throws WorkError that
/// names the file and the reason; the old file, if any, is then untouched.
void write_file(const std::filesystem::path& path, std::string_view content);

/// Size in bytes. Throws InputError, which names the file, when it is missing, not a regular file or cannot be looked
/// at.
std::uint64_t check_file(const std::filesystem::path& path);

/// The whole content. Throws InputError, which names the file, when it is missing, not a regular file, unreadable or
/// larger than `most` bytes.
std::string read_file(const std::filesystem::path& path, std::uint64_t most = std::uint64_t{1} << 30);

}  // namespace sightline
