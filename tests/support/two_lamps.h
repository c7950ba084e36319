// A room with a lamp in it, and a far stronger one above its roof that shines in through a hole.
#pragma once

#include "support/renders.h"

namespace sunfleck::engine::testing_support {

/// @param n  pixels each way. @param strength  radiance of the lamp above, whose area is a hundred
/// times that of the lamp within (radiance 20).
inline std::string two_lamps_text(int n, int strength) {
    const std::string walls =
        quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") + quad("-1 -1 0  -1 -1 1  1 -1 1  1 -1 0") +
        quad("-1 1 0  1 1 0  1 1 1  -1 1 1") + quad("-1 -1 0  -1 1 0  -1 1 1  -1 -1 1") +
        quad("1 -1 0  1 -1 1  1 1 1  1 1 0");
    // The roof, around a hole of .5 by .5.
    const std::string roof = quad("-1 -1 1  -1 1 1  -.25 1 1  -.25 -1 1") +
                             quad(".25 -1 1  .25 1 1  1 1 1  1 -1 1") +
                             quad("-.25 -1 1  -.25 -.25 1  .25 -.25 1  .25 -1 1") +
                             quad("-.25 .25 1  -.25 1 1  .25 1 1  .25 .25 1");
    const auto lamp = [](int radiance, const std::string& shape) {
        const std::string l = std::to_string(radiance) + " ";
        return "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [" + l + l + l + "]\n" +
               shape + "AttributeEnd\n";
    };
    return view("0 -.9 .5  0 1 .3  0 0 1", 60, n) + diffuse("0.6 0.5 0.4") + walls + roof +
           lamp(20, quad("-.6 -.6 .9  -.6 -.2 .9  -.2 -.2 .9  -.2 -.6 .9")) +
           lamp(strength, quad("-2 -2 3  -2 2 3  2 2 3  2 -2 3"));
}

inline Scene two_lamps(int n, int strength = 400) {
    return scene_of(two_lamps_text(n, strength));
}

}  // namespace sunfleck::engine::testing_support
