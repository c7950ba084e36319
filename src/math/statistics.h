// Running mean and variance of a series, one number at a time, without cancellation.
//
// Source: Welford, Note on a method for calculating corrected sums of squares and products (1962);
// joining of two series: Chan, Golub, LeVeque (1983).
#pragma once

#include <cmath>
#include <cstdint>

namespace sunfleck::engine {

class RunningMean {
public:
    void add(double value) {
        ++count_;
        const double step = value - mean_;
        mean_ += step / static_cast<double>(count_);
        squares_ += step * (value - mean_);
    }

    /// Joins another series, as if its numbers had come after these. The order is part of the
    /// last bits: join in a fixed order.
    void add(const RunningMean& other) {
        if (other.count_ == 0) return;
        const auto here = static_cast<double>(count_);
        const auto there = static_cast<double>(other.count_);
        const double step = other.mean_ - mean_;
        count_ += other.count_;
        mean_ += step * (there / (here + there));
        squares_ += other.squares_ + step * step * (here * there / (here + there));
    }

    std::uint64_t count() const { return count_; }
    /// Zero when empty.
    double mean() const { return mean_; }
    /// Unbiased, of one number; zero with fewer than two numbers.
    double variance() const { return count_ < 2 ? 0 : squares_ / static_cast<double>(count_ - 1); }
    /// Standard deviation of the mean; zero with fewer than two numbers.
    double standard_error() const {
        return count_ < 2 ? 0 : std::sqrt(variance() / static_cast<double>(count_));
    }

private:
    std::uint64_t count_ = 0;
    double mean_ = 0;
    double squares_ = 0;  // sum of squared deviations from the mean
};

}  // namespace sunfleck::engine
