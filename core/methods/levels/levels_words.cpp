// What the method `levels` says of itself.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/methods/levels/levels_run.h"

namespace sightline {

namespace {

template <int D>
constexpr std::string_view primitive_word = D == 2 ? "segment" : "triangle";

std::string pixels_text(double pixels) {
    if (!(pixels < 1e6)) return "many pixels";
    return short_number(pixels, 2) + (pixels == 1 ? " pixel" : " pixels");
}

}  // namespace

template <int D>
std::uint32_t LevelsRun<D>::place_of(std::uint32_t object) const {
    const auto found = std::find(order_.begin(), order_.end(), object);
    return found == order_.end() ? none : static_cast<std::uint32_t>(found - order_.begin());
}

template <int D>
std::string LevelsRun<D>::object_name(std::uint32_t object) const {
    return "object " + levels_->objects.names[object];
}

template <int D>
double LevelsRun<D>::error_pixels(std::uint32_t object, std::uint32_t level) const {
    return levels_->at(object, level).error * scale_.pixels_per_unit(levels_->boxes[object]);
}

template <int D>
std::string LevelsRun<D>::popped_words(const Step& step) const {
    const std::uint32_t object = step.item.id, place = place_of(object);
    if (place == none || place >= level_of_.size()) return object_name(object);
    const std::uint32_t level = level_of_[place];
    const std::string all = counted(levels_->primitives_of(object).size(), primitive_word<D>);
    std::string text = object_name(object) + ": ";
    if (level > 0)
        text += "level " + std::to_string(level) + ", " + std::to_string(levels_->at(object, level).count()) + " of " +
                all + ", error " + pixels_text(error_pixels(object, level));
    else
        text += "as it is, " + all;
    return text + "; the frame now " + short_number(frame_ms(place + 1, reading_)) + " ms";
}

template <int D>
Verdict LevelsRun<D>::why_not(const Item& item) const {
    if (item.kind == Kind::cell) return {"no-cells", "the method takes objects, not cells"};
    if (item.kind == Kind::object && mark(item).state == CellState::unseen)
        return {"outside-view", "its box lies outside the view"};
    if (item.kind != Kind::primitive || this->drawn_.has(item.id)) return {};
    const Item object{levels_->objects.of[item.id], Kind::object};
    const std::uint32_t place = place_of(object.id);
    if (place == none)
        return {"outside-view", object_name(object.id) + ", which it is a part of, lies outside the view"};
    if (place >= level_of_.size()) return {"waits", object_name(object.id) + ", which it is a part of, waits", object};
    if (level_of_[place] > 0)
        return {"level",
                object_name(object.id) + ", which it is a part of, is drawn at level " +
                    std::to_string(level_of_[place]) + ": as " +
                    counted(levels_->at(object.id, level_of_[place]).count(), primitive_word<D>) + " in place of " +
                    std::to_string(levels_->primitives_of(object.id).size()),
                object};
    return {};
}

template <int D>
Verdict LevelsRun<D>::why_drawn(const Item& item) const {
    if (item.kind != Kind::object) return {};
    const std::uint32_t place = place_of(item.id);
    if (place == none || place >= level_of_.size()) return {};
    const std::uint32_t level = level_of_[place];
    const auto levels = levels_->of(item.id);
    if (level > 0) {
        std::string text = "level " + std::to_string(level) + " of " + std::to_string(levels.size()) +
                           " stands in for it: it is off by no more than " + pixels_text(error_pixels(item.id, level));
        if (level < levels.size()) text += ", the next one by up to " + pixels_text(error_pixels(item.id, level + 1));
        return {"level", std::move(text)};
    }
    if (levels.empty()) return {"no-levels", "it is drawn as it is: it has too few primitives for levels"};
    if (error_pixels(item.id, 1) <= pixel_error_)
        return {"enough", "it is drawn as it is: without it the frame was quick enough already"};
    return {"too-near",
            "it is drawn as it is: its finest level is off by up to " + pixels_text(error_pixels(item.id, 1))};
}

template <int D>
std::vector<CodeLine> LevelsRun<D>::code(const CodePlace& at) const {
    const Counters& counters = this->counters_;
    const bool in_step = at.in_step(), taking = in_step && *at.substep == 0;
    LevelRule rule = LevelRule::outside;
    if (in_step && !at.changes.empty()) rule = LevelRule{at.changes.front().rule};
    std::vector<CodeLine> lines;
    const auto add = [&](std::string text, int indent, bool lit, std::string values = {}, std::string source = {}) {
        lines.push_back({std::move(text), indent, lit, lit ? std::move(values) : std::string(), std::move(source)});
    };
    add("list the objects whose boxes are in the view, the farthest first", 0, false, {}, "DAS 3.1.3");
    add("while one is left:", 0, !in_step && counters.spent < this->problem_.budget,
        std::to_string(counters.front_size) + (counters.front_size == 1 ? " is left" : " are left"));
    add("take the farthest one", 1, taking, at.step ? object_name(at.step->item.id) : "");
    if (target_ms_ > 0)
        add("the frame is predicted to take no longer than " + short_number(target_ms_) + " ms: draw it as it is", 1,
            in_step && !taking && rule == LevelRule::enough,
            at.step ? short_number(frame_ms(at.number, reading_)) + " ms" : "", "DAS 3.1.3");
    add("draw the coarsest level that is off by no more than " + pixels_text(pixel_error_), 1,
        in_step && !taking && rule == LevelRule::coarser,
        at.step && rule == LevelRule::coarser ? "level " + std::to_string(at.changes.front().via) : "");
    add("where there is none, draw it as it is", 1, in_step && !taking && rule == LevelRule::as_it_is,
        counted(at.rendered, "primitive"));
    lines.push_back(budget_line(*this, 1, "", taking, in_step));
    lines.back().source.clear();
    return lines;
}

template <int D>
std::span<const Field<D>> LevelsRun<D>::fields() const {
    static const auto table = std::to_array<Field<D>>(
        {{"distance", "distance", "of the nearest point of the object's box from the eye",
          [](const Run<D>& run, const Item& item) -> std::optional<double> {
              const auto& own = static_cast<const LevelsRun&>(run);
              if (item.kind != Kind::object) return std::nullopt;
              return std::sqrt(squared_distance(own.levels_->boxes[item.id], run.problem().view.eye));
          }},
         {"level", "level", "the level that the object is drawn at; 0: it is drawn as it is",
          [](const Run<D>& run, const Item& item) -> std::optional<double> {
              const auto& own = static_cast<const LevelsRun&>(run);
              if (item.kind != Kind::object || run.mark(item).state != CellState::projected) return std::nullopt;
              return own.level_of_[own.place_of(item.id)];
          }},
         {"error_pixels", "error in pixels", "how many pixels that level may be off",
          [](const Run<D>& run, const Item& item) -> std::optional<double> {
              const auto& own = static_cast<const LevelsRun&>(run);
              if (item.kind != Kind::object || run.mark(item).state != CellState::projected) return std::nullopt;
              const std::uint32_t level = own.level_of_[own.place_of(item.id)];
              return level > 0 ? own.error_pixels(item.id, level) : 0;
          }},
         {"frame_ms", "predicted ms", "what the frame is predicted to take once the object is taken",
          [](const Run<D>& run, const Item& item) -> std::optional<double> {
              const auto& own = static_cast<const LevelsRun&>(run);
              if (item.kind != Kind::object || run.mark(item).state != CellState::projected) return std::nullopt;
              return own.frame_ms(own.place_of(item.id) + 1, own.reading_);
          }}});
    return table;
}

#define SIGHTLINE_INSTANTIATE(D)                                                    \
    template std::uint32_t LevelsRun<D>::place_of(std::uint32_t) const;             \
    template std::string LevelsRun<D>::object_name(std::uint32_t) const;            \
    template double LevelsRun<D>::error_pixels(std::uint32_t, std::uint32_t) const; \
    template std::string LevelsRun<D>::popped_words(const Step&) const;             \
    template Verdict LevelsRun<D>::why_not(const Item&) const;                      \
    template Verdict LevelsRun<D>::why_drawn(const Item&) const;                    \
    template std::vector<CodeLine> LevelsRun<D>::code(const CodePlace&) const;      \
    template std::span<const Field<D>> LevelsRun<D>::fields() const;
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
