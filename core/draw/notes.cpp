// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/notes.h"

namespace sightline {

void draw_notes(const Session<2>& session, const Colours& colours, std::uint16_t style, DrawList& list) {
    for (const Note<2>& note : session.notes) {
        if (session.position() < note.first_step || session.position() > note.last_step) continue;
        Vec<2> at = note.point;
        if (note.anchor == Note<2>::Anchor::cell) at = session.cells().centres[note.index];
        if (note.anchor == Note<2>::Anchor::primitive) {
            const Primitive<2>& segment = session.scene().primitives[note.index];
            at = (segment[0] + segment[1]) * 0.5;
        }
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
