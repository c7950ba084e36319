// Pixels repeated.
#include "display/enlarged.h"

namespace sunfleck::engine {

Picture enlarged(const Picture& small, int width, int height) {
    Picture large{width, height, {}, {}};
    for (const Channel& channel : small.channels) {
        auto value = large.add(channel.name).values.begin();
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const int from = y * small.height / height * small.width + x * small.width / width;
                *value++ = channel.values[static_cast<std::size_t>(from)];
            }
    }
    return large;
}

}  // namespace sunfleck::engine
