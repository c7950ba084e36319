// Work that all ranks do or none: a fault of any of them ends all, and is said once.
#pragma once

#include "core/error.h"
#include "render/ranks.h"

#include <optional>
#include <stdexcept>

namespace sunfleck {

/// Thrown on every rank of several when the work has failed on any: what() is for rank 0 to say.
class FaultOfAll : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What task() returns. @throws FaultOfAll where it throws Error on any rank, of one or of all;
/// of many faults that of the lowest rank. A rank that is alone throws the Error itself.
template <class Task>
auto together(const Ranks& ranks, const Task& task) {
    if (ranks.is_alone()) return task();
    std::optional<decltype(task())> result;
    std::string fault;
    try {
        result.emplace(task());
    } catch (const Error& error) {
        const std::string place = ranks.is_first() ? "" : "rank " + std::to_string(ranks.rank);
        fault = (place.empty() ? "" : place + ": ") + error.what();
    }
    const std::string first = first_text(ranks, fault);
    if (!first.empty()) throw FaultOfAll(first);
    return std::move(*result);
}

}  // namespace sunfleck
