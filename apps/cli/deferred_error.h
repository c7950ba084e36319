// Faults of output files, thrown at the end, so that one fault does not lose the other files.
//
// The files have been checked before the work. What fails later is a fault of the machine.
#pragma once

#include "apps/cli/messages.h"
#include "apps/cli/options.h"
#include "core/machine_fault.h"

#include <fmt/format.h>

#include <exception>

namespace sunfleck::engine {

class DeferredError {
public:
    explicit DeferredError(LogLevel log) : log_(log) {}

    /// @param write  may throw: the first fault is a warning, if not quiet. @return whether it did
    /// not.
    template <class Write>
    bool attempt(const Write& write) {
        try {
            write();
            return true;
        } catch (const std::exception& error) {
            if (!fault_ && log_ != LogLevel::quiet)
                say(fmt::format("warning: {} (the render goes on)", error.what()));
            if (!fault_) fault_ = std::current_exception();
            return false;
        }
    }
    /// Forgets earlier faults, because a later attempt has succeeded.
    void forget() { fault_ = nullptr; }
    /// Throws the fault that has not been forgotten. @throws MachineFault  in place of Error.
    void finish() const {
        try {
            if (fault_) std::rethrow_exception(fault_);
        } catch (const Error& error) {
            throw MachineFault(error);
        }
    }

private:
    LogLevel log_;
    std::exception_ptr fault_;
};

}  // namespace sunfleck::engine
