// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/open_scene.h"

#include <filesystem>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/stopwatch.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "core/session/condition.h"
#include "core/session/start_settings.h"
#include "core/space/cells_file.h"

namespace sightline {

template <int D>
std::optional<std::string> state_text(const std::string& name) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(name, error) || find_in_catalogue<D>(name)) return std::nullopt;
    std::string text = read_file(name);
    // Both kinds of JSON say at the top what they are; the rest is the readers' matter.
    if (text.substr(0, 200).find("\"sightline-state\"") == std::string::npos) return std::nullopt;
    return text;
}

template <int D>
Settings start_settings(const std::string& name, bool in_window) {
    Settings settings = catalogue_settings<D>(name);
    if (D == 2 && in_window && settings.label == CellNumber::none) settings.label = CellNumber::solidity;
    return settings;
}

template <int D>
Session<D> open_scene(const std::string& name, const Settings& settings, std::span<const Method<D>> methods,
                      const std::function<void(const std::string&)>& warn, const Graphics& graphics,
                      const std::string& cells, const ChooseView<D>& look, bool choose_view) {
    const Stopwatch reading;
    LoadOptions options = read_options(settings, graphics.progress);
    options.choose_view = choose_view;
    auto scene = std::make_shared<const Scene<D>>(load_scene<D>(name, options));
    double read_ms = reading.milliseconds();
    for (const std::string& warning : scene->warnings) warn(warning);
    if (const Dropped& d = scene->dropped; d.total() > 0)
        warn(name + ": dropped " + std::to_string(d.degenerate) + (D == 2 ? " of zero length, " : " of zero area, ") +
             std::to_string(d.duplicate) + " duplicates, " + std::to_string(d.not_finite) + " not finite");
    ViewSpec<D> view;
    view.look_at.x = 1;
    if (scene->start_view) view = *scene->start_view;
    if (look) view = look(view, *scene);
    std::shared_ptr<const CellComplex<D>> at_hand;
    if (!cells.empty()) {
        report(graphics.progress, "reading the cells", 0);
        const Stopwatch also;
        at_hand = std::make_shared<const CellComplex<D>>(read_cells<D>(cells, *scene, settings));
        read_ms += also.milliseconds();
    }
    Session<D> session(scene, view, settings, methods, graphics.draw_ids, graphics.progress, std::move(at_hand));
    session.times().read = read_ms;
    return session;
}

template <int D>
void add_bookmarks(Session<D>& session) {
    const CatalogueRow<D>* row = find_in_catalogue<D>(session.scene().id);
    if (!row || session.scene().source != "generated") return;
    Session<D> scout = session;
    for (const CatalogueBookmark& bookmark : row->bookmarks) {
        const Condition<D> condition(bookmark.condition);
        scout.seek(0);
        if (run_until(scout, condition) == Stop::breakpoint)
            session.bookmarks.push_back({scout.position(), bookmark.label});
    }
}

template <int D>
std::shared_ptr<const Scene<D>> reread(const std::shared_ptr<const Scene<D>>& scene, const Settings& settings) {
    if (D == 2 && scene->source != "wad" && scene->source != "geojson") return scene;
    if (scene->name.empty()) throw InputError("the scene's file is unknown, so it cannot be read again");
    return std::make_shared<const Scene<D>>(load_scene<D>(scene->name, read_options(settings)));
}

#define SIGHTLINE_INSTANTIATE(D)                                                                       \
    template std::optional<std::string> state_text<D>(const std::string&);                             \
    template Settings start_settings<D>(const std::string&, bool);                                     \
    template Session<D> open_scene<D>(const std::string&, const Settings&, std::span<const Method<D>>, \
                                      const std::function<void(const std::string&)>&, const Graphics&, \
                                      const std::string&, const ChooseView<D>&, bool);                 \
    template void add_bookmarks<D>(Session<D>&);                                                       \
    template std::shared_ptr<const Scene<D>> reread<D>(const std::shared_ptr<const Scene<D>>&, const Settings&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
