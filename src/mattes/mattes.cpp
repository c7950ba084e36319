// Rays of each pixel, their IDs by rank, the names of those that were seen.
#include "mattes/mattes.h"

#include "core/parallel.h"
#include "mattes/ranking.h"
#include "mattes/scene_ids.h"
#include "random_numbers/batch_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace sunfleck::engine {
namespace {

/// Seed of the rays, which no render shares by intention.
constexpr std::uint64_t kSeed = 0x6D61747465;

/// Returns the first surface along a camera ray that camera paths do not pass straight.
std::optional<Hit> seen_along(const Scene& scene, const CameraRay& ray) {
    const Vec3 direction(ray.direction);
    std::optional<Hit> hit = scene.first_hit(ray);
    while (hit && scene.is_null_interface(*hit))
        hit = scene.geometry().intersect(ray_from(*hit, direction));
    return hit;
}

/// The rays of a pixel: together one Owen-scrambled net in each pair of dimensions.
class PixelRays {
public:
    PixelRays(const Scene& scene, std::uint32_t samples)
        : scene_(scene),
          filter_(scene.filter()),
          window_(window_of(scene.film())),
          in_pass_(samples / kBatchPasses) {}

    /// @param sample  below the number of samples.
    CameraRay ray(std::size_t pixel, std::uint32_t sample) const {
        const PathOfPixel path{sample % in_pass_,
                               static_cast<std::uint32_t>(std::countr_zero(in_pass_))};
        BatchPoints numbers({kSeed, sample / in_pass_}, static_cast<std::uint32_t>(pixel), path);
        const FilterSample filtered = filter_.sample(numbers.next_2d());
        return camera_ray(scene_.camera(), window_.place(pixel, filtered.offset),
                          numbers.next_2d());
    }
    const PixelWindow& window() const { return window_; }

private:
    const Scene& scene_;
    FilterSampler filter_;
    PixelWindow window_;
    std::uint32_t in_pass_;  // rays that stand for the paths of one pass in a batch
};

/// A matte while its pixels are filled in.
struct GrowingMatte {
    GrowingMatte(const Scene& scene, MatteKind kind, std::size_t pixels, std::size_t blocks)
        : ids(scene, kind), seen(blocks), crowded(blocks) {
        values.fill(std::vector<float>(pixels));
    }

    /// @param samples  IDs of the pixel's rays; they are sorted.
    void set(std::size_t pixel, std::vector<MatteId>& samples, std::size_t block) {
        const auto all = static_cast<float>(samples.size());
        const std::vector<RankedId> ranked = ranked_ids(samples);
        crowded[block] += ranked.size() > kMatteIds ? 1 : 0;
        for (std::size_t rank = 0; rank < std::min(ranked.size(), kMatteIds); ++rank) {
            values.at(2 * rank)[pixel] = std::bit_cast<float>(ranked[rank].id);
            values.at(2 * rank + 1)[pixel] = static_cast<float>(ranked[rank].count) / all;
        }
        for (const RankedId& one : ranked) seen[block].push_back(one.id);
    }

    SceneIds ids;
    std::array<std::vector<float>, 2 * kMatteIds> values;  // ID and coverage of each rank
    // By block of pixels.
    std::vector<std::vector<MatteId>> seen;
    std::vector<std::size_t> crowded;
};

void keep_each_once(std::vector<MatteId>& ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

void trace(const Scene& scene, std::uint32_t samples, std::vector<GrowingMatte>& mattes,
           std::size_t block_size) {
    const PixelRays rays(scene, samples);
    parallel_blocks(rays.window().pixels(), block_size, [&](std::size_t begin, std::size_t end) {
        std::vector<std::vector<MatteId>> found(mattes.size());
        for (std::size_t pixel = begin; pixel < end; ++pixel) {
            for (std::vector<MatteId>& ids : found) ids.assign(samples, kNoMatteId);
            for (std::uint32_t i = 0; i < samples; ++i)
                if (const auto hit = seen_along(scene, rays.ray(pixel, i)))
                    for (std::size_t m = 0; m < mattes.size(); ++m)
                        found[m][i] = mattes[m].ids.at(*hit);
            for (std::size_t m = 0; m < mattes.size(); ++m)
                mattes[m].set(pixel, found[m], begin / block_size);
        }
        for (GrowingMatte& matte : mattes) keep_each_once(matte.seen[begin / block_size]);
    });
}

/// Adds a matte that is complete.
void add(GrowingMatte matte, const std::string& layer, Mattes& mattes) {
    constexpr std::string_view kChannels = "RGBA";
    for (std::size_t i = 0; i < matte.values.size(); ++i)
        mattes.channels.push_back({fmt::format("{}{:02}.{}", layer, i / kChannels.size(),
                                               kChannels[i % kChannels.size()]),
                                   std::move(matte.values.at(i))});
    for (const std::size_t crowded : matte.crowded) mattes.crowded += crowded;
    std::vector<MatteId> seen;
    for (const std::vector<MatteId>& ids : matte.seen)
        seen.insert(seen.end(), ids.begin(), ids.end());
    keep_each_once(seen);
    mattes.metadata.merge(matte_metadata(layer, matte.ids.names_of(seen)));
}

}  // namespace

Mattes make_mattes(const Scene& scene, const MatteSettings& settings) {
    constexpr std::size_t kBlock = 256;
    const std::size_t pixels = window_of(scene.film()).pixels();
    std::vector<GrowingMatte> growing;
    for (const MatteKind kind : settings.kinds)
        growing.emplace_back(scene, kind, pixels, (pixels + kBlock - 1) / kBlock);
    trace(scene, settings.samples, growing, kBlock);
    Mattes mattes;
    for (std::size_t i = 0; i < growing.size(); ++i)
        add(std::move(growing[i]), std::string(layer_of(settings.kinds[i])), mattes);
    return mattes;
}

void add_mattes(const Mattes& mattes, Picture& picture) {
    picture.channels.insert(picture.channels.end(), mattes.channels.begin(), mattes.channels.end());
    picture.metadata.insert(mattes.metadata.begin(), mattes.metadata.end());
}

}  // namespace sunfleck::engine
