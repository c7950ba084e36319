// The border of the library: what leaves it is an Error.
#pragma once

#include "sunfleck/error.h"

#include <exception>
#include <new>

namespace sunfleck {

/// Runs task() and returns what it returns.
/// @throws Error  also in place of other exceptions, which come of the machine.
template <class Task>
auto guarded(const Task& task) {
    try {
        return task();
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw Error({"sunfleck"}, "there is not enough memory",
                    "render fewer pixels or photons, or free some", ErrorCode::machine);
    } catch (const std::exception& fault) {
        throw Error({"sunfleck"}, fault.what(), "see what the machine lacks", ErrorCode::machine);
    }
}

}  // namespace sunfleck
