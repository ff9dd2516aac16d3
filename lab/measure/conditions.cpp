// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/conditions.h"

#include <cstring>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/base/hash.h"
#include "core/base/machine.h"

namespace sightline::lab {

namespace {

std::string program_hash() {
    const std::string bytes = read_file("/proc/self/exe");
    Hash hash;
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, std::min(sizeof word, bytes.size() - i));
        hash.add(word);
    }
    return hash_text(hash.value());
}

}  // namespace

Conditions conditions_here(std::string study, std::string renderer) {
    Conditions c{std::move(study),    std::string("compiler ") + __VERSION__,
                 program_hash(),      machine_text(),
                 std::move(renderer), today_text()};
#ifdef NDEBUG
    c.build += ", optimised";
#else
    c.build += ", not optimised";
#endif
    return c;
}

std::string conditions_json(const Conditions& c) {
    using Json = nlohmann::ordered_json;
    return Json{{"study", Json::parse(c.study)}, {"build", c.build},       {"program", c.program},
                {"machine", c.machine},          {"renderer", c.renderer}, {"date", c.date}}
        .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace sightline::lab
