// Reading and writing of film heads.
#include "film/film_head.h"

#include "film/pass_groups.h"
#include "film/pass_weight.h"

#include <bit>
#include <cmath>
#include <utility>

namespace sunfleck::engine {
namespace {

constexpr std::uint64_t kVersion = 10;
constexpr std::uint64_t kSequential = std::uint64_t{1} << 63U;
constexpr std::uint64_t kMostPixelsAcross = 1U << 17U;
constexpr std::uint64_t kMostPasses = std::uint64_t{1} << 32U;

FilmKey read_key(WordReader& in) {
    in.check_head(kFilmMagic, kVersion);
    FilmKey key;
    key.width = static_cast<int>(in.word_up_to(kMostPixelsAcross));
    key.height = static_cast<int>(in.word_up_to(kMostPixelsAcross));
    const std::uint64_t flags = in.word();
    const std::uint64_t aovs = flags & ~kSequential;
    key.sequential = aovs != flags;
    if ((aovs >> kAovCount) != 0) in.damaged();
    if (key.pixels() == 0 || (aovs & 1U) == 0) in.damaged();
    for (std::size_t i = 0; i < kAovCount; ++i) key.aovs.at(i) = (aovs >> i & 1U) != 0;
    key.alpha = std::bit_cast<double>(in.word());
    if (!(key.alpha >= 0 && key.alpha < 1) || std::signbit(key.alpha)) in.damaged();
    if (key.sequential && key.has_discs()) in.damaged();
    key.small_passes = in.word_up_to(kSmallPasses);
    if (key.sequential && key.small_passes > 0) in.damaged();
    key.seed = in.word();
    key.scene_hash = in.word();
    key.settings = in.text();
    const std::uint64_t light_groups = in.word_up_to(kMostLightGroups);
    for (std::uint64_t i = 0; i < light_groups; ++i) {
        key.light_groups.push_back(in.text());
        const std::string& name = key.light_groups.back();
        if (!is_aov_name(name) || is_taken_aov_name(name)) in.damaged();
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

void put_passes(WordList& out, const PassSet& passes) {
    out.put(passes.ranges().size());
    for (const PassRange& range : passes.ranges()) {
        out.put(range.begin);
        out.put(range.end);
    }
}

}  // namespace

std::vector<std::uint64_t> head_words(const FilmSums& sums) {
    std::uint64_t aovs = sums.key.sequential ? kSequential : 0;
    for (std::size_t i = 0; i < kAovCount; ++i)
        if (sums.key.has(i)) aovs |= std::uint64_t{1} << i;
    WordList out;
    for (const std::uint64_t word :
         {kFilmMagic, kVersion, static_cast<std::uint64_t>(sums.key.width),
          static_cast<std::uint64_t>(sums.key.height), aovs,
          std::bit_cast<std::uint64_t>(sums.key.alpha), sums.key.small_passes, sums.key.seed,
          sums.key.scene_hash})
        out.put(word);
    out.put(sums.key.settings);
    out.put(sums.key.light_groups.size());
    for (const std::string& name : sums.key.light_groups) out.put(name);
    put_passes(out, sums.passes);
    out.put(sums.statistics.size());
    for (const auto& [name, value] : sums.statistics) {
        out.put(name);
        out.put(value);
    }
    return out.words;
}

FilmHead take_head(WordReader& in) {
    FilmHead head;
    head.key = read_key(in);
    head.passes = read_passes(in);
    head.statistics = read_statistics(in);
    return head;
}

std::vector<PassRange> open_groups(const FilmHead& head) {
    if (head.key.sequential) return {};
    return open_groups(head.passes);
}

FilmSums empty_sums(FilmHead head) {
    const std::vector<PassRange> open = open_groups(head);
    FilmSums sums = empty_sums(std::move(head.key));
    sums.passes = std::move(head.passes);
    sums.statistics = std::move(head.statistics);
    sums.early = empty_early_sums(sums.key, sums.passes);
    for (const PassRange& group : open) sums.open_groups[group.begin] = empty_group(sums.key);
    return sums;
}

}  // namespace sunfleck::engine
