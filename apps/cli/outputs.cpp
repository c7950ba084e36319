// Output files of render and merge.
#include "apps/cli/outputs.h"

#include "film/film_file.h"
#include "film/film_picture.h"
#include "sunfleck/error.h"

#include <filesystem>

namespace sunfleck::engine {
namespace {

bool is_film(const std::string& path) {
    return path.ends_with(".film");
}

}  // namespace

void check_outputs(const std::vector<std::string>& outputs,
                   const std::vector<std::string>& others) {
    for (const std::string& path : outputs) {
        if (!is_film(path) && !is_picture_path(path))
            throw Error({path}, "unknown output format", "end it in .film, " + picture_endings());
        if (is_film(path))
            check_writable(path);
        else
            check_picture_path(path);
    }
    for (const std::string& path : others)
        if (!path.empty()) check_writable(path);
}

OutputClaims::OutputClaims(const std::vector<std::string>& files) {
    for (const std::string& file : files)
        if (!file.empty()) claims_.emplace_back(file);
}

WrittenOutputs write_outputs(const std::vector<std::string>& outputs, const Film& film,
                             const OutputOptions& options, DeferredError& faults) {
    WrittenOutputs written;
    Picture picture = film_picture(film, {options.extrapolate});
    if (options.mattes != nullptr) add_mattes(*options.mattes, picture);
    const PictureFileOptions files = with_exposure(options.files, options.exposure, picture);
    for (const std::string& path : outputs) {
        const bool is_written = faults.attempt([&] {
            if (is_film(path))
                write_film(path, film);
            else
                write_picture(path, picture, files);
        });
        if (!is_written) continue;
        written.files.push_back(path);
        if (written.found_exposure || !options.exposure.is_automatic) continue;
        if (is_film(path) || !loses_aovs(path)) continue;
        written.found_exposure = files.transform.exposure;
        written.exposed_ending = std::filesystem::path(path).extension().string();
    }
    return written;
}

}  // namespace sunfleck::engine
