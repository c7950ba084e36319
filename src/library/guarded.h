// The border of the library: within it floating-point modes are the default ones, and what is
// thrown out of it is an Error.
#pragma once

#include "core/default_floats.h"
#include "sunfleck/error.h"

#include <exception>
#include <new>
#include <string>

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

/// Calls what the library's user has given. @param what  "report" or "log".
/// @throws Error  in place of all that it throws.
template <class Callback>
void call_back(const std::string& what, const Callback& callback) {
    const std::string mend = "catch it there, or mend the " + what;
    try {
        callback();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& fault) {
        throw Error({"Renderer"}, "the " + what + " has thrown: " + fault.what(), mend);
    } catch (...) {
        throw Error({"Renderer"}, "the " + what + " has thrown what is no std::exception", mend);
    }
}

}  // namespace sunfleck
