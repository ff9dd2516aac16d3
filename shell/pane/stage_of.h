// A viewer's picture and thumbnails as the window takes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/scene/make/catalogue.h"
#include "shell/lesson/lesson.h"
#include "shell/pane/thumbnails.h"
#include "shell/window/stage.h"

namespace sightline {

/// `held` has a `picture` and `thumbnails`, and lives as long as the stage.
template <typename Held>
Stage stage_of(const std::shared_ptr<Held>& held, std::vector<SceneChoice> scenes) {
    Stage stage;
    stage.draw = [held](Ui& ui, const Area& area) { held->picture.draw(ui, area); };
    stage.interact = [held](Ui& ui, const Area& area) {
        held->thumbnails.next_frame();
        held->picture.interact(ui, area);
    };
    stage.cancel = [held] { return held->picture.cancel(); };
    stage.lively = [held] { return held->picture.lively(); };
    stage.scenes = std::move(scenes);
    stage.thumbnail = [held](const SceneChoice& scene, int width, int height) {
        return held->thumbnails.texture(scene, width, height);
    };
    return stage;
}

/// The catalogue's scenes.
template <int D>
void add_catalogue(std::vector<SceneChoice>& scenes) {
    for (const CatalogueRow<D>& row : catalogue<D>()) scenes.push_back({row.id, row.title, row.lesson, "Scenes"});
}

/// Those in which methods fail.
template <int D>
void add_failures(std::vector<SceneChoice>& scenes) {
    for (const CatalogueRow<D>& row : failure_scenes<D>())
        scenes.push_back({row.id, row.title, row.lesson, "Gallery: where methods fail"});
}

/// The lessons of this dimension.
template <int D>
void add_lessons(std::vector<SceneChoice>& scenes) try {
    for (const Lesson& lesson : read_lessons(lessons_of_the_project())) {
        if (lesson.dimension != D) continue;
        const std::string what = counted(lesson.parts.size(), "part") + ", " + counted(lesson.minutes(), "minute") +
                                 ": " + lesson.parts.front().title + " …";
        scenes.push_back({"lesson " + lesson.id, lesson.title, what, "Lessons", "lesson " + lesson.id,
                          opens(lesson, lesson.parts.front())});
    }
} catch (const InputError&) {  // the command `lesson` says what is wrong with them
}

}  // namespace sightline
