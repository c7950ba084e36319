// A file in memory, read from its front to its end and never beyond.
#pragma once

#include "image/image_memory.h"
#include "sunfleck/error.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace sunfleck::engine {

class ByteSource {
public:
    /// @param name  of the file, and @param format  of it: for messages.
    ByteSource(std::string_view bytes, std::string name, std::string format)
        : rest_(bytes), name_(std::move(name)), format_(std::move(format)) {}

    /// @throws Error, always.
    [[noreturn]] void refuse(const std::string& what) const {
        throw Error({name_}, "cannot be read as " + format_ + ": " + what,
                    "write the picture again, as PNG or EXR");
    }

    std::size_t left() const { return rest_.size(); }

    /// The next bytes. @throws Error if there are fewer.
    std::string_view take(std::size_t count) {
        if (count > rest_.size()) refuse("the file is cut");
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }
    /// Accepts the next byte if it is that one.
    void skip(char byte) {
        if (rest_.starts_with(byte)) rest_.remove_prefix(1);
    }
    std::uint8_t byte() { return static_cast<std::uint8_t>(take(1)[0]); }
    /// Two bytes, the lesser one first.
    unsigned word() {
        const unsigned low = byte();
        return low | static_cast<unsigned>(byte()) << 8U;
    }

    /// Text up to the end of the line, which is taken but not returned.
    std::string_view line() {
        const std::size_t end = rest_.find('\n');
        if (end == std::string_view::npos) refuse("its head has no end");
        std::string_view text = take(end);
        take(1);
        if (text.ends_with('\r')) text.remove_suffix(1);
        return text;
    }

    /// A size that a picture may have. @param most  texels that what is left can hold.
    /// @param bytes  that a decoded texel takes.
    void check_size(std::int64_t width, std::int64_t height, std::uint64_t most,
                    std::uint64_t bytes) const {
        constexpr std::int64_t kMostAcross = 1 << 17;
        if (width < 1 || height < 1 || width > kMostAcross || height > kMostAcross)
            refuse("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                   " pixels");
        const auto texels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
        if (texels > most) refuse("it claims more pixels than its size can hold");
        const std::string fault = fault_of_size(texels * bytes);
        if (!fault.empty()) refuse(fault);
    }

private:
    std::string_view rest_;
    std::string name_;
    std::string format_;
};

}  // namespace sunfleck::engine
