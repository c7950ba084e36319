// Terms that wait in lists of many threads make the same sums as terms added one by one.
#include "estimate/shared_terms.h"

#include "core/parallel.h"
#include "core/random.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kPixels = 40'000;
constexpr std::size_t kTerms = 100'000;

/// Term i of a list in which few pixels get most of the terms.
SharedTerms::Term term(std::size_t i) {
    RandomStream random(1, Purpose::test, 0, static_cast<std::uint32_t>(i));
    const float place = random.next_float();
    const auto pixel = static_cast<std::uint32_t>(place * place * place * kPixels);
    const Aov owner = random.next_float() < 0.5F ? Aov::caustic : Aov::indirect;
    return {Vec3(random.next_float(), -random.next_float(), 1e-9F * random.next_float()), pixel,
            owner};
}

PassImage image() {
    AovSet wanted{};
    wanted[static_cast<std::size_t>(Aov::caustic)] = true;
    return {kPixels, wanted};
}

TEST(SharedTerms, sums_are_those_of_terms_added_one_by_one) {
    PassImage expected = image();
    for (std::size_t i = 0; i < kTerms; ++i)
        expected.add_light(term(i).pixel, term(i).rgb, term(i).owner);
    PassImage shared = image();
    PixelLocks locks;
    const ThreadLimit limit(4);
    parallel_blocks(kTerms, 9000, [&](std::size_t begin, std::size_t end) {
        SharedTerms terms(shared, locks);
        for (std::size_t i = begin; i < end; ++i) terms.add(term(i));
        terms.flush();
    });
    for (const Aov aov : {Aov::total, Aov::caustic})
        for (std::size_t pixel = 0; pixel < kPixels; ++pixel)
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_EQ(shared.value(aov, pixel, c), expected.value(aov, pixel, c));
}

}  // namespace
}  // namespace sunfleck::engine
