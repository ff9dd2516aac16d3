// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/checkpoint.h"

#include <cerrno>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/hash.h"
#include "core/base/text.h"

namespace sightline::lab {

namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string hash_of(std::string_view text) {
    Hash hash;
    for (const char c : text) hash.add(static_cast<std::uint8_t>(c));
    return hash_text(hash.value());
}

constexpr std::string_view opening = R"({"hash":")", closing = R"(",)";
constexpr std::size_t hash_digits = 16, rest_at = opening.size() + hash_digits + closing.size();

/// The object of a line; what is wrong with it in `reason`, else that is empty.
Json read_line(std::string_view line, std::string& reason) {
    reason = "is cut or damaged";
    if (line.size() <= rest_at || !line.starts_with(opening)) return {};
    if (line.substr(opening.size(), hash_digits) != hash_of(line.substr(rest_at))) return {};
    Json json = Json::parse(line, nullptr, false);
    if (json.is_discarded() || !json.is_object()) return {};
    reason.clear();
    return json;
}

/// The next line of the text, which is taken off; one without its end is cut.
std::string_view next_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = end == std::string_view::npos ? std::string_view() : text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
}

}  // namespace

std::string checkpoint_line(const std::string& object) {
    const std::string rest = object.substr(1);
    return std::string(opening) + hash_of(rest) + std::string(closing) + rest;
}

std::optional<std::string> checkpoint_study(const std::filesystem::path& file) {
    const std::string text = read_file(file);
    std::string_view rest = text;
    std::string reason;
    const Json head = read_line(next_line(rest), reason);
    if (!reason.empty()) return std::nullopt;
    return line_of(head.value("study", Json()));
}

Checkpoint::Checkpoint(std::filesystem::path file, const Conditions& c) : file_(std::move(file)) {
    const std::string head = checkpoint_line(line_of(
        {{"study", Json::parse(c.study)}, {"program", c.program}, {"machine", c.machine}, {"renderer", c.renderer}}));
    std::string kept = head + "\n";
    if (std::filesystem::exists(file_)) {
        const std::string text = read_file(file_);
        std::string_view rest = text;
        std::size_t number = 1;
        const auto damaged = [&](const std::string& reason, const char* what) {
            damages_.push_back(one_line(file_.string(), 4096) + ": line " + std::to_string(number) + ": " + reason +
                               "; " + what);
        };
        std::string reason;
        const std::string_view first = next_line(rest);
        const Json found = read_line(first, reason);
        if (!reason.empty())
            damaged(reason, "all is measured again, and the file is kept with .old behind its name");
        else if (line_of(found.value("study", Json())) != c.study)
            throw InputError(file_.string() + ": belongs to another study; choose another --out, or remove it");
        began_anew_ = first != head;
        if (began_anew_) write_file(file_.string() + ".old", text);
        while (!began_anew_ && !rest.empty()) {
            ++number;
            const std::string_view line = next_line(rest);
            const Json json = read_line(line, reason);
            if (!reason.empty() || !json.contains("piece") || !json.value("key", Json()).is_string()) {
                damaged(reason.empty() ? "is no piece of a study" : reason, "what it held is measured again");
                continue;
            }
            pieces_[json.at("key")] = json.at("piece").dump();
            kept += std::string(line) + "\n";
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
    errno = 0;
    out_ << checkpoint_line("{\"key\":" + line_of(key) + ",\"piece\":" + piece + "}") << "\n" << std::flush;
    if (!out_)
        throw WorkError(file_.string() + ": cannot be written" +
                        (errno != 0 ? ": " + std::generic_category().message(errno) : std::string()));
    pieces_[key] = piece;
}

}  // namespace sightline::lab
