// A film's head as numbers and texts, then its arrays in one order.
#include "render/film_transfer.h"

#include <bit>
#include <sstream>
#include <utility>

namespace sunfleck {
namespace {

using Words = std::vector<std::uint64_t>;

/// Texts: the settings, then names, a line each: of the layers of lights, of the statistics.
struct Head {
    Words numbers;
    std::string settings;
    std::string names;
};

Head head_of(const FilmSums& sums) {
    const FilmKey& key = sums.key;
    std::uint64_t layers = 0;
    for (std::size_t i = 0; i < kLayerCount; ++i)
        if (key.layers.at(i)) layers |= std::uint64_t{1} << i;
    Head head{{static_cast<std::uint64_t>(key.width), static_cast<std::uint64_t>(key.height),
               layers, key.sequential ? 1U : 0U, std::bit_cast<std::uint64_t>(key.alpha), key.seed,
               key.scene_hash, sums.passes.ranges().size(), sums.statistics.size(),
               sums.open_rounds.size(), key.light_layers.size()},
              key.settings,
              {}};
    for (const std::string& name : key.light_layers) head.names += name + "\n";
    for (const PassRange& range : sums.passes.ranges()) {
        head.numbers.push_back(range.begin);
        head.numbers.push_back(range.end);
    }
    for (const auto& [name, value] : sums.statistics) {
        head.names += name + "\n";
        head.numbers.push_back(static_cast<std::uint64_t>(value.high));
        head.numbers.push_back(value.low);
    }
    for (const auto& [number, round] : sums.open_rounds) head.numbers.push_back(number);
    return head;
}

/// The film of that head, all sums zero.
FilmSums empty_film(const Head& head) {
    auto next = head.numbers.begin();
    const auto take = [&] { return *next++; };
    FilmKey key;
    key.width = static_cast<int>(take());
    key.height = static_cast<int>(take());
    const std::uint64_t layers = take();
    for (std::size_t i = 0; i < kLayerCount; ++i) key.layers.at(i) = (layers >> i & 1U) != 0;
    key.sequential = take() != 0;
    key.alpha = std::bit_cast<double>(take());
    key.seed = take();
    key.scene_hash = take();
    key.settings = head.settings;
    const std::uint64_t ranges = take();
    const std::uint64_t statistics = take();
    const std::uint64_t open_rounds = take();
    std::istringstream names(head.names);
    for (std::uint64_t left = take(); left > 0; --left)
        std::getline(names, key.light_layers.emplace_back());
    FilmSums sums = empty_sums(std::move(key));
    for (std::uint64_t i = 0; i < ranges; ++i) {
        const std::uint64_t begin = take();
        sums.passes.insert({begin, take()});
    }
    for (std::uint64_t i = 0; i < statistics; ++i) {
        std::string name;
        std::getline(names, name);
        const auto high = static_cast<std::int64_t>(take());
        sums.statistics[name] = {high, take()};
    }
    for (std::uint64_t i = 0; i < open_rounds; ++i)
        sums.open_rounds[take()] = empty_round(sums.key);
    return sums;
}

/// Calls visit(span) for each array of sums.
template <class Sums, class Visit>
void for_arrays(Sums& sums, const Visit& visit) {
    for (const auto& array : total_arrays(sums)) visit(array);
    for (auto& [number, round] : sums.open_rounds)
        for (const auto& array : arrays(round)) visit(array);
}

}  // namespace

void send_words(const Ranks& ranks, int to, const Words& words) {
    ranks.send(to, std::as_bytes(std::span(words)));
}

Words receive_words(const Ranks& ranks, int from, std::size_t count) {
    Words words(count);
    ranks.receive(from, std::as_writable_bytes(std::span(words)));
    return words;
}

void send_film(const Ranks& ranks, int to, const Film& film) {
    const Head head = head_of(film.sums());
    send_words(ranks, to, {head.numbers.size()});
    send_words(ranks, to, head.numbers);
    send_text(ranks, to, head.settings);
    send_text(ranks, to, head.names);
    for_arrays(film.sums(), [&](auto array) {
        if (!array.empty()) ranks.send(to, std::as_bytes(array));
    });
}

Film receive_film(const Ranks& ranks, int from) {
    Head head;
    head.numbers = receive_words(ranks, from, receive_words(ranks, from, 1)[0]);
    head.settings = receive_text(ranks, from);
    head.names = receive_text(ranks, from);
    FilmSums sums = empty_film(head);
    for_arrays(sums, [&](auto array) {
        if (!array.empty()) ranks.receive(from, std::as_writable_bytes(array));
    });
    return Film(std::move(sums));
}

}  // namespace sunfleck
