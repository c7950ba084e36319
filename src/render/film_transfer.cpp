// A film's head as in a film file, with its checksum; then its arrays in one order.
#include "render/film_transfer.h"

#include "film/film_head.h"

#include <cstring>
#include <sstream>
#include <string>
#include <utility>

namespace sunfleck {
namespace {

using Words = std::vector<std::uint64_t>;

constexpr WordFileKind kKind{"film", "start the render again"};

Words checked_head(const FilmSums& sums) {
    Words words = head_words(sums);
    WordHash hash;
    for (const std::uint64_t word : words) hash.add(word);
    words.push_back(hash.value());
    return words;
}

FilmHead head_from(const Words& words) {
    const auto bytes = std::as_bytes(std::span(words));
    std::string text(bytes.size(), '\0');
    std::memcpy(text.data(), bytes.data(), bytes.size());
    std::istringstream stream(std::move(text));
    WordReader in(stream, bytes.size(), "what a rank sent", kKind);
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
    const Words head = checked_head(film.sums());
    send_words(ranks, to, {head.size()});
    send_words(ranks, to, head);
    for (const auto& array : all_arrays(film.sums()))
        if (!array.empty()) ranks.send(to, std::as_bytes(array));
}

Film receive_film(const Ranks& ranks, int from) {
    const Words head = receive_words(ranks, from, receive_words(ranks, from, 1)[0]);
    FilmSums sums = empty_sums(head_from(head));
    for (const auto& array : all_arrays(sums))
        if (!array.empty()) ranks.receive(from, std::as_writable_bytes(array));
    return Film(std::move(sums));
}

}  // namespace sunfleck
