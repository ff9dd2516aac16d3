// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/draw_ids.h"

#include <memory>

#include "core/base/error.h"
#include "core/truth/software_ids.h"

namespace sightline {

DrawIds draw_ids_with(std::function<IdRenderer&()> renderer, std::function<void(const std::string& line)> warn) {
    const auto missing = std::make_shared<bool>(false);
    return [=](const Scene<3>& scene, const View<3>& view, const ImageSize& size, int layers) {
        IdRenderer* by = nullptr;
        if (!*missing) try {
                by = &renderer();
            } catch (const WorkError& error) {
                *missing = true;
                const std::string why = error.what();
                warn("the reference is drawn in software: " + why.substr(0, why.find('\n')));
            }
        return by ? by->draw(scene, view, size, layers) : draw_ids_in_software(scene, view, size, layers);
    };
}

}  // namespace sightline
