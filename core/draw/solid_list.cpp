// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/solid_list.h"

#include "core/draw/list_text.h"

namespace sightline {

std::string to_text(const SolidList& list) {
    std::string text = "camera " + point_text(list.camera.eye) + " " + point_text(list.camera.look_at) + "\n";
    for (const SolidStyle& s : list.styles)
        text += "style " + s.name + " " + colour_text(s.colour) + (s.lit ? " lit" : "") + " width " +
                number_text(s.width_pt) + "\n";
    if (list.slice) text += "slice " + point_text(list.slice->normal) + " at " + number_text(list.slice->offset) + "\n";
    for (const SolidList::Run& run : list.runs) {
        text += "triangles " + list.styles[run.style].name;
        for (std::uint32_t i = 0; i < run.count; ++i) text += " " + std::to_string(list.triangles[run.first + i]);
        text += "\n";
    }
    for (std::size_t face = 0; face < list.face_style.size(); ++face) {
        text += "face " + list.styles[list.face_style[face]].name + " of " + std::to_string(list.face_cell[face]);
        for (std::uint32_t i = list.face_begin[face]; i < list.face_begin[face + 1]; ++i)
            text += " " + point_text(list.points[i]);
        text += "\n";
    }
    for (std::size_t edge = 0; edge < list.edge_style.size(); ++edge)
        text += "edge " + list.styles[list.edge_style[edge]].name + " " + point_text(list.edge_points[2 * edge]) + " " +
                point_text(list.edge_points[2 * edge + 1]) + "\n";
    return text;
}

}  // namespace sightline
