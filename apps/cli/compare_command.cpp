// `sunfleck compare`: pictures in, a table and a page out.
#include "apps/cli/commands.h"
#include "apps/cli/outputs.h"
#include "compare/comparison.h"
#include "core/thread_trial.h"
#include "image/atomic_file.h"
#include "report/page.h"

#include <fmt/format.h>

#include <cstdio>

namespace sunfleck::engine {

namespace {

std::vector<std::string> files_of(const CompareInput& reference,
                                  const std::vector<CompareInput>& inputs) {
    std::vector<std::string> files = {reference.path};
    for (const CompareInput& input : inputs) {
        const std::vector<std::string> read = files_of(input);
        files.insert(files.end(), read.begin(), read.end());
    }
    return files;
}

}  // namespace

int run_compare(const CompareOptions& options) {
    try_threads();
    std::vector<CompareInput> inputs;
    for (const std::string& text : options.inputs) inputs.push_back(compare_input(text));
    const CompareInput reference = compare_input(options.reference);
    const std::vector<std::string> written = {options.report, options.json};
    check_outputs({}, written);
    check_apart({files_of(reference, inputs), written});
    const OutputClaims claims(written);
    const Comparison comparison = compare(reference, inputs);
    DeferredError faults(LogLevel::quiet);  // thrown when all is tried
    const auto write = [&](const std::string& path, const auto& text) {
        if (!path.empty()) faults.attempt([&] { write_file(path, text(comparison)); });
    };
    write(options.report, report_page);
    write(options.json, comparison_json);
    faults.finish();
    fmt::print("{}", comparison_table(comparison));
    return 0;
}

}  // namespace sunfleck::engine
