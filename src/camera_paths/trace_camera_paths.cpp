// Camera paths of all pixels of a pass, in blocks.
#include "camera_paths/trace_camera_paths.h"

#include "camera_paths/camera_path.h"
#include "camera_paths/edge_probes.h"
#include "core/parallel.h"

namespace sunfleck::engine {
namespace {

/// Returns how to probe the discs of a pixel.
Probes probes_of(std::span<const Edge> edges, std::size_t pixel) {
    if (edges.empty()) return Probes::of_trial;
    if (edges[pixel] == Edge::none) return Probes::none;
    return edges[pixel] == Edge::of_sight ? Probes::of_sight : Probes::of_surface;
}

/// Probes the kernels of a pixel. @param points  of a block, the pixel's from `first` on.
void probe(const CameraPass& pass, std::size_t pixel, std::vector<VisiblePoint>& points,
           std::size_t first) {
    if (!pass.settings.edges || first == points.size()) return;
    probe_edges(pass.scene, std::span(points).subspan(first), probes_of(pass.edges, pixel),
                pass.id.stream(Purpose::edge_probe, pixel));
}

}  // namespace

VisiblePointLists trace_camera_paths(const CameraPass& pass, PassImage& image,
                                     Statistics& statistics) {
    constexpr std::size_t kBlock = 256;
    const std::size_t pixels = pass.window.pixels();
    const PixelCells cells{pass.window, pass.cells};
    const FilterSampler filter(pass.scene.scene.filter());
    VisiblePointLists lists((pixels + kBlock - 1) / kBlock);
    std::vector<Statistics> counts(lists.size());
    parallel_blocks(pixels, kBlock, [&](std::size_t begin, std::size_t end) {
        const std::size_t block = begin / kBlock;
        lists[block].reserve(end - begin);
        Statistics& count = counts[block];
        for (std::size_t pixel = begin; pixel < end; ++pixel) {
            if (!cells.has(pixel)) continue;
            PathOfPixel path{0, pass.log2_samples.empty() ? 0U : pass.log2_samples[pixel]};
            const std::uint64_t before = count[Count::camera_rays];
            const std::size_t first = lists[block].size();
            for (; path.number < path.count(); ++path.number)
                CameraPath(pass, filter, image, lists[block], count)
                    .trace(static_cast<std::uint32_t>(pixel), path);
            count[Count::camera_paths] += path.count();
            probe(pass, pixel, lists[block], first);
            if (!pass.rays.empty()) pass.rays[pixel] += count[Count::camera_rays] - before;
        }
        count[Count::visible_points] += lists[block].size();
    });
    for (const Statistics& c : counts) statistics += c;
    return lists;
}

}  // namespace sunfleck::engine
