// 3 x 3 matrices of colour, in double: products, inverses, and those of primaries.
#pragma once

#include "math/triple.h"

namespace sunfleck::engine {

using Rows = std::array<Triple, 3>;

inline Triple operator*(const Rows& m, const Triple& v) {
    Triple product{};
    for (std::size_t i = 0; i < 3; ++i)
        product[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return product;
}

inline Rows inverse(const Rows& m) {
    Rows cofactor{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t a = (i + 1) % 3;
            const std::size_t b = (i + 2) % 3;
            const std::size_t c = (j + 1) % 3;
            const std::size_t d = (j + 2) % 3;
            cofactor[j][i] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
        }
    }
    const double determinant =
        m[0][0] * cofactor[0][0] + m[0][1] * cofactor[1][0] + m[0][2] * cofactor[2][0];
    for (Triple& row : cofactor)
        for (double& value : row) value /= determinant;
    return cofactor;
}

/// The look of a colour in another white: cones (Bradford) scaled one by one. All in XYZ.
/// Source: Lam, Metamerism and Colour Constancy (1985); what pbrt-v4 uses.
inline Triple adapted(const Triple& xyz, const Triple& from_white, const Triple& to_white) {
    constexpr Rows kBradford = {Triple{0.8951, 0.2664, -0.1614}, Triple{-0.7502, 1.7135, 0.0367},
                                Triple{0.0389, -0.0685, 1.0296}};
    const Triple from = kBradford * from_white;
    const Triple to = kBradford * to_white;
    Triple cones = kBradford * xyz;
    for (std::size_t i = 0; i < 3; ++i) cones[i] *= to[i] / from[i];
    return inverse(kBradford) * cones;
}

/// XYZ of rgb. @param primaries  x, y, 1 - x - y in columns. @param white  XYZ of (1, 1, 1).
inline Rows xyz_of_primaries(const Rows& primaries, const Triple& white) {
    const Triple amount = inverse(primaries) * white;
    Rows result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result[i][j] = primaries[i][j] * amount[j];
    return result;
}

}  // namespace sunfleck::engine
