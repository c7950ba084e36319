// Sums of real numbers that do not depend on the order of adding: two-word fixed point.
//
// Unit 2^-64, range [-2^63, 2^63). A float is added exactly if its last bit is worth 2^-64 or
// more (any |x| >= 2^-41); smaller ones are rounded towards zero to the unit. Addition of integers
// is associative, so threads, ranks and merged files give the same bytes in any order.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>

namespace sunfleck::engine {

/// A number of the exact sums: value = high + low / 2^64.
struct FixedPoint {
    std::int64_t high = 0;
    std::uint64_t low = 0;

    friend bool operator==(const FixedPoint&, const FixedPoint&) = default;

    /// Wraps around beyond the range; from_double() keeps single terms far inside it.
    FixedPoint& operator+=(const FixedPoint& other) {
        low += other.low;
        const std::uint64_t carry = low < other.low ? 1 : 0;
        high = static_cast<std::int64_t>(static_cast<std::uint64_t>(high) +
                                         static_cast<std::uint64_t>(other.high) + carry);
        return *this;
    }

    FixedPoint operator-() const {
        const std::uint64_t carry = low == 0 ? 1 : 0;
        return {static_cast<std::int64_t>(~static_cast<std::uint64_t>(high) + carry), ~low + 1};
    }

    /// This n times; wraps around as sums do. @param n  below 2^31.
    FixedPoint times(std::uint32_t n) const {
        const std::uint64_t lower = (low & 0xFFFF'FFFFU) * n;
        const std::uint64_t upper = (low >> 32U) * n + (lower >> 32U);
        return {static_cast<std::int64_t>(static_cast<std::uint64_t>(high) * n + (upper >> 32U)),
                upper << 32U | (lower & 0xFFFF'FFFFU)};
    }

    /// The multiple of the unit nearest to x on the side of zero. @param x  |x| <= kLargestTerm.
    static FixedPoint from_double(double x) {
        const double size = std::abs(x);
        const auto whole = static_cast<std::int64_t>(size);
        // In two halves: converting to 64 unsigned bits at once would branch on the first of them.
        const double upper = (size - static_cast<double>(whole)) * 0x1p32;
        const auto upper_bits = static_cast<std::int64_t>(upper);
        const double lower = (upper - static_cast<double>(upper_bits)) * 0x1p32;
        const FixedPoint result{whole,
                                static_cast<std::uint64_t>(upper_bits) << 32U |
                                    static_cast<std::uint64_t>(static_cast<std::int64_t>(lower))};
        return x < 0 ? -result : result;
    }

    /// The value, to one unit in the last place of a double; small negative ones, too.
    double to_double() const {
        if (high < 0 && *this != -*this) return -(-*this).to_double();  // -2^63 is its own negative
        return static_cast<double>(high) + static_cast<double>(low) * 0x1p-64;
    }
};

/// Terms beyond this are saturated by whoever adds, and counted: fewer than 2^16 of them fit.
inline constexpr double kLargestTerm = 0x1p47;

/// @return the number nearest to x that one term may be. @param x  not NaN.
constexpr double cut_term(double x) {
    return std::clamp(x, -kLargestTerm, kLargestTerm);
}

/// A FixedPoint that many threads may add to at once. Read it only when all adding has ended.
class AtomicFixedPoint {
public:
    void add(const FixedPoint& term) {
        const std::uint64_t before = low_.fetch_add(term.low, std::memory_order_relaxed);
        const std::uint64_t carry = before + term.low < before ? 1 : 0;
        const std::uint64_t high = static_cast<std::uint64_t>(term.high) + carry;
        if (high != 0) high_.fetch_add(high, std::memory_order_relaxed);
    }

    /// The same, by a thread that is alone here until others are told: without a locked bus.
    void add_alone(const FixedPoint& term) {
        FixedPoint sum = value();
        sum += term;
        low_.store(sum.low, std::memory_order_relaxed);
        high_.store(static_cast<std::uint64_t>(sum.high), std::memory_order_relaxed);
    }

    FixedPoint value() const {
        return {static_cast<std::int64_t>(high_.load(std::memory_order_relaxed)),
                low_.load(std::memory_order_relaxed)};
    }

private:
    std::atomic<std::uint64_t> high_{0};
    std::atomic<std::uint64_t> low_{0};
};

}  // namespace sunfleck::engine
