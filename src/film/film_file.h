// Film files (.film): complete films, for resuming and merging without loss.
//
// Layout, in 64-bit little-endian words: magic, version, width, height, AOVs (bit i: row i of
// kAovs; bit 63: sequential), alpha (the bits of a double; zero: no discs), small passes, seed,
// scene hash, settings; count of light groups, and each name; count of pass ranges, and each begin
// and end; count of statistics, and each name, high and low word; the sums (high, low) of each AOV,
// of each light group, pixel squares, block squares, the picture's square; with discs, of photons'
// light: RGB sums, those times area, block squares, the picture's square; where there are early
// batches, of these pixel squares, block squares, with discs those of photons' light and photons'
// luminance times area, the picture's square, that of photons' light; for each open group its sums
// of each AOV and light group and, with discs, photons' RGB of each block (a sequential film has
// none); checksum of everything before. Equal films have equal files.
#pragma once

#include "film/film.h"
#include "film/word_file.h"

#include <cstdint>
#include <istream>
#include <string>

namespace sunfleck::engine {

/// Writes the film atomically.
/// @throws Error  if the file cannot be written.
void write_film(const std::string& path, const Film& film);

/// @throws Error  for what is not a film, is truncated or damaged, or has another version.
Film read_film(const std::string& path);

/// Reads a film from a stream.
/// @param size  bytes of the film, which reaches to the end of the stream.
/// @param name  for errors.
Film read_film(std::istream& stream, std::uint64_t size, const std::string& name);

/// Writes the words of a film without checksum, for files that contain a film and more.
void put_film(WordWriter& out, const Film& film);
/// Reads a film from all remaining words.
Film take_film(WordReader& in);

}  // namespace sunfleck::engine
