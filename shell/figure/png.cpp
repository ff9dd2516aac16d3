// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/png.h"

#include <cairo.h>

#include <cmath>
#include <cstdint>
#include <string_view>

#include "core/base/error.h"

namespace sightline {

namespace {

std::uint32_t crc32(std::string_view data) {
    std::uint32_t crc = 0xffffffffu;
    for (const char c : data) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}

void append_big_endian(std::string& out, std::uint32_t value) {
    for (const int shift : {24, 16, 8, 0}) out += static_cast<char>(value >> shift & 255);
}

cairo_status_t append_png(void* text, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string encode_png(cairo_surface_t* surface, double dpi) {
    std::string file;
    if (const cairo_status_t status = cairo_surface_write_to_png_stream(surface, append_png, &file);
        status != CAIRO_STATUS_SUCCESS)
        throw WorkError(std::string("cannot encode the PNG: ") + cairo_status_to_string(status));
    const auto per_metre = static_cast<std::uint32_t>(std::lround(dpi / 0.0254));
    std::string chunk = "pHYs";
    append_big_endian(chunk, per_metre);
    append_big_endian(chunk, per_metre);
    chunk += '\1';  // metres
    std::string block;
    append_big_endian(block, static_cast<std::uint32_t>(chunk.size() - 4));
    block += chunk;
    append_big_endian(block, crc32(chunk));
    const std::size_t after_header = 8 + 25;  // the signature and the chunk IHDR
    file.insert(after_header, block);
    return file;
}

}  // namespace sightline
