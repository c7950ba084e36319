// The page and the files beside it.
#include "experiment/page.h"

#include "experiment/machine.h"
#include "experiment/methods.h"
#include "experiment/record.h"
#include "image/atomic_file.h"
#include "image/exr.h"
#include "image/png.h"
#include "report/assets.h"
#include "report/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string_view>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

/// Beside the look of all pages.
constexpr std::string_view kStyle = R"(
body { max-width: 76rem; margin: 0 auto; padding: 1rem; }
a { color: var(--accent); }
h2 { margin-top: 3rem; border-top: 1px solid var(--line); padding-top: 1rem; }
nav { display: flex; flex-wrap: wrap; gap: 0 .8em; }
blockquote { border-left: 4px solid var(--accent); margin: 1em 0; padding: .1em 1em; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .85rem; font-variant-numeric: tabular-nums; }
.caption { font-weight: 600; font-size: .85rem; margin-bottom: .3em; }
th, td { padding: .25em .7em; border-bottom: 1px solid var(--line); text-align: left; }
th.number, td.number { text-align: right; } td:first-child { white-space: nowrap; }
.row { display: grid; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr)); gap: .6rem; }
figure { margin: 0 0 1rem; } figure img { width: 100%; }
figcaption { font-size: .8rem; color: var(--quiet); }
svg { max-width: 100%; height: auto; }
)";

void write_text(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    write_file(path.string(), text);
}

/// Returns the stops that map the 97% quantile of the pixels to 0.85.
float exposure_of(const Reference& reference) {
    std::vector<double> sorted = reference.picture.luminance;
    std::sort(sorted.begin(), sorted.end());
    const double bright = sorted[sorted.size() * 97 / 100];
    return bright > 0 ? static_cast<float>(std::log2(0.85 / bright)) : 0;
}

/// Returns the caption without the scene.
std::string label_of(const ShownPicture& shown, const PictureRow& row) {
    const std::string scene = row.scene + ", ";
    return shown.caption.starts_with(scene) ? shown.caption.substr(scene.size()) : shown.caption;
}

/// Writes the page that compares a row with the reference. @return a link to it.
std::string comparison_html(const Results& results, const PictureRow& row) {
    const RunSettings& settings = results.settings();
    const std::string reference = results.facts(reference_cell(row.scene, settings)).picture;
    std::set<std::string> done = {reference};
    std::vector<CompareInput> others;
    for (const ShownPicture& shown : row.pictures)
        if (done.insert(shown.file).second) others.push_back({label_of(shown, row), shown.file});
    const std::string name = "compare/" + row.name + ".html";
    write_text(fs::path(settings.folder) / name,
               report_page(compare({row.scene + ", reference", reference}, others)));
    return fmt::format("<p><a href=\"{}\">Over the reference, pixel by pixel</a></p>\n",
                       escaped(name));
}

std::string pictures_html(const Results& results, const Section& section) {
    std::string html;
    for (const PictureRow& row : section.rows) {
        const float exposure = exposure_of(results.reference(row.scene));
        html += "<div class=\"row\">\n";
        for (const ShownPicture& shown : row.pictures) {
            const std::string name = "pictures/" + shown.name + ".png";
            const fs::path path = fs::path(results.settings().folder) / name;
            fs::create_directories(path.parent_path());
            write_png(path.string(), read_exr(shown.file), {.exposure = exposure});
            html += fmt::format(
                "<figure><img src=\"{0}\" alt=\"{1}\" loading=\"lazy\">"
                "<figcaption>{1}</figcaption></figure>\n",
                escaped(name), escaped(shown.caption));
        }
        html += "</div>\n" + comparison_html(results, row);
    }
    return html;
}

/// Also writes tables, charts and pictures.
std::string section_html(const Results& results, const Figure& figure, const Section& section) {
    const fs::path folder = results.settings().folder;
    std::string html =
        fmt::format("<h2 id=\"{}\">{}</h2>\n<blockquote>The paper: {}</blockquote>\n", figure.name,
                    escaped(figure.title), escaped(figure.claim));
    for (const std::string& finding : section.findings) html += "<p>" + escaped(finding) + "</p>\n";
    for (const Table& table : section.tables) {
        write_text(folder / "tables" / (table.name + ".csv"), table_csv(table));
        html += fmt::format("{}<p><a href=\"tables/{}.csv\">CSV</a></p>\n", table_html(table),
                            table.name);
    }
    for (const Chart& chart : section.charts) {
        const std::string svg = chart_svg(chart);
        write_text(folder / "charts" / (chart.name + ".svg"), svg);
        html += svg;
    }
    return html + pictures_html(results, section);
}

std::string intro_html(const Results& results, const std::vector<FinishedFigure>& finished) {
    const RunSettings& s = results.settings();
    const std::string budget = s.passes > 0
                                   ? fmt::format("{} passes", s.passes)
                                   : fmt::format("{:.3g} processor minutes", s.cpu_seconds / 60);
    std::string html = fmt::format(
        "<h1>Robust Adaptive Photon Tracing, reproduced</h1>\n"
        "<p>Hachisuka and Jensen, ACM Transactions on Graphics 30(5), 2011, beside Sunfleck {}: "
        "{} a render, {} seeds, pictures of {}. {}</p>\n"
        "<p>The scenes are our own, built after the paper's text and triangle counts, as its "
        "models "
        "are not public; radii are local footprints instead of numbers chosen by hand. The "
        "samplers "
        "random, uniform, paper and adaptive differ in the photon paths alone: all light by "
        "photons, 200,000 paths a pass, alpha 0.7; but paper's radii shrink where photons land, "
        "pixel "
        "by pixel, as in its algorithm, the others' alike everywhere. Errors are against "
        "references of {:.3g} times "
        "the budget: MSE over the squared mean, relMSE over each pixel's own square, trimmed MSE "
        "without the worst 1% of each picture's pixels; intervals are of 95%, over seeds; ratios "
        "are geometric means.</p>\n<nav>",
        SUNFLECK_VERSION, budget, s.seeds,
        s.scale == 1 ? "full size" : fmt::format("{:.3g} of their size", s.scale),
        escaped(machine_text()), s.reference_budget);
    for (const FinishedFigure& f : finished)
        html += fmt::format("<a href=\"#{0}\">{0}</a>", f.figure->name);
    return html + "<a href=\"results.json\">results.json</a></nav>\n";
}

}  // namespace

FinishedFigure finish_figure(const Results& results, const Figure& figure) {
    Section section = figure.section(results);
    std::string html = section_html(results, figure, section);
    return {&figure, std::move(section), std::move(html)};
}

void write_results(const Results& results, const std::vector<FinishedFigure>& finished) {
    std::string html = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
        "<meta name=\"color-scheme\" content=\"light dark\">"
        "<title>Robust Adaptive Photon Tracing, reproduced</title><style>{}{}</style>"
        "</head><body>\n",
        kBaseStyle, kStyle);
    html += intro_html(results, finished);
    for (const FinishedFigure& f : finished) html += f.html;
    write_text(fs::path(results.settings().folder) / "index.html", html + "</body></html>\n");
    write_text(fs::path(results.settings().folder) / "results.json",
               results_json(results, finished));
}

}  // namespace sunfleck::engine
