// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/memory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_input.h"
#include "core/base/text.h"
#include "shell/desk/recent.h"
#include "shell/panels/panel.h"

namespace sightline {

namespace {

constexpr const char* format = "sightline-memory";
constexpr std::uint64_t most_bytes = 1 << 20;
constexpr std::size_t longest_name = 4096;
constexpr double narrowest = 100, widest = 4000;  // of columns and the timeline

/// The member of an object, with its place for error lines.
struct Member {
    const Json& value;
    JsonPlace place;
    const std::string& name;

    [[noreturn]] void fail(const std::string& reason) const { throw input_error(name, place.text(), reason); }
    double number(double low, double high) const {
        const double x = json_number(value, place, name);
        if (!(x >= low && x <= high)) fail("a number out of range");
        return x;
    }
    int whole(int low, int high) const {
        if (!value.is_number_integer()) fail(std::string("expected a whole number, found ") + json_kind(value));
        return static_cast<int>(number(low, high));
    }
    bool flag() const {
        if (!value.is_boolean()) fail(std::string("expected true or false, found ") + json_kind(value));
        return value.get<bool>();
    }
    std::string text() const {
        if (!value.is_string()) fail(std::string("expected a string, found ") + json_kind(value));
        std::string words = value.get<std::string>();
        if (words.size() > longest_name) fail("the string is too long");
        return words;
    }
};

Member member(const Json& object, const JsonPlace& place, const char* key, const std::string& name) {
    if (!object.is_object())
        throw input_error(name, place.text(), std::string("expected an object, found ") + json_kind(object));
    const auto found = object.find(key);
    if (found == object.end()) throw input_error(name, place.text(), std::string("'") + key + "' is missing");
    return {*found, place.member(key), name};
}

Placement read_placement(const Member& window) {
    const auto at = [&](const char* key) { return member(window.value, window.place, key, window.name); };
    Placement p;
    if (window.value.contains("width") || window.value.contains("height")) {
        p.width = at("width").whole(smallest_width, largest_size);
        p.height = at("height").whole(smallest_height, largest_size);
    }
    p.maximised = at("maximised").flag();
    if (window.value.contains("x"))
        p.at = {at("x").whole(-farthest_place, farthest_place), at("y").whole(-farthest_place, farthest_place)};
    return p;
}

template <int D>
std::string read_panel(const Member& member, Column side) {
    std::string id = member.text();
    if (id.empty()) return id;
    const Panel<D>* panel = find_panel<D>(id);
    if (!panel) member.fail("there is no such panel");
    return panel->column == side ? id : "";  // it stood on this side in an earlier version
}

/// What an older version did not write keeps its default.
template <int D>
Desk read_desk(const Member& part) {
    Desk desk;
    const auto read = [&](const char* key, const auto& use) {
        if (!part.value.is_object() || part.value.contains(key)) use(member(part.value, part.place, key, part.name));
    };
    read("left", [&](const Member& m) { desk.left = read_panel<D>(m, Column::left); });
    read("right", [&](const Member& m) { desk.right = read_panel<D>(m, Column::right); });
    read("left_width", [&](const Member& m) { desk.left_width = m.number(narrowest, widest); });
    read("right_width", [&](const Member& m) { desk.right_width = m.number(narrowest, widest); });
    read("timeline", [&](const Member& m) { desk.timeline = m.flag(); });
    read("timeline_height", [&](const Member& m) { desk.timeline_height = m.number(narrowest, widest); });
    read("legend", [&](const Member& m) { desk.legend = m.flag(); });
    read("animate", [&](const Member& m) { desk.animate = m.flag(); });
    read("scale", [&](const Member& m) { desk.scale = m.number(smallest_scale, largest_scale); });
    read("axis", [&](const Member& m) {
        const std::string axis = m.text();
        if (axis == timeline_axis_words[1])
            desk.axis = TimelineAxis::primitives;
        else if (axis != timeline_axis_words[0])
            m.fail("no axis of the timeline");
    });
    return desk;
}

std::vector<std::string> read_recent(const Member& list) {
    if (!list.value.is_array()) list.fail(std::string("expected an array, found ") + json_kind(list.value));
    if (list.value.size() > most_recent) list.fail("too many");
    std::vector<std::string> recent;
    for (std::size_t i = 0; i < list.value.size(); ++i) {
        const Member entry{list.value[i], list.place.element(i), list.name};
        recent.push_back(entry.text());
        if (recent.back().empty()) entry.fail("an empty name");
    }
    return recent;
}

/// One window at a time reads the file and writes it. Where there are no locks, the last one wins.
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder)
        : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        if (descriptor_ >= 0) flock(descriptor_, LOCK_EX);
    }
    ~FolderLock() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_;
};

/// Renames to the first free name. False when that fails.
bool set_aside(const std::filesystem::path& file, std::filesystem::path& aside) {
    std::error_code error;
    aside = file.string() + ".damaged";
    for (int i = 2; std::filesystem::exists(aside, error); ++i) aside = file.string() + ".damaged" + std::to_string(i);
    std::filesystem::rename(file, aside, error);
    return !error;
}

}  // namespace

Desk lasting(const Desk& desk) {
    Desk kept;
    kept.scale = desk.scale;
    kept.left = desk.left;
    kept.right = desk.right;
    kept.timeline = desk.timeline;
    kept.legend = desk.legend;
    kept.animate = desk.animate;
    kept.left_width = std::clamp(desk.left_width, narrowest, widest);
    kept.right_width = std::clamp(desk.right_width, narrowest, widest);
    kept.timeline_height = std::clamp(desk.timeline_height, narrowest, widest);
    kept.axis = desk.axis;
    return kept;
}

std::string memory_json(const Memory& memory) {
    const Placement& p = memory.placement;
    const Desk& d = memory.desk;
    Json window{{"maximised", p.maximised}};
    if (p.width > 0 && p.height > 0) {
        window["width"] = p.width;
        window["height"] = p.height;
    }
    if (p.at) {
        window["x"] = (*p.at)[0];
        window["y"] = (*p.at)[1];
    }
    const Json desk{{"left", d.left},
                    {"right", d.right},
                    {"left_width", d.left_width},
                    {"right_width", d.right_width},
                    {"timeline", d.timeline},
                    {"timeline_height", d.timeline_height},
                    {"legend", d.legend},
                    {"animate", d.animate},
                    {"scale", d.scale},
                    {"axis", timeline_axis_words[static_cast<std::size_t>(d.axis)]}};
    const Json all{{"format", format}, {"window", window}, {"desk", desk}, {"recent", memory.recent}};
    // Names of files may be in no encoding at all.
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

template <int D>
Memory read_memory(const std::string& text, const std::string& name) {
    const Json root = parse_json(text, name);
    const JsonPlace top;
    const auto at = [&](const char* key) { return member(root, top, key, name); };
    if (at("format").text() != format) at("format").fail(std::string("expected ") + format);
    return {read_placement(at("window")), read_desk<D>(at("desk")), read_recent(at("recent"))};
}

std::filesystem::path memory_file(const std::string& program) {
    const auto folder = [](const char* variable) {
        const char* value = std::getenv(variable);
        const std::filesystem::path path = value ? value : "";
        return path.is_absolute() ? path : std::filesystem::path();  // so the rules of XDG: a relative one is no path
    };
    std::filesystem::path config = folder("XDG_CONFIG_HOME");
    if (config.empty() && !folder("HOME").empty()) config = folder("HOME") / ".config";
    return config.empty() ? config : config / "sightline" / (program + ".json");
}

template <int D>
Recalled recall(const std::filesystem::path& file) {
    std::error_code error;
    if (file.empty() || std::filesystem::status(file, error).type() == std::filesystem::file_type::not_found) return {};
    std::string text;
    try {
        text = read_file(file, most_bytes);
    } catch (const InputError& unreadable) {
        return {{}, std::string("the saved window layout: ") + unreadable.what()};
    }
    try {
        return {read_memory<D>(text, file.string()), ""};
    } catch (const InputError& damage) {
        std::filesystem::path aside;
        const bool moved = set_aside(file, aside);
        return {{},
                "the saved window layout is damaged" +
                    (moved ? " and was renamed to " + aside.string() : " and cannot be renamed") + " (" +
                    damage.what() + ")"};
    }
}

template <int D>
std::vector<std::string> keep(const std::filesystem::path& file, Memory memory, const std::vector<std::string>& known) {
    if (file.empty()) return memory.recent;
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) throw WorkError("cannot make the folder " + file.parent_path().string() + ": " + error.message());
    const FolderLock lock(file.parent_path());
    try {
        if (std::filesystem::exists(file, error))
            memory.recent =
                merge_recent(memory.recent, read_memory<D>(read_file(file, most_bytes), file.string()).recent, known);
    } catch (const InputError&) {  // damaged since: nothing to take over
    }
    write_file(file, memory_json(memory));
    return memory.recent;
}

template std::vector<std::string> keep<2>(const std::filesystem::path&, Memory, const std::vector<std::string>&);
template std::vector<std::string> keep<3>(const std::filesystem::path&, Memory, const std::vector<std::string>&);

template Memory read_memory<2>(const std::string&, const std::string&);
template Memory read_memory<3>(const std::string&, const std::string&);
template Recalled recall<2>(const std::filesystem::path&);
template Recalled recall<3>(const std::filesystem::path&);

}  // namespace sightline
