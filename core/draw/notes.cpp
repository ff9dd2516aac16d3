// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/notes.h"

namespace sightline {

Vec<2> anchor_point(const Session<2>& session, const Note<2>& note) {
    if (note.anchor == Note<2>::Anchor::cell) return session.cells().centre(note.index);
    if (note.anchor == Note<2>::Anchor::point) return note.point;
    const Primitive<2>& segment = session.scene().primitives[note.index];
    return (segment[0] + segment[1]) * 0.5;
}

std::vector<Note<2>> current_notes(const Session<2>& session) {
    std::vector<Note<2>> notes = session.notes;
    std::erase_if(notes, [&](const Note<2>& note) {
        return session.position() < note.first_step || session.position() > note.last_step;
    });
    return notes;
}

void draw_notes(const Session<2>& session, const Colours& colours, std::uint16_t style, DrawList& list) {
    for (const Note<2>& note : current_notes(session)) {
        const Vec<2> at = anchor_point(session, note);
        Label label;
        label.at = at;
        label.offset_pt = note.offset_pt;
        label.text = note.text;
        label.colour = colours.ink;
        label.halo = colours.halo;
        label.leader = note.kind == Note<2>::Kind::arrow;
        if (note.kind == Note<2>::Kind::ring) list.add(ShapeKind::ring, style, {at}, 7);
        if (note.kind == Note<2>::Kind::callout) {
            label.text = std::to_string(note.number);
            label.offset_pt = {0, 0};
            label.colour = colours.background;
            label.disc = colours.ink;
            label.halo = transparent;
        }
        list.labels.push_back(label);
    }
}

}  // namespace sightline
