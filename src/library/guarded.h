// The border of the library: within it floating-point modes are the default ones, and what is
// thrown out of it is an Error.
#pragma once

#include "core/default_floats.h"
#include "sunfleck/error.h"

#include <exception>
#include <new>

namespace sunfleck {

/// Runs task() and returns what it returns.
/// @throws Error  also in place of other exceptions, which come of the machine.
template <class Task>
auto guarded(const Task& task) {
    const engine::DefaultFloats modes;
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
