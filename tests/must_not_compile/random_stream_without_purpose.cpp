// A stream cannot be named by bare numbers: whoever draws says what for.
// Refused with: no matching function|no matching constructor|could not convert
#include "core/random.h"

namespace sunfleck::engine {

constexpr std::uint64_t first_number() {
#ifdef FAULT
    RandomStream stream(1, 0, 0, 0);
#else
    RandomStream stream(1, Purpose::test, 0, 0);
#endif
    return stream.next_fraction();
}

static_assert(first_number() == first_number());

}  // namespace sunfleck::engine
