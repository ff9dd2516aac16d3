// Lessons as data: parts that open a scene or a state, and in each part what is asked, done and said, press by press.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sightline {

/// One press of the clicker: the question stands there, the press answers it.
struct Beat {
    std::string ask;                      ///< before; empty: the press before this one does it at once
    std::string act;                      ///< commands that the press runs; may be empty
    std::string say;                      ///< after
    bool guess = false;                   ///< the class may take a cell before (GuessScore)
    bool reveal = false;                  ///< the truth is shown from here on
    std::optional<std::uint32_t> key_of;  ///< an exercise: the class finds this cell's key, which is not told before
    std::vector<std::string> shows;       ///< what stands on the screen after it: for the test of the lesson
};

struct LessonPart {
    std::string title;
    int minutes = 0;
    std::string open;        ///< a state file of the lesson's folder, or what the command `open` takes
    std::string act;         ///< commands after that
    std::string panel;       ///< that stays in projector mode; empty: none
    bool concealed = false;  ///< what is visible is not told until a beat reveals it
    std::string notes;       ///< for the speaker
    std::vector<Beat> beats;
};

struct Lesson {
    std::string id, title;
    int dimension = 2;
    std::filesystem::path folder;  ///< of the index
    std::vector<LessonPart> parts;

    int minutes() const;
};

/// An index of lessons (docs/teaching.md). `file` begins every error line. Throws InputError where it cannot be read,
/// is none, or has a lesson without a part.
std::vector<Lesson> read_lessons(const std::filesystem::path& file);

/// Those of the project.
std::filesystem::path lessons_of_the_project();

/// What the command `open` takes for a part.
std::string opens(const Lesson& lesson, const LessonPart& part);

}  // namespace sightline
