// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands/key_bindings.h"

#include <algorithm>
#include <utility>

namespace sightline {

std::vector<KeyBinding> key_bindings(std::string_view id, std::string_view keys) {
    std::vector<KeyBinding> bindings;
    while (!keys.empty()) {
        const std::size_t end = std::min(keys.find(' '), keys.size());
        const std::string_view item = keys.substr(0, end);
        const std::size_t equals = item.find('=');
        KeyBinding binding{std::string(item.substr(0, equals)), std::string(id), false};
        if (equals != std::string_view::npos) {
            const std::string_view argument = item.substr(equals + 1);
            binding.asks = argument == "?";
            if (!binding.asks) binding.command += " " + std::string(argument);
        }
        bindings.push_back(std::move(binding));
        keys.remove_prefix(std::min(end + 1, keys.size()));
    }
    return bindings;
}

}  // namespace sightline
