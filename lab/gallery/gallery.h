// The gallery: scenes in which methods fail (field-notes D), what is measured in each, and who is expected to pass.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/scene/make/car_parts.h"
#include "core/scene/scene.h"
#include "core/session/session.h"
#include "core/truth/id_image.h"

namespace sightline::lab {

/// Field-notes D numbers them from 1.
inline constexpr int gallery_numbers = 30;

enum class Expect : std::uint8_t { pass, fail, pending };
enum class Bound : std::uint8_t { at_least, at_most };

struct Expectation {
    /// A method and settings over those of the row: "published penalty=none". Also "loader", "cells" and "reference",
    /// which are measured without one, and with Expect::pending a method that the table does not have yet.
    const char* subject;
    Expect expect;
    const char* measure;  ///< id of gallery_measures (gallery_measures.h)
    Bound bound;
    double threshold;
    const char* means;  ///< what the threshold tells apart
};

template <int D>
struct GalleryRow {
    const char* id;
    int number;                         ///< in field-notes D
    const char* scene;                  ///< of the catalogue, with a size where it has one
    std::vector<const char*> settings;  ///< FIELD=VALUE over the catalogue's
    const char* look;                   ///< caption: what to look at, one line
    const char* until;                  ///< condition (session/condition.h) of the step that shows it; empty: the end
    std::vector<Expectation> expectations;
    std::optional<ViewSpec<D>> view{};                               ///< unless the scene's own
    std::optional<ViewSpec<D>> to{};                                 ///< where a walk from the view ends
    std::vector<CarPart> (*parts)(const Scene<D>& scene) = nullptr;  ///< where measures split by part
};

/// All rows by number.
template <int D>
std::span<const GalleryRow<D>> gallery();
template <>
std::span<const GalleryRow<2>> gallery<2>();
template <>
std::span<const GalleryRow<3>> gallery<3>();

struct Verdict {
    /// asked: of a method beside the gallery's own, of which nothing is expected.
    enum class Kind : std::uint8_t { expected, surprise, pending, asked };
    Kind kind = Kind::expected;
    const Expectation* expectation = nullptr;
    double value = 0;  ///< NaN when pending, or when there is no such number
    bool passed = false;
    std::string subject{};  ///< the expectation's, or the method that was asked for
};

/// Whether a value keeps to the bound; NaN never does.
bool passes(const Expectation& expectation, double value);

/// A value against what is expected of it. `known`: whether there is such a subject: a pending one that has come is a
/// surprise, so that somebody writes down what is expected of it, and so is one that has gone.
Verdict judge(const Expectation& expectation, bool known, double value);

/// Measures one row; `also` are variants held to what is asked of `published`. Numbers only, no clock. Throws
/// InputError for a row that names what does not exist.
template <int D>
std::vector<Verdict> measure_row(const GalleryRow<D>& row, const DrawIds& draw_ids,
                                 std::span<const Method<D>> methods = method_table<D>(),
                                 std::span<const std::string> also = {});

/// "passes", "fails", "pending" or "SURPRISE".
const char* verdict_word(const Verdict& verdict);

/// The row as a session: the first subject that is to fail, else the first that is measured, at the step that `until`
/// names, with the caption as a note and as a bookmark.
template <int D>
Session<D> gallery_session(const GalleryRow<D>& row, const DrawIds& draw_ids,
                           std::span<const Method<D>> methods = method_table<D>());

}  // namespace sightline::lab
