// Files that could not be written: no reason to lose what else there is, but a fault at the end.
//
// That they can be written has been tried before the work: what comes in between is the machine's.
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
    /// What failed before no longer matters.
    void forget() { fault_ = nullptr; }
    /// Throws what failed and still matters. @throws MachineFault in place of Error.
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
