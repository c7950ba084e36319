// Checkpoints: a render as it stands between two passes, to go on from after a stop or a crash.
//
// A file of words (film/word_file.h): magic, version; program, isa; count of the scene's files, and
// each name and hash; radius factor, seconds of building, camera paths, index, photons, learning,
// all of them, and those of the processors; the index of the photon sampler's state in SamplerState
// (0: none, 1: of `paper`) and the state; the words of a film file; checksum of all before. Real
// numbers are the bits of their double; lists are their length and their elements. The next pass is
// the one after the film's last.
//
// The file is written beside the former one and renamed onto it, folder synced: after a crash at
// any moment either is there, whole.
#pragma once

#include "render/render_state.h"
#include "stages/settings.h"

#include <istream>
#include <string>
#include <vector>

namespace sunfleck::engine {

struct SceneFileHash {
    std::string name;  // as read
    std::uint64_t hash = 0;
    friend bool operator==(const SceneFileHash&, const SceneFileHash&) = default;
};

/// What passes depend on beside the film's key, or what explains it.
struct Origin {
    std::string program;  // its version
    std::string isa;
    std::vector<SceneFileHash> files;
    friend bool operator==(const Origin&, const Origin&) = default;
};

struct Checkpoint {
    Origin origin;
    RenderState state;
};

/// @throws Error if the file cannot be written; the former one stands then.
void write_checkpoint(const std::string& path, const Origin& origin, const RenderState& state);

/// @throws Error for what is no checkpoint, is cut or damaged, or was written by another version.
Checkpoint read_checkpoint(const std::string& path);
/// The same from a stream of that many bytes. @param name  for errors.
Checkpoint read_checkpoint(std::istream& stream, std::uint64_t size, const std::string& name);

/// May a job go on from it?
/// @param name  of the checkpoint's file. @param key, stop  the job's.
/// @throws Error that names the first difference, with the value in the file and the one asked for.
void check_same_render(const std::string& name, const Checkpoint& checkpoint, const Origin& origin,
                       const FilmKey& key, const StopSettings& stop);

}  // namespace sunfleck::engine
