// DisplayLink: what `--display-server` shows of a render in tev while it goes on.
//
// Pictures are made between passes, so rarely that making and sending them cost at most a fiftieth
// of the time.
#pragma once

#include "apps/cli/pacing.h"
#include "apps/cli/render_setup.h"
#include "display/sender.h"

#include <cstdint>
#include <memory>

namespace sunfleck::engine {

class DisplayLink {
public:
    /// Connects. @param options  with an address. @throws Error if nobody listens there.
    explicit DisplayLink(const RenderOptions& options);

    /// The scene has been read. @param earlier  passes of a render that goes on, or null.
    void begin(const FilmKey& key, const Film* earlier);
    /// Shows a picture of fewer pixels, each as large as makes it the render's size.
    void preview(const Picture& picture);
    /// Shows the picture so far, if it is time for one.
    void show(const Film& film);
    /// All files are written: shows the last picture, and waits for a while until it is sent.
    void end(const Film& film);

private:
    void show_now(const Film& film);

    bool extrapolates_ = false;
    int width_ = 0;
    int height_ = 0;
    Pacing pacing_;
    std::uint64_t shown_passes_ = 0;  // in the picture
    DisplaySender sender_;
};

/// Returns the link that the options ask for, of the first rank; null if there is none.
/// @throws Error if nobody listens at its address.
std::unique_ptr<DisplayLink> display_link(const RenderOptions& options, const Ranks& ranks);

}  // namespace sunfleck::engine
