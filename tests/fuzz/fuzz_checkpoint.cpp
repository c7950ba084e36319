// Fuzz target: any bytes as a checkpoint end in a state that can be written again, or in an Error
// of one line. They are taken as they stand, and again under a checksum that fits.
#include "film/word_hash.h"
#include "render/checkpoint.h"
#include "sunfleck/error.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>

namespace {

void read(const std::string& bytes) {
    std::istringstream stream(bytes);
    try {
        const auto state =
            sunfleck::engine::read_checkpoint(stream, bytes.size(), "fuzz.ckpt").state;
        const sunfleck::engine::FilmKey& key = state.film.key();
        if (key.pixels() == 0 || state.film.sums().aovs[0].size() != 3 * key.pixels() ||
            state.film.passes().ranges().size() != 1 ||
            (state.sampler.index() != 0) != key.sequential)
            std::abort();
    } catch (const sunfleck::Error& error) {
        if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
    std::string bytes(reinterpret_cast<const char*>(data), size);
    read(bytes);
    bytes.resize(size / 8 * 8);
    sunfleck::engine::WordHash hash;
    for (std::size_t i = 0; i < bytes.size(); i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, 8);
        hash.add(word);
    }
    const std::uint64_t checksum = hash.value();
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): a word as bytes
    read(bytes + std::string(reinterpret_cast<const char*>(&checksum), 8));
    return 0;
}
