// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/page.h"

#include <cmath>

#include "core/base/file.h"
#include "core/base/number.h"

namespace sightline::lab {

namespace {

constexpr const char* style = R"(
:root { color-scheme: light; }
body { font: 15px/1.5 "DejaVu Sans", system-ui, sans-serif; color: #1c2430; max-width: 1000px; margin: 2rem auto;
       padding: 0 1rem; }
h1 { font-size: 1.7rem; margin-bottom: 0; } h2 { margin-top: 2.4rem; border-bottom: 1px solid #ccd; }
h3 { margin-top: 1.6rem; } p.lead { color: #445; margin-top: .3rem; }
table { border-collapse: collapse; margin: .8rem 0; font-size: 13.5px; } caption { text-align: left; color: #445; }
th, td { padding: .25rem .7rem; border-bottom: 1px solid #dde; text-align: right; }
th { background: #f3f5f9; } td.t, th.t { text-align: left; }
figure { margin: 1rem 0; } figure img { width: 100%; } figcaption { color: #445; font-size: 13.5px; }
.pictures { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; } .pictures img { width: 100%; border: 1px solid #ccd; }
code { font-size: 12.5px; background: #f3f5f9; padding: .1rem .3rem; overflow-wrap: anywhere; }
.holds, .not, .noise { white-space: nowrap; } .holds { color: #00713a; } .not { color: #b3261e; font-weight: bold; }
.waits { color: #667; } .surprise { color: #fff; background: #b3261e; font-weight: bold; padding: 0 .3rem; }
section { break-inside: avoid; margin-top: 2.4rem; } p.look { margin-bottom: 0; }
.matrix th, .matrix td { padding: .1rem .45rem; } .matrix thead th { position: sticky; top: 0; }
.matrix td.m, .matrix th.m { text-align: center; white-space: nowrap; } .matrix .group { border-left: 2px solid #ccd; }
.matrix .up { writing-mode: vertical-rl; transform: rotate(180deg); } .matrix small { font-size: 11px; }
.swatch { vertical-align: middle; }
.all { background: #e6f4ea; } .some { background: #fff6da; } .nothing { background: #fce8e6; }
.matrix .alarm { background: #b3261e; }
)";

}  // namespace

std::string per_cent(double share) { return std::isnan(share) ? "–" : short_number(100 * share); }
std::string number(double value) { return std::isnan(value) ? "–" : short_number(value); }
std::string cell(const std::string& text, bool words) {
    return std::string("<td") + (words ? " class=t" : "") + ">" + escaped(text) + "</td>";
}

std::string picture(const std::filesystem::path& file, const std::string& caption) {
    const std::string kind = file.extension() == ".svg" ? "svg+xml" : "png";
    return "<figure><img alt='' src='data:image/" + kind + ";base64," + base64(read_file(file)) + "'><figcaption>" +
           caption + "</figcaption></figure>";
}

std::string page(const std::string& title, const std::string& body) {
    return "<!doctype html><html lang=en><meta charset=utf-8><title>Sightline: " + escaped(title) + "</title><style>" +
           style + "</style><h1>" + escaped(title) + "</h1>" + body + "</html>\n";
}

}  // namespace sightline::lab
