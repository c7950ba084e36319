// What can be wrong with a scene's renders.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace sunfleck::engine::differential {

enum class Kind {
    refused,     // exit code other than 0, or killed by a signal
    late,        // more than its limit of processor time
    values,      // NaN, infinite or negative
    threads,     // bytes depend on the number of threads
    resume,      // bytes of an interrupted and resumed render differ
    light,       // brightness differs from the references', whatever the discs' radius
    discs,       // brightness differs with discs of the default radius, beyond the reported bias
    error_bars,  // true differences are larger than the reported errors
};

std::string_view name(Kind kind);

struct Fault {
    Kind kind;
    std::string text;
};

/// Thrown where a render that others build on has failed.
class RenderFault : public std::runtime_error {
public:
    explicit RenderFault(Fault fault) : std::runtime_error(fault.text), fault_(std::move(fault)) {}
    const Fault& fault() const { return fault_; }

private:
    Fault fault_;
};

}  // namespace sunfleck::engine::differential
