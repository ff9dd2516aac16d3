// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/checkpoint.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/error.h"
#include "core/base/file.h"

namespace sightline::lab {

namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

Checkpoint::Checkpoint(std::filesystem::path file, const Conditions& c) : file_(std::move(file)) {
    const std::string head = line_of(
        {{"study", Json::parse(c.study)}, {"program", c.program}, {"machine", c.machine}, {"renderer", c.renderer}});
    std::string kept = head + "\n";
    if (std::filesystem::exists(file_)) {
        const std::string text = read_file(file_);
        std::istringstream in(text);
        std::string line;
        std::getline(in, line);
        const Json found = Json::parse(line, nullptr, false);
        if (found.is_discarded() || !found.is_object() || line_of(found.value("study", Json())) != c.study)
            throw InputError(file_.string() + ": belongs to another study; choose another --out, or remove it");
        began_anew_ = line != head;
        if (began_anew_) write_file(file_.string() + ".old", text);
        while (!began_anew_ && std::getline(in, line)) {
            const Json json = Json::parse(line, nullptr, false);
            if (in.eof() || !json.is_object() || !json.contains("piece") || !json.value("key", Json()).is_string())
                break;
            pieces_[json.at("key")] = json.at("piece").dump();
            kept += line + "\n";
        }
    }
    write_file(file_, kept);
    out_.open(file_, std::ios::app);
}

const std::string* Checkpoint::find(const std::string& key) const {
    const auto at = pieces_.find(key);
    return at == pieces_.end() ? nullptr : &at->second;
}

void Checkpoint::add(const std::string& key, const std::string& piece) {
    out_ << "{\"key\":" << line_of(key) << ",\"piece\":" << piece << "}\n" << std::flush;
    if (!out_) throw WorkError(file_.string() + ": cannot be written");
    pieces_[key] = piece;
}

}  // namespace sightline::lab
