// Inputs that the scene tests build, and the check that an error line is what people are promised.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace sightline::test {

inline std::string little(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xff);
    return text;
}

struct WadLump {
    std::string name, bytes;
};

/// Header, lumps, directory.
inline std::string wad_of(const std::vector<WadLump>& lumps, const std::string& magic = "PWAD") {
    std::string body, directory;
    for (const WadLump& lump : lumps) {
        directory += little(static_cast<std::uint32_t>(12 + body.size()), 4);
        directory += little(static_cast<std::uint32_t>(lump.bytes.size()), 4);
        directory += (lump.name + std::string(8, '\0')).substr(0, 8);
        body += lump.bytes;
    }
    std::string wad = magic + little(static_cast<std::uint32_t>(lumps.size()), 4);
    wad += little(static_cast<std::uint32_t>(12 + body.size()), 4);
    return wad + body + directory;
}

inline std::string point(int x, int y) {
    return little(static_cast<std::uint32_t>(x), 2) + little(static_cast<std::uint32_t>(y), 2);
}
inline std::string linedef(std::uint32_t a, std::uint32_t b, std::uint32_t left_side = 0xffff) {
    return little(a, 2) + little(b, 2) + little(1, 2) + little(0, 4) + little(0, 2) + little(left_side, 2);
}
inline std::string thing(int x, int y, int angle, int type) { return point(x, y) + point(angle, type) + little(7, 2); }

/// The five lumps of a map: a square room of 100 units with a see-through line across, player 1 looking north.
inline std::vector<WadLump> room_map(const std::string& name) {
    return {{name, ""},
            {"THINGS", thing(10, 20, 0, 3001) + thing(-30, 40, 90, 1)},
            {"LINEDEFS", linedef(0, 1) + linedef(1, 2) + linedef(2, 3) + linedef(3, 0) + linedef(0, 2, 5)},
            {"SIDEDEFS", ""},
            {"VERTEXES", point(-50, 0) + point(50, 0) + point(50, 100) + point(-50, 100)}};
}

/// `action` must throw InputError with exactly this line, or, when the text ends in "*", one that begins like that.
template <typename Action>
void expect_input_error(const Action& action, const std::string& line) {
    try {
        action();
        ADD_FAILURE() << "nothing thrown instead of: " << line;
    } catch (const InputError& error) {
        const std::string what = error.what();
        EXPECT_EQ(what.find_first_of("\n\r\t"), std::string::npos) << what;
        const std::size_t star = line.find('*');
        if (star == std::string::npos) {
            EXPECT_EQ(what, line);
        } else {
            EXPECT_TRUE(what.starts_with(line.substr(0, star)) && what.ends_with(line.substr(star + 1)))
                << what << "\ninstead of: " << line;
        }
    }
}

/// A file that lives as long as the object.
class TemporaryFile {
public:
    TemporaryFile(const std::string& name, const std::string& bytes)
        : path_(std::filesystem::path(::testing::TempDir()) / name) {
        std::ofstream(path_, std::ios::binary) << bytes;
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() { std::filesystem::remove(path_); }
    std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

}  // namespace sightline::test
