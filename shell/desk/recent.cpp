// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/recent.h"

#include <algorithm>
#include <filesystem>

#include "core/scene/make/catalogue.h"

namespace sightline {

namespace {

/// The name that opens the same from any folder.
template <int D>
std::string whole_name(const std::string& name) {
    if (find_in_catalogue<D>(name)) return name;
    std::error_code error;
    const auto whole = [&](const std::string& file) { return std::filesystem::absolute(file, error).string(); };
    if (std::filesystem::exists(name, error)) return whole(name);
    const std::size_t hash = name.rfind('#');
    if (hash != std::string::npos && std::filesystem::exists(name.substr(0, hash), error))
        return whole(name.substr(0, hash)) + name.substr(hash);
    return name;
}

/// How many names at the front of the list were put there since it was `known`: the rest are some of those, in order.
std::ptrdiff_t newly_opened(const std::vector<std::string>& list, const std::vector<std::string>& known) {
    auto before = known.rbegin();
    auto name = list.rbegin();
    for (; name != list.rend(); ++name) {
        before = std::find(before, known.rend(), *name);
        if (before == known.rend()) break;
        ++before;
    }
    return list.rend() - name;
}

}  // namespace

std::vector<std::string> merge_recent(const std::vector<std::string>& ours, const std::vector<std::string>& theirs,
                                      const std::vector<std::string>& known) {
    std::vector<std::string> merged;
    const auto add = [&](auto begin, auto end) {
        for (; begin != end; ++begin)
            if (merged.size() < most_recent && std::find(merged.begin(), merged.end(), *begin) == merged.end())
                merged.push_back(*begin);
    };
    const auto here = ours.begin() + newly_opened(ours, known);
    add(ours.begin(), here);
    add(theirs.begin(), theirs.begin() + newly_opened(theirs, known));
    add(here, ours.end());
    return merged;
}

template <int D>
void note_opened(std::vector<std::string>& recent, const std::string& name) {
    const std::string whole = whole_name<D>(name);
    std::erase(recent, whole);
    recent.insert(recent.begin(), whole);
    if (recent.size() > most_recent) recent.resize(most_recent);
}

template void note_opened<2>(std::vector<std::string>&, const std::string&);
template void note_opened<3>(std::vector<std::string>&, const std::string&);

}  // namespace sightline
