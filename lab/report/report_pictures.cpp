// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/report_pictures.h"

#include <algorithm>

#include "lab/report/chart.h"
#include "lab/report/key_chart.h"

namespace sightline::lab {

namespace {

/// The row in the middle of a method's budgets, where anything is wrong.
std::vector<const Row*> middle_rows(const Group& group) {
    std::vector<const Row*> chosen;
    for (std::size_t i = 0; i < group.rows.size();) {
        std::size_t end = i;
        while (end < group.rows.size() && group.rows[end]->method == group.rows[i]->method) ++end;
        const Row* const row = group.rows[i + (end - i) / 2];
        if (row->approximate && worst(*row, Measure::wrong) != 0) chosen.push_back(row);
        i = end;
    }
    return chosen;
}

template <int D>
void draw(const Group& group, const std::vector<Claim>& claims, const Study& study, const std::filesystem::path& folder,
          LabGraphics& graphics, ReportPictures& pictures) {
    const LabScene<D> lab = load_lab_scene<D>(group.scene, group.path, study);
    const auto worst_of = [&](const Row& row, const std::string& name) {
        return draw_frame<D>(lab, study, row, worst_frame(row, Measure::wrong), folder / (file_stem(name) + ".png"),
                             graphics);
    };
    for (const Row* row : middle_rows(group))
        pictures.worst.push_back(worst_of(*row, group.scene + "-" + group.path + "-" + method_text(row->method)));
    for (NamedChart& chart : key_charts<D>(lab, group, graphics.draw_ids())) pictures.keys.push_back(std::move(chart));
    for (std::size_t i = 0; i < claims.size(); ++i)
        if (const Row* row = row_to_show(claims[i]); row && std::count(group.rows.begin(), group.rows.end(), row) > 0)
            pictures.claims[i] = worst_of(*row, "claim-" + std::to_string(i + 1));
}

}  // namespace

ReportPictures draw_report_pictures(const Results& results, const std::vector<Claim>& claims, const Study& study,
                                    const std::filesystem::path& folder, LabGraphics& graphics) {
    ReportPictures pictures;
    std::filesystem::create_directories(folder);
    for (const Group& group : groups(results))
        if (parse_scene(group.scene).dimension == 2)
            draw<2>(group, claims, study, folder, graphics, pictures);
        else
            draw<3>(group, claims, study, folder, graphics, pictures);
    return pictures;
}

}  // namespace sightline::lab
