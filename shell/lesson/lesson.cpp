// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/lesson/lesson.h"

#include <limits>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_input.h"
#include "core/base/text.h"

namespace sightline {

namespace {

constexpr const char* format = "sightline-lessons";
constexpr std::uint64_t most_bytes = 1 << 20;
constexpr int most_presses = 1000, most_minutes = 600;

/// An object of the index; each member is asked for by its name, and those that nobody asked for are an error.
class Part {
public:
    Part(const Json& value, JsonPlace place, const std::string& name) : value_(value), place_(place), name_(name) {
        if (!value.is_object()) fail(place_, std::string("expected an object, found ") + json_kind(value));
    }
    Part(const Part&) = delete;

    std::string text(const char* key) {
        const Json* const found = find(key);
        if (!found) return {};
        if (!found->is_string()) fail(place_.member(key), std::string("expected a string, found ") + json_kind(*found));
        return found->get<std::string>();
    }
    bool flag(const char* key) {
        const Json* const found = find(key);
        if (!found) return false;
        if (!found->is_boolean())
            fail(place_.member(key), std::string("expected true or false, found ") + json_kind(*found));
        return found->get<bool>();
    }
    int whole(const char* key, int otherwise, int low, int high) {
        const Json* const found = find(key);
        if (!found) return otherwise;
        if (!found->is_number_integer() || *found < low || *found > high)
            fail(place_.member(key),
                 "expected a whole number from " + std::to_string(low) + " to " + std::to_string(high));
        return found->get<int>();
    }
    template <typename Each>
    void each(const char* key, Each each) {
        const Json* const found = find(key);
        if (!found) return;
        const JsonPlace list = place_.member(key);
        if (!found->is_array()) fail(list, std::string("expected an array, found ") + json_kind(*found));
        for (std::size_t i = 0; i < found->size(); ++i) each((*found)[i], list.element(i));
    }
    std::string needed(const char* key) {
        std::string words = text(key);
        if (words.empty()) fail(place_, std::string("'") + key + "' is missing");
        return words;
    }
    void nothing_else() const {
        for (const auto& [key, value] : value_.items())
            if (!asked_.contains(key)) fail(place_, "unknown member '" + key + "'");
    }
    [[noreturn]] void fail(const JsonPlace& place, const std::string& reason) const {
        throw input_error(name_, place.text(), reason);
    }
    const JsonPlace& place() const { return place_; }

private:
    const Json* find(const char* key) {
        asked_[key] = true;
        const auto found = value_.find(key);
        return found == value_.end() ? nullptr : &*found;
    }

    const Json& value_;
    JsonPlace place_;
    const std::string& name_;
    Json asked_ = Json::object();
};

void add_beats(const Json& value, const JsonPlace& place, const std::string& name, std::vector<Beat>& beats) {
    Part in(value, place, name);
    Beat beat{in.text("ask"), in.text("do"), in.text("say"), in.flag("guess"), in.flag("reveal"), {}, {}};
    if (const int cell = in.whole("key_of", -1, 0, std::numeric_limits<int>::max()); cell >= 0)
        beat.key_of = static_cast<std::uint32_t>(cell);
    in.each("shows", [&](const Json& words, const JsonPlace& at) {
        if (!words.is_string()) in.fail(at, std::string("expected a string, found ") + json_kind(words));
        beat.shows.push_back(words.get<std::string>());
    });
    const int times = in.whole("times", 1, 1, most_presses);
    in.nothing_else();
    beats.insert(beats.end(), static_cast<std::size_t>(times), beat);
}

LessonPart read_part(const Json& value, const JsonPlace& place, const std::string& name) {
    Part in(value, place, name);
    LessonPart part{in.needed("title"), in.whole("minutes", 0, 0, most_minutes),
                    in.needed("open"),  in.text("do"),
                    in.text("panel"),   in.flag("concealed"),
                    in.text("notes"),   {}};
    in.each("beats", [&](const Json& beat, const JsonPlace& at) { add_beats(beat, at, name, part.beats); });
    in.nothing_else();
    return part;
}

}  // namespace

int Lesson::minutes() const {
    int all = 0;
    for (const LessonPart& part : parts) all += part.minutes;
    return all;
}

std::vector<Lesson> read_lessons(const std::filesystem::path& file) {
    const std::string name = file.string();
    const Json root = parse_json(read_file(file, most_bytes), name);
    const JsonPlace top;
    Part in(root, top, name);
    if (in.text("format") != format) in.fail(top, std::string("'format' is not ") + format);
    std::vector<Lesson> lessons;
    in.each("lessons", [&](const Json& value, const JsonPlace& place) {
        Part one(value, place, name);
        Lesson lesson{one.needed("id"), one.needed("title"), one.whole("dimension", 2, 2, 3), file.parent_path(), {}};
        one.each("parts",
                 [&](const Json& part, const JsonPlace& at) { lesson.parts.push_back(read_part(part, at, name)); });
        one.nothing_else();
        if (lesson.parts.empty()) one.fail(place, "a lesson without a part");
        lessons.push_back(std::move(lesson));
    });
    in.nothing_else();
    return lessons;
}

std::filesystem::path lessons_of_the_project() { return std::filesystem::path(SIGHTLINE_EXAMPLES) / "lessons.json"; }

std::string opens(const Lesson& lesson, const LessonPart& part) {
    const std::filesystem::path file = lesson.folder / part.open;
    return part.open.ends_with(".json") && std::filesystem::exists(file) ? file.string() : part.open;
}

}  // namespace sightline
