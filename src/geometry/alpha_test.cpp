// The hash of a ray and of its crossing with a primitive.
#include "geometry/alpha_test.h"

#include "core/hash.h"

#include <bit>

namespace sunfleck::engine {
namespace {

std::uint64_t hash_of(const Vec3d& origin, const Vec3d& direction) {
    std::uint64_t hash = 0;
    for (const Vec3d& v : {origin, direction})
        for (int i = 0; i < 3; ++i) hash = hash_joined(hash, std::bit_cast<std::uint64_t>(v[i]));
    return hash;
}

}  // namespace

bool passes_alpha_test(float cover, const Vec3d& origin, const Vec3d& direction,
                       const CrossingName& name) {
    if (cover >= 1) return true;
    if (!(cover > 0)) return false;
    std::uint64_t hash =
        hash_joined(hash_of(origin, direction), std::uint64_t{name.shape} << 32U | name.primitive);
    hash = hash_joined(hash, std::uint64_t{name.instance} << 32U | name.crossing);
    return hash_to_unit(hash) < cover;
}

}  // namespace sunfleck::engine
