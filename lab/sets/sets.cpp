// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/sets/sets.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/quote.h"
#include "core/measure/frame_numbers.h"
#include "core/session/settings_table.h"
#include "core/truth/software_ids.h"
#include "lab/measure/measure_path.h"

namespace sightline::lab {

namespace {

using Json = nlohmann::ordered_json;

template <int D>
Json point(const Vec<D>& p) {
    Json json = Json::array();
    for (int i = 0; i < D; ++i) json.push_back(p[i]);
    return json;
}

}  // namespace

std::vector<ObjectSet> by_object(const FrameSets& frame, const Objects& objects) {
    std::map<std::uint32_t, ObjectSet> sums;
    for (const SetEntry& entry : frame.entries) {
        const std::uint32_t object = objects.of[entry.primitive];
        ObjectSet& sum = sums[object];
        sum.object = object;
        sum.visible += entry.visible;
        sum.rendered += entry.rendered;
        sum.missed += entry.missed();
        sum.extra += entry.rendered && !entry.visible;
        sum.pixels += entry.pixels;
        sum.wrong += entry.wrong();
    }
    std::vector<ObjectSet> all;
    for (const auto& [object, sum] : sums) all.push_back(sum);
    return all;
}

template <int D>
PathSets path_sets(const LabScene<D>& lab, const MethodChoice& choice, const Budget& budget, const DrawIds& draw_ids,
                   const std::function<bool(std::size_t)>& go_on) {
    const Scene<D>& scene = *lab.scene;
    const auto count = static_cast<std::uint32_t>(scene.primitives.size());
    const Variant<D> variant = lab.variant_for(choice);
    const CellComplex<D>& cells = lab.on(choice.tessellation);
    const std::uint32_t k = variant.method.budgeted ? std::min(count, budget.primitives(count)) : count;
    const DrawIds drawing = drawing_of(lab.settings.reference, draw_ids);
    PathSets sets;
    sets.method = method_text(choice);
    sets.budget = variant.method.budgeted ? budget_text(budget) : "unlimited";
    sets.objects = all_objects(scene);
    for (std::size_t i = 0; i < lab.views.size(); ++i) {
        const CellComplex<D>* const on[] = {&cells};
        const Reference reference =
            make_truths<D>(scene, on, lab.views[i], lab.settings.reference_size, drawing, false).front().reference;
        sets.reference = reference.name;
        const Services services =
            known_services(std::make_shared<std::vector<std::uint8_t>>(reference.visible), lab.settings.reference_size);
        Problem<D> problem =
            make_problem(variant.method, variant.parameters, scene, cells, lab.views[i], none, services);
        problem.budget = k;
        problem.history = frame_history<D>(variant.method, problem, lab.before[i]);
        const WholeRun run = whole_run<D>(variant.method, problem, reference, false, drawing);
        const std::size_t met = cut_at(run, k).met;
        FrameSets& frame = sets.frames.emplace_back();
        frame.frame = lab.frames[i];
        frame.image_pixels = reference.image.ids.size();
        for (std::size_t m = 0; m < met; ++m)
            if (!run.met[m].culled()) frame.order.push_back(run.met[m].primitive());
        const std::vector<std::uint8_t> rendered = rendered_by(run, met, count);
        for (std::uint32_t p = 0; p < count; ++p)
            if (reference.visible[p] || rendered[p])
                frame.entries.push_back({p, reference.visible[p] != 0, rendered[p] != 0, reference.pixels[p]});
        if (go_on && !go_on(i + 1)) break;
    }
    return sets;
}

std::string primitives_csv(const PathSets& sets) {
    std::string text = "frame,primitive,object,visible,rendered,missed,pixels,wrong_pixels\n";
    for (const FrameSets& frame : sets.frames)
        for (const SetEntry& e : frame.entries)
            text += std::to_string(frame.frame) + ',' + std::to_string(e.primitive) + ',' +
                    csv_field(sets.objects.names[sets.objects.of[e.primitive]]) + ',' + (e.visible ? '1' : '0') + ',' +
                    (e.rendered ? '1' : '0') + ',' + (e.missed() ? '1' : '0') + ',' + std::to_string(e.pixels) + ',' +
                    std::to_string(e.wrong()) + '\n';
    return text;
}

std::string objects_csv(const PathSets& sets) {
    const ObjectRows rows = primitives_of_objects(sets.objects);
    std::string text = "frame,object,primitives,visible,rendered,missed,extra,pixels,wrong_pixels\n";
    for (const FrameSets& frame : sets.frames)
        for (const ObjectSet& sum : by_object(frame, sets.objects))
            text += std::to_string(frame.frame) + ',' + csv_field(sets.objects.names[sum.object]) + ',' +
                    std::to_string(rows.first[sum.object + 1] - rows.first[sum.object]) + ',' +
                    std::to_string(sum.visible) + ',' + std::to_string(sum.rendered) + ',' +
                    std::to_string(sum.missed) + ',' + std::to_string(sum.extra) + ',' + std::to_string(sum.pixels) +
                    ',' + std::to_string(sum.wrong) + '\n';
    return text;
}

template <int D>
std::string sets_json(const PathSets& sets, const LabScene<D>& lab) {
    Json json{{"format", "sightline-sets"},
              {"version", 1},
              {"dimension", D},
              {"scene", lab.name},
              {"primitives", lab.scene->primitives.size()},
              {"path", lab.path},
              {"origin", point<D>(lab.scene->origin)},
              {"method", sets.method},
              {"budget", sets.budget},
              {"reference", sets.reference},
              {"frames", Json::array()}};
    for (std::size_t i = 0; i < sets.frames.size(); ++i) {
        const FrameSets& frame = sets.frames[i];
        const ViewSpec<D>& view = lab.specs[i];
        Json one{{"frame", frame.frame},
                 {"view", {{"eye", point<D>(view.eye)}, {"look_at", point<D>(view.look_at)}, {"fov", view.fov}}},
                 {"image_pixels", frame.image_pixels},
                 {"visible", Json::array()},
                 {"pixels", Json::array()},
                 {"rendered", frame.order},
                 {"missed", Json::array()},
                 {"objects", Json::array()}};
        for (const SetEntry& e : frame.entries) {
            if (e.visible) {
                one["visible"].push_back(e.primitive);
                one["pixels"].push_back(e.pixels);
            }
            if (e.missed()) one["missed"].push_back(e.primitive);
        }
        for (const ObjectSet& sum : by_object(frame, sets.objects))
            one["objects"].push_back({{"object", sets.objects.names[sum.object]},
                                      {"visible", sum.visible},
                                      {"rendered", sum.rendered},
                                      {"missed", sum.missed},
                                      {"extra", sum.extra},
                                      {"pixels", sum.pixels},
                                      {"wrong_pixels", sum.wrong}});
        json["frames"].push_back(std::move(one));
    }
    // A frame a line: files of thousands of frames stay readable and can be taken apart with line tools.
    Json frames = std::move(json["frames"]);
    json.erase("frames");
    const auto line = [](const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); };
    std::string text = line(json);
    text.back() = ',';
    text += "\"frames\":[";
    for (std::size_t i = 0; i < frames.size(); ++i) text += (i > 0 ? ",\n" : "\n") + line(frames[i]);
    return text + "\n]}\n";
}

#define SIGHTLINE_INSTANTIATE(D)                                                                           \
    template PathSets path_sets<D>(const LabScene<D>&, const MethodChoice&, const Budget&, const DrawIds&, \
                                   const std::function<bool(std::size_t)>&);                               \
    template std::string sets_json<D>(const PathSets&, const LabScene<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline::lab
