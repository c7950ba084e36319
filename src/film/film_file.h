// Film files (.film): all of a film, to be resumed or merged with nothing lost.
//
// Layout, in 64-bit little-endian words: magic, version, width, height, AOVs (bit i: row i of
// kAovs; bit 63: sequential), alpha (the bits of a double; zero: no discs), seed, scene hash,
// settings; count of light groups, and each name; count of pass ranges, and each begin and end;
// count of weights above one, and each, with its passes in the same way;
// count of statistics, and each name, high and low word; the sums (high, low) of each AOV, of
// each light group, pixel squares, block squares, the picture's square; with discs, of what
// photons have brought: RGB sums, those by area, block squares, the picture's square; for each open
// batch its sums of each AOV and of each light group and, with discs, photons' RGB of each
// block (a sequential film has none); checksum of all before. One film has one file.
#pragma once

#include "film/film.h"
#include "film/word_file.h"

#include <cstdint>
#include <istream>
#include <string>

namespace sunfleck::engine {

/// Writes the film, atomically.
/// @throws Error if the file cannot be written.
void write_film(const std::string& path, const Film& film);

/// @throws Error for what is no film, is cut or damaged, or was written by another version.
Film read_film(const std::string& path);

/// The same from a stream. @param size  bytes of the film, all of the stream's from here on.
/// @param name  for errors.
Film read_film(std::istream& stream, std::uint64_t size, const std::string& name);

/// The words of a film file but its checksum, for files that hold a film and more.
void put_film(WordWriter& out, const Film& film);
/// The same back: all words that are left.
Film take_film(WordReader& in);

}  // namespace sunfleck::engine
