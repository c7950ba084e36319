// Files that could not be written: no reason to lose what else there is, but a fault at the end.
//
// That they can be written has been tried before the work: what comes in between is the machine's.
#pragma once

#include "apps/cli/options.h"
#include "core/machine_fault.h"

#include <fmt/format.h>

#include <cstdio>
#include <optional>

namespace sunfleck {

class LateFault {
public:
    explicit LateFault(LogLevel log) : log_(log) {}

    /// @param write  may throw Error: the first is a warning, if not quiet. @return whether it did
    /// not.
    template <class Write>
    bool attempt(const Write& write) {
        try {
            write();
            return true;
        } catch (const Error& error) {
            if (!fault_ && log_ != LogLevel::quiet)
                fmt::print(stderr, "warning: {} (the render goes on)\n", error.what());
            if (!fault_) fault_ = error;
            return false;
        }
    }
    /// What failed before no longer matters.
    void forget() { fault_.reset(); }
    /// @throws MachineFault if something failed that still matters.
    void finish() const {
        if (fault_) throw MachineFault(*fault_);
    }

private:
    LogLevel log_;
    std::optional<Error> fault_;
};

}  // namespace sunfleck
