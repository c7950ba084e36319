// A picture as a value: named channels of floats.
#pragma once

#include <sunfleck/export.h>

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sunfleck {

/// Immutable, and cheap to copy: copies share their channels. Any number of threads may use it.
///
/// Channels have OpenEXR's names: "R", "G", "B" for the picture (linear sRGB), "error.Y" for the
/// standard error of its luminance, "bias.R" ... for the estimated bias of the gather radius,
/// "caustic.R", "depth.Z" ... for AOVs (docs/reference/render.md).
class SUNFLECK_API Picture {
public:
    /// Reads an .exr with all its channels. @throws Error  for what cannot be read.
    static Picture load(const std::string& path);

    int width() const;
    int height() const;
    std::vector<std::string> channels() const;
    bool has(const std::string& channel) const;
    /// width * height values, row after row from the top. They live as long as any copy of the
    /// picture. @throws Error  for a channel that the picture does not have.
    std::span<const float> channel(const std::string& name) const;
    const std::map<std::string, std::string>& metadata() const;

    /// Writes .exr with all channels, or .png or .jpg of R, G, B; whole or not at all. The picture
    /// of a Renderer has its settings of picture files: "tone", "exr-half" and so on.
    /// @param exposure  stops, for .png and .jpg. @throws Error  for another ending, and where the
    /// file cannot be written.
    void save(const std::string& path, std::optional<double> exposure = {}) const;

    // For the library alone.
    struct Data;
    explicit Picture(std::shared_ptr<const Data> data);

private:
    std::shared_ptr<const Data> data_;
};

}  // namespace sunfleck
