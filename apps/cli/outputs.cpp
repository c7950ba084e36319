// Output files of render and merge.
#include "apps/cli/outputs.h"

#include "film/film_file.h"
#include "film/film_picture.h"
#include "image/atomic_file.h"
#include "image/picture_file.h"

namespace sunfleck {
namespace {

bool is_film(const std::string& path) {
    return path.ends_with(".film");
}

}  // namespace

void check_outputs(const std::vector<std::string>& outputs, const std::string& stats) {
    for (const std::string& path : outputs) {
        if (is_film(path))
            check_writable(path);
        else
            check_picture_path(path);
    }
    if (!stats.empty()) check_writable(stats);
}

void write_outputs(const std::vector<std::string>& outputs, const Film& film,
                   const OutputOptions& options) {
    const Picture picture = film_picture(film, {1, options.extrapolate});
    for (const std::string& path : outputs) {
        if (is_film(path))
            write_film(path, film);
        else
            write_picture(path, picture, {static_cast<float>(options.exposure), false});
    }
}

}  // namespace sunfleck
