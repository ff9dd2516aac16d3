// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/gallery/gallery_report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/number.h"
#include "lab/gallery/gallery_measures.h"
#include "lab/report/method_looks.h"
#include "lab/report/page.h"

namespace sightline::lab {

namespace {

/// A measure as the page names it; both dimensions have the same.
struct MeasureText {
    std::string name;
    std::string_view unit, formula;
};

MeasureText text_of(std::string_view id) {
    for (const MeasureRow& row : measure_table())
        if (row.id == id) return {std::string(row.title), row.unit, row.formula};
    for (const GalleryMeasure<2>& measure : gallery_measures<2>()) {
        if (measure.id != id) continue;
        MeasureText text{std::string(id), measure.unit, measure.formula};
        std::replace(text.name.begin(), text.name.end(), '_', ' ');
        return text;
    }
    return {std::string(id), "", ""};
}

/// The text on one line: with spaces at which nothing breaks.
std::string unbroken(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == ' ' ? std::string("\u00a0") : std::string(1, c);
    return result;
}

/// Shares in per cent.
std::string value_text(double value, std::string_view unit) {
    if (std::isnan(value)) return "–";
    if (std::isinf(value)) return "∞";
    if (unit == "share") return per_cent(value) + " %";
    return number(value) + (unit.empty() ? "" : " " + std::string(unit));
}

std::string bound_cell(const Expectation& e) {
    return (e.bound == Bound::at_least ? "at least " : "at most ") + value_text(e.threshold, text_of(e.measure).unit);
}

/// The first word of a subject, and the settings after it.
std::pair<std::string, std::string> parts_of(const std::string& subject) {
    const std::size_t space = subject.find(' ');
    return space == std::string::npos ? std::pair(subject, std::string())
                                      : std::pair(subject.substr(0, space), subject.substr(space + 1));
}

bool is_of_table(const std::string& id) {
    for (const Method<2>& method : method_table<2>())
        if (method.id == id) return true;
    return false;
}

/// A sample of line and marker for each method and variant of an entry, by subject.
std::map<std::string, std::string> swatches_of(const GalleryEntry& entry) {
    std::vector<std::string> variants;
    for (const Verdict& verdict : entry.verdicts)
        if (is_of_table(parts_of(verdict.subject).first)) variants.push_back(verdict.subject);
    const std::vector<VariantLook> looks = variant_looks(variants);
    std::map<std::string, std::string> swatches;
    for (std::size_t i = 0; i < looks.size(); ++i) swatches.emplace(variants[i], swatch(looks[i]));
    return swatches;
}

bool is_surprise(const Verdict& verdict) { return verdict.kind == Verdict::Kind::surprise; }
bool is_beside(const Verdict& verdict) { return verdict.kind == Verdict::Kind::asked; }
bool is_pending(const Verdict& verdict) { return verdict.kind == Verdict::Kind::pending; }

/// The class of a verdict, for its colour.
const char* look_of(const Verdict& verdict) {
    if (is_surprise(verdict)) return "surprise";
    if (is_pending(verdict)) return "waits";
    return verdict.passed ? "holds" : "not";
}

const char* symbol_of(const Verdict& verdict) {
    if (is_pending(verdict)) return "○";
    return verdict.passed ? "✓" : "✗";
}

std::string mark(const Verdict& verdict) {
    const Expectation& e = *verdict.expectation;
    const MeasureText measure = text_of(e.measure);
    const std::string says = verdict.subject + ": " + measure.name + " " +
                             (is_pending(verdict) ? "" : value_text(verdict.value, measure.unit) + ", ") +
                             bound_cell(e);
    return std::string("<span class=") + look_of(verdict) + " title=\"" + escaped(says) + "\">" + symbol_of(verdict) +
           (is_surprise(verdict) ? "!" : "") + "</span>";
}

/// Columns of the matrix: methods that exist, what is measured without one, methods that do not exist yet.
struct Columns {
    std::vector<std::string> groups[3];
};

Columns columns_of(std::span<const GalleryEntry> entries) {
    std::vector<std::string> order;
    for (const Method<2>& method : method_table<2>()) order.emplace_back(method.id);
    const std::size_t methods = order.size();
    for (const char* without : {"reference", "cells", "loader"}) order.emplace_back(without);
    const std::size_t known = order.size();
    std::vector<bool> used(known);
    for (const GalleryEntry& entry : entries)
        for (const Verdict& verdict : entry.verdicts) {
            if (is_beside(verdict)) continue;
            const std::string id = parts_of(verdict.subject).first;
            const auto found = std::find(order.begin(), order.end(), id);
            if (found == order.end())
                order.push_back(id);
            else if (const auto at = static_cast<std::size_t>(found - order.begin()); at < known)
                used[at] = true;
        }
    Columns columns;
    for (std::size_t i = 0; i < order.size(); ++i)
        if (i >= known || used[i]) columns.groups[i < methods ? 0 : i < known ? 1 : 2].push_back(order[i]);
    return columns;
}

/// What one column says of one scene: marks, those with settings of their own smaller and after the others.
std::string matrix_cell(const GalleryEntry& entry, const std::string& id, bool first_of_group) {
    std::string plain, varied;
    std::size_t passed = 0, measured = 0;
    bool surprise = false;
    for (const Verdict& verdict : entry.verdicts) {
        const auto [subject, settings] = parts_of(verdict.subject);
        if (subject != id || is_beside(verdict)) continue;
        surprise = surprise || is_surprise(verdict);
        (settings.empty() ? plain : varied) += mark(verdict);
        if (!settings.empty() || is_pending(verdict)) continue;
        ++measured;
        passed += verdict.passed;
    }
    std::string look = "m";
    if (surprise)
        look += " alarm";
    else if (measured > 0)
        look += passed == measured ? " all" : passed == 0 ? " nothing" : " some";
    if (first_of_group) look += " group";
    return "<td class='" + look + "'>" + plain + (varied.empty() ? "" : " <small>" + varied + "</small>") + "</td>";
}

/// How often a method passes with the settings of the scene.
std::string tally(std::span<const GalleryEntry> entries, const std::string& id) {
    std::size_t passed = 0, measured = 0;
    for (const GalleryEntry& entry : entries)
        for (const Verdict& verdict : entry.verdicts) {
            if (id != verdict.subject || is_pending(verdict) || is_beside(verdict)) continue;
            ++measured;
            passed += verdict.passed;
        }
    return measured > 0 ? std::to_string(passed) + "/" + std::to_string(measured) : "";
}

std::string anchor(const GalleryEntry& entry) {
    std::string id = entry.name;
    std::replace(id.begin(), id.end(), ':', '-');
    return id;
}

std::string plain_name(const GalleryEntry& entry) { return entry.name.substr(entry.name.find(':') + 1); }

std::string matrix(std::span<const GalleryEntry> entries) {
    static constexpr const char* titles[] = {"methods", "independent of the method", "not implemented yet"};
    const Columns columns = columns_of(entries);
    std::string top = "<tr><th colspan=3></th>", heads = "<tr><th></th><th class=t>scene</th><th></th>", body, sums;
    for (std::size_t g = 0; g < 3; ++g) {
        if (columns.groups[g].empty()) continue;
        top += "<th class='m group' colspan=" + std::to_string(columns.groups[g].size()) + ">" + titles[g] + "</th>";
        for (const std::string& id : columns.groups[g]) {
            const std::string group = id == columns.groups[g].front() ? " group" : "";
            heads += "<th class='m" + group + "'><span class=up>" + escaped(id) + "</span></th>";
            sums += "<th class='m" + group + "'>" + tally(entries, id) + "</th>";
        }
    }
    for (const GalleryEntry& entry : entries) {
        body += "<tr><td>" + std::to_string(entry.number) + "</td><td class=t><a href='#" + anchor(entry) + "'>" +
                escaped(plain_name(entry)) + "</a></td><td>" + std::to_string(entry.dimension) + "D</td>";
        for (const std::vector<std::string>& group : columns.groups)
            for (const std::string& id : group) body += matrix_cell(entry, id, id == group.front());
        body += "</tr>";
    }
    std::string who;
    for (const Method<2>& method : method_table<2>())
        if (const auto& used = columns.groups[0]; std::find(used.begin(), used.end(), method.id) != used.end())
            who += (who.empty() ? "" : "; ") + swatch(variant_looks(std::vector{std::string(method.id)}).front()) +
                   "<b>" + std::string(method.id) + "</b>: " + escaped(method.sentence);
    return "<h2>Which method passes where</h2><p>One mark per expectation: <span class=holds>✓</span> the method keeps "
           "to "
           "the bound, <span class=not>✗</span> it does not, <span class=waits>○</span> the method does not exist "
           "yet. Small marks are runs with other settings, which the scene's table names; colours and "
           "the last line leave them out: <span class=all>all</span>, <span class=some>some</span> or <span "
           "class=nothing>none</span> of the bounds are kept. Both ✓ and ✗ are expected results; an unexpected one "
           "is a <span class=surprise>surprise!</span></p><p>" +
           who + ".</p><table class=matrix><thead>" + top + "</tr>" + heads + "</tr></thead><tbody>" + body +
           "</tbody><tfoot><tr><th colspan=3 class=t>passes</th>" + sums + "</tr></tfoot></table>";
}

std::string table_of(const GalleryEntry& entry) {
    std::string html =
        "<table><tr><th class=t>method</th><th class=t>measure</th><th>value</th><th>bound</th><th class=t>to pass "
        "means"
        "</th><th class=t>result</th></tr>";
    std::map<std::string, std::string> swatches = swatches_of(entry);
    for (const Verdict& verdict : entry.verdicts) {
        const Expectation& e = *verdict.expectation;
        const auto [subject, settings] = parts_of(verdict.subject);
        const MeasureText measure = text_of(e.measure);
        std::string result = unbroken(std::string(symbol_of(verdict)) + " " + verdict_word(verdict));
        if (is_surprise(verdict))
            result += e.expect == Expect::pending
                          ? ": it exists now"
                          : std::string(": was expected to ") + (e.expect == Expect::pass ? "pass" : "fail");
        html += "<tr><td class=t>" + swatches[verdict.subject] + escaped(subject) +
                (settings.empty() ? "" : " <code>" + escaped(settings) + "</code>") + "</td>" +
                cell(unbroken(measure.name), true) +
                cell(is_pending(verdict) ? "" : unbroken(value_text(verdict.value, measure.unit))) +
                cell(unbroken(bound_cell(e))) + cell(e.means, true) + "<td class='t " + look_of(verdict) + "'>" +
                result + "</td></tr>";
    }
    return html + "</table>";
}

std::string section(const GalleryEntry& entry) {
    std::string html = "<section id='" + anchor(entry) + "'><h3>" + std::to_string(entry.number) + " · " +
                       escaped(plain_name(entry)) + ", " + std::to_string(entry.dimension) +
                       "D</h3><p class=look><b>Look:</b> " + escaped(entry.look) + ".</p><p class=lead>The scene, " +
                       escaped(entry.title) + ": " + escaped(entry.lesson) + "</p>";
    html += "<div class=pictures>";
    for (const GalleryPicture& p : entry.pictures) html += picture(p.file, escaped(p.caption));
    html += "</div>" + table_of(entry);
    if (!entry.command.empty()) html += "<p>To open it at this step: <code>" + escaped(entry.command) + "</code></p>";
    return html + "</section>";
}

/// Of the measures that the page uses, in the order of their first use.
std::string measures(std::span<const GalleryEntry> entries) {
    std::vector<std::string_view> ids;
    for (const GalleryEntry& entry : entries)
        for (const Verdict& verdict : entry.verdicts)
            if (std::find(ids.begin(), ids.end(), verdict.expectation->measure) == ids.end())
                ids.push_back(verdict.expectation->measure);
    std::string html =
        "<h2>What the numbers mean</h2><p>S is the scene, k the budget, V the set of primitives that are really "
        "visible, "
        "T_k what is drawn within the budget, ε the coverage, |V ∩ T_k| / |V|. Shares are in per cent.</p>"
        "<table><tr><th class=t>measure</th><th class=t>unit</th><th class=t>is</th></tr>";
    for (const std::string_view id : ids) {
        const MeasureText text = text_of(id);
        html += "<tr>" + cell(text.name, true) + cell(std::string(text.unit), true) +
                cell(std::string(text.formula), true) + "</tr>";
    }
    return html + "</table>";
}

}  // namespace

GalleryCounts count(std::span<const GalleryEntry> entries) {
    GalleryCounts counts;
    for (const GalleryEntry& entry : entries) {
        ++counts.scenes;
        for (const Verdict& verdict : entry.verdicts) {
            counts.expectations += !is_beside(verdict);
            counts.pending += is_pending(verdict);
            counts.surprises += is_surprise(verdict);
        }
    }
    return counts;
}

std::string counts_text(const GalleryCounts& counts) {
    return std::to_string(counts.scenes) + " scenes, " + std::to_string(counts.expectations) + " expectations, " +
           std::to_string(counts.pending) + " pending, " + std::to_string(counts.surprises) + " surprises";
}

std::string gallery_page(std::span<const GalleryEntry> entries, const std::string& conditions) {
    const GalleryCounts counts = count(entries);
    std::string html =
        "<p class=lead>Small scenes, each with something that a method is known to get wrong, and the measure that "
        "exposes it. " +
        escaped(conditions) + "</p><p class='" + (counts.surprises > 0 ? "surprise" : "holds") + "'><b>" +
        counts_text(counts) + "</b></p>" + matrix(entries) + "<h2>The scenes</h2>";
    for (const GalleryEntry& entry : entries) html += section(entry);
    return page("Where methods fail", html + measures(entries));
}

}  // namespace sightline::lab
