// Film files, word by word; a reader never allocates more than the file can fill.
#include "film/film_file.h"

#include <bit>
#include <cmath>

namespace sunfleck {
namespace {

constexpr std::uint64_t kMagic = 0x0A'6D'6C'69'66'6E'75'73;  // "sunfilm\n"
constexpr std::uint64_t kVersion = 3;
constexpr std::uint64_t kSequential = std::uint64_t{1} << 63U;
constexpr std::uint64_t kMostPixelsAcross = 1U << 17U;
constexpr std::uint64_t kMostPasses = std::uint64_t{1} << 32U;
constexpr WordFileKind kKind{"film file", "use another copy, or render its passes again"};

FilmKey read_key(WordReader& in) {
    in.check_head(kMagic, kVersion);
    FilmKey key;
    key.width = static_cast<int>(in.word_up_to(kMostPixelsAcross));
    key.height = static_cast<int>(in.word_up_to(kMostPixelsAcross));
    const std::uint64_t flags = in.word();
    const std::uint64_t layers = flags & ~kSequential;
    key.sequential = layers != flags;
    if ((layers >> kLayerCount) != 0) in.damaged();
    if (key.pixels() == 0 || (layers & 1U) == 0) in.damaged();
    for (std::size_t i = 0; i < kLayerCount; ++i) key.layers.at(i) = (layers >> i & 1U) != 0;
    key.alpha = std::bit_cast<double>(in.word());
    if (!(key.alpha >= 0 && key.alpha < 1) || std::signbit(key.alpha)) in.damaged();
    if (key.sequential && key.has_discs()) in.damaged();
    key.seed = in.word();
    key.scene_hash = in.word();
    key.settings = in.text();
    const std::uint64_t light_layers = in.word_up_to(kMostLightLayers);
    for (std::uint64_t i = 0; i < light_layers; ++i) {
        key.light_layers.push_back(in.text());
        const std::string& name = key.light_layers.back();
        if (!is_layer_name(name) || is_taken_layer_name(name)) in.damaged();
    }
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
    const std::uint64_t discs = key.has_discs() ? 1 : 0;
    std::uint64_t a_pixel = 1 + 3 * open_round_count + 6 * discs + 3 * key.light_layers.size();
    for (std::size_t i = 0; i < kLayerCount; ++i)
        if (key.has(i)) a_pixel += kLayers.at(i).channels.size();
    if (a_pixel > words / key.pixels()) return false;  // so that the product cannot overflow
    const std::uint64_t a_block = 1 + discs + 3 * open_round_count * discs;
    return words == 2 * (a_pixel * key.pixels() + a_block * blocks(key.width) * blocks(key.height) +
                         1 + discs);
}

}  // namespace

void put_film(WordWriter& out, const Film& film) {
    const FilmSums& sums = film.sums();
    std::uint64_t layers = sums.key.sequential ? kSequential : 0;
    for (std::size_t i = 0; i < kLayerCount; ++i)
        if (sums.key.has(i)) layers |= std::uint64_t{1} << i;
    for (const std::uint64_t word :
         {kMagic, kVersion, static_cast<std::uint64_t>(sums.key.width),
          static_cast<std::uint64_t>(sums.key.height), layers,
          std::bit_cast<std::uint64_t>(sums.key.alpha), sums.key.seed, sums.key.scene_hash})
        out.put(word);
    out.put(sums.key.settings);
    out.put(sums.key.light_layers.size());
    for (const std::string& name : sums.key.light_layers) out.put(name);
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
    for (const auto& array : total_arrays(sums)) out.put(array);
    for (const auto& [number, round] : sums.open_rounds)
        for (const auto& array : arrays(round)) out.put(array);
}

void write_film(const std::string& path, const Film& film) {
    WordWriter out(path);
    put_film(out, film);
    out.finish();
}

Film take_film(WordReader& in) {
    const FilmKey key = read_key(in);
    PassSet passes = read_passes(in);
    FilmStatistics statistics = read_statistics(in);
    const auto open = key.sequential ? std::vector<std::uint64_t>() : open_rounds(passes);
    if (!sums_fill(in.left(), key, open.size())) in.damaged();

    FilmSums sums = empty_sums(key);
    sums.passes = std::move(passes);
    sums.statistics = std::move(statistics);
    for (const auto& array : total_arrays(sums)) in.fill(array);
    for (const std::uint64_t number : open) {
        OpenRound& round = sums.open_rounds[number] = empty_round(key);
        for (const auto& array : arrays(round)) in.fill(array);
    }
    return Film(std::move(sums));
}

Film read_film(std::istream& stream, std::uint64_t size, const std::string& name) {
    WordReader in(stream, size, name, kKind);
    Film film = take_film(in);
    in.finish();
    return film;
}

Film read_film(const std::string& path) {
    OpenFile file(path);
    return read_film(file.stream, file.size, path);
}

}  // namespace sunfleck
