// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/listed/listed.h"

#include <filesystem>
#include <typeinfo>

#include "core/base/excerpt.h"
#include "core/base/file.h"
#include "core/base/hash.h"
#include "core/base/made_once.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/methods/orders/order_run.h"

namespace sightline {

namespace {

std::string check_name(const ParameterRow&, std::string_view text) {
    if (!text.empty()) check_file(text);
    return std::string(text);
}

/// A path of the scene has any name: whether there is one is known only with the scene.
std::string check_path(const ParameterRow&, std::string_view text) { return std::string(text); }

const ParameterRow& file_row() {
    static const ParameterRow row =
        text_row("file", "", "a file", "docs/measuring.md, sets of an engine",
                 "JSON or CSV that lists per frame the primitives or objects that were rendered", check_name);
    return row;
}

const ParameterRow& along_row() {
    static const ParameterRow row =
        text_row("along", "", "a path of the scene or a file", "docs/measuring.md, sets of an engine",
                 "the path that the file's frame numbers count in, where it has no views", check_path);
    return row;
}

/// Read once for as long as the file is the same one.
template <typename T, typename Read>
std::shared_ptr<const T> kept(const MadeOnce& cache, const std::string& file, Read read) {
    std::error_code error;
    const auto time = static_cast<long long>(std::filesystem::last_write_time(file, error).time_since_epoch().count());
    const auto size = std::filesystem::file_size(file, error);
    const std::string key = typeid(T).name() + std::to_string(time) + " " + std::to_string(size) + " " + file;
    return cache.of<T>(key, [&] { return read(read_file(file), file); });
}

template <int D>
bool same_view(const ViewSpec<D>& a, const View<D>& b) {
    const auto same = [](double x, double y) { return x == y || static_cast<float>(x) == static_cast<float>(y); };
    for (int i = 0; i < D; ++i)
        if (!same(a.eye[i], b.eye[i]) || !same(a.look_at[i], b.look_at[i])) return false;
    return same(a.fov, b.fov);
}

/// The numbers that the view has in the path `along`.
template <int D>
std::vector<std::uint32_t> numbers_of(const MadeOnce& cache, const Problem<D>& problem, const std::string& along) {
    const Scene<D>& scene = *problem.scene;
    FlightPath<D> path;
    for (const FlightPath<D>& own : scene.paths)
        if (own.id == along) path = own;
    if (path.frames.empty()) {
        path = *kept<FlightPath<D>>(cache, along, read_path<D>);
        set_origin(path, scene.origin);
    }
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < path.frames.size(); ++i)
        if (same_view(path.frames[i], problem.view)) numbers.push_back(i);
    return numbers;
}

/// The primitives listed for the problem's view; `why` says why there are none.
template <int D>
std::vector<std::uint32_t> listed_ids(const MadeOnce& cache, const Problem<D>& problem, std::string& why) {
    const std::string file(problem.parameters.text(file_row())), along(problem.parameters.text(along_row()));
    if (file.empty()) {
        why = "method 'listed' needs file=FILE";
        return {};
    }
    const auto sets = kept<SetsFile<D>>(cache, file, read_sets<D>);
    const Scene<D>& scene = *problem.scene;
    const SetFrame<D>* found = nullptr;
    for (const SetFrame<D>& frame : sets->frames) {
        if (found || !frame.view) continue;
        ViewSpec<D> view = *frame.view;
        view.eye += sets->origin - scene.origin;
        view.look_at += sets->origin - scene.origin;
        if (same_view(view, problem.view)) found = &frame;
    }
    if (!found && !along.empty())
        for (const std::uint32_t number : numbers_of(cache, problem, along))
            for (const SetFrame<D>& frame : sets->frames)
                if (!found && frame.number == number) found = &frame;
    if (!found) {
        std::string eye;
        for (int i = 0; i < D; ++i) eye += (i > 0 ? "," : "") + number_text(problem.view.eye[i] + scene.origin[i]);
        why = excerpt(file) + ": none of its " + counted(sets->frames.size(), "frame") + " has the view from " + eye +
              (along.empty() ? "; does it number frames? Then give along=PATH" : "");
        return {};
    }
    const auto count = static_cast<std::uint32_t>(scene.primitives.size());
    std::vector<std::uint32_t> ids;
    for (const std::uint32_t id : found->primitives) {
        if (id < count)
            ids.push_back(id);
        else if (why.empty())
            why = excerpt(file) + ": lists primitive " + std::to_string(id) + ", and the scene has " +
                  std::to_string(count);
    }
    if (found->objects.empty()) return ids;
    const Objects objects = all_objects(scene);
    const ObjectRows rows = primitives_of_objects(objects);
    for (const std::string& name : found->objects) {
        const std::uint32_t object = object_named(objects, name);
        if (object != none)
            ids.insert(ids.end(), rows.ids.begin() + rows.first[object], rows.ids.begin() + rows.first[object + 1]);
        else if (why.empty())
            why = excerpt(file) + ": lists object '" + excerpt(name) + "', which the scene does not have";
    }
    return ids;
}

}  // namespace

template <int D>
Method<D> listed_method() {
    const auto cache = std::make_shared<const MadeOnce>();
    PrimitiveOrder<D> order;
    order.primitives = [cache](const Problem<D>& problem) {
        std::string why;
        return listed_ids<D>(*cache, problem, why);
    };
    order.culls = false;
    order.code = "take the primitives that the file lists for this view";
    order.when_empty = "none: no frame of the file has this view, or nothing is listed there";
    Method<D> method = order_method<D>(listed_id, "listed",
                                       "what a file lists for the frame, such as an engine's own visible set", order);
    // Told what to draw: what finding it took is not known here, so that it stands for the drawing alone.
    method.needs.visible_set = true;
    method.budgeted = false;
    method.compared = false;
    method.parameters = {&file_row(), &along_row()};
    return method;
}

template <int D>
std::string listed_lacks(const Problem<D>& problem) {
    std::string why;
    listed_ids<D>(MadeOnce(), problem, why);
    return why;
}

std::uint64_t listed_hash(const Parameters& parameters) {
    Hash hash;
    bool any = false;
    for (const ParameterRow* row : {&file_row(), &along_row()}) {
        const std::string file(parameters.text(*row));
        std::error_code error;
        if (file.empty() || !std::filesystem::is_regular_file(file, error)) continue;
        any = true;
        for (const char c : read_file(file)) hash.add(static_cast<std::uint8_t>(c));
    }
    return any ? hash.value() : 0;
}

#define SIGHTLINE_INSTANTIATE(D)           \
    template Method<D> listed_method<D>(); \
    template std::string listed_lacks<D>(const Problem<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
