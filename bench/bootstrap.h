// 95% intervals by drawing seeds again with repetition (Efron 1979).
#pragma once

#include "core/random.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sunfleck::engine::bench {

struct Interval {
    double low = 0;
    double high = 0;
};

/// Returns the interval of a statistic of two methods.
/// @param seeds  of each. @param statistic  of two lists of seeds, one per method.
template <class Statistic>
Interval bootstrap(std::size_t seeds, const Statistic& statistic) {
    constexpr std::size_t kResamples = 2000;
    RandomStream random(1, Purpose::test, 0, 0);
    std::vector<double> values;
    for (std::size_t resample = 0; resample < kResamples; ++resample) {
        std::vector<std::size_t> first;
        std::vector<std::size_t> second;
        for (std::size_t i = 0; i < seeds; ++i) {
            first.push_back(static_cast<std::size_t>(random.next() * static_cast<double>(seeds)));
            second.push_back(static_cast<std::size_t>(random.next() * static_cast<double>(seeds)));
        }
        values.push_back(statistic(first, second));
    }
    std::sort(values.begin(), values.end());
    return {values[kResamples / 40], values[kResamples - kResamples / 40]};
}

}  // namespace sunfleck::engine::bench
