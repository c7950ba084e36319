// Snapshots: picture and statistics of a render under way, a pair of files each.
#include "apps/cli/snapshots.h"

#include "film/film_picture.h"
#include "image/atomic_file.h"
#include "image/picture_file.h"
#include "sunfleck/error.h"

#include <fmt/format.h>

#include <filesystem>

namespace sunfleck::engine {

namespace fs = std::filesystem;

std::string claim_of_snapshots(const std::string& folder) {
    return folder + "/passes.json";
}

void prepare_snapshots(const std::string& folder, bool resumed) {
    std::error_code code;
    fs::create_directories(folder, code);
    if (!fs::is_directory(folder, code))
        throw Error({folder}, "cannot create this folder",
                    "name one in a folder that you may write to");
    const fs::directory_iterator entries(folder, code);
    if (code) throw Error({folder}, "cannot be read: " + code.message(), "name another folder");
    for (const auto& entry : entries)
        if (!resumed && entry.path().extension() == ".exr")
            throw Error({folder}, "holds pictures already", "name a new folder");
    check_writable(claim_of_snapshots(folder));
}

bool is_snapshot(const std::string& name) {
    return name.starts_with("passes-") && (name.ends_with(".exr") || name.ends_with(".json"));
}

void write_snapshot(const std::string& folder, const Film& film, const RunFacts& facts) {
    const std::string name = fmt::format("{}/passes-{:06}", folder, film.pass_count());
    const std::string json = stats_json(film, facts);
    write_file(name + ".json", json);
    write_picture(name + ".exr", film_picture(film, {facts.error_terms.extrapolated}));
}

}  // namespace sunfleck::engine
