// Film files: nothing is lost, merged parts give the same bytes, every damage is an Error.
#include "film/film_file.h"

#include "film/word_hash.h"
#include "image/read_file.h"
#include "sunfleck/error.h"
#include "synthetic.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <sstream>

namespace sunfleck::engine {
namespace {

using testing_support::film_of;
using testing_support::numbers;
using testing_support::small_key;

class FilmFile : public testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return folder_ + "/" + name; }

    std::string bytes_of(const Film& film) const {
        write_film(path("bytes.film"), film);
        return read_file(path("bytes.film"));
    }

    /// Reads a file of these bytes; what the Error says, or "" if there is none.
    std::string fault_of(const std::string& bytes) const {
        std::istringstream stream(bytes);
        try {
            read_film(stream, bytes.size(), "fault.film");
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

private:
    std::string folder_ = testing::TempDir() + "/sunfleck_film_" + std::to_string(::getpid());
};

TEST_F(FilmFile, comes_back_as_it_was) {
    for (const std::uint32_t passes : {0U, 1U, 16U, 40U}) {
        const Film film = film_of(small_key(), numbers(0, passes));
        write_film(path("a.film"), film);
        EXPECT_EQ(read_film(path("a.film")).sums(), film.sums()) << passes;
    }
}

TEST_F(FilmFile, comes_back_without_discs) {
    FilmKey key = small_key();
    key.alpha = 0;
    const Film film = film_of(key, numbers(0, 40));
    EXPECT_TRUE(film.sums().photons.rgb.empty());
    write_film(path("a.film"), film);
    EXPECT_EQ(read_film(path("a.film")).sums(), film.sums());
    EXPECT_LT(bytes_of(film).size() + 24 * key.pixels(),
              bytes_of(film_of(small_key(), numbers(0, 40))).size());
}

/// A film file with one word changed, under a checksum that fits.
std::string with_word(std::string bytes, std::size_t place, std::uint64_t word) {
    std::memcpy(bytes.data() + 8 * place, &word, 8);
    WordHash hash;
    for (std::size_t i = 0; i + 8 < bytes.size(); i += 8) {
        std::uint64_t next = 0;
        std::memcpy(&next, bytes.data() + i, 8);
        hash.add(next);
    }
    const std::uint64_t sum = hash.value();
    std::memcpy(bytes.data() + bytes.size() - 8, &sum, 8);
    return bytes;
}

TEST_F(FilmFile, more_small_passes_than_there_are_are_refused) {
    constexpr std::size_t kSmallPassesPlace = 6;
    const std::string bytes = bytes_of(film_of(small_key(3, 2), numbers(0, 16)));
    EXPECT_EQ(fault_of(with_word(bytes, kSmallPassesPlace, kSmallPasses)), "");
    EXPECT_NE(fault_of(with_word(bytes, kSmallPassesPlace, kSmallPasses + 1)), "");
}

TEST_F(FilmFile, a_sequence_of_radii_that_cannot_be_is_refused) {
    constexpr std::size_t kAovsPlace = 4;
    constexpr std::size_t kAlphaPlace = 5;
    FilmKey key = small_key(3, 2);
    const auto fault_with = [&](double alpha) {
        const std::string bytes = bytes_of(film_of(key, numbers(0, 16)));
        return fault_of(with_word(bytes, kAlphaPlace, std::bit_cast<std::uint64_t>(alpha)));
    };
    EXPECT_EQ(fault_with(0.5), "");
    for (const double alpha : {0.0, -0.5, 1.0, 1e9, std::nan("")})
        EXPECT_NE(fault_with(alpha), "") << alpha;
    const std::string bytes = bytes_of(film_of(key, numbers(0, 16)));
    std::uint64_t held = 0;
    std::memcpy(&held, bytes.data() + 8 * kAovsPlace, 8);
    EXPECT_EQ(fault_of(with_word(bytes, kAovsPlace, held)), "");
    const std::uint64_t sequential = std::uint64_t{1} << 63U;
    EXPECT_NE(fault_of(with_word(bytes, kAovsPlace, held | sequential)), "");
    key.alpha = 0;
    EXPECT_EQ(fault_with(0.0), "");
    EXPECT_NE(fault_with(-0.0), "");  // one film has one file
}

TEST_F(FilmFile, merged_parts_have_the_bytes_of_one_run) {
    const std::string whole = bytes_of(film_of(small_key(), numbers(0, 40)));
    write_film(path("a.film"), film_of(small_key(), numbers(0, 7)));
    write_film(path("b.film"), film_of(small_key(), numbers(7, 29)));
    write_film(path("c.film"), film_of(small_key(), numbers(29, 40)));
    for (std::string order : {"abc", "acb", "bac", "bca", "cab", "cba"}) {
        Film film = read_film(path(order.substr(0, 1) + ".film"));
        merge(film, read_film(path(order.substr(1, 1) + ".film")));
        merge(film, read_film(path(order.substr(2, 1) + ".film")));
        EXPECT_TRUE(bytes_of(film) == whole) << order;
    }
}

TEST_F(FilmFile, a_resumed_film_goes_on_as_if_never_stopped) {
    write_film(path("a.film"), film_of(small_key(), numbers(0, 21)));
    Film film = read_film(path("a.film"));
    merge(film, film_of(small_key(), numbers(21, 34)));
    EXPECT_EQ(film.sums(), film_of(small_key(), numbers(0, 34)).sums());
}

TEST_F(FilmFile, every_flipped_byte_is_an_error) {
    const std::string bytes = bytes_of(film_of(small_key(3, 2), numbers(0, 18)));
    EXPECT_EQ(fault_of(bytes), "");
    for (std::size_t i = 0; i < bytes.size(); ++i)
        for (const int flip : {0x01, 0x80, 0xFF}) {
            std::string broken = bytes;
            broken[i] = static_cast<char>(broken[i] ^ flip);
            EXPECT_NE(fault_of(broken), "") << "byte " << i;
        }
}

TEST_F(FilmFile, top_bits_flipped_in_two_words_do_not_cancel) {
    std::string bytes = bytes_of(film_of(small_key(3, 2), numbers(0, 18)));
    for (const std::size_t word : {60U, 70U})
        bytes[8 * word + 7] = static_cast<char>(bytes[8 * word + 7] ^ 0x80);
    EXPECT_NE(fault_of(bytes), "");
}

TEST_F(FilmFile, every_cut_is_an_error_and_so_is_more) {
    const std::string bytes = bytes_of(film_of(small_key(3, 2), numbers(0, 18)));
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_NE(fault_of(bytes.substr(0, size)), "") << size;
    EXPECT_NE(fault_of(bytes + std::string(8, '\0')), "");
    EXPECT_NE(fault_of(bytes + "x"), "");
}

/// Every word of the header set to large values: refused before anything is allocated for it.
TEST_F(FilmFile, huge_claims_are_refused) {
    const std::string bytes = bytes_of(film_of(small_key(3, 2), numbers(0, 18)));
    for (std::size_t word = 0; word < 30; ++word)
        for (const std::uint64_t claim : {std::uint64_t{1} << 17U, std::uint64_t{1} << 31U,
                                          std::uint64_t{1} << 61U, ~std::uint64_t{0}}) {
            std::string broken = bytes;
            for (std::size_t i = 0; i < 8; ++i)
                broken[8 * word + i] = static_cast<char>(claim >> (8 * i));
            EXPECT_NE(fault_of(broken), "") << word;
        }
}

TEST_F(FilmFile, errors_are_one_clear_line) {
    std::string bytes = bytes_of(film_of(small_key(3, 2), numbers(0, 18)));
    EXPECT_EQ(fault_of("anything"),
              std::string("fault.film") +
                  ": is not a film file, or is truncated or damaged; use another copy, "
                  "or render its passes again");
    bytes[8] = 8;
    EXPECT_EQ(fault_of(bytes), std::string("fault.film") +
                                   ": is a film file of version 8; use the program that wrote "
                                   "it; this one reads version 10");
    EXPECT_THROW(read_film(path("none.film")), Error);
}

/// Whatever its length: most are no multiple of words, and some are shorter than one.
TEST_F(FilmFile, another_kind_of_file_is_named) {
    using std::string_literals::operator""s;
    const std::map<std::string, std::string> files = {
        {"", "is empty"},
        {"version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 1\n", "git lfs pull"},
        {"<!DOCTYPE html><html><body>Not found</body></html>", "a web page"},
        {"\x1F\x8B\x08\0\0\0\0\0\0\0"s, "compressed by gzip"},
        {"PK\x03\x04", "a ZIP archive"},
        {"\x28\xB5\x2F\xFD", "compressed by zstd"},
        {"\x76\x2F\x31\x01\x02\0\0\0"s + std::string(1000, 'x'), "an OpenEXR picture"},
        {"sunckpt\n"s + std::string(64, '\0'), "a checkpoint of Sunfleck"},
        {"ply\n", "a PLY mesh"}};
    for (const auto& [bytes, part] : files) {
        EXPECT_NE(fault_of(bytes).find(part), std::string::npos) << part << ": " << fault_of(bytes);
        EXPECT_NE(fault_of(bytes).find("film file"), std::string::npos) << fault_of(bytes);
    }
}

/// Names that no picture could hold beside its other aovs.
TEST_F(FilmFile, light_layers_have_names_of_layers) {
    FilmKey key = small_key();
    key.light_groups = {"lamps", "sun-2"};
    EXPECT_EQ(fault_of(bytes_of(film_of(key, numbers(0, 2)))), "");
    for (const char* name : {"a b", "", "2nd", "error", "bias", "direct", "d.R"}) {
        key.light_groups[1] = name;
        EXPECT_NE(fault_of(bytes_of(film_of(key, numbers(0, 2)))), "") << name;
    }
}

}  // namespace
}  // namespace sunfleck::engine
