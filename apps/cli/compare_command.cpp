// `sunfleck compare`: pictures in, a table and a page out.
#include "apps/cli/commands.h"
#include "apps/cli/outputs.h"
#include "compare/comparison.h"
#include "image/atomic_file.h"
#include "report/page.h"

#include <fmt/format.h>

#include <cstdio>

namespace sunfleck {

int run_compare(const CompareOptions& options) {
    check_distinct({options.report, options.json});
    if (!options.report.empty()) check_writable(options.report);
    if (!options.json.empty()) check_writable(options.json);
    std::vector<CompareInput> inputs;
    for (const std::string& text : options.inputs) inputs.push_back(compare_input(text));
    const Comparison comparison = compare(compare_input(options.reference), inputs);
    const auto write = [](const std::string& path, const std::string& text) {
        if (!path.empty()) write_file(path, text);
    };
    if (!options.report.empty()) write(options.report, report_page(comparison));
    write(options.json, comparison_json(comparison));
    fmt::print("{}", comparison_table(comparison));
    return 0;
}

}  // namespace sunfleck
