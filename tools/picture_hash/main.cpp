// Prints a hash of the pixel values of each EXR file, one line a file, whatever its metadata say.
// Usage: picture_hash FILE.exr...
#include "core/hash.h"
#include "image/exr.h"
#include "sunfleck/error.h"

#include <fmt/format.h>

#include <bit>

namespace {

/// @return a hash of the size, the channels' names and their values, bit by bit.
std::uint64_t hash_of(const sunfleck::engine::Picture& picture) {
    std::uint64_t hash = 0;
    const auto join = [&](std::uint64_t bits) { hash = sunfleck::engine::hash_joined(hash, bits); };
    join(static_cast<std::uint64_t>(picture.width));
    join(static_cast<std::uint64_t>(picture.height));
    for (const sunfleck::engine::Channel& channel : picture.channels) {
        for (const char letter : channel.name) join(static_cast<unsigned char>(letter));
        for (const float value : channel.values) join(std::bit_cast<std::uint32_t>(value));
    }
    return hash;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        for (int i = 1; i < argc; ++i)
            fmt::print("{:016x}  {}\n", hash_of(sunfleck::engine::read_exr(argv[i])), argv[i]);
        return 0;
    } catch (const sunfleck::Error& error) {
        fmt::print(stderr, "picture_hash: {}\n", error.what());
        return 2;
    }
}
