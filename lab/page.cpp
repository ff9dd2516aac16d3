// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/page.h"

#include <cmath>

#include "core/file.h"
#include "core/number.h"

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
.holds { color: #00713a; } .not { color: #b3261e; font-weight: bold; }
)";

std::string base64(const std::string& bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

}  // namespace

std::string escaped(const std::string& text) {
    std::string html;
    for (const char c : text) {
        if (c == '<')
            html += "&lt;";
        else if (c == '>')
            html += "&gt;";
        else if (c == '&')
            html += "&amp;";
        else if (c == '"')
            html += "&quot;";
        else
            html += c;
    }
    return html;
}

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
