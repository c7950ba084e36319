// Tables of results, and how they are written: CSV for programs, HTML for the page.
#pragma once

#include "experiment/numbers.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// Every row has as many texts as there are columns.
struct Table {
    std::string name;  // of its file: small letters, digits, hyphens
    std::string title;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

/// Four digits, as short as can be; "-" for what is no number.
std::string number_text(double value);
/// "1.2 [1.1, 1.3]".
std::string interval_text(const Interval& interval);

/// RFC 4180, with a line of names first.
std::string table_csv(const Table& table);
std::string table_html(const Table& table);

/// Text as HTML shows it.
std::string escaped(const std::string& text);

}  // namespace sunfleck::engine
