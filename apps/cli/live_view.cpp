// The page's texts and pictures, from the thread that renders.
#include "apps/cli/live_view.h"

#include "apps/cli/interrupt.h"
#include "apps/cli/messages.h"
#include "film/film_picture.h"
#include "live/layers.h"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <thread>
#include <utility>

extern char** environ;  // NOLINT(readability-redundant-declaration): not every system declares it

namespace sunfleck::engine {
namespace {

constexpr int kOftenOverCost = 50;  // a picture is made once in as many times of what it took
constexpr std::chrono::milliseconds kLeastPause(200);

/// Ends the render as Ctrl+C does, once: a second signal would lose it.
std::function<void()> stop_once() {
    return [is_asked = std::make_shared<std::atomic<bool>>(false)] {
        if (!is_asked->exchange(true)) ::kill(::getpid(), SIGINT);
    };
}

/// Opens an address by the desktop's own choice of a browser.
void open_in_browser(const std::string& url, LogLevel log) {
    std::string program = "xdg-open";
    std::string address = url;
    const std::array<char*, 3> words{program.data(), address.data(), nullptr};
    ::posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    for (const int stream : {1, 2})
        ::posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_WRONLY, 0);
    ::pid_t child = 0;
    const int fault =
        ::posix_spawnp(&child, program.c_str(), &files, nullptr, words.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    if (fault != 0 && log != LogLevel::quiet)
        say("warning: there is no xdg-open; open the address above yourself");
}

}  // namespace

LiveView::LiveView(LiveViewing viewing)
    : viewing_(std::move(viewing)),
      board_(std::make_shared<LiveBoard>()),
      server_(board_, stop_once()) {
    status_.scene = viewing_.name;
    tell();
    const std::string url = server_.url();
    if (viewing_.log != LogLevel::quiet) say(url);
    if (viewing_.opens) open_in_browser(url, viewing_.log);
}

void LiveView::begin(const RenderSetup& setup, const std::vector<std::string>& warnings,
                     const Film* earlier) {
    const FilmKey key = key_of(setup.job);
    status_.width = key.width;
    status_.height = key.height;
    status_.warnings = warnings;
    status_.stage = LiveStage::rendering;
    if (earlier != nullptr) show_now(*earlier);
    tell();
}

void LiveView::report(const Progress& progress) {
    status_.progress = progress;
    status_.stage = progress.is_learning ? LiveStage::learning : LiveStage::rendering;
    tell();
}

void LiveView::preview(Picture picture) {
    put_up(std::move(picture), true);
    tell();
}

void LiveView::show(const Film& film) {
    if (!status_.is_preview && Clock::now() < next_) return;
    show_now(film);
    tell();
}

void LiveView::show_last(const RenderState& result) {
    if (result.film.pass_count() == shown_passes_) return;
    show_now(result.film);
    tell();
}

void LiveView::show_finished(Picture picture) {
    status_.width = picture.width;
    status_.height = picture.height;
    put_up(std::move(picture), false);
}

void LiveView::show_now(const Film& film) {
    const Clock::time_point begin = Clock::now();
    put_up(film_picture(film, {viewing_.extrapolates}), false);
    shown_passes_ = film.pass_count();
    const Clock::time_point end = Clock::now();
    next_ = end + std::max<Clock::duration>(kLeastPause, kOftenOverCost * (end - begin));
}

void LiveView::put_up(Picture picture, bool is_preview) {
    status_.exposure = stops_of(viewing_.exposure, picture);
    status_.is_preview = is_preview;
    status_.layers.clear();
    for (const LiveLayer& layer : layers_of(picture)) status_.layers.push_back(layer.name);
    status_.picture = board_->show(std::move(picture));
}

void LiveView::end(const std::vector<std::string>& warnings) {
    status_.warnings = warnings;
    status_.stage = LiveStage::ended;
    tell();
    if (!viewing_.stays || InterruptGuard::interrupted()) return;
    static constexpr InterruptAnswer kNothingIsLost{};
    InterruptGuard::set_answer(kNothingIsLost);
    constexpr std::chrono::milliseconds kTick(50);
    while (!InterruptGuard::interrupted()) std::this_thread::sleep_for(kTick);
}

}  // namespace sunfleck::engine
