// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/file_kind.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace sightline {

namespace {

using std::string_view_literals::operator""sv;

struct Kind {
    std::string_view first, name, endings;
};

constexpr Kind kinds[] = {
    {"\x89PNG\r\n"sv, "a PNG picture", ".png"},
    {"\xff\xd8\xff"sv, "a JPEG picture", ".jpg .jpeg"},
    {"GIF8"sv, "a GIF picture", ".gif"},
    {"%PDF-"sv, "a PDF document", ".pdf"},
    {"PK\x03\x04"sv, "a ZIP archive", ".zip .3mf .amf .zae .q3o .q3s .pk3"},
    {"\x1f\x8b"sv, "a gzip archive", ".gz .blend"},
    {"7z\xbc\xaf"sv, "a 7-Zip archive", ".7z"},
    {"\x7f"
     "ELF"sv,
     "a program", ""},
    {"IWAD"sv, "a Doom WAD, which viewer2d reads", ""},
    {"PWAD"sv, "a Doom WAD, which viewer2d reads", ""},
    {"glTF"sv, "binary glTF", ".glb .vrm"},
    {"ply\n"sv, "PLY", ".ply"},
    {"ply\r"sv, "PLY", ".ply"},
    {"OFF\n"sv, "OFF", ".off"},
    {"OFF\r"sv, "OFF", ".off"},
    {"OFF "sv, "OFF", ".off"},
    {"solid "sv, "STL", ".stl"},
    {"v "sv, "OBJ", ".obj"},
    {"o "sv, "OBJ", ".obj"},
    {"{"sv, "JSON, as glTF of text", ".gltf"},
    {"mtllib "sv, "OBJ", ".obj"},
    {"ISO-10303-21;"sv, "STEP", ".ifc .step .stp"},
    {"Kaydara FBX Binary"sv, "FBX", ".fbx"},
    {"BLENDER"sv, "Blender's own format", ".blend"},
    {"\xff\xfe"sv, "text in UTF-16: save it as UTF-8", ""},
    {"\xfe\xff"sv, "text in UTF-16: save it as UTF-8", ""},
    {"<!DOCTYPE html"sv, "a web page", ".html"},
    {"<html"sv, "a web page", ".html"},
    {"version https://git-lfs"sv, "a stand-in of Git LFS, not the file itself", ""},
};

bool names(std::string_view endings, std::string_view ending) {
    if (ending.empty()) return false;
    const std::size_t at = endings.find(ending);
    const std::size_t end = at + ending.size();
    return at != std::string_view::npos && (end == endings.size() || endings[end] == ' ');
}

}  // namespace

std::string ending_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
    return ending;
}

std::string kind_of(std::string_view bytes) {
    for (const Kind& kind : kinds)
        if (bytes.starts_with(kind.first)) return std::string(kind.name);
    return "";
}

std::string kind_behind(const std::string& path) {
    char bytes[1024];
    std::ifstream file(path, std::ios::binary);
    file.read(bytes, sizeof bytes);
    std::string_view begin(bytes, static_cast<std::size_t>(file.gcount()));
    while (begin.starts_with('#')) begin.remove_prefix(std::min(begin.find('\n'), begin.size() - 1) + 1);  // comments
    const std::string ending = ending_of(path);
    for (const Kind& kind : kinds)
        if (begin.starts_with(kind.first)) return names(kind.endings, ending) ? "" : std::string(kind.name);
    return "";
}

std::string with_kind(const std::string& reason, const std::string& path) {
    const std::string kind = kind_behind(path);
    return kind.empty() ? reason : reason + " (it begins like " + kind + ")";
}

}  // namespace sightline
