// Reading and writing of film files; a reader never allocates more than the file can fill.
#include "film/film_file.h"

#include "core/input_file.h"
#include "film/film_head.h"
#include "film/luminance.h"

#include <utility>

namespace sunfleck::engine {
namespace {

constexpr WordFileKind kKind{kFilmMagic, "film file",
                             "use another copy, or render its passes again"};

/// Returns whether the sums fill the rest of the file; checked before they are allocated.
bool sums_fill(std::uint64_t words, const FilmHead& head) {
    const FilmKey& key = head.key;
    const std::uint64_t open_group_count = open_groups(head).size();
    const std::uint64_t early = has_early_sums(key, head.passes) ? 1 : 0;
    const auto blocks = [](int pixels) {
        return static_cast<std::uint64_t>((pixels + kErrorBlock - 1) / kErrorBlock);
    };
    const std::uint64_t discs = key.has_discs() ? 1 : 0;
    std::uint64_t aovs = 3 * key.light_groups.size();
    for (std::size_t i = 0; i < kAovCount; ++i)
        if (key.has(i)) aovs += kAovs.at(i).channels.size();
    const std::uint64_t a_pixel = 1 + early + (1 + open_group_count) * aovs;
    if (a_pixel > words / key.pixels()) return false;  // so that the product cannot overflow
    const std::uint64_t a_block =
        1 + early + (1 + 2 * early) * discs + 3 * open_group_count * discs;
    return words == 2 * (a_pixel * key.pixels() + 6 * discs * photon_cells_of(key).count() +
                         a_block * blocks(key.width) * blocks(key.height) + 1 + discs + 2 * early);
}

}  // namespace

void put_film(WordWriter& out, const Film& film) {
    out.put(head_words(film.sums()));
    for (const auto& array : all_arrays(film.sums())) out.put(array);
}

void write_film(const std::string& path, const Film& film) {
    WordWriter out(path);
    put_film(out, film);
    out.finish();
}

Film take_film(WordReader& in) {
    FilmHead head = take_head(in);
    if (!sums_fill(in.left(), head)) in.damaged();
    FilmSums sums = empty_sums(std::move(head));
    for (const auto& array : all_arrays(sums)) in.fill(array);
    return Film(std::move(sums));
}

Film read_film(std::istream& stream, std::uint64_t size, const std::string& name) {
    WordReader in(stream, size, name, kKind);
    Film film = take_film(in);
    in.finish();
    return film;
}

Film read_film(const std::string& path) {
    OpenFile file = open_input_file(path, {path});
    return read_film(file.stream, file.size, path);
}

}  // namespace sunfleck::engine
