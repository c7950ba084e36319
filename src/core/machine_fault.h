// Faults of the machine: no room, no memory, no thread. The user's words are right; exit code 1.
#pragma once

#include "sunfleck/error.h"

namespace sunfleck::engine {

class MachineFault : public Error {
public:
    using Error::Error;
    /// An error that input which has been checked cannot be the cause of.
    explicit MachineFault(const Error& error) : Error(error) {}
};

}  // namespace sunfleck::engine
