// gzip by way of zlib: the output comes in pieces, so that a file's claim is never believed.
#include "core/gzip.h"

#include "core/memory_room.h"
#include "sunfleck/error.h"

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20U;
constexpr std::size_t kLargestStep = std::size_t{1} << 30U;  // zlib counts in 32 bits

/// zlib's state for one gzip member after another.
class Inflater {
public:
    Inflater(std::string_view input, const std::string& name) : input_(input), name_(name) {
        // 15: the largest window; 16: a gzip header and trailer, both checked.
        if (inflateInit2(&stream_, 15 + 16) != Z_OK) fail("zlib cannot start");
    }
    ~Inflater() { inflateEnd(&stream_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
    Inflater(Inflater&&) = delete;
    Inflater& operator=(Inflater&&) = delete;

    std::string all() {
        std::vector<std::string> pieces(1, std::string(kPiece, '\0'));
        std::size_t filled = 0;  // of the last piece
        while (step(pieces.back(), filled))
            if (filled == kPiece) {
                check_size(pieces.size() * kPiece);
                pieces.emplace_back(kPiece, '\0');
                filled = 0;
            }
        pieces.back().resize(filled);
        std::string output;
        output.reserve((pieces.size() - 1) * kPiece + filled);
        for (std::string& piece : pieces) output += std::exchange(piece, {});
        return output;
    }

private:
    /// The pieces and what is joined of them are in memory together.
    void check_size(std::size_t unpacked) const {
        if (unpacked <= free_memory()) return;
        constexpr std::size_t kMebi = std::size_t{1} << 20U;
        throw Error({name_},
                    "it unpacks to more than " + std::to_string(unpacked / kMebi) +
                        " MiB, half of the memory that was free",
                    "free some memory, or use a smaller file");
    }

    /// Fills more of the output. @return whether there may be more.
    bool step(std::string& output, std::size_t& filled) {
        const std::string_view in = input_.substr(used_, kLargestStep);
        const std::size_t space = std::min(output.size() - filled, kLargestStep);
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-*): zlib has unsigned bytes, and writes none
        stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(in.data()));
        stream_.avail_in = static_cast<uInt>(in.size());
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the same
        stream_.next_out = reinterpret_cast<Bytef*>(output.data() + filled);
        stream_.avail_out = static_cast<uInt>(space);
        const int result = inflate(&stream_, Z_NO_FLUSH);
        used_ += in.size() - stream_.avail_in;
        filled += space - stream_.avail_out;
        if (result == Z_STREAM_END)
            return is_gzip(input_.substr(used_)) && inflateReset(&stream_) == Z_OK;
        if (result == Z_BUF_ERROR && used_ == input_.size()) fail("the gzip file is cut");
        if (result != Z_OK && result != Z_BUF_ERROR) fail("the gzip file is damaged");
        return true;
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw Error({name_}, what, "pack the file again");
    }

    std::string_view input_;
    const std::string& name_;
    std::size_t used_ = 0;
    z_stream stream_{};
};

}  // namespace

std::string gunzip(std::string_view bytes, const std::string& name) {
    try {
        return Inflater(bytes, name).all();
    } catch (const std::bad_alloc&) {
        throw Error({name}, "unpacks to more than there is memory for", "use a smaller file");
    }
}

}  // namespace sunfleck::engine
