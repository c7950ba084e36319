// Numbers of a PLY body one after the other: from text, or from bytes of either order.
//
// Both kinds offer number(type), which throws PlyFault at the end of the bytes, and skip(count,
// type). room_for() says whether that many rows can be there at all, before anything is allocated.
#pragma once

#include "import/ply/header.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace sunfleck::engine {

/// The bytes end, or hold what is no number; the reader adds where.
struct PlyFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

template <std::endian Order>
class PlyBinarySource {
public:
    explicit PlyBinarySource(std::string_view bytes)
        : at_(bytes.data()), end_(bytes.data() + bytes.size()) {}

    double number(PlyType type) {
        switch (type) {
            case PlyType::int8:
                return take<std::int8_t>();
            case PlyType::uint8:
                return take<std::uint8_t>();
            case PlyType::int16:
                return take<std::int16_t>();
            case PlyType::uint16:
                return take<std::uint16_t>();
            case PlyType::int32:
                return take<std::int32_t>();
            case PlyType::uint32:
                return take<std::uint32_t>();
            case PlyType::float32:
                return static_cast<double>(take<float>());
            case PlyType::float64:
                return take<double>();
        }
        return 0;
    }

    void skip(std::uint64_t count, PlyType type) {
        if (count > left() / ply_size(type)) throw PlyFault("the file ends there");
        at_ += count * ply_size(type);
    }

    bool room_for(const PlyElement& element) const {
        std::uint64_t row = 0;
        for (const PlyProperty& p : element.properties)
            row += ply_size(p.count_type.value_or(p.type));
        return row == 0 || element.count <= left() / row;
    }

private:
    std::uint64_t left() const { return static_cast<std::uint64_t>(end_ - at_); }

    template <class Value>
    Value take() {
        if (left() < sizeof(Value)) throw PlyFault("the file ends there");
        std::array<char, sizeof(Value)> bytes;
        std::memcpy(bytes.data(), at_, sizeof(Value));
        if constexpr (Order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
        at_ += sizeof(Value);
        return std::bit_cast<Value>(bytes);
    }

    const char* at_;
    const char* end_;
};

class PlyTextSource {
public:
    explicit PlyTextSource(std::string_view bytes)
        : at_(bytes.data()), end_(bytes.data() + bytes.size()) {}

    double number(PlyType) {
        while (at_ != end_ && is_blank(*at_)) ++at_;
        if (at_ == end_) throw PlyFault("the file ends there");
        const bool plus = *at_ == '+' && at_ + 1 != end_ && at_[1] != '-';
        double value = 0;
        const auto result = std::from_chars(at_ + (plus ? 1 : 0), end_, value);
        if (result.ec == std::errc::result_out_of_range) return out_of_range(result.ptr);
        if (result.ec == std::errc() && result.ptr != end_ && *result.ptr == '#')
            return not_finite(result.ptr);
        if (result.ec != std::errc() || (result.ptr != end_ && !is_blank(*result.ptr)))
            throw PlyFault("\"" + word() + "\" is no number" +
                           (word().find(',') == std::string::npos
                                ? ""
                                : ", which has a point in place of a comma"));
        at_ = result.ptr;
        return value;
    }

    void skip(std::uint64_t count, PlyType type) {
        for (std::uint64_t i = 0; i < count; ++i) number(type);
    }

    /// A number takes two bytes with the blank behind it, which the last may lack.
    bool room_for(const PlyElement& element) const {
        const std::uint64_t row = 2 * element.properties.size();
        return row == 0 || element.count <= static_cast<std::uint64_t>(end_ - at_ + 1) / row;
    }

private:
    static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    /// What Microsoft's library writes for numbers that are not finite: 1.#INF, -1.#IND, 1.#QNAN.
    double not_finite(const char* mark) {
        for (const std::string_view kind : {"#INF", "#IND", "#QNAN", "#SNAN"}) {
            if (!std::string_view(mark, static_cast<std::size_t>(end_ - mark)).starts_with(kind))
                continue;
            at_ = mark;
            while (at_ != end_ && !is_blank(*at_)) ++at_;
            return kind == "#INF" ? HUGE_VAL : std::nan("");
        }
        throw PlyFault("\"" + word() + "\" is no number");
    }

    /// Tiny numbers are zero; huge ones are infinite, and refused where a float is needed.
    double out_of_range(const char* behind) {
        const std::string_view text(at_, static_cast<std::size_t>(behind - at_));
        const std::size_t exponent = text.find_first_of("eE");
        const bool tiny = exponent == std::string_view::npos
                              ? text.find_first_of("123456789") > text.find('.')
                              : text.find('-', exponent) != std::string_view::npos;
        at_ = behind;
        return tiny ? 0.0 : HUGE_VAL;
    }

    /// The word that stands here, short and printable.
    std::string word() const {
        std::string text;
        for (const char* c = at_; c != end_ && !is_blank(*c) && text.size() < 40; ++c)
            text += *c < 32 || *c > 126 ? '?' : *c;
        return text;
    }

    const char* at_;
    const char* end_;
};

}  // namespace sunfleck::engine
