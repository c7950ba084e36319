// LookAside: a render of what a viewer looks at aside, a region or by another camera.
//
// It shares the scene's geometry and lights, and leaves the render that waits for it as it is.
#pragma once

#include "apps/cli/render_setup.h"
#include "image/picture.h"
#include "live/look.h"
#include "render/render_hooks.h"

#include <array>
#include <string>

namespace sunfleck::engine {

class LookAside {
public:
    /// @throws Error for settings that the view does not allow.
    LookAside(const RenderSetup& setup, const Look& look);

    /// Returns x0 x1 y0 y1 in pixels of the picture that is rendered.
    const std::array<int, 4>& region() const { return region_; }
    /// Returns the camera as statements of pbrt.
    std::string camera_text() const;

    /// Renders until it is told to end.
    void run(const RenderHooks& hooks);
    /// Returns few pixels at once: surfaces in their colours, as bright as they face the camera.
    /// @param stops  of the exposure at which they are shown.
    Picture sketch(double stops) const;

private:
    RenderSettings settings_;
    std::array<int, 4> region_;
    Scene scene_;
};

}  // namespace sunfleck::engine
