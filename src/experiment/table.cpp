// Tables as text.
#include "experiment/table.h"

#include <fmt/format.h>

#include <cmath>

namespace sunfleck {
namespace {

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

std::string csv_line(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) line += csv_field(field) + ',';
    line.back() = '\n';
    return line;
}

/// Numbers stand to the right.
std::string html_row(const std::vector<std::string>& fields, const char* tag) {
    std::string row = "<tr>";
    for (const std::string& field : fields) {
        const bool is_number = field.find_first_of("0123456789-") == 0;
        row += fmt::format("<{0}{1}>{2}</{0}>", tag, is_number ? " class=\"number\"" : "",
                           escaped(field));
    }
    return row + "</tr>\n";
}

}  // namespace

std::string number_text(double value) {
    return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-";
}

std::string interval_text(const Interval& interval) {
    if (!std::isfinite(interval.value)) return "-";
    return fmt::format("{:.3g} [{:.3g}, {:.3g}]", interval.value, interval.low, interval.high);
}

std::string table_csv(const Table& table) {
    std::string csv = csv_line(table.columns);
    for (const auto& row : table.rows) csv += csv_line(row);
    return csv;
}

std::string table_html(const Table& table) {
    std::string html = fmt::format("<table><caption>{}</caption>\n<thead>{}</thead>\n<tbody>",
                                   escaped(table.title), html_row(table.columns, "th"));
    for (const auto& row : table.rows) html += html_row(row, "td");
    return html + "</tbody></table>\n";
}

std::string escaped(const std::string& text) {
    std::string html;
    for (const char c : text) {
        switch (c) {
            case '&':
                html += "&amp;";
                break;
            case '<':
                html += "&lt;";
                break;
            case '>':
                html += "&gt;";
                break;
            case '"':
                html += "&quot;";
                break;
            default:
                html += c;
        }
    }
    return html;
}

}  // namespace sunfleck
