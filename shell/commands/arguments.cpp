// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands/arguments.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/draw/shown_boxes.h"
#include "core/space/box_tree.h"

namespace sightline {

std::array<std::string, 2> split_word(Text text) {
    const std::size_t space = text.find(' ');
    if (space == std::string::npos) return {text, ""};
    const std::size_t rest = text.find_first_not_of(' ', space);
    return {text.substr(0, space), rest == std::string::npos ? "" : text.substr(rest)};
}

std::uint32_t whole_argument(Text text, const char* what) {
    const auto number = parse_whole(text);
    if (!number) throw InputError("'" + text + "' is not " + what);
    return *number;
}

double number_argument(Text text, const char* what) {
    const auto number = parse_number(text);
    if (!number) throw InputError("'" + text + "' is not " + what);
    return *number;
}

std::size_t word_argument(Text text, std::span<const std::string_view> words) {
    const auto found = std::find(words.begin(), words.end(), text);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    std::string known;
    for (const std::string_view word : words) known += (known.empty() ? "" : ", ") + std::string(word);
    throw InputError("'" + text + "' is not one of " + known);
}

std::optional<std::array<std::uint32_t, 2>> parse_steps(std::string_view text) {
    const std::size_t dash = text.find('-');
    if (dash == std::string_view::npos) return std::nullopt;
    const auto from = parse_whole(text.substr(0, dash)), to = parse_whole(text.substr(dash + 1));
    if (!from || !to) return std::nullopt;
    return std::array{*from, *to};
}

std::optional<Vec<2>> parse_pair(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return std::nullopt;
    const auto x = parse_number(text.substr(0, comma)), y = parse_number(text.substr(comma + 1));
    if (!x || !y) return std::nullopt;
    return Vec<2>(*x, *y);
}

const std::string& file_argument(Text text) {
    if (text.empty()) throw InputError("a file name is missing");
    return text;
}

template <int D>
std::uint32_t cell_argument(const Workbench<D>& bench, Text text) {
    const Session<D>& session = bench.session;
    if (text == "last") {
        if (const std::uint32_t cell = last_cell(session); cell != none) return cell;
        throw InputError("no cell has been projected yet");
    }
    if (text == "selected") {
        if (session.selected_cell == none) throw InputError("no cell is selected");
        return session.selected_cell;
    }
    const std::uint32_t cell = whole_argument(text, "a cell");
    if (cell >= session.cells().cell_count())
        throw InputError("cell " + text + " does not exist; there are " + std::to_string(session.cells().cell_count()) +
                         ", from 0");
    return cell;
}

template <int D>
std::uint32_t node_argument(const Workbench<D>& bench, Text text) {
    const Session<D>& session = bench.session;
    if (session.method().pops != Kind::node)
        throw InputError("method '" + std::string(session.method().id) + "' walks no tree of boxes");
    if (text == "last") {
        if (const std::uint32_t node = last_node(session); node != none) return node;
        throw InputError("no box has been popped yet");
    }
    const std::uint32_t node = whole_argument(text, "the number of a node");
    const std::size_t count = session.traversal().boxes()->nodes.size();
    if (node >= count)
        throw InputError("node " + std::to_string(node) + " does not exist; there are " + std::to_string(count) +
                         ", from 0");
    return node;
}

template <int D>
std::uint32_t primitive_argument(const Workbench<D>& bench, Text text) {
    if (text == "selected") {
        if (bench.session.selected_primitive == none) throw InputError("no primitive is selected");
        return bench.session.selected_primitive;
    }
    const std::uint32_t primitive = whole_argument(text, "a primitive");
    if (primitive >= bench.session.scene().primitives.size())
        throw InputError("primitive " + text + " does not exist; there are " +
                         std::to_string(bench.session.scene().primitives.size()) + ", from 0");
    return primitive;
}

template <int D>
std::uint32_t note_argument(const Workbench<D>& bench, Text text) {
    const std::size_t count = bench.session.notes.size();
    if (text == "selected") {
        if (bench.selected_note >= count) throw InputError("no note is selected");
        return bench.selected_note;
    }
    const std::uint32_t n = whole_argument(text, "the number of a note");
    if (n < 1 || n > count) throw InputError("there is no note " + text + "; there are " + std::to_string(count));
    return n - 1;
}

template <int D>
Vec<D> parse_point(Text text, const Scene<D>& scene) {
    Vec<D> point{};
    std::string_view rest = text;
    for (int i = 0; i < D; ++i) {
        const std::size_t end = i + 1 < D ? rest.find(',') : rest.size();
        const auto number = end == std::string_view::npos ? std::nullopt : parse_number(rest.substr(0, end));
        if (!number) throw InputError("point '" + text + "': write " + (D == 2 ? "X,Y" : "X,Y,Z"));
        point[i] = *number;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return point - scene.origin;
}

template <int D>
std::string point_text(const Vec<D>& point, const Scene<D>& scene) {
    std::string text;
    for (int i = 0; i < D; ++i) text += (i > 0 ? "," : "") + number_text(point[i] + scene.origin[i]);
    return text;
}

template std::uint32_t cell_argument<2>(const Workbench<2>&, Text);
template std::uint32_t cell_argument<3>(const Workbench<3>&, Text);
template std::uint32_t node_argument<2>(const Workbench<2>&, Text);
template std::uint32_t node_argument<3>(const Workbench<3>&, Text);
template std::uint32_t primitive_argument<2>(const Workbench<2>&, Text);
template std::uint32_t primitive_argument<3>(const Workbench<3>&, Text);
template std::uint32_t note_argument<2>(const Workbench<2>&, Text);
template std::uint32_t note_argument<3>(const Workbench<3>&, Text);
template Vec<2> parse_point<2>(Text, const Scene<2>&);
template Vec<3> parse_point<3>(Text, const Scene<3>&);
template std::string point_text<2>(const Vec<2>&, const Scene<2>&);
template std::string point_text<3>(const Vec<3>&, const Scene<3>&);

}  // namespace sightline
