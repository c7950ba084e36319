// Tables of results, and their output as CSV for programs and HTML for the page.
#pragma once

#include "experiment/numbers.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// Every row has as many texts as there are columns.
struct Table {
    std::string name;  // of its file: lower case letters, digits, hyphens
    std::string title;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

/// Returns a number with four digits, as short as possible; "-" for NaN.
std::string number_text(double value);
/// Returns "1.2 [1.1, 1.3]".
std::string interval_text(const Interval& interval);

/// Returns CSV (RFC 4180) with a line of names first.
std::string table_csv(const Table& table);
std::string table_html(const Table& table);

/// Escapes text for HTML.
std::string escaped(const std::string& text);

}  // namespace sunfleck::engine
