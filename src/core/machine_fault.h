// Faults of the machine: no room, no memory, no thread. The user's words are right; exit code 1.
#pragma once

#include "sunfleck/error.h"

namespace sunfleck::engine {

class MachineFault : public Error {
public:
    MachineFault(SourceLocation where, const std::string& what, const std::string& mend)
        : Error(std::move(where), what, mend, ErrorCode::machine) {}
    /// An error that input which has been checked cannot be the cause of.
    explicit MachineFault(const Error& error)
        : Error(error.where(), error.what(), ErrorCode::machine) {}
};

}  // namespace sunfleck::engine
