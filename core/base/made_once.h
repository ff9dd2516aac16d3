// Things that take time to make and are asked for again, by a text that says all that they depend on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace sightline {

/// Keeps the few that were asked for last. Any thread may ask; one makes, the others wait. The same text must always
/// name the same type.
class MadeOnce {
public:
    template <typename T, typename Make>
    std::shared_ptr<const T> of(const std::string& text, Make make) const {
        const std::lock_guard lock(mutex_);
        const auto known =
            std::find_if(kept_.begin(), kept_.end(), [&](const auto& kept) { return kept.first == text; });
        if (known != kept_.end()) {
            std::rotate(known, known + 1, kept_.end());
            return std::static_pointer_cast<const T>(kept_.back().second);
        }
        auto made = std::make_shared<const T>(make());
        if (kept_.size() == most) kept_.erase(kept_.begin());
        kept_.emplace_back(text, made);
        return made;
    }

private:
    static constexpr std::size_t most = 8;
    mutable std::mutex mutex_;
    mutable std::vector<std::pair<std::string, std::shared_ptr<const void>>> kept_;
};

}  // namespace sightline
