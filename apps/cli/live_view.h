// LiveView: what `--view` shows of a render while it goes on.
//
// Pictures are made between passes, so rarely that they cost at most a fiftieth of the time,
// whether anybody looks or not.
#pragma once

#include "apps/cli/pacing.h"
#include "apps/cli/render_setup.h"
#include "live/server.h"
#include "live/status.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// How a page begins and ends.
struct LiveViewing {
    std::string name;  // of what is shown
    Exposure exposure;
    OutputTransform transform{};  // its tone and white balance
    std::string earlier;          // a picture file to compare with, or empty
    std::string host;             // as server.h has it, or empty
    bool extrapolates = false;    // the bias away
    bool opens = false;           // in a browser
    bool stays = false;           // until a signal
    LogLevel log = LogLevel::info;
};

class LiveView {
public:
    /// Serves the page, and says its address unless the log is quiet.
    /// @throws Error if that cannot be, or the earlier picture cannot be read.
    explicit LiveView(LiveViewing viewing);

    /// The scene has been read. @param earlier  passes of a render that goes on, or null.
    void begin(const RenderSetup& setup, const std::vector<std::string>& warnings,
               const Film* earlier);
    void report(const Progress& progress);
    void preview(Picture picture);
    /// Shows the picture so far, if it is time for one.
    void show(const Film& film);
    /// Shows the picture of a render that has ended, unless it stands there.
    void show_last(const RenderState& result);
    /// Shows a picture that is finished.
    void show_finished(Picture picture);
    /// All files are written. Returns when the page is to go.
    /// @param meanwhile  called while viewers want to look at something.
    void end(const std::vector<std::string>& warnings, const std::function<void()>& meanwhile);

    // What viewers want of the render (apps/cli/steered_render.h).
    LiveWishes& wishes() { return *wishes_; }
    int watching() const { return server_.watching(); }
    /// Returns the stops of the exposure that the page follows.
    double exposure() const { return status_.exposure; }
    void accept_wishes();
    /// Says so, if it is new.
    void set_paused(bool is_paused);
    void set_ends(const LiveEnds& ends);
    // A look aside.
    void begin_look(const LiveLook& look);
    void report_look(const Progress& progress);
    void sketch_look(Picture picture);
    void show_look(const Film& film);
    void fail_look(const std::string& fault);
    void end_look();

private:
    /// Puts a picture up. @return what the page says of it.
    LivePicture put_up(Picture picture, LivePlace place, bool is_preview);
    LivePicture picture_of(const Film& film, LivePlace place);
    void tell() { board_->tell(status_json(status_)); }

    LiveViewing viewing_;
    LiveStatus status_;
    Pacing pacing_;
    Pacing look_pacing_;
    std::uint64_t shown_passes_ = 0;  // in the picture
    std::shared_ptr<LiveBoard> board_;
    std::shared_ptr<LiveWishes> wishes_;
    LiveServer server_;
};

}  // namespace sunfleck::engine
