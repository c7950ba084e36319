// Gather tests of eight kernels at once, compiled once per instruction set; the first call selects
// one.
//
// The operations and their order are those of accepts(), without fused ones, so results are the
// same.
#include "visible_points/lookup.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visible_points/lookup.cpp"
// At most eight floats: boxes and discs come in eights.
#define HWY_DISABLED_TARGETS (HWY_AVX3 | HWY_AVX3_DL | HWY_SSE4)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sunfleck::engine::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 8>;
using Integers = hn::RebindToSigned<Floats>;
using Vector = hn::Vec<Floats>;
using Mask = hn::Mask<Floats>;
using Eight = std::array<float, 8>;
constexpr std::size_t kAtOnce = hn::MaxLanes(Floats());
/// Eight leaves of eight photons, and one that is written beyond the end.
constexpr std::size_t kPhotonsOfNode = 65;

struct Vectors {
    Vector x;
    Vector y;
    Vector z;
};

HWY_INLINE Vector all(float value) {
    return hn::Set(Floats(), value);
}
HWY_INLINE Vectors all(const Vec3& v) {
    return {all(v.x), all(v.y), all(v.z)};
}
HWY_INLINE Vector load(const Eight& values, std::size_t i) {
    return hn::Load(Floats(), &values[i]);
}
HWY_INLINE Vectors load(const std::array<Eight, 3>& values, std::size_t i) {
    return {load(values[0], i), load(values[1], i), load(values[2], i)};
}
HWY_INLINE Vector dot(const Vectors& a, const Vectors& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE unsigned bits_of(const Mask& mask, std::size_t first) {
    std::uint8_t bits = 0;
    hn::StoreMaskBits(Floats(), mask, &bits);
    return static_cast<unsigned>(bits) << first;
}

/// Returns a mask: bit i is set if the box intersects that of child i.
HWY_INLINE unsigned touched(const BoxNode& node, const Box& box) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < 8; i += kAtOnce) {
        const Vectors low = load(node.low, i);
        const Vectors high = load(node.high, i);
        const Vectors box_low = all(box.low);
        const Vectors box_high = all(box.high);
        const Mask x = hn::And(hn::Le(low.x, box_high.x), hn::Le(box_low.x, high.x));
        const Mask y = hn::And(hn::Le(low.y, box_high.y), hn::Le(box_low.y, high.y));
        const Mask z = hn::And(hn::Le(low.z, box_high.z), hn::Le(box_low.z, high.z));
        bits |= bits_of(hn::And(x, hn::And(y, z)), i);
    }
    return bits;
}

/// Returns a mask: bit i is set if photon i is in the (closed) box.
HWY_INLINE unsigned inside(const PhotonLeaf& leaf, const Box& box) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < 8; i += kAtOnce) {
        const Vectors at = load(leaf.position, i);
        const Mask x = hn::And(hn::Le(all(box.low.x), at.x), hn::Le(at.x, all(box.high.x)));
        const Mask y = hn::And(hn::Le(all(box.low.y), at.y), hn::Le(at.y, all(box.high.y)));
        const Mask z = hn::And(hn::Le(all(box.low.z), at.z), hn::Le(at.z, all(box.high.z)));
        bits |= bits_of(hn::And(x, hn::And(y, z)), i);
    }
    return bits;
}

/// Tests side, kind and depth.
HWY_INLINE Mask accept(const DiscBlock& discs, const Photon& photon, int max_depth, Mask behind,
                       std::size_t i) {
    constexpr Integers kTag;
    const auto rules = hn::Load(kTag, &discs.rules[i]);
    const auto kind =
        hn::Set(kTag, static_cast<std::int32_t>(photon.kinds()) << DiscBlock::kKindsFrom);
    const auto room = hn::Set(kTag, max_depth - static_cast<std::int32_t>(photon.bounces));
    const auto bounces = hn::And(rules, hn::Set(kTag, DiscBlock::kBounces));
    const auto wanted = hn::And(hn::Eq(hn::And(rules, kind), kind), hn::Lt(bounces, room));
    const auto both_sides = hn::And(rules, hn::Set(kTag, DiscBlock::kBothSides));
    const auto one_sided = hn::Eq(both_sides, hn::Zero(kTag));
    return hn::AndNot(hn::And(behind, hn::RebindMask(Floats(), one_sided)),
                      hn::RebindMask(Floats(), wanted));
}

/// radius_of_kind() of discs from i on.
HWY_INLINE Vector radii_for(const DiscBlock& discs, PhotonKind kind, std::size_t i) {
    if (kind == PhotonKind::indirect) return load(discs.indirect_radius, i);
    const Vector radius = load(discs.radius, i);
    if (kind != PhotonKind::long_specular_chain) return radius;
    const Vector indirect = load(discs.indirect_radius, i);
    return hn::Sub(hn::Add(indirect, indirect), radius);
}

/// Returns the ways from kernels i on to a photon.
HWY_INLINE Vectors ways_to(const Photon& photon, const DiscBlock& discs, std::size_t i) {
    const Vectors to = all(photon.position);
    const Vectors from = load(discs.position, i);
    return {hn::Sub(to.x, from.x), hn::Sub(to.y, from.y), hn::Sub(to.z, from.z)};
}

/// Returns a mask: bit i is set if cylinder i accepts a photon of a medium. Names are those of
/// is_in_cylinder().
HWY_INLINE unsigned accepting_cylinders(const VisiblePointIndex& index, std::size_t block,
                                        const Photon& photon) {
    const DiscBlock& discs = index.discs(block);
    const DiscBlock::Floats& half_lengths = index.half_lengths(block);
    unsigned bits = 0;
    for (std::size_t i = 0; i < 8; i += kAtOnce) {
        const Vectors d = ways_to(photon, discs, i);
        const Vector radius = radii_for(discs, photon.kind, i);
        const Vector above = dot(d, load(discs.normal, i));
        const Mask beside = hn::Lt(hn::Abs(above), load(half_lengths, i));
        const Mask within =
            hn::Lt(hn::Sub(dot(d, d), hn::Mul(above, above)), hn::Mul(radius, radius));
        const Mask taken = hn::And(
            hn::And(beside, within),
            accept(discs, photon, index.max_depth(), hn::MaskFromVec(hn::Zero(Floats())), i));
        bits |= bits_of(taken, i);
    }
    return bits;
}

/// Returns a mask: bit i is set if disc i accepts a photon of a surface. Names are those of
/// is_in_disc().
HWY_INLINE unsigned accepting_discs(const DiscBlock& discs, const Photon& photon, int max_depth) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < 8; i += kAtOnce) {
        const Vectors d = ways_to(photon, discs, i);
        const Vector radius = radii_for(discs, photon.kind, i);
        const Vector radius2 = hn::Mul(radius, radius);
        const Vector distance2 = dot(d, d);
        const Mask near = hn::Lt(distance2, hn::Mul(all(1.5F), radius2));
        const Vectors normal = load(discs.normal, i);
        const Vectors given = all(photon.normal);
        const Vector agreement = dot(normal, given);
        const Mask behind = hn::Lt(agreement, all(0));
        const Vector turn = hn::And(hn::VecFromMask(Floats(), behind), all(-0.0F));
        const Vectors sum{hn::Add(normal.x, hn::Xor(given.x, turn)),
                          hn::Add(normal.y, hn::Xor(given.y, turn)),
                          hn::Add(normal.z, hn::Xor(given.z, turn))};
        const Vector along = hn::Mul(dot(d, sum), all(0.5F));
        const Vector above = dot(d, normal);
        const Mask apart = hn::Or(hn::Lt(hn::Abs(agreement), all(kNormalAgreement)),
                                  hn::Gt(hn::Abs(along), hn::Mul(all(kDiscFlatness), radius)));
        const Mask within = hn::Lt(hn::Sub(distance2, hn::Mul(above, above)), radius2);
        const Mask taken = hn::And(hn::And(near, hn::AndNot(apart, within)),
                                   accept(discs, photon, max_depth, behind, i));
        bits |= bits_of(taken, i);
    }
    return bits;
}

/// Returns a mask: bit i is set if kernel i of the block accepts the photon.
HWY_INLINE unsigned accepting(const VisiblePointIndex& index, std::size_t block,
                              const Photon& photon) {
    if (!photon.in_medium) return accepting_discs(index.discs(block), photon, index.max_depth());
    return index.has_cylinders() ? accepting_cylinders(index, block, photon) : 0;
}

/// Writes the indices of the bits of `met`, counted from `first`. It writes eight, of which the
/// first ones count, because a branch would be unpredictable. @return the end of those that count.
HWY_INLINE std::uint32_t* write_numbers(unsigned met, std::uint32_t first, std::uint32_t* out) {
    for (std::uint32_t i = 0; i < 8; ++i) {
        *out = first + i;
        out += met >> i & 1U;
    }
    return out;
}

/// Lists the photons in the block's boxes, from the nearby nodes. @return their count.
HWY_INLINE std::size_t list_near(const VisiblePointIndex& index, const SortedPhotons& photons,
                                 std::size_t block, TakenPhotons& taken) {
    std::size_t count = 0;
    for (const std::uint32_t node : taken.nodes) {
        const PhotonKind widest = photons.widest_before((std::size_t{node} + 1) * 64);
        const Box& box = index.around(widest).boxes[block];
        if (count + kPhotonsOfNode > taken.near.size())
            taken.near.resize(2 * count + kPhotonsOfNode);
        std::uint32_t* const begin = taken.near.data();
        std::uint32_t* end = begin + count;
        unsigned leaves = touched(photons.tree().node(node), box);
        for (; leaves != 0; leaves &= leaves - 1) {
            const std::uint32_t leaf = node * 8 + static_cast<std::uint32_t>(__builtin_ctz(leaves));
            end = write_numbers(inside(photons.leaf(leaf), box), leaf * 8, end);
        }
        count = static_cast<std::size_t>(end - begin);
    }
    return count;
}

/// Lists what the block accepts, starting at `first` of the list. All nearby photons are listed
/// before any is tested, so that loop ends are predictable.
HWY_INLINE TakenPhotons::Block list_taken(const VisiblePointIndex& index,
                                          const SortedPhotons& photons, std::size_t block,
                                          std::size_t first, TakenPhotons& taken) {
    const std::size_t count = list_near(index, photons, block, taken);
    if (first + count > taken.list.size()) taken.list.resize(2 * first + count);
    std::size_t end = first;
    std::uint32_t accepting_of_any = 0;
    for (std::size_t n = 0; n < count; ++n) {
        const std::uint32_t i = taken.near[n];
        const unsigned by = accepting(index, block, photons[i]);
        taken.list[end] = {i, by};
        end += by != 0 ? 1 : 0;
        accepting_of_any |= by;
    }
    return {first, end - first, accepting_of_any};
}

bool find_taken(const VisiblePointIndex& index, const SortedPhotons& photons, std::size_t begin,
                std::size_t end, TakenPhotons& taken) {
    const PhotonKind widest = photons.widest_before(photons.size());
    Box around_all;
    for (std::size_t block = begin; block < end; ++block)
        around_all.extend(index.around(widest).boxes[block]);
    const auto near = [&](const BoxNode& node) HWY_ATTR { return touched(node, around_all); };
    taken.nodes.clear();
    photons.tree().append_nodes(near, taken.nodes);
    if (taken.nodes.empty()) return false;
    std::size_t listed = 0;
    for (std::size_t block = begin; block < end; ++block) {
        TakenPhotons::Block& here = taken.blocks[block - begin];
        here = list_taken(index, photons, block, listed, taken);
        listed += here.count;
    }
    return listed > 0;
}

bool is_any_taken(const VisiblePointIndex& index, std::span<const Photon> path) {
    for (const Photon& photon : path) {
        if (!index.may_accept(photon)) continue;
        const Box place{photon.position, photon.position};
        const auto near = [&](const BoxNode& node) HWY_ATTR { return touched(node, place); };
        const auto go_on = [&](std::uint32_t block)
                               HWY_ATTR { return accepting(index, block, photon) == 0; };
        if (index.around(photon.kind).tree.visit(near, go_on)) return true;
    }
    return false;
}

}  // namespace sunfleck::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sunfleck::engine {

HWY_EXPORT(find_taken);
HWY_EXPORT(is_any_taken);

bool find_taken(const VisiblePointIndex& index, const SortedPhotons& photons, std::size_t begin,
                std::size_t end, TakenPhotons& taken) {
    return HWY_DYNAMIC_DISPATCH(find_taken)(index, photons, begin, end, taken);
}

bool VisiblePointIndex::any(std::span<const Photon> path) const {
    return HWY_DYNAMIC_DISPATCH(is_any_taken)(*this, path);
}

}  // namespace sunfleck::engine
#endif
