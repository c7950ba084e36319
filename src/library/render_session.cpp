// Views, passes, and what is told of them.
#include "library/render_session.h"

#include "film/film_picture.h"
#include "library/guarded.h"
#include "library/picture_data.h"
#include "scene/adjust.h"
#include "stats/remarks.h"
#include "stats/stats.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace sunfleck {
namespace {

constexpr std::uint64_t kMostPasses = std::numeric_limits<std::uint32_t>::max();

void check_isa(const Settings& settings, const std::string& isa) {
    const auto& texts = settings.data().texts;
    if (!texts.contains("--isa") || texts.at("--isa").front() == isa) return;
    throw Error({"isa"}, "the scene has been built for \"" + isa + "\"",
                "give it to Scene::load() or SceneBuilder::build()");
}

Progress progress_of(const engine::Progress& p) {
    Progress progress;
    progress.passes = p.passes;
    progress.of = p.of;
    progress.seconds = p.seconds;
    progress.cpu_seconds = p.cpu_seconds;
    if (p.error) progress.error = p.error->value();
    progress.target_error = p.target;
    progress.seconds_left = p.seconds_left;
    progress.is_learning = p.is_learning;
    return progress;
}

}  // namespace

RenderSession::RenderSession(const Scene& scene, const Settings& settings,
                             const RendererOptions& options)
    : options_(options),
      request_(settings.data().request()),
      scene_(scene.data().scene),
      camera_(scene.data().camera_in_world),
      isa_(scene.data().isa),
      settings_(engine::settings_for(scene_, request_)),
      threads_(options.threads) {
    check_isa(settings, isa_);
    if (!request_.exposure) request_.exposure = scene.data().exposure;
    if (request_.settings.energy_compensation) scene_.compensate_energy();
    engine::Camera camera = camera_;
    engine::FilmDescription film = scene_.film();
    engine::adjust_view(camera, film, request_);
    set_view(std::move(camera), std::move(film));
    cropped_film_ = shown_->scene.film();
}

void RenderSession::set_camera(
    const std::function<engine::Camera(const engine::Vec2i&)>& camera_for) {
    const engine::FilmDescription& film = shown_->scene.film();
    set_view(camera_for(film.resolution), film);
}

void RenderSession::set_resolution(const engine::Vec2i& size) {
    engine::check_film_size(size, {"resolution"});
    engine::Camera camera = camera_;
    engine::FilmDescription film = cropped_film_;
    engine::set_resolution(camera, film, size);
    if (request_.crop_window) film.crop = engine::pixels_of_window(*request_.crop_window, size);
    set_view(std::move(camera), std::move(film));
}

void RenderSession::set_crop(const std::optional<std::array<int, 4>>& crop) {
    engine::FilmDescription film = shown_->scene.film();
    film.crop.reset();
    if (crop) engine::set_crop(film, *crop, "crop");
    set_view(camera_, film);
    cropped_film_ = std::move(film);
    request_.crop_window.reset();
}

void RenderSession::set_view(engine::Camera camera, engine::FilmDescription film) {
    engine::Scene view = scene_;
    view.set_view(camera, std::move(film));
    auto next = std::make_unique<Shown>(std::move(view), settings_, request_.stop);
    {
        const std::lock_guard lock(guard_);
        shown_.swap(next);
        camera_ = std::move(camera);
        progress_ = {};
    }
    remarks_before_ = engine::remarks_before(job(), isa_);
    remarks_after_.clear();
    say(remarks_before_);
}

Outcome RenderSession::render(std::optional<std::uint32_t> passes, const Renderer::Report& report) {
    engine::StopSettings stop = request_.stop;
    if (passes) {
        const std::uint64_t end =
            stop.first_pass + shown_->loop.result().film.pass_count() + *passes;
        stop.end_pass = static_cast<std::uint32_t>(std::min(end, kMostPasses));
        stop.seconds = stop.cpu_seconds = stop.target_error = std::nullopt;
    }
    threads_.run([&] { shown_->loop.run(stop, hooks(report)); });
    if (shown_->loop.result().interrupted) return Outcome::cancelled;
    if (passes) return Outcome::finished;
    remarks_after_ = engine::remarks_after(job(), shown_->loop.result());
    say(remarks_after_);
    return Outcome::finished;
}

engine::RenderHooks RenderSession::hooks(const Renderer::Report& report) {
    engine::RenderHooks hooks;
    hooks.report = [this, &report](const engine::Progress& now) {
        take(now);
        if (report) call_back("report", [&] { report(progress()); });
    };
    hooks.cancelled = &is_cancelled_;
    hooks.change = [this](const std::function<void()>& change) {
        const std::lock_guard lock(guard_);
        change();
    };
    return hooks;
}

void RenderSession::take(const engine::Progress& progress) {
    const std::lock_guard lock(guard_);
    progress_ = progress_of(progress);
}

Progress RenderSession::progress() const {
    const std::lock_guard lock(guard_);
    return progress_;
}

Picture RenderSession::picture() const {
    const engine::FilmPictureOptions options{request_.stop.error_terms.extrapolated};
    return guarded([&] {
        const std::lock_guard lock(guard_);
        engine::Picture made = engine::film_picture(shown_->loop.result().film, options);
        engine::PictureFileOptions files = request_.files;
        files.transform.exposure = static_cast<float>(engine::stops_of(*request_.exposure, made));
        return Picture(std::make_shared<const Picture::Data>(
            Picture::Data{std::move(made), std::move(files)}));
    });
}

std::string RenderSession::statistics() {
    const engine::RenderResult& result = shown_->loop.result();
    engine::RunFacts facts;
    facts.scene = scene_.path();
    facts.isa = isa_;
    threads_.run([&] { facts.threads = engine::thread_count(); });
    facts.total_seconds = result.total_seconds;
    facts.cpu_seconds = result.cpu_seconds;
    facts.seconds = result.seconds;
    facts.radius_factor = result.radius_factor;
    facts.warnings = remarks_before_;
    facts.warnings.insert(facts.warnings.end(), remarks_after_.begin(), remarks_after_.end());
    facts.error_terms = request_.stop.error_terms;
    return engine::stats_json(result.film, facts);
}

void RenderSession::say(const std::vector<std::string>& lines) const {
    if (!options_.log) return;
    for (const std::string& line : lines)
        call_back("log", [&] { options_.log(Severity::warning, line); });
}

}  // namespace sunfleck
