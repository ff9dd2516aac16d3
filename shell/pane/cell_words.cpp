// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/cell_words.h"

#include "core/base/number.h"
#include "core/session/headline.h"

namespace sightline {

template <int D>
std::string cell_words(const Session<D>& session, std::uint32_t cell) {
    const Mark mark = session.mark(cell);
    std::string text =
        "cell " + std::to_string(cell) + ", " + std::string(cell_state_words[static_cast<std::size_t>(mark.state)]);
    if (mark.state == CellState::enqueued || mark.state == CellState::projected)
        text += ", " + std::string(key_title(session)) + " = " + short_number(mark.key);
    text += ", |A| " + std::to_string(session.cells().count(cell));
    // In 3D it may be costly: while flying there is none yet.
    if (tells_truth(session) && (D == 2 || session.has_reference()))
        text += ", visible share " + short_number(session.reference().cell_share[cell]);
    return text;
}

template std::string cell_words<2>(const Session<2>&, std::uint32_t);
template std::string cell_words<3>(const Session<3>&, std::uint32_t);

}  // namespace sightline
