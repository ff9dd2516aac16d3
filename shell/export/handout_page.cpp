// A hand-out is put into the page that ./run web makes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/file.h"
#include "shell/export/handout.h"

namespace sightline {

namespace {

constexpr std::string_view begin_tag = "<script type=\"application/json\" id=\"handout\">", end_tag = "</script>";

}  // namespace

std::string page_with(std::string_view page, const std::string& handout, const std::string& name) {
    const std::size_t begin = page.find(begin_tag);
    const std::size_t end = begin == std::string_view::npos ? begin : page.find(end_tag, begin);
    if (end == std::string_view::npos)
        throw input_error(name, "", "is no page of Sightline that takes a session: ./run web makes one");
    std::string made(page.substr(0, begin + begin_tag.size()));
    for (const char c : handout)
        if (c == '<')
            made += "\\u003c";  // or the text could end the script
        else
            made += c;
    return made.append(page.substr(end));
}

std::filesystem::path page_of_the_project() { return SIGHTLINE_PAGE; }

template <int D>
void write_page(Workbench<D>& bench, const std::string& file) {
    const std::filesystem::path from = bench.page.empty() ? page_of_the_project() : bench.page;
    if (!std::filesystem::is_regular_file(from))
        throw InputError(bench.page.empty() ? "the page for browsers is not built: ./run web makes it"
                                            : from.string() + ": there is no such page: ./run web makes one");
    const std::string made = page_with(read_file(from), handout_text(bench), from.string());
    write_file(file, made);
    bench.say("wrote " + file + ", " + std::to_string(made.size() / 1024) +
              " KiB: any browser opens it, and shows this");
    if (bench.teaching && !carries_lesson(bench))
        bench.say("the page shows the state, not the lesson, which is not one of the project's");
}

template void write_page<2>(Workbench<2>&, const std::string&);
template void write_page<3>(Workbench<3>&, const std::string&);

}  // namespace sightline
