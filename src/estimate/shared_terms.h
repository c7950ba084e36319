// Terms of pixels to which several threads add: kept, and added many at a time under a lock.
//
// Sums of pixels are exact, so the order of adding does not matter. A locked addition a channel and
// a word would wait for memory each time; so terms wait in a list, and a lock stands for all pixels
// of a stripe.
#pragma once

#include "aovs/pass_image.h"

#include <array>
#include <mutex>
#include <vector>

namespace sunfleck::engine {

/// One lock a stripe of the image's pixels.
class PixelLocks {
public:
    static constexpr std::size_t kStripes = 64;

    static std::size_t stripe_of(std::size_t pixel) { return pixel / kPixels % kStripes; }
    std::mutex& of_stripe(std::size_t stripe) { return locks_[stripe].lock; }
    std::mutex& of_pixel(std::size_t pixel) { return of_stripe(stripe_of(pixel)); }

private:
    static constexpr std::size_t kPixels = 256;  // side by side in one stripe

    struct alignas(64) Lock {
        std::mutex lock;
    };
    std::array<Lock, kStripes> locks_;
};

class SharedTerms {
public:
    struct Term {
        Vec3 rgb;  // PassImage::is_addable()
        std::uint32_t pixel = 0;
        Aov owner = Aov::total;
    };

    /// Whoever else adds to the same pixels meanwhile must hold their locks.
    SharedTerms(PassImage& image, PixelLocks& locks) : image_(image), locks_(locks) {}

    void add(const Term& term) {
        terms_.push_back(term);
        if (terms_.size() == kAtOnce) flush();
    }

    /// Adds what was kept to the image. To be called at the end.
    void flush() {
        std::array<std::size_t, PixelLocks::kStripes + 1> ends{};
        for (const Term& term : terms_) ++ends[PixelLocks::stripe_of(term.pixel) + 1];
        for (std::size_t s = 0; s < PixelLocks::kStripes; ++s) ends[s + 1] += ends[s];
        order_.resize(terms_.size());
        auto next = ends;
        for (std::size_t i = 0; i < terms_.size(); ++i)
            order_[next[PixelLocks::stripe_of(terms_[i].pixel)]++] = static_cast<std::uint32_t>(i);
        for (std::size_t s = 0; s < PixelLocks::kStripes; ++s)
            if (ends[s] < ends[s + 1]) add_stripe(s, ends[s], ends[s + 1]);
        terms_.clear();
    }

private:
    static constexpr std::size_t kAtOnce = 4096;
    static constexpr std::size_t kAhead = 8;

    void add_stripe(std::size_t stripe, std::size_t begin, std::size_t end) {
        const std::lock_guard<std::mutex> guard(locks_.of_stripe(stripe));
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kAhead < order_.size())
                __builtin_prefetch(image_.place_of(terms_[order_[i + kAhead]].pixel), 1);
            const Term& term = terms_[order_[i]];
            image_.add_alone(term.pixel, term.rgb, term.owner);
        }
    }

    PassImage& image_;
    PixelLocks& locks_;
    std::vector<Term> terms_;
    std::vector<std::uint32_t> order_;  // of terms, by stripe
};

}  // namespace sunfleck::engine
