// A film's head as in a film file, with its checksum; then its arrays in one order.
#include "ranks/film_transfer.h"

#include "film/film_head.h"

#include <cstring>
#include <sstream>
#include <string>
#include <utility>

namespace sunfleck::engine {
namespace {

using Words = std::vector<std::uint64_t>;

constexpr WordFileKind kSentFilm{kFilmMagic, "film", "start the render again"};

std::string bytes_of(const FilmSums& sums) {
    Words words = head_words(sums);
    WordHash hash;
    for (const std::uint64_t word : words) hash.add(word);
    words.push_back(hash.value());
    std::string bytes(sizeof(std::uint64_t) * words.size(), '\0');
    std::memcpy(bytes.data(), words.data(), bytes.size());
    return bytes;
}

FilmHead head_from(const std::string& bytes) {
    std::istringstream stream(bytes);
    WordReader in(stream, bytes.size(), "what a rank sent", kSentFilm);
    FilmHead head = take_head(in);
    in.finish();
    return head;
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
    send_text(ranks, to, bytes_of(film.sums()));
    for (const auto& array : all_arrays(film.sums()))
        if (!array.empty()) ranks.send(to, std::as_bytes(array));
}

Film receive_film(const Ranks& ranks, int from) {
    FilmSums sums = empty_sums(head_from(receive_text(ranks, from)));
    for (const auto& array : all_arrays(sums))
        if (!array.empty()) ranks.receive(from, std::as_writable_bytes(array));
    return Film(std::move(sums));
}

}  // namespace sunfleck::engine
