// stats.json: statistics of a render, under stable names (docs/reference/stats.md).
#pragma once

#include "film/target_error.h"
#include "stages/pass_result.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// Facts of a run that the film does not hold.
struct RunFacts {
    std::string scene;
    std::string command;
    std::string isa;
    std::size_t threads = 0;
    double load_seconds = 0;
    double total_seconds = 0;
    double cpu_seconds = 0;  // of all threads
    PassTimes seconds;
    double radius_factor = 1;
    std::vector<std::string> warnings;
    int ranks = 1;
    ErrorTerms error_terms{};
};

/// Returns JSON text, which ends in a new line.
std::string stats_json(const Film& film, const RunFacts& facts);

/// Returns warnings about the picture's errors, a line each, such as an uncertain brightness.
std::vector<std::string> reliability_warnings(const Film& film);

}  // namespace sunfleck::engine
