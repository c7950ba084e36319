// The paper's chain walks through photon paths.
#include "photon/paper_paths.h"

#include "core/parallel.h"
#include "photon/tracer.h"

#include <algorithm>

namespace sunfleck {
namespace {

/// Iterations whose photons are splatted together.
constexpr std::uint32_t kAtOnce = 1U << 16U;

/// Paths are the photons that a visible point may take; they are visible, or not.
class SeenPhotons {
public:
    using Path = std::vector<Photon>;
    using Tally = Statistics;

    SeenPhotons(const PhotonTracer& tracer, const VisiblePointIndex& index)
        : tracer_(tracer), index_(index) {}

    template <SlotReader Reader>
    void trace(Reader&& read, Path& path, Statistics& counts) const {
        path.clear();
        const auto visit = [&](const Photon& photon) {
            if (index_.may_take(photon)) path.push_back(photon);
            return true;
        };
        count_end(tracer_.trace(read, visit, counts[Count::photon_rays]), counts);
    }

    int height(const Path& path) const { return index_.any(path) ? kVisible : 0; }

    /// Of a path that ends at the first photon that is seen.
    template <SlotReader Reader>
    bool is_visible(Reader&& read, Statistics& counts) const {
        const auto visit = [&](const Photon& photon) { return !index_.any(photon); };
        const PathEnd end = tracer_.trace(read, visit, counts[Count::photon_rays]);
        count_end(end, counts);
        return end == PathEnd::stopped;
    }

private:
    const PhotonTracer& tracer_;
    const VisiblePointIndex& index_;
};

static_assert(PathSpace<SeenPhotons>);

/// V of the uniform paths first .. first + count - 1.
std::vector<std::uint8_t> visibility(const SeenPhotons& space, const IndependentPoints& points,
                                     std::uint32_t first, std::uint32_t count, Statistics& counts) {
    constexpr std::size_t kBlock = 512;
    std::vector<std::uint8_t> visible(count);
    std::vector<Statistics> counted((count + kBlock - 1) / kBlock);
    parallel_blocks(count, kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            visible[i] = space.is_visible(points.path(first + static_cast<std::uint32_t>(i)),
                                          counted[begin / kBlock])
                             ? 1
                             : 0;
    });
    for (const Statistics& block : counted) counts += block;
    counts[Count::uniform_paths] += count;
    counts[Count::uniform_visible] +=
        static_cast<std::uint64_t>(std::count(visible.begin(), visible.end(), 1));
    return visible;
}

void count_step(Statistics& counts, PaperStep step) {
    const bool accepted = step == PaperStep::accepted;
    counts[Count::mutated_paths] += accepted || step == PaperStep::rejected ? 1 : 0;
    counts[Count::accepted_paths] += accepted ? 1 : 0;
    counts[Count::distinct_visible] += accepted || step == PaperStep::exchanged ? 1 : 0;
}

}  // namespace

Statistics trace_paper_paths(const PhotonView& view, const PaperPass& pass, PaperState& state,
                             const SplatPhotons& splat) {
    const PhotonTracer tracer(view.scene, view.transport);
    const SeenPhotons space(tracer, view.index);
    const IndependentPoints points(pass.id);
    Statistics counts;
    for (std::uint32_t begin = 0; begin < pass.paths; begin += kAtOnce) {
        const std::uint32_t some = std::min(kAtOnce, pass.paths - begin);
        const auto visible = visibility(space, points, begin, some, counts);
        PaperChain<SeenPhotons> chain(space, pass.replica_exchange, state,
                                      pass.id.stream(Purpose::chain, begin / kAtOnce), counts);
        RepeatedPhotons photons;
        const auto leave = [&](const std::vector<Photon>& path, std::uint32_t steps) {
            for (const Photon& photon : path) photons.add(photon, steps);
            counts[Count::visible_states] += space.height(path) == kVisible ? steps : 0;
        };
        for (std::uint32_t i = 0; i < some; ++i)
            count_step(counts, chain.step(points.path(begin + i), visible[i] != 0, leave, counts));
        chain.finish(leave);
        counts += splat(photons);
    }
    return counts;
}

}  // namespace sunfleck
