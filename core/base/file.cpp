// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file.h"

#include <fstream>

#include "core/base/error.h"
#include "core/base/output_file.h"

namespace sightline {

void write_file(const std::filesystem::path& path, std::string_view content) {
    OutputFile file(path);
    file.write(content);
    file.commit();
}

std::uint64_t check_file(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) throw InputError(path.string() + ": no such file");
    if (status.type() == fs::file_type::directory) throw InputError(path.string() + ": is a directory, not a file");
    if (status.type() == fs::file_type::none) throw InputError(path.string() + ": cannot be read: " + error.message());
    if (status.type() != fs::file_type::regular) throw InputError(path.string() + ": is not a regular file");

    const std::uintmax_t size = fs::file_size(path, error);
    if (error) throw InputError(path.string() + ": cannot be read: " + error.message());
    return size;
}

std::string read_file(const std::filesystem::path& path, std::uint64_t most) {
    const std::uint64_t size = check_file(path);
    if (size > most)
        throw InputError(path.string() + ": has " + std::to_string(size) + " bytes; the limit is " +
                         std::to_string(most));
    std::string bytes(size, '\0');
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(path.string() + ": cannot be opened (permission?)");
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    if (file.bad()) throw InputError(path.string() + ": reading failed");
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

}  // namespace sightline
