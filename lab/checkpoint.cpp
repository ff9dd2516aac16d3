// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/checkpoint.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/error.h"
#include "core/file.h"

namespace sightline::lab {

namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const std::string& scene, const std::string& path, const FrameResult& result) {
    Json values = Json::array();
    for (const Values& v : result.values) {
        Json one = Json::array();
        for (const double value : v.all) one.push_back(std::isfinite(value) ? Json(value) : Json(nullptr));
        values.push_back(std::move(one));
    }
    return Json{{"scene", scene}, {"path", path}, {"frame", result.frame}, {"values", std::move(values)}}.dump(
               -1, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

}  // namespace

Checkpoint::Checkpoint(std::filesystem::path file, const std::string& study) : file_(std::move(file)) {
    std::string kept = study + "\n";
    if (std::filesystem::exists(file_)) {
        std::istringstream in(read_file(file_));
        std::string line;
        std::getline(in, line);
        if (line != study)
            throw InputError(file_.string() + ": holds frames of another study; choose another --out, or remove it");
        while (std::getline(in, line)) {
            const Json json = Json::parse(line, nullptr, false);
            if (json.is_discarded() || in.eof()) break;
            FrameResult result{json.at("frame"), {}};
            for (const Json& one : json.at("values")) {
                Values& v = result.values.emplace_back();
                for (std::size_t i = 0; i < measure_count; ++i)
                    if (!one.at(i).is_null()) v.all[i] = one.at(i);
            }
            finished_[{json.at("scene"), json.at("path"), result.frame}] = std::move(result);
            kept += line + "\n";
        }
    }
    write_file(file_, kept);
    out_.open(file_, std::ios::app);
}

const FrameResult* Checkpoint::find(const std::string& scene, const std::string& path, std::uint32_t frame) const {
    const auto at = finished_.find({scene, path, frame});
    return at == finished_.end() ? nullptr : &at->second;
}

void Checkpoint::add(const std::string& scene, const std::string& path, const FrameResult& result) {
    out_ << line_of(scene, path, result) << std::flush;
    if (!out_) throw WorkError(file_.string() + ": cannot be written");
    finished_[{scene, path, result.frame}] = result;
}

}  // namespace sightline::lab
