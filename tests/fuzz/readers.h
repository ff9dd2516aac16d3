// One entry per reader, as libFuzzer calls it: any bytes end in a scene or in InputError, which is checked here.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/base/error.h"
#include "core/scene/read/read_geojson.h"
#include "core/scene/read/read_json.h"
#include "core/scene/read/read_wad.h"

namespace sightline::fuzz {

inline std::string_view bytes_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// What every caller of a reader relies on.
inline bool is_usable(const Scene<2>& scene) {
    for (const Primitive<2>& s : scene.primitives)
        if (!is_finite(s[0]) || !is_finite(s[1]) || s[0] == s[1]) return false;
    if (!scene.start_view) return false;
    const ViewSpec<2>& view = *scene.start_view;
    return is_finite(view.eye) && is_finite(view.look_at) && view.eye != view.look_at && view.fov > 0;
}

inline bool is_one_line(std::string_view text) {
    for (const char c : text)
        if (static_cast<unsigned char>(c) < 0x20) return false;
    return text.starts_with("input: ") && text.size() < 5000;
}

/// 1: read, 0: refused properly. Ends the program when a promise is broken; lets other exceptions escape.
template <typename Read>
int check(const Read& read) {
    try {
        if (!is_usable(read())) std::abort();
        return 1;
    } catch (const InputError& error) {
        if (!is_one_line(error.what())) std::abort();
        return 0;
    }
}

inline int fuzz_json(const std::uint8_t* data, std::size_t size) {
    return check([&] { return read_json(bytes_of(data, size), "input"); });
}
inline int fuzz_geojson(const std::uint8_t* data, std::size_t size) {
    return check([&] { return read_geojson(bytes_of(data, size), "input"); });
}
inline int fuzz_wad(const std::uint8_t* data, std::size_t size) {
    return check([&] { return read_wad(bytes_of(data, size), "input", {"", true}); });
}

}  // namespace sightline::fuzz
