// Pictures for the sender, from the thread that renders.
#include "apps/cli/display_link.h"

#include "apps/cli/interrupt.h"
#include "apps/cli/messages.h"
#include "display/enlarged.h"
#include "film/film_picture.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Two renders of a scene are two images, as pbrt-v4's are.
std::string image_name(const RenderOptions& options) {
    return fmt::format("{} - Sunfleck ({})",
                       std::filesystem::path(options.scene).filename().string(), ::getpid());
}

SenderSettings sender_settings(const RenderOptions& options) {
    return {.address = *options.display_server,
            .flag = "--display-server",
            .image = image_name(options),
            .warn = [log = options.log](const std::string& what) {
                if (log != LogLevel::quiet) say("warning: " + what);
            }};
}

}  // namespace

DisplayLink::DisplayLink(const RenderOptions& options)
    : extrapolates_(options.request.stop.error_terms.extrapolated),
      sender_(sender_settings(options)) {}

void DisplayLink::begin(const FilmKey& key, const Film* earlier) {
    width_ = key.width;
    height_ = key.height;
    if (earlier != nullptr) show_now(*earlier);
}

void DisplayLink::preview(const Picture& picture) {
    sender_.show(enlarged(picture, width_, height_));
}

void DisplayLink::show(const Film& film) {
    if (pacing_.is_due() && !sender_.is_over()) show_now(film);
}

void DisplayLink::end(const Film& film) {
    if (sender_.is_over()) return;
    static constexpr InterruptAnswer kNothingIsLost{};
    InterruptGuard::set_answer(kNothingIsLost);
    if (film.pass_count() != shown_passes_) show_now(film);
    sender_.finish();
}

void DisplayLink::show_now(const Film& film) {
    pacing_.run([&] { sender_.show(film_picture(film, {extrapolates_})); }, sender_.cost());
    shown_passes_ = film.pass_count();
}

std::unique_ptr<DisplayLink> display_link(const RenderOptions& options, const Ranks& ranks) {
    if (!options.display_server || !ranks.is_first()) return nullptr;
    return std::make_unique<DisplayLink>(options);
}

}  // namespace sunfleck::engine
