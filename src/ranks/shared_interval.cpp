// Blocks are rendered first and handed up after, so that no rank waits for one that is at work.
#include "ranks/shared_interval.h"

#include "ranks/film_transfer.h"
#include "ranks/reduction_interval.h"
#include "sunfleck/error.h"

#include <array>
#include <bit>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Passes of one part that a rank holds, its own and those handed up to it.
struct Held {
    std::optional<Film> film;
    double radius_factor = 1;  // of the last one: radii never grow, and neighbours hand up in order
};

void add(Held& held, Held&& other, int from) {
    if (!other.film) return;
    held.radius_factor = other.radius_factor;
    if (held.film)
        held.film->merge(*other.film, "rank " + std::to_string(from));
    else
        held.film = std::move(other.film);
}

void hand_up_films(const Ranks& ranks, Held& held) {
    const auto take = [&](int from) {
        Held other;
        if (receive_words(ranks, from, 1)[0] != 0) {
            other.radius_factor = std::bit_cast<double>(receive_words(ranks, from, 1)[0]);
            other.film = receive_film(ranks, from);
        }
        add(held, std::move(other), from);
    };
    hand_up(ranks, take, [&](int to) {
        send_words(ranks, to, {held.film ? 1U : 0U});
        if (!held.film) return;
        send_words(ranks, to, {std::bit_cast<std::uint64_t>(held.radius_factor)});
        send_film(ranks, to, *held.film);
        held.film.reset();
    });
}

RankNote hand_up_notes(const Ranks& ranks, RankNote note) {
    const auto take = [&](int from) {
        const auto words = receive_words(ranks, from, 2);
        note.cpu_seconds += std::bit_cast<double>(words[0]);
        note.interrupted = note.interrupted || words[1] != 0;
    };
    hand_up(ranks, take, [&](int to) {
        send_words(ranks, to,
                   {std::bit_cast<std::uint64_t>(note.cpu_seconds), note.interrupted ? 1U : 0U});
    });
    return note;
}

}  // namespace

void check_same_render(const Ranks& ranks, const FilmKey& key) {
    const std::string all = std::string(SUNFLECK_VERSION) + "\n" + key.settings;
    const std::array<std::uint64_t, 3> mine = {key.scene_hash, key.seed, hash_text(all)};
    std::array<std::uint64_t, 3> of_first = mine;
    broadcast(ranks, std::as_writable_bytes(std::span(of_first)));
    const auto differs = [&](const std::string& what) {
        throw Error({"render"}, what + " is not that of rank 0",
                    "give all ranks the same program, files and flags");
    };
    if (mine[0] != of_first[0]) differs("the scene");
    if (mine != of_first) differs("a setting or the program's version");
}

RankNote SharedInterval::render(
    const PassRange& interval, const std::function<RankNote()>& note,
    const std::function<void(const PassRange&, const Film&, double)>& take) {
    const PassRange block = block_of(interval, ranks_.rank, ranks_.size);
    const std::vector<PassRange> parts =
        ends_at_batches_ ? cut_at_batches(interval) : std::vector<PassRange>{interval};
    std::vector<Held> held(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const PassRange mine = common(parts[i], block);
        if (mine.size() > 0) held[i].film.emplace(key_);
        for (std::uint64_t number = mine.begin; number < mine.end; ++number) {
            held[i].radius_factor = make_pass_(static_cast<std::uint32_t>(number), *held[i].film);
        }
    }
    const RankNote all = hand_up_notes(ranks_, note());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        hand_up_films(ranks_, held[i]);
        if (ranks_.is_first()) take(parts[i], *held[i].film, held[i].radius_factor);
        held[i].film.reset();
    }
    return all;
}

}  // namespace sunfleck::engine
