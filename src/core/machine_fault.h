// MachineFault: the machine failed (disk full, no memory, no thread), not the input. Exit code 1.
#pragma once

#include "sunfleck/error.h"

namespace sunfleck::engine {

class MachineFault : public Error {
public:
    MachineFault(SourceLocation where, const std::string& what, const std::string& mend)
        : Error(std::move(where), what, mend, ErrorCode::machine) {}
    /// Converts an Error that checked input cannot have caused.
    explicit MachineFault(const Error& error)
        : Error(error.where(), error.what(), ErrorCode::machine) {}
};

}  // namespace sunfleck::engine
