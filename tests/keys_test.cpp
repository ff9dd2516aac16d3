// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/keys.h"

#include <gtest/gtest.h>

#include <map>

#include "shell/commands/command_table.h"

namespace sightline {
namespace {

TEST(Keys, NoTwoCommandsShareOne) {
    std::map<std::string, std::string> commands;
    for (const Command<2>& command : command_table<2>())
        for (const KeyBinding& binding : key_bindings(command.id, command.keys)) {
            EXPECT_FALSE(binding.key.empty()) << command.id;
            const auto [other, is_new] = commands.emplace(binding.key, binding.command);
            EXPECT_TRUE(is_new) << binding.key << " runs '" << other->second << "' and '" << binding.command << "'";
        }
    EXPECT_GT(commands.size(), 40u);
}

}  // namespace
}  // namespace sightline
