// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/compare.h"

#include "core/base/error.h"
#include "shell/desk/moved.h"
#include "shell/desk/moves.h"

namespace sightline {

namespace {

/// Differences in more settings than these make no title.
constexpr std::size_t most_in_title = 2;

/// A setting as it is said of one side: "no penalty", "penalty=add".
std::string setting_words(const SettingPair& pair, const std::string& own) {
    if (pair.name == "penalty" && own == "none") return "no penalty";
    if (pair.name == "penalty" && (pair.left == "none" || pair.right == "none")) return "penalty";
    return std::string(pair.name) + "=" + own;
}

template <int D>
Other<D>& need_other(Workbench<D>& bench) {
    if (!bench.other) throw InputError("nothing to compare with: use compare first");
    return *bench.other;
}

}  // namespace

template <int D>
void compare_with(Workbench<D>& bench, Session<D> other, const std::string& title, Align align) {
    const Session<D>& lead = bench.session;
    if (other.shared_scene() != lead.shared_scene() && scene_hash(other.scene()) == scene_hash(lead.scene()))
        other.set_scene(lead.shared_scene());
    bench.other = Other<D>{std::move(other), align, title, lead.shared_scene(), lead.culling_view()};
    if (bench.record_ahead) record_whole_run(bench.other->session);
    ++bench.run;
    moved(bench);
    const auto titles = side_titles(bench);
    bench.say("left: " + titles[0] + ", right: " + titles[1] + ". " +
              (lead.flying() ? "" : so_far_sentence(lead, bench.other->session)));
}

template <int D>
void compare_settings(Workbench<D>& bench, const Settings& settings, const std::string& title) {
    Session<D> other = bench.session;
    other.change(settings);
    compare_with(bench, std::move(other), title, bench.other ? bench.other->align : Align::step);
}

template <int D>
void compare_off(Workbench<D>& bench) {
    bench.other.reset();
    moved(bench);
}

template <int D>
void align_with(Workbench<D>& bench, Align align) {
    need_other(bench).align = align;
    moved(bench);
    bench.say(align_sentence(bench.session, bench.other->session, align));
}

template <int D>
const Difference& first_difference(const Workbench<D>& bench) {
    const Other<D>& other = *bench.other;
    if (other.difference && other.difference->run == bench.run) return *other.difference;
    const auto compare = [&](const Session<D>& left, const Session<D>& right) {
        const auto step = sightline::first_difference(left, right);
        return Difference{step.value_or(none),
                          step ? difference_sentence(left, right, *step)
                               : "Both agree to the end, step " + std::to_string(left.recorded()) + ".",
                          bench.run};
    };
    other.difference = bench.record_ahead ? compare(bench.session, other.session)
                                          : compare(at_the_end(bench.session), at_the_end(other.session));
    return *other.difference;
}

template <int D>
void go_to_difference(Workbench<D>& bench) {
    Other<D>& other = need_other(bench);
    const Difference difference = first_difference(bench);
    bench.say(difference.sentence);
    if (difference.step == none) return;
    go_to_step(bench, difference.step);
    other.session.seek(difference.step);  // whatever the right side is aligned by
}

template <int D>
void swap_sides(Workbench<D>& bench) {
    Other<D>& other = need_other(bench);
    Session<D>&left = bench.session, &right = other.session;
    const auto titles = side_titles(bench);
    std::swap(left, right);
    std::swap(left.breakpoints, right.breakpoints);
    std::swap(left.bookmarks, right.bookmarks);
    other.title = titles[0];
    other.lead_scene = left.shared_scene();
    other.lead_view = left.culling_view();
    bench.history = {};
    traversal_changed(bench);
}

std::vector<SettingPair> different_settings(const Settings& left, const Settings& right) {
    std::vector<SettingPair> pairs;
    for (const SettingRow& row : settings_table())
        if (row.invalidates > Invalidates::picture && row.get(left) != row.get(right))
            pairs.push_back({row.name, row.get(left), row.get(right)});
    return pairs;
}

template <int D>
std::array<std::string, 2> side_titles(const Workbench<D>& bench) {
    const Session<D>&left = bench.session, &right = bench.other->session;
    const auto pairs = different_settings(left.settings(), right.settings());
    std::array<std::string, 2> titles;
    const auto add = [&](const std::string& left_words, const std::string& right_words) {
        titles[0] += (titles[0].empty() ? "" : ", ") + left_words;
        titles[1] += (titles[1].empty() ? "" : ", ") + right_words;
    };
    if (left.scene().id != right.scene().id) add(left.scene().id, right.scene().id);
    if (pairs.size() <= most_in_title) {
        for (const SettingPair& pair : pairs)
            if (pair.name == "method")
                add(std::string(left.method().title), std::string(right.method().title));
            else
                add(setting_words(pair, pair.left), setting_words(pair, pair.right));
    }
    if (titles[0].empty()) add("left", bench.other->title);
    return titles;
}

std::string SideHead::text() const { return title + " · " + drawn + (visible.empty() ? "" : " · " + visible); }

template <int D>
SideHead side_head(const Session<D>& session, std::string title) {
    SideHead head{std::move(title), std::to_string(session.counters().drawn()) + " drawn", ""};
    // A frame of a flight does not wait for the exact image.
    if (session.settings().show_visibility == Switch::on && (!session.flying() || session.has_reference()))
        head.visible = std::to_string(session.visible_rendered()) + " of " + std::to_string(session.reference().count) +
                       " visible";
    return head;
}

#define SIGHTLINE_INSTANTIATE(D)                                                           \
    template SideHead side_head<D>(const Session<D>&, std::string);                        \
    template void compare_with<D>(Workbench<D>&, Session<D>, const std::string&, Align);   \
    template void compare_settings<D>(Workbench<D>&, const Settings&, const std::string&); \
    template void compare_off<D>(Workbench<D>&);                                           \
    template void align_with<D>(Workbench<D>&, Align);                                     \
    template const Difference& first_difference<D>(const Workbench<D>&);                   \
    template void go_to_difference<D>(Workbench<D>&);                                      \
    template void swap_sides<D>(Workbench<D>&);                                            \
    template std::array<std::string, 2> side_titles<D>(const Workbench<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
