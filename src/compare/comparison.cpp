// Reads the pictures, checks that they can be compared, and measures them.
#include "compare/comparison.h"

#include "sunfleck/error.h"

#include <filesystem>
#include <set>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& path) {
    std::error_code code;
    return fs::is_directory(path, code);
}

RgbImage read_like(const std::string& path, const Compared& reference) {
    RgbImage image = read_rgb(path);
    if (image.width == reference.image.width && image.height == reference.image.height)
        return image;
    throw Error({path},
                "has " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                    " pixels, and the reference " + std::to_string(reference.image.width) + " x " +
                    std::to_string(reference.image.height),
                "render both in one size");
}

void measure_series(const std::vector<Snapshots>& seeds, const Compared& reference,
                    Compared& compared) {
    std::vector<std::vector<SeriesSample>> samples;
    for (const Snapshots& seed : seeds) {
        auto& row = samples.emplace_back();
        for (const Snapshot& snapshot : seed) {
            const RgbImage image = read_like(snapshot.picture, reference);
            row.push_back({snapshot, measure(reference.image, image, false).metrics});
        }
    }
    compared.seeds = seeds.size();
    compared.points = series_points(samples);
}

Compared compare_one(const CompareInput& input, const Compared& reference) {
    Compared compared;
    compared.input = input;
    compared.shown = input.path;
    if (is_folder(input.path)) {
        const std::vector<Snapshots> seeds = read_series(input.path);
        measure_series(seeds, reference, compared);
        compared.shown = seeds.front().back().picture;
    }
    compared.image = read_like(compared.shown, reference);
    compared.broken = broken_pixels(compared.image);
    compared.measured = measure(reference.image, compared.image);
    return compared;
}

}  // namespace

CompareInput compare_input(const std::string& text) {
    std::error_code code;
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos && !fs::exists(text, code)) {
        CompareInput input{text.substr(0, equals), text.substr(equals + 1)};
        if (input.label.empty() || input.path.empty())
            throw Error({text}, "is no LABEL=PATH", "write both, as in uniform=u.exr");
        return input;
    }
    if (!is_folder(text)) return {fs::path(text).stem().string(), text};
    const fs::path folder = fs::weakly_canonical(text, code);
    return {folder.filename().string(), text};
}

std::vector<std::string> files_of(const CompareInput& input) {
    if (!is_folder(input.path)) return {input.path};
    std::vector<std::string> files;
    for (const Snapshots& seed : read_series(input.path))
        for (const Snapshot& snapshot : seed)
            files.insert(
                files.end(),
                {snapshot.picture, fs::path(snapshot.picture).replace_extension(".json").string()});
    return files;
}

Comparison compare(const CompareInput& reference, const std::vector<CompareInput>& inputs) {
    std::set<std::string> labels;
    for (const CompareInput& input : inputs)
        if (!labels.insert(input.label).second)
            throw Error({input.path}, "is the second picture called \"" + input.label + "\"",
                        "name them, as in LABEL=" + input.path);
    if (is_folder(reference.path))
        throw Error({reference.path}, "is a folder, and the reference is one picture",
                    "name a file in it");
    Comparison comparison;
    comparison.reference.input = reference;
    comparison.reference.shown = reference.path;
    comparison.reference.image = read_rgb(reference.path);
    comparison.reference.broken = broken_pixels(comparison.reference.image);
    for (const CompareInput& input : inputs)
        comparison.pictures.push_back(compare_one(input, comparison.reference));
    return comparison;
}

}  // namespace sunfleck::engine
