// `sunfleck relight`: lamps dimmed after the render.
#include "apps/cli/commands.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/picture_flags.h"
#include "image/exr.h"
#include "image/id_layers.h"
#include "image/picture_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sunfleck::engine {

int run_relight(const RelightOptions& options) {
    for (const std::string& path : options.outputs) check_picture_path(path);
    check_apart({{options.picture}, options.outputs});
    const OutputClaims claims(options.outputs);
    const Relit relit_now = relit(read_exr(options.picture), options.factors, options.picture);
    DeferredError faults(LogLevel::quiet);  // thrown when all is tried
    check_half_layers(options.files.exr, relit_now.picture);
    check_ids_kept(relit_now.picture, options.files.exr);
    const PictureFileOptions files =
        with_exposure(options.files, options.exposure, relit_now.picture);
    for (const std::string& path : options.outputs)
        faults.attempt([&] { write_picture(path, relit_now.picture, files); });
    faults.finish();
    if (!relit_now.left_out.empty())
        say(fmt::format("{}: the AOVs {} were left out: they show the lights before relighting",
                        options.picture, fmt::join(relit_now.left_out, ", ")));
    return 0;
}

}  // namespace sunfleck::engine
