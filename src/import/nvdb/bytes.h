// NvdbBytes: numbers of a NanoVDB file, each read within its bounds.
#pragma once

#include "sunfleck/error.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace sunfleck::engine {

static_assert(std::endian::native == std::endian::little, "NanoVDB's numbers are read as they are");

class NvdbBytes {
public:
    /// @param name  of the file, for messages; it and the bytes must outlive this.
    NvdbBytes(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    std::size_t size() const { return bytes_.size(); }
    const std::string& name() const { return name_; }

    /// Returns `count` bytes. @throws Error  if they are not all there.
    std::string_view part(std::uint64_t begin, std::uint64_t count) const {
        if (begin > bytes_.size() || count > bytes_.size() - begin)
            refuse("is cut short, or one of its offsets leads out of it", "copy or write it again");
        return bytes_.substr(begin, count);
    }
    template <class Number>
    Number at(std::uint64_t begin) const {
        static_assert(std::is_arithmetic_v<Number>);
        Number number;
        std::memcpy(&number, part(begin, sizeof(Number)).data(), sizeof(Number));
        return number;
    }

    [[noreturn]] void refuse(const std::string& what, const std::string& mend) const {
        throw Error({name_}, what, mend);
    }

private:
    std::string_view bytes_;
    const std::string& name_;
};

}  // namespace sunfleck::engine
