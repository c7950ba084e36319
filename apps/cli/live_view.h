// LiveView: what `--view` shows of a render while it goes on.
//
// Pictures are made between passes, so rarely that they cost at most a fiftieth of the time,
// whether anybody looks or not.
#pragma once

#include "apps/cli/render_setup.h"
#include "live/server.h"
#include "live/status.h"

#include <chrono>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// How a page begins and ends.
struct LiveViewing {
    std::string name;  // of what is shown
    Exposure exposure;
    bool extrapolates = false;  // the bias away
    bool opens = false;         // in a browser
    bool stays = false;         // until a signal
    LogLevel log = LogLevel::info;
};

class LiveView {
public:
    /// Serves the page, and says its address unless the log is quiet.
    /// @throws Error if that cannot be.
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
    void end(const std::vector<std::string>& warnings);

private:
    using Clock = std::chrono::steady_clock;

    void put_up(Picture picture, bool is_preview);
    void show_now(const Film& film);
    void tell() { board_->tell(status_json(status_)); }

    LiveViewing viewing_;
    LiveStatus status_;
    Clock::time_point next_;          // picture at the earliest
    std::uint64_t shown_passes_ = 0;  // in the picture
    std::shared_ptr<LiveBoard> board_;
    LiveServer server_;
};

}  // namespace sunfleck::engine
