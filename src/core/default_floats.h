// Floating-point modes that do not depend on the caller of a library.
#pragma once

#include <cfenv>

namespace sunfleck::engine {

/// The modes that a program starts with hold while it lives: rounding to nearest, denormals.
class DefaultFloats {
public:
    DefaultFloats() {
        std::fegetenv(&before_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~DefaultFloats() { std::fesetenv(&before_); }
    DefaultFloats(const DefaultFloats&) = delete;
    DefaultFloats& operator=(const DefaultFloats&) = delete;
    DefaultFloats(DefaultFloats&&) = delete;
    DefaultFloats& operator=(DefaultFloats&&) = delete;

private:
    std::fenv_t before_{};
};

}  // namespace sunfleck::engine
