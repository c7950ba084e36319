// Stored samples: read again they give the same; mutated, they keep to what was read.
#include "chains/stored_sample.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// Gives 1000 + dimension and counts how often it is asked.
struct CountingReader {
    int* asked;
    std::uint64_t operator()(std::uint32_t dimension) const {
        ++*asked;
        return 1000 + dimension;
    }
};

RandomStream numbers() {
    return {5, Purpose::test, 0, 0};
}

constexpr auto kOneMore = [](std::uint32_t, std::uint64_t value) { return value + 1; };

TEST(StoredSample, has_what_was_set) {
    StoredSample sample;
    EXPECT_FALSE(sample.has(0));
    sample.set(200, 7);
    sample.set(3, 8);
    for (std::uint32_t i = 0; i < 300; ++i) EXPECT_EQ(sample.has(i), i == 3 || i == 200) << i;
    EXPECT_EQ(sample[200], 7U);
    EXPECT_EQ(sample[3], 8U);
}

TEST(StoredSample, cleared_has_nothing_even_when_it_grows_again) {
    StoredSample sample;
    for (std::uint32_t i = 0; i < 130; ++i) sample.set(i, i);
    sample.clear();
    sample.set(129, 1);
    for (std::uint32_t i = 0; i < 129; ++i) EXPECT_FALSE(sample.has(i)) << i;
    EXPECT_TRUE(sample.has(129));
}

TEST(RecordingReader, keeps_what_is_read_and_nothing_else) {
    int asked = 0;
    StoredSample sample;
    RecordingReader read(CountingReader{&asked}, sample);
    EXPECT_EQ(read(9), 1009U);
    EXPECT_EQ(read(4), 1004U);
    EXPECT_EQ(read(9), 1009U);
    EXPECT_EQ(asked, 2);
    for (std::uint32_t i = 0; i < 20; ++i) EXPECT_EQ(sample.has(i), i == 4 || i == 9) << i;
}

TEST(RepeatingReader, repeats_and_draws_nothing) {
    int asked = 0;
    StoredSample sample;
    RecordingReader record(CountingReader{&asked}, sample);
    for (const std::uint32_t i : {0U, 70U, 5U}) record(i);
    RandomStream stream = numbers();
    StoredSample copy = sample;
    RepeatingReader again(copy, stream);
    for (const std::uint32_t i : {5U, 0U, 70U, 5U}) EXPECT_EQ(again(i), 1000 + i);
    EXPECT_EQ(copy, sample);
    EXPECT_EQ(stream.next_fraction(), numbers().next_fraction());
}

TEST(RepeatingReader, draws_what_is_lacking_once) {
    StoredSample sample;
    RandomStream stream = numbers();
    RepeatingReader read(sample, stream);
    const std::uint64_t value = read(11);
    EXPECT_EQ(value, numbers().next_fraction());
    EXPECT_EQ(read(11), value);
    EXPECT_EQ(sample[11], value);
}

TEST(MutatingReader, moves_what_the_parent_read_and_draws_the_rest) {
    StoredSample parent;
    parent.set(2, 50);
    parent.set(90, 60);
    StoredSample child;
    RandomStream stream = numbers();
    MutatingReader read(parent, child, stream, kOneMore);
    EXPECT_EQ(read(90), 61U);
    EXPECT_EQ(read(90), 61U);
    EXPECT_EQ(read(3), numbers().next_fraction());
    EXPECT_EQ(read(3), numbers().next_fraction());
    EXPECT_EQ(parent[90], 60U);
}

TEST(MutatingReader, forgets_what_the_new_path_does_not_read) {
    StoredSample parent;
    parent.set(2, 50);
    parent.set(90, 60);
    StoredSample child;
    RandomStream stream = numbers();
    MutatingReader(parent, child, stream, kOneMore)(2);
    EXPECT_FALSE(child.has(90));
    StoredSample grandchild;
    const std::uint64_t fresh = MutatingReader(child, grandchild, stream, kOneMore)(90);
    EXPECT_EQ(fresh, numbers().next_fraction());
}

TEST(MutatingReader, unread_dimensions_are_never_drawn) {
    StoredSample parent;
    for (std::uint32_t i = 0; i < 10; ++i) parent.set(i, i);
    StoredSample child;
    RandomStream stream = numbers();
    MutatingReader read(parent, child, stream, kOneMore);
    for (const std::uint32_t i : {0U, 7U}) read(i);
    for (std::uint32_t i = 0; i < 100; ++i) EXPECT_EQ(child.has(i), i == 0 || i == 7) << i;
    EXPECT_EQ(stream.next_fraction(), numbers().next_fraction());
}

}  // namespace
}  // namespace sunfleck::engine
