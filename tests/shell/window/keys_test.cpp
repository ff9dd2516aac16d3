// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/keys.h"

#include <gtest/gtest.h>

#include <cctype>
#include <map>

#include "shell/commands/command_table.h"
#include "shell/commands/key_bindings.h"

namespace sightline {
namespace {

/// Every command has an id and keys of its own: the first one of two would hide the other.
template <int D>
void expect_no_two_alike() {
    std::map<std::string, std::string> commands, ids;
    for (const Command<D>& command : command_table<D>()) {
        EXPECT_TRUE(ids.emplace(command.id, command.text).second) << command.id;
        for (const KeyBinding& binding : key_bindings(command.id, command.keys)) {
            EXPECT_FALSE(binding.key.empty()) << command.id;
            const auto [other, is_new] = commands.emplace(binding.key, binding.command);
            EXPECT_TRUE(is_new) << binding.key << " runs '" << other->second << "' and '" << binding.command << "'";
        }
    }
    EXPECT_GT(commands.size(), 40u);
}

TEST(Keys, NoTwoCommandsShareOne) {
    expect_no_two_alike<2>();
    expect_no_two_alike<3>();
}

/// As a keyboard sends it: characters that lie elsewhere on other keyboards as text.
TEST(Keys, CharactersOfCommandsAreHeard) {
    for (const Command<3>& command : command_table<3>())
        for (const KeyBinding& binding : key_bindings(command.id, command.keys)) {
            if (binding.key.size() != 1 || std::isalnum(static_cast<unsigned char>(binding.key[0]))) continue;
            SDL_Event event{};
            event.type = SDL_TEXTINPUT;
            event.text.text[0] = binding.key[0];
            EXPECT_EQ(key_name(event), binding.key) << command.id;
        }
}

/// X sends the text of Ctrl and + too: the scale changes, and the picture must not be zoomed as well.
TEST(Keys, TextThatComesWithCtrlIsNoKey) {
    SDL_Event event{};
    event.type = SDL_TEXTINPUT;
    event.text.text[0] = '+';
    EXPECT_EQ(key_name(event), "+");
    SDL_SetModState(KMOD_LCTRL);
    EXPECT_EQ(key_name(event), "");
    SDL_SetModState(KMOD_NONE);
}

}  // namespace
}  // namespace sightline
