// Work of all ranks together: a fault on one rank ends all of them, and is reported once.
#pragma once

#include "core/machine_fault.h"
#include "ranks/ranks.h"

#include <optional>
#include <stdexcept>

namespace sunfleck::engine {

/// Thrown on every rank of several when the work has failed on any: what() is for rank 0 to say,
/// and the program's exit code is code().
class FaultOfAll : public std::runtime_error {
public:
    FaultOfAll(int code, const std::string& what) : std::runtime_error(what), code_(code) {}
    int code() const { return code_; }

private:
    int code_;
};

/// What task() returns. @throws FaultOfAll where it throws Error on any rank, of one or of all;
/// of many faults that of the lowest rank. A rank that is alone throws the Error itself.
template <class Task>
auto together(const Ranks& ranks, const Task& task) {
    if (ranks.is_alone()) return task();
    std::optional<decltype(task())> result;
    const std::string place = ranks.is_first() ? "" : "rank " + std::to_string(ranks.rank) + ": ";
    std::string fault;  // after one character for the exit code
    try {
        result.emplace(task());
    } catch (const MachineFault& error) {
        fault = "1" + place + error.what();
    } catch (const Error& error) {
        fault = "2" + place + error.what();
    }
    const std::string first = first_text(ranks, fault);
    if (!first.empty()) throw FaultOfAll(first.front() - '0', first.substr(1));
    return std::move(*result);
}

}  // namespace sunfleck::engine
