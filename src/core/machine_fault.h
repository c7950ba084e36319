// MachineFault: the machine failed (disk full, no memory, no thread), not the input. Exit code 1.
#pragma once

#include "sunfleck/error.h"

namespace sunfleck::engine {

class MachineFault : public Error {
public:
    using Error::Error;
    /// Converts an Error that checked input cannot have caused.
    explicit MachineFault(const Error& error) : Error(error) {}
};

}  // namespace sunfleck::engine
