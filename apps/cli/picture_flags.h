// The flags of picture files, which every command has that writes pictures.
#pragma once

#include "flags/render_flags.h"
#include "image/picture_file.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace sunfleck::engine {

/// Adds --exposure and the flags of kPictureFilesGroup.
void add_picture_flags(CLI::App& app, RenderFlags& flags);

/// Adds those that a page in the browser follows.
void add_page_flags(CLI::App& app, RenderFlags& flags);

/// @param files  that the command writes; names that are no pictures do not count.
/// @param has_page  shows the picture in a browser, too.
/// @throws Error for a flag of a format that none of the files has.
void check_picture_flags(const CLI::App& given, const std::vector<std::string>& files,
                         bool has_page = false);

/// @param layers  that the pictures may have.
/// @throws Error for a layer of --exr-half that is none of them.
void check_half_layers(const ExrOptions& options, const std::vector<std::string>& layers);

/// The same for the layers of a picture.
void check_half_layers(const ExrOptions& options, const Picture& picture);

}  // namespace sunfleck::engine
