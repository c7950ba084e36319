// Files of 64-bit little-endian words that end in a checksum: what film files and checkpoints are
// made of.
//
// Texts are their length in bytes and those, padded with zeros; sums are two words, the high one
// first. A reader never makes room for more than the file can fill.
#pragma once

#include "core/exact_sum.h"
#include "film/word_hash.h"
#include "image/atomic_file.h"

#include <cstdint>
#include <istream>
#include <span>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A text as words: its length in bytes and those, padded with zeros.
std::vector<std::uint64_t> words_of(const std::string& text);

/// Words in memory, put together as in a file.
struct WordList {
    std::vector<std::uint64_t> words;

    void put(std::uint64_t word) { words.push_back(word); }
    void put(const std::string& text) {
        for (const std::uint64_t word : words_of(text)) put(word);
    }
    void put(const FixedPoint& sum) {
        put(static_cast<std::uint64_t>(sum.high));
        put(sum.low);
    }
};

/// Writes a file; it has its name when finish() has returned. All faults throw Error.
class WordWriter {
public:
    explicit WordWriter(const std::string& path) : file_(path) {}

    void put(std::uint64_t word) {
        hash_.add(word);
        buffer_.push_back(word);
        if (buffer_.size() >= kWordsAtOnce) flush();
    }
    void put(const std::vector<std::uint64_t>& words) {
        for (const std::uint64_t word : words) put(word);
    }
    void put(const std::string& text) { put(words_of(text)); }
    void put(const FixedPoint& sum) {
        put(static_cast<std::uint64_t>(sum.high));
        put(sum.low);
    }
    void put(std::span<const FixedPoint> sums) {
        for (const FixedPoint& sum : sums) put(sum);
    }

    /// Adds the checksum and commits the file. Call it once, last.
    void finish();

private:
    static constexpr std::size_t kWordsAtOnce = 1U << 15U;

    void flush();

    AtomicFile file_;
    WordHash hash_;
    std::vector<std::uint64_t> buffer_;
};

/// A kind of file that begins with its own word, and what a reader's faults say.
struct WordFileKind {
    std::uint64_t magic;
    const char* name;  // "film file"
    const char* mend;  // what to do about a damaged one
};

/// Accepts the words one after the other; all faults throw Error, of one line.
class WordReader {
public:
    /// @param stream  to be read to its end, which is `size` bytes from here on; outlives this.
    /// @param path    its name, for errors.
    /// @throws Error  that says what the file is, where that is known and it is not of this kind.
    WordReader(std::istream& stream, std::uint64_t size, std::string path, WordFileKind kind);

    /// Words before the checksum that were not taken yet.
    std::uint64_t left() const { return left_; }

    std::uint64_t word() {
        if (left_ == 0) damaged();
        --left_;
        const std::uint64_t word = raw_word();
        hash_.add(word);
        return word;
    }
    /// A word that is at most so large.
    std::uint64_t word_up_to(std::uint64_t largest) {
        const std::uint64_t value = word();
        if (value > largest) damaged();
        return value;
    }
    std::string text();
    FixedPoint sum() {
        const std::uint64_t high = word();
        return {static_cast<std::int64_t>(high), word()};
    }
    void fill(std::span<FixedPoint> sums) {
        for (FixedPoint& value : sums) value = sum();
    }

    /// Accepts two words, and refuses a file of another kind or version.
    void check_head(std::uint64_t magic, std::uint64_t version);
    /// The end of the file: nothing left, and the checksum agrees.
    void finish();

    [[noreturn]] void damaged() const;

private:
    static constexpr std::uint64_t kWordsAtOnce = 1U << 15U;

    std::uint64_t raw_word() {
        if (next_ == buffer_.size()) refill();
        return buffer_[next_++];
    }
    void refill();

    std::istream& stream_;
    std::string path_;
    WordFileKind kind_;
    WordHash hash_;
    std::uint64_t left_ = 0;
    std::vector<std::uint64_t> buffer_;
    std::size_t next_ = 0;
};

}  // namespace sunfleck::engine
