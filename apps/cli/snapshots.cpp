// Files of a folder of snapshots.
#include "apps/cli/snapshots.h"

#include "core/snapshot_names.h"
#include "film/film_picture.h"
#include "image/atomic_file.h"
#include "image/picture_file.h"
#include "sunfleck/error.h"

#include <fmt/format.h>

#include <filesystem>

namespace sunfleck::engine {

namespace fs = std::filesystem;

namespace {

std::string latest_file(const std::string& folder, std::string_view name) {
    return fmt::format("{}/{}", folder, name);
}

/// A link would lead a snapshot to a file that may be finished.
void refuse_link(const std::string& path) {
    std::error_code code;
    if (fs::is_symlink(path, code))
        throw Error({path}, "is a link, and what it leads to would be replaced by a snapshot",
                    "remove it, or name another folder");
}

}  // namespace

std::vector<std::string> claims_of_snapshots(const std::string& folder) {
    return {folder + "/passes.json", latest_file(folder, kLatestExr),
            latest_file(folder, kLatestPng)};
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
        if (!resumed && (entry.path().extension() == ".exr" ||
                         is_latest_snapshot(entry.path().filename().string())))
            throw Error({folder}, "holds pictures already", "name a new folder");
    for (const std::string_view name : {kLatestExr, kLatestPng})
        refuse_link(latest_file(folder, name));
    for (const std::string& file : claims_of_snapshots(folder)) check_writable(file);
}

bool is_snapshot(const std::string& name) {
    return is_latest_snapshot(name) ||
           (name.starts_with("passes-") && (name.ends_with(".exr") || name.ends_with(".json")));
}

void write_snapshot(const std::string& folder, const Film& film, const RunFacts& facts,
                    const OutputOptions& options) {
    const std::string name = fmt::format("{}/passes-{:06}", folder, film.pass_count());
    const std::string json = stats_json(film, facts);
    write_file(name + ".json", json);
    const Picture picture = film_picture(film, {facts.error_terms.extrapolated});
    const PictureFileOptions files = with_exposure(options.files, options.exposure, picture);
    write_picture(name + ".exr", picture, files);
    write_picture(latest_file(folder, kLatestExr), picture, files);
    write_picture(latest_file(folder, kLatestPng), picture, files);
}

}  // namespace sunfleck::engine
