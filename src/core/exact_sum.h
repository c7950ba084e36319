// Exact sums of real numbers: two-word fixed point, so that the order of addition does not matter.
//
// The unit is 2^-64, the range [-2^63, 2^63). A float is added exactly if its last bit is worth
// 2^-64 or more (any |x| >= 2^-41); smaller ones are rounded towards zero. Integer addition is
// associative, so threads, ranks and merged files give the same bytes in any order.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>

namespace sunfleck::engine {

/// A fixed-point number: value = high + low / 2^64.
struct FixedPoint {
    std::int64_t high = 0;
    std::uint64_t low = 0;

    friend bool operator==(const FixedPoint&, const FixedPoint&) = default;

    /// Adds with wrap-around beyond the range; from_double() keeps single terms far inside it.
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

    /// Returns the number over 2^bits, rounded down to a multiple of the unit. @param bits
    /// below 64.
    FixedPoint shifted_down(unsigned bits) const {
        if (bits == 0) return *this;
        return {high >> bits, low >> bits | static_cast<std::uint64_t>(high) << (64 - bits)};
    }

    /// Returns x rounded towards zero to a multiple of the unit. @param x  |x| <= kLargestTerm.
    static FixedPoint from_double(double x) {
        const double size = std::abs(x);
        const auto whole = static_cast<std::int64_t>(size);
        // Two halves, because a conversion to 64 unsigned bits at once branches on the sign bit.
        const double upper = (size - static_cast<double>(whole)) * 0x1p32;
        const auto upper_bits = static_cast<std::int64_t>(upper);
        const double lower = (upper - static_cast<double>(upper_bits)) * 0x1p32;
        const FixedPoint result{whole,
                                static_cast<std::uint64_t>(upper_bits) << 32U |
                                    static_cast<std::uint64_t>(static_cast<std::int64_t>(lower))};
        return x < 0 ? -result : result;
    }

    /// Returns the value as a double, exact to one unit in its last place; also for small negative
    /// ones.
    double to_double() const {
        if (high < 0 && *this != -*this) return -(-*this).to_double();  // -2^63 is its own negative
        return static_cast<double>(high) + static_cast<double>(low) * 0x1p-64;
    }
};

/// The largest term of a sum. Callers clamp larger terms and count them; 2^16 terms fit.
inline constexpr double kLargestTerm = 0x1p47;

/// Clamps x to the range of one term. @param x  not NaN.
constexpr double cut_term(double x) {
    return std::clamp(x, -kLargestTerm, kLargestTerm);
}

/// A FixedPoint that many threads add to at once. It is read only when all threads have finished.
class AtomicFixedPoint {
public:
    void add(const FixedPoint& term) {
        const std::uint64_t before = low_.fetch_add(term.low, std::memory_order_relaxed);
        const std::uint64_t carry = before + term.low < before ? 1 : 0;
        const std::uint64_t high = static_cast<std::uint64_t>(term.high) + carry;
        if (high != 0) high_.fetch_add(high, std::memory_order_relaxed);
    }

    /// Adds without atomic read-modify-write, for a thread that is the only one to write for now.
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
