// `sunfleck view`: a finished picture in the browser.
#include "apps/cli/commands.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/live_view.h"
#include "image/exr.h"
#include "live/layers.h"
#include "sunfleck/error.h"

#include <filesystem>

namespace sunfleck::engine {

int run_view(const ViewOptions& options) {
    Picture picture = read_exr(options.picture);
    if (layers_of(picture).empty())
        throw Error({options.picture}, "has no channel that can be shown",
                    "use a picture with channels R, G, B or Y, or with layers of such");
    static constexpr InterruptAnswer kNothingIsLost{};
    const InterruptGuard guard(kNothingIsLost);
    LiveView view({.name = std::filesystem::path(options.picture).filename().string(),
                   .exposure = options.exposure,
                   .transform = options.transform,
                   .earlier = options.against,
                   .host = options.host,
                   .opens = options.opens,
                   .stays = true});
    view.show_finished(std::move(picture));
    view.end({}, [] {});
    return 0;
}

}  // namespace sunfleck::engine
