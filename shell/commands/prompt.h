// What the console offers when a command needs an argument: its id, and a name where one suggests itself.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "shell/desk/workbench.h"

namespace sightline {

/// "shot bottleneck-12.svg", or just "until ".
template <int D>
std::string prompt(const Workbench<D>& bench, const std::string& id) {
    const Session<D>& s = bench.session;
    const std::string scene = std::filesystem::path(s.scene().id).stem().string();
    const std::string place = scene + "-" + std::to_string(s.position());
    if (id == "shot") return "shot " + place + ".svg";
    if (id == "page") return "page " + place + ".html";
    if (id == "save") return "save " + place + ".json";
    if (id == "stats" || id == "trace") return id + " " + place + "-" + id + ".json";
    if (id == "path save") return "path save " + scene + "-path.json";
    if (id == "film") return "film 0-" + std::to_string(s.recorded()) + " " + scene + ".pdf";
    return id + " ";
}

/// Opens the console with it.
template <int D>
void ask(Workbench<D>& bench, const std::string& id) {
    bench.desk.console = true;
    bench.desk.console_text = prompt(bench, id);
}

}  // namespace sightline
