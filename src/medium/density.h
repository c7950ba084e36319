// Density: how much of a medium there is at a point, as a factor of its coefficients.
//
// In:  a way. Out: the amount of medium along it, which takes the place of the distance in all that
// holds for a medium that is alike everywhere (docs/method/media-fields.md).
#pragma once

#include "medium/density_grid.h"

#include <concepts>
#include <variant>

namespace sunfleck::engine {

/// What the alternatives of Density provide. All but mean() and moved() are called in inner loops.
template <class Field>
concept DensityModel = requires(const Field& field, const Ray& way, const Vec3& point, float amount,
                                const Vec3d& by) {
    /// The density at a point: 0 or more, and 0 far away.
    { field.at(point) } -> std::same_as<float>;
    /// Its integral along a way, whose length may be infinite; that of at() to the precision that
    /// the model states.
    { field.amount(way) } -> std::same_as<float>;
    /// The inverse: the greatest distance before which lies no more than an amount, or where the
    /// last of the density ends, if all of it is less.
    { field.distance_at(way, amount) } -> std::same_as<float>;
    /// An upper bound of the density, and its mean where it may be more than zero: for messages.
    { field.greatest() } -> std::same_as<float>;
    { field.mean() } -> std::same_as<float>;
    /// The same density elsewhere in the world.
    { field.moved(by) } -> std::same_as<Field>;
};

template <DensityModel... Models>
using DensityVariant = std::variant<Models...>;

using Density = DensityVariant<DensityGrid>;

inline float density_at(const Density& density, const Vec3& point) {
    return std::visit([&](const auto& field) { return field.at(point); }, density);
}
inline float amount(const Density& density, const Ray& way) {
    return std::visit([&](const auto& field) { return field.amount(way); }, density);
}
inline float distance_at(const Density& density, const Ray& way, float amount) {
    return std::visit([&](const auto& field) { return field.distance_at(way, amount); }, density);
}
inline float greatest(const Density& density) {
    return std::visit([](const auto& field) { return field.greatest(); }, density);
}
inline float mean(const Density& density) {
    return std::visit([](const auto& field) { return field.mean(); }, density);
}
inline Density moved(const Density& density, const Vec3d& by) {
    return std::visit([&](const auto& field) { return Density(field.moved(by)); }, density);
}

}  // namespace sunfleck::engine
