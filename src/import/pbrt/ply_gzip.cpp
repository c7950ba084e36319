// gzip by way of zlib: the output grows as it comes, so a file's claim is never believed.
#include "import/pbrt/ply_gzip.h"

#include "core/error.h"

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <new>

namespace sunfleck {
namespace {

constexpr std::size_t kFreeOutput = std::size_t{1} << 28U;
constexpr std::size_t kMostOfAByte = 256;  // deflate could give 1032
constexpr std::size_t kSmallestStep = std::size_t{1} << 16U;
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
        std::string output;
        std::size_t filled = 0;
        for (bool more = true; more;) {
            if (filled == output.size()) grow(output);
            more = step(output, filled);
        }
        output.resize(filled);
        return output;
    }

private:
    void grow(std::string& output) {
        if (output.size() >= kFreeOutput + kMostOfAByte * input_.size())
            fail("it unpacks to more than 256 times its size");
        output.resize(std::max({2 * output.size(), 4 * input_.size(), kSmallestStep}));
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

    [[noreturn]] void fail(const std::string& what) {
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

}  // namespace sunfleck
