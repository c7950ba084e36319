// Access to the channels of a picture.
#include "sunfleck/picture.h"

#include "image/exr.h"
#include "image/picture_file.h"
#include "library/guarded.h"
#include "library/picture_data.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck {
namespace {

/// Layers in halves must be there, but for those that a picture of few passes lacks.
void check_layers(const engine::ExrOptions& options, const engine::Picture& picture) {
    for (const std::string& layer : options.half_layers) {
        if (layer == "error" || layer == "bias") continue;
        if (std::none_of(picture.channels.begin(), picture.channels.end(),
                         [&](const auto& c) { return engine::exr_layer(c.name) == layer; }))
            throw Error({"exr-half"}, "the picture has no layer \"" + layer + "\"",
                        "ask channels() for those that there are");
    }
}

}  // namespace

Picture Picture::load(const std::string& path) {
    return guarded(
        [&] { return Picture(std::make_shared<const Data>(Data{engine::read_exr(path)})); });
}

Picture::Picture(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

int Picture::width() const {
    return data_->picture.width;
}

int Picture::height() const {
    return data_->picture.height;
}

std::vector<std::string> Picture::channels() const {
    std::vector<std::string> names;
    for (const engine::Channel& channel : data_->picture.channels) names.push_back(channel.name);
    return names;
}

bool Picture::has(const std::string& channel) const {
    return data_->picture.find(channel) != nullptr;
}

std::span<const float> Picture::channel(const std::string& name) const {
    const engine::Channel* const found = data_->picture.find(name);
    if (found == nullptr)
        throw Error({"Picture"}, "there is no channel \"" + name + "\"",
                    "ask channels() for those that there are");
    return found->values;
}

const std::map<std::string, std::string>& Picture::metadata() const {
    return data_->picture.metadata;
}

void Picture::save(const std::string& path, std::optional<double> exposure) const {
    engine::PictureFileOptions files = data_->files;
    if (exposure) {
        if (!(std::abs(*exposure) <= engine::kMostExposure))
            throw Error({"Picture"}, "an exposure of " + std::to_string(*exposure) + " stops",
                        "use -100 to 100");
        files.transform.exposure = static_cast<float>(*exposure);
    }
    check_layers(files.exr, data_->picture);
    guarded([&] { engine::write_picture(path, data_->picture, files); });
}

}  // namespace sunfleck
