// Eight discs side by side: which of them take a photon, four answers at a time.
//
// The same operations in the same order as takes(), without fused ones: the same answers.
#pragma once

#include "measurement/box_tree.h"
#include "measurement/visible_point.h"

namespace sunfleck {

class DiscBlock {
public:
    static constexpr std::size_t kWidth = 8;

    /// Places that are not set take nothing.
    void set(std::size_t i, const Disc& disc) {
        for (int c = 0; c < 3; ++c) {
            position_.at(static_cast<std::size_t>(c)).at(i) = disc.position[c];
            normal_.at(static_cast<std::size_t>(c)).at(i) = disc.normal[c];
        }
        radius_.at(i) = disc.radius;
        bounces_.at(i) = disc.bounces;
        kinds_.at(i) = static_cast<std::int32_t>(disc.kinds);
        both_sides_.at(i) = disc.both_sides ? 1 : 0;
    }

    float radius(std::size_t i) const { return radius_[i]; }

    /// Bit i is set if disc i takes the photon: takes(disc, photon, max_depth).
    unsigned takers(const Photon& photon, int max_depth) const {
        return eight_bits([&](unsigned i) { return four_takers(photon, max_depth, i); });
    }

private:
    using Vector = hwy::HWY_NAMESPACE::Vec<FourFloats>;
    using Mask = hwy::HWY_NAMESPACE::Mask<FourFloats>;
    using FourIntegers = hwy::HWY_NAMESPACE::FixedTag<std::int32_t, 4>;
    struct Vectors {
        Vector x;
        Vector y;
        Vector z;
        Vector dot(const Vectors& b) const { return x * b.x + y * b.y + z * b.z; }
    };
    using Floats = std::array<float, kWidth>;
    using Integers = std::array<std::int32_t, kWidth>;

    static Vector all(float value) { return hwy::HWY_NAMESPACE::Set(FourFloats(), value); }
    static Vectors all(const Vec3& v) { return {all(v.x), all(v.y), all(v.z)}; }
    static Vector load(const Floats& values, unsigned i) {
        return hwy::HWY_NAMESPACE::Load(FourFloats(), &values[i]);
    }
    static Vectors load(const std::array<Floats, 3>& values, unsigned i) {
        return {load(values[0], i), load(values[1], i), load(values[2], i)};
    }

    /// Of discs i .. i + 3. The names are those of takes().
    Mask four_takers(const Photon& photon, int max_depth, unsigned i) const {
        namespace hn = hwy::HWY_NAMESPACE;
        const Vectors to = all(photon.position);
        const Vectors from = load(position_, i);
        const Vectors d{to.x - from.x, to.y - from.y, to.z - from.z};
        const Vector radius = load(radius_, i);
        const Vector radius2 = radius * radius;
        const Vector distance2 = d.dot(d);
        const Mask near = hn::Lt(distance2, all(1.5F) * radius2);
        const Vectors normal = load(normal_, i);
        Vectors other = all(photon.normal);
        const Vector agreement = normal.dot(other);
        const Mask behind = hn::Lt(agreement, all(0));
        other.x = hn::IfThenElse(behind, hn::Neg(other.x), other.x);
        other.y = hn::IfThenElse(behind, hn::Neg(other.y), other.y);
        other.z = hn::IfThenElse(behind, hn::Neg(other.z), other.z);
        const Vectors sum{normal.x + other.x, normal.y + other.y, normal.z + other.z};
        const Vector along = d.dot(sum) * all(0.5F);
        const Vector above = d.dot(normal);
        const Mask apart = hn::Or(hn::Lt(hn::Abs(agreement), all(kNormalAgreement)),
                                  hn::Gt(hn::Abs(along), all(kDiscFlatness) * radius));
        const Mask inside = hn::Lt(distance2 - above * above, radius2);
        return hn::And(hn::And(near, hn::AndNot(apart, inside)),
                       accepts(photon, max_depth, behind, i));
    }

    /// Side, kind and depth.
    Mask accepts(const Photon& photon, int max_depth, Mask behind, unsigned i) const {
        namespace hn = hwy::HWY_NAMESPACE;
        constexpr FourIntegers kTag;
        const auto kinds = hn::Load(kTag, &kinds_[i]);
        const auto kind = hn::Set(kTag, static_cast<std::int32_t>(photon.kind));
        const auto room = hn::Set(kTag, max_depth - static_cast<std::int32_t>(photon.bounces));
        const auto shallow = hn::Lt(hn::Load(kTag, &bounces_[i]), room);
        const auto wanted = hn::And(hn::Eq(hn::And(kinds, kind), kind), shallow);
        const auto one_sided = hn::Eq(hn::Load(kTag, &both_sides_[i]), hn::Zero(kTag));
        return hn::AndNot(hn::And(behind, hn::RebindMask(FourFloats(), one_sided)),
                          hn::RebindMask(FourFloats(), wanted));
    }

    alignas(64) std::array<Floats, 3> position_{};
    Floats radius_{};
    std::array<Floats, 3> normal_{};
    Integers bounces_{};
    Integers kinds_{};
    Integers both_sides_{};
};

}  // namespace sunfleck
