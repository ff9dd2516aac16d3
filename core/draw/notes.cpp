// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/notes.h"

namespace sightline {

template <int D>
Vec<D> anchor_point(const Session<D>& session, const Note<D>& note) {
    if (note.anchor == Note<D>::Anchor::cell) return session.cells().centre(note.index);
    if (note.anchor == Note<D>::Anchor::point) return note.point;
    Vec<D> sum(0);
    for (const Vec<D>& p : session.scene().primitives[note.index]) sum += p;
    return sum / static_cast<double>(D);
}

template <int D>
std::vector<Note<D>> current_notes(const Session<D>& session) {
    std::vector<Note<D>> notes = session.notes;
    std::erase_if(notes, [&](const Note<D>& note) {
        return session.position() < note.first_step || session.position() > note.last_step;
    });
    return notes;
}

template <int D>
std::string cell_letter(std::span<const Note<D>> notes, std::uint32_t cell) {
    for (const Note<D>& note : notes)
        if (note.kind == Note<D>::Kind::text && note.anchor == Note<D>::Anchor::cell && note.index == cell &&
            !note.text.empty() && note.text.size() <= 2)
            return note.text;
    return std::to_string(cell);
}

void name_line(const Vec<2>& at, std::string name, DrawList& list, const Colours& colours) {
    Label label;
    label.at = at;
    label.text = std::move(name);
    label.scale = 0.8;
    label.colour = colours.ink;
    label.halo = colours.halo;
    label.yields = true;
    list.labels.push_back(std::move(label));
}

template <int D>
void draw_notes(const Session<D>& session, const std::function<std::optional<Vec<2>>(const Vec<D>&)>& place,
                const Colours& colours, std::uint16_t style, DrawList& list) {
    for (const Note<D>& note : current_notes(session)) {
        const std::optional<Vec<2>> at = place(anchor_point(session, note));
        if (!at) continue;
        Label label;
        label.at = *at;
        label.offset_pt = note.offset_pt;
        label.text = note.text;
        label.colour = colours.ink;
        label.halo = colours.halo;
        label.note = true;
        label.leader = note.kind == Note<D>::Kind::arrow;
        if (note.kind == Note<D>::Kind::ring) list.add(ShapeKind::ring, style, {*at}, 7);
        if (note.kind == Note<D>::Kind::callout) {
            label.text = std::to_string(note.number);
            label.colour = colours.background;
            label.disc = colours.ink;
            label.halo = transparent;
            label.leader = note.offset_pt != Vec<2>(0);
        }
        list.labels.push_back(label);
    }
}

template Vec<2> anchor_point<2>(const Session<2>&, const Note<2>&);
template Vec<3> anchor_point<3>(const Session<3>&, const Note<3>&);
template std::string cell_letter<2>(std::span<const Note<2>>, std::uint32_t);
template std::string cell_letter<3>(std::span<const Note<3>>, std::uint32_t);
template std::vector<Note<2>> current_notes<2>(const Session<2>&);
template std::vector<Note<3>> current_notes<3>(const Session<3>&);
template void draw_notes<2>(const Session<2>&, const std::function<std::optional<Vec<2>>(const Vec<2>&)>&,
                            const Colours&, std::uint16_t, DrawList&);
template void draw_notes<3>(const Session<3>&, const std::function<std::optional<Vec<2>>(const Vec<3>&)>&,
                            const Colours&, std::uint16_t, DrawList&);

}  // namespace sightline
