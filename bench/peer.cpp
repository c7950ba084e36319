// bench_peer: the error of a render after some processor time, against a picture of the same scene
// by another renderer: to be set beside that renderer's own error after the same time.
//
// usage: bench_peer SCENE REFERENCE.exr [--cpu-time 20,60,120] [--noise X]
//                   [--leave-out X0,X1,Y0,Y1]
// Grey value of a pixel: the mean of its channels. relMSE divides each squared error by the
// reference's square plus 1% of the mean's, and has the reference's own noise taken out; "trimmed"
// leaves out the worst 1% of pixels. Blocks are of 16 x 16 pixels, their differences relative.
#include "core/parallel.h"
#include "film/film.h"
#include "gain_errors.h"
#include "image/read_file.h"
#include "image/read_image.h"
#include "import/load.h"
#include "program.h"
#include "render/progressive.h"
#include "scene/adjust.h"

#include <fmt/format.h>

#include <optional>

namespace sunfleck::engine::bench {
namespace {

struct Settings {
    std::string scene;
    std::string reference;
    std::vector<double> cpu_times = {20, 60, 120};
    double noise = 0;  // relMSE of the reference
    std::vector<int> left_out = {0, 0, 0, 0};
    std::size_t threads = 1;
    std::uint64_t seed = 0;
};

using Grey = std::vector<double>;

Grey grey_of(const Image& image) {
    Grey grey;
    for (int y = 0; y < image.resolution().y; ++y)
        for (int x = 0; x < image.resolution().x; ++x) {
            const Vec3 rgb = image.rgb(x, y);
            grey.push_back((double{rgb.x} + double{rgb.y} + double{rgb.z}) / 3);
        }
    return grey;
}

Grey grey_of(const Film& film) {
    const FixedPoints& sums = film.sums().aovs[0];
    const auto passes = static_cast<double>(film.pass_count());
    Grey grey;
    for (std::size_t i = 0; i < sums.size(); i += 3)
        grey.push_back((sums[i].to_double() + sums[i + 1].to_double() + sums[i + 2].to_double()) /
                       (3 * passes));
    return grey;
}

class Peer {
public:
    explicit Peer(const Settings& settings) : settings_(settings) {
        const Image image = parse_image(read_file(settings.reference), settings.reference);
        width_ = image.resolution().x;
        reference_ = grey_of(image);
        for (std::size_t i = 0; i < reference_.size(); ++i)
            if (counts(i)) mean_ += reference_[i];
        mean_ /= static_cast<double>(pixels());
    }

    Vec2i resolution() const { return {width_, static_cast<int>(reference_.size()) / width_}; }

    void print(const RenderState& state) const {
        const Grey grey = grey_of(state.film);
        std::vector<double> relative;
        double plain = 0;
        double brightness = 0;
        for (std::size_t i = 0; i < grey.size(); ++i) {
            if (!counts(i)) continue;
            const double square = (grey[i] - reference_[i]) * (grey[i] - reference_[i]);
            plain += square;
            brightness += grey[i];
            relative.push_back(relative_square(square, reference_[i], mean_));
        }
        const auto count = static_cast<double>(pixels());
        std::sort(relative.begin(), relative.end());
        const std::size_t kept = relative.size() - relative.size() / 100;
        double trimmed = 0;
        double all = 0;
        for (std::size_t i = 0; i < relative.size(); ++i) (i < kept ? trimmed : all) += relative[i];
        all += trimmed;
        fmt::print("{:7.1f} {:7} {:11.4g} {:11.4g} {:11.4g} {:11.4f}  {}\n", state.cpu_seconds,
                   state.film.pass_count(), plain / count, all / count - settings_.noise,
                   trimmed / static_cast<double>(kept), brightness / count / mean_, blocks(grey));
    }

private:
    static constexpr int kBlock = 16;

    bool counts(std::size_t i) const {
        const int x = static_cast<int>(i) % width_;
        const int y = static_cast<int>(i) / width_;
        const std::vector<int>& out = settings_.left_out;
        return x < out[0] || x >= out[1] || y < out[2] || y >= out[3];
    }
    std::size_t pixels() const {
        std::size_t sum = 0;
        for (std::size_t i = 0; i < reference_.size(); ++i) sum += counts(i) ? 1 : 0;
        return sum;
    }

    /// Relative differences of whole blocks above a tenth of the mean: root of the mean square,
    /// worst.
    std::string blocks(const Grey& grey) const {
        const int across = width_ / kBlock;
        const int down = resolution().y / kBlock;
        std::vector<double> ours(static_cast<std::size_t>(across) * down);
        std::vector<double> theirs(ours.size());
        for (std::size_t i = 0; i < grey.size(); ++i) {
            const int x = static_cast<int>(i) % width_ / kBlock;
            const int y = static_cast<int>(i) / width_ / kBlock;
            if (!counts(i) || x >= across || y >= down) continue;
            const auto b = static_cast<std::size_t>(y * across + x);
            ours[b] += grey[i];
            theirs[b] += reference_[i];
        }
        double squares = 0;
        double worst = 0;
        int some = 0;
        for (std::size_t b = 0; b < ours.size(); ++b) {
            if (theirs[b] < 0.1 * mean_ * kBlock * kBlock) continue;
            const double off = std::abs(ours[b] / theirs[b] - 1);
            squares += off * off;
            worst = std::max(worst, off);
            ++some;
        }
        return fmt::format("{:.2f}% {:.2f}%", 100 * std::sqrt(squares / some), 100 * worst);
    }

    const Settings& settings_;
    int width_ = 0;
    Grey reference_;
    double mean_ = 0;
};

void run(const Settings& settings) {
    const ThreadLimit limit(settings.threads);
    const Peer peer(settings);
    SceneDescription description = load_scene(settings.scene);
    set_resolution(description, peer.resolution());
    const Scene scene(std::move(description));
    RenderJob job{scene, {}, {}, 0};
    job.settings.seed = settings.seed;
    if (scene.hints().max_depth) job.settings.transport.max_depth = *scene.hints().max_depth;
    fmt::print("{:>7} {:>7} {:>11} {:>11} {:>11} {:>11}  blocks: rms, worst\n", "cpu s", "passes",
               "MSE", "relMSE", "trimmed", "brightness");
    std::optional<RenderState> state;
    for (const double seconds : settings.cpu_times) {
        job.stop.cpu_seconds = seconds;
        state = render(job, {}, std::move(state));
        peer.print(*state);
    }
}

}  // namespace
}  // namespace sunfleck::engine::bench

int main(int count, char** words) {
    sunfleck::engine::bench::Settings settings;
    CLI::App app("Error after some processor time, against another renderer's picture");
    app.add_option("SCENE", settings.scene, "Scene file")->required();
    app.add_option("REFERENCE", settings.reference, "Its picture, in linear light")->required();
    app.add_option("--cpu-time", settings.cpu_times, "Seconds, ascending (default 20,60,120)")
        ->delimiter(',');
    app.add_option("--noise", settings.noise, "relMSE of the reference, taken out (default 0)");
    app.add_option("--leave-out", settings.left_out, "Pixels that do not count: X0,X1,Y0,Y1")
        ->delimiter(',')
        ->expected(4);
    app.add_option("--threads", settings.threads, "Default 1");
    app.add_option("--seed", settings.seed, "Default 0");
    return sunfleck::engine::bench::run_program(app, count, words,
                                                [&] { sunfleck::engine::bench::run(settings); });
}
