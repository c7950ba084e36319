// Standard errors, as they are reported, against the true spread of many independent renders.
#pragma once

#include "film/error_bars.h"

namespace sunfleck::engine::testing_support {

/// Mean over renders of the reported variance, over the true variance between them.
class Spread {
public:
    void add(const MeanError& seen) {
        ++count_;
        reported_ += seen.standard_error * seen.standard_error;
        const double before = seen.mean - mean_;
        mean_ += before / count_;
        squares_ += before * (seen.mean - mean_);
    }
    double reported() const { return reported_ / count_; }
    double spread() const { return squares_ / (count_ - 1); }

private:
    int count_ = 0;
    double reported_ = 0;
    double mean_ = 0;
    double squares_ = 0;
};

}  // namespace sunfleck::engine::testing_support
