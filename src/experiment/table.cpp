// Tables as text.
#include "experiment/table.h"

#include <fmt/format.h>

#include <cmath>

namespace sunfleck::engine {
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

bool is_number(const std::string& field) {
    return field.find_first_of("0123456789-") == 0;
}

/// Numbers stand to the right, and so do the names of their columns.
/// @param like  the row that says which columns hold numbers.
std::string html_row(const std::vector<std::string>& fields, const std::vector<std::string>& like,
                     const char* tag) {
    std::string row = "<tr>";
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const bool right = i < like.size() && is_number(like[i]);
        row += fmt::format("<{0}{1}>{2}</{0}>", tag, right ? " class=\"number\"" : "",
                           escaped(fields[i]));
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
    const auto& like = table.rows.empty() ? table.columns : table.rows[0];
    std::string html = fmt::format(
        "<p class=\"caption\">{}</p>\n<div class=\"wide\"><table>\n<thead>{}</thead>\n<tbody>",
        escaped(table.title), html_row(table.columns, like, "th"));
    for (const auto& row : table.rows) html += html_row(row, row, "td");
    return html + "</tbody></table></div>\n";
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

}  // namespace sunfleck::engine
