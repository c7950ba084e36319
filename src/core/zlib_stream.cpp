// zlib's uncompress(), which counts in unsigned long.
#include "core/zlib_stream.h"

#include <zlib.h>

namespace sunfleck::engine {

std::optional<std::string> inflated(std::string_view stream, std::size_t size) {
    constexpr std::size_t kMostPerByte = 1040;  // deflate cannot pack more into one
    if (size / kMostPerByte > stream.size()) return {};
    std::string bytes(size, '\0');
    uLongf filled = size;
    // NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast): zlib has unsigned bytes
    const int result = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &filled,
                                  reinterpret_cast<const Bytef*>(stream.data()), stream.size());
    // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)
    if (result != Z_OK || filled != size) return {};
    return bytes;
}

}  // namespace sunfleck::engine
