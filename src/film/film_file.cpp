// Film files, word by word; a reader never allocates more than the file can fill.
#include "film/film_file.h"

#include "core/error.h"
#include "film/word_hash.h"
#include "image/atomic_file.h"

#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>

namespace sunfleck {
namespace {

static_assert(std::endian::native == std::endian::little, "words are stored as they stand");
static_assert(sizeof(FixedPoint) == 16, "sums are stored as two words");

constexpr std::uint64_t kMagic = 0x0A'6D'6C'69'66'6E'75'73;  // "sunfilm\n"
constexpr std::uint64_t kVersion = 1;
constexpr std::uint64_t kSequential = std::uint64_t{1} << 63U;
constexpr std::uint64_t kMostPixelsAcross = 1U << 17U;
constexpr std::uint64_t kMostPasses = std::uint64_t{1} << 32U;
constexpr std::size_t kWordsAtOnce = 1U << 15U;

class WordWriter {
public:
    explicit WordWriter(const std::string& path) : file_(path) {}

    void put(std::uint64_t word) {
        hash_.add(word);
        buffer_.push_back(word);
        if (buffer_.size() >= kWordsAtOnce) flush();
    }
    void put(const std::string& text) {
        put(text.size());
        for (std::size_t i = 0; i < text.size(); i += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, text.data() + i, std::min<std::size_t>(8, text.size() - i));
            put(word);
        }
    }
    void put(const FixedPoint& sum) {
        put(static_cast<std::uint64_t>(sum.high));
        put(sum.low);
    }
    void put(const FixedPoints& sums) {
        for (const FixedPoint& sum : sums) put(sum);
    }

    void finish() {
        put(hash_.value());
        flush();
        file_.commit();
    }

private:
    void flush() {
        file_.write(std::as_bytes(std::span(buffer_)));
        buffer_.clear();
    }

    AtomicFile file_;
    WordHash hash_;
    std::vector<std::uint64_t> buffer_;
};

class WordReader {
public:
    WordReader(std::istream& stream, std::uint64_t size, const std::string& path)
        : stream_(stream), path_(path) {
        if (size % 8 != 0 || size < 16) damaged();
        left_ = size / 8 - 1;  // the last is the checksum
    }

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
    std::string text() {
        const std::uint64_t size = word_up_to(left_ * 8);
        if ((size + 7) / 8 > left_) damaged();
        std::string text(size, '\0');
        for (std::size_t i = 0; i < size; i += 8) {
            const std::uint64_t bytes = word();
            std::memcpy(text.data() + i, &bytes, std::min<std::size_t>(8, size - i));
        }
        return text;
    }
    FixedPoint sum() {
        const std::uint64_t high = word();
        return {static_cast<std::int64_t>(high), word()};
    }
    void fill(FixedPoints& sums) {
        for (FixedPoint& value : sums) value = sum();
    }

    /// The end of the file: nothing left, and the checksum agrees.
    void finish() {
        if (left_ != 0 || raw_word() != hash_.value()) damaged();
    }

    [[noreturn]] void damaged() const {
        throw Error({path_}, "is no film file, or is cut or damaged",
                    "use another copy, or render its passes again");
    }

    const std::string& path() const { return path_; }

private:
    std::uint64_t raw_word() {
        if (next_ == buffer_.size()) {
            buffer_.resize(std::min<std::uint64_t>(kWordsAtOnce, left_ + 2));
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): streams take char alone
            stream_.read(reinterpret_cast<char*>(buffer_.data()),
                         static_cast<std::streamsize>(buffer_.size() * 8));
            buffer_.resize(static_cast<std::size_t>(stream_.gcount()) / 8);
            next_ = 0;
            if (buffer_.empty()) damaged();
        }
        return buffer_[next_++];
    }

    std::istream& stream_;
    const std::string& path_;
    WordHash hash_;
    std::uint64_t left_ = 0;
    std::vector<std::uint64_t> buffer_;
    std::size_t next_ = 0;
};

FilmKey read_key(WordReader& in) {
    if (in.word() != kMagic) in.damaged();
    const std::uint64_t version = in.word();
    if (version != kVersion)
        throw Error({in.path()}, "is a film file of version " + std::to_string(version),
                    "use the program that wrote it; this one reads version 1");
    FilmKey key;
    key.width = static_cast<int>(in.word_up_to(kMostPixelsAcross));
    key.height = static_cast<int>(in.word_up_to(kMostPixelsAcross));
    const std::uint64_t flags = in.word();
    const std::uint64_t layers = flags & ~kSequential;
    key.sequential = layers != flags;
    if ((layers >> kLayerCount) != 0) in.damaged();
    if (key.pixels() == 0 || (layers & 1U) == 0) in.damaged();
    for (std::size_t i = 0; i < kLayerCount; ++i) key.layers.at(i) = (layers >> i & 1U) != 0;
    key.seed = in.word();
    key.scene_hash = in.word();
    key.settings = in.text();
    return key;
}

PassSet read_passes(WordReader& in) {
    PassSet passes;
    const std::uint64_t count = in.word_up_to(in.left() / 2);
    std::uint64_t last_end = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        PassRange range;
        range.begin = in.word_up_to(kMostPasses);
        range.end = in.word_up_to(kMostPasses);
        const bool touches = i > 0 && range.begin <= last_end;
        if (range.begin >= range.end || touches) in.damaged();
        last_end = range.end;
        passes.insert(range);
    }
    return passes;
}

FilmStatistics read_statistics(WordReader& in) {
    FilmStatistics statistics;
    const std::uint64_t count = in.word_up_to(in.left() / 3);
    for (std::uint64_t i = 0; i < count; ++i) {
        std::string name = in.text();
        if (!statistics.empty() && name <= statistics.rbegin()->first) in.damaged();
        statistics.emplace(std::move(name), in.sum());
    }
    return statistics;
}

/// Do the sums fill the rest of the file? Asked before any room is made for them.
bool sums_fill(std::uint64_t words, const FilmKey& key, std::uint64_t open_round_count) {
    const auto blocks = [](int pixels) {
        return static_cast<std::uint64_t>((pixels + kErrorBlock - 1) / kErrorBlock);
    };
    std::uint64_t a_pixel = 1 + 3 * open_round_count;
    for (std::size_t i = 0; i < kLayerCount; ++i)
        if (key.has(i)) a_pixel += kLayers.at(i).channels.size();
    if (a_pixel > words / key.pixels()) return false;  // so that the product cannot overflow
    return words == 2 * (a_pixel * key.pixels() + blocks(key.width) * blocks(key.height) + 1);
}

}  // namespace

void write_film(const std::string& path, const Film& film) {
    const FilmSums& sums = film.sums();
    WordWriter out(path);
    std::uint64_t layers = sums.key.sequential ? kSequential : 0;
    for (std::size_t i = 0; i < kLayerCount; ++i)
        if (sums.key.has(i)) layers |= std::uint64_t{1} << i;
    for (const std::uint64_t word :
         {kMagic, kVersion, static_cast<std::uint64_t>(sums.key.width),
          static_cast<std::uint64_t>(sums.key.height), layers, sums.key.seed, sums.key.scene_hash})
        out.put(word);
    out.put(sums.key.settings);
    out.put(sums.passes.ranges().size());
    for (const PassRange& range : sums.passes.ranges()) {
        out.put(range.begin);
        out.put(range.end);
    }
    out.put(sums.statistics.size());
    for (const auto& [name, value] : sums.statistics) {
        out.put(name);
        out.put(value);
    }
    for (const FixedPoints& layer : sums.layers) out.put(layer);
    out.put(sums.pixel_squares);
    out.put(sums.block_squares);
    out.put(sums.image_square);
    for (const auto& [number, round] : sums.open_rounds) out.put(round);
    out.finish();
}

Film read_film(std::istream& stream, std::uint64_t size, const std::string& name) {
    WordReader in(stream, size, name);
    const FilmKey key = read_key(in);
    PassSet passes = read_passes(in);
    FilmStatistics statistics = read_statistics(in);
    const auto open = key.sequential ? std::vector<std::uint64_t>() : open_rounds(passes);
    if (!sums_fill(in.left(), key, open.size())) in.damaged();

    FilmSums sums = std::move(Film(key)).sums();
    sums.passes = std::move(passes);
    sums.statistics = std::move(statistics);
    for (FixedPoints& layer : sums.layers) in.fill(layer);
    in.fill(sums.pixel_squares);
    in.fill(sums.block_squares);
    sums.image_square = in.sum();
    for (const std::uint64_t number : open) {
        FixedPoints& round = sums.open_rounds[number];
        round.resize(3 * key.pixels());
        in.fill(round);
    }
    in.finish();
    return Film(std::move(sums));
}

Film read_film(const std::string& path) {
    std::error_code code;
    std::ifstream file(path, std::ios::binary);
    const std::uintmax_t size = std::filesystem::file_size(path, code);
    if (code || !file)
        throw Error({path}, "there is no such file, or it cannot be opened", "check the name");
    return read_film(file, size, path);
}

}  // namespace sunfleck
