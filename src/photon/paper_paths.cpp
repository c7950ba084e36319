// The paper's chain on photon paths.
#include "photon/paper_paths.h"

#include "core/parallel.h"
#include "photon/interleaved.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Iterations whose photons are deposited together.
constexpr std::uint32_t kAtOnce = 1U << 16U;
/// Uniform paths traced ahead of the chain, and per task: few enough to be in the cache when the
/// chain uses them.
constexpr std::uint32_t kAhead = 1024;
constexpr std::uint32_t kBlock = 256;

/// The photons of a path that a visible point may accept.
struct SeenPath {
    std::vector<Photon> photons;
    bool visible = false;  // V: one is accepted

    void clear() {
        photons.clear();
        visible = false;
    }
};

class SeenPhotons {
public:
    using Path = SeenPath;
    using Tally = Statistics;

    explicit SeenPhotons(const PhotonContext& photon_context)
        : tracer_(photon_context.scene, photon_context.transport), index_(photon_context.index) {}

    template <PrimarySampleReader Reader>
    void trace(Reader&& read, SeenPath& path, Statistics& counts) const {
        path.clear();
        const auto visit = [&](const Photon& photon) {
            if (index_.may_accept(photon)) path.photons.push_back(photon);
        };
        count_end(tracer_.trace(read, visit, counts[Count::photon_rays]), counts);
        path.visible = index_.any(path.photons);
    }

    int height(const SeenPath& path) const { return path.visible ? kVisible : 0; }

    /// Traces many paths in lockstep.
    /// @param points  of paths with these indices.
    /// @param path_of  returns where path i is stored.
    template <class Points, class PathOf>
    void trace(const Points& points, const PathRange& range, const PathOf& path_of,
               Statistics& counts) const {
        for (std::size_t i = range.begin; i < range.end; ++i) path_of(i).clear();
        const auto visit = [&](const Photon& photon, std::uint32_t i, const auto&) {
            if (index_.may_accept(photon)) path_of(i).photons.push_back(photon);
        };
        const auto ended = [&](PathEnd end) { count_end(end, counts); };
        InterleavedPaths paths(tracer_, points, visit, ended);
        counts[Count::photon_rays] += paths.trace(range);
        for (std::size_t i = range.begin; i < range.end; ++i)
            path_of(i).visible = index_.any(path_of(i).photons);
    }

private:
    PhotonTracer tracer_;
    const VisiblePointIndex& index_;
};

static_assert(PathSpace<SeenPhotons>);

/// Uniform paths ahead of the chain, each with the dimensions that it has read.
class UniformPathsAhead {
public:
    UniformPathsAhead(const SeenPhotons& space, PassId pass) : space_(space), points_(pass) {}

    /// Traces paths first .. first + count - 1 on all threads, in place of the previous ones.
    void trace(std::uint32_t first, std::uint32_t count, Statistics& counts) {
        first_ = first;
        if (places_.size() < count) places_.resize(count);
        std::vector<Statistics> counted((count + kBlock - 1) / kBlock);
        parallel_blocks(count, kBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) places_[i].sample.clear();
            Statistics& here = counted[begin / kBlock];
            const auto path_of = [&](std::size_t i) -> SeenPath& { return at(i).path; };
            space_.trace(Recorded{*this}, {first + begin, first + end}, path_of, here);
            here[Count::uniform_paths] += end - begin;
            for (std::size_t i = begin; i < end; ++i)
                here[Count::uniform_visible] += places_[i].path.visible ? 1 : 0;
        });
        for (const Statistics& block : counted) counts += block;
    }

    bool visible(std::uint32_t i) const { return places_[i - first_].path.visible; }

    /// Moves path i out when it is called.
    auto taking(std::uint32_t i) {
        return [&place = at(i)](StoredSample& sample, SeenPath& path) {
            std::swap(sample, place.sample);
            std::swap(path, place.path);
        };
    }

private:
    struct Place {
        StoredSample sample;
        SeenPath path;
    };
    /// Points that record the dimensions read.
    struct Recorded {
        UniformPathsAhead& paths;
        RecordingReader<IndependentReader> path(std::uint32_t i) const {
            return {paths.points_.path(i), paths.at(i).sample};
        }
    };

    Place& at(std::size_t i) { return places_[i - first_]; }

    const SeenPhotons& space_;
    IndependentPoints points_;
    std::uint32_t first_ = 0;
    std::vector<Place> places_;
};

/// @param number  of the path in its chunk.
void add_path(PhotonChunk& chunk, const SeenPath& path, std::uint32_t number, std::uint32_t steps) {
    for (const Photon& photon : path.photons) chunk.add_copies(photon, number, steps);
}

void count_step(Statistics& counts, PaperStep step) {
    const bool accepted = step == PaperStep::accepted;
    counts[Count::mutated_paths] += accepted || step == PaperStep::rejected ? 1 : 0;
    counts[Count::accepted_paths] += accepted ? 1 : 0;
    counts[Count::distinct_visible] += accepted || step == PaperStep::exchanged ? 1 : 0;
}

}  // namespace

Statistics trace_paper_paths(const PhotonContext& photon_context, const PaperPass& pass,
                             PaperState& state, const DepositChunks& deposit) {
    const SeenPhotons space(photon_context);
    UniformPathsAhead uniform(space, pass.id);
    Statistics counts;
    std::vector<PhotonChunk> chunks(1);
    for (std::uint32_t begin = 0; begin < pass.paths; begin += kAtOnce) {
        const std::uint32_t end = begin + std::min(kAtOnce, pass.paths - begin);
        PaperChain<SeenPhotons> chain(space, pass.replica_exchange, state,
                                      pass.id.stream(Purpose::chain, begin / kAtOnce), counts);
        std::uint32_t left = 0;
        chunks[0].clear();
        const auto leave = [&](const SeenPath& path, std::uint32_t steps) {
            if (!path.visible) return;
            counts[Count::visible_states] += steps;
            add_path(chunks[0], path, left++, steps);
        };
        for (std::uint32_t i = begin; i < end; ++i) {
            if ((i - begin) % kAhead == 0) uniform.trace(i, std::min(kAhead, end - i), counts);
            count_step(counts, chain.step(uniform.visible(i), uniform.taking(i), leave, counts));
        }
        chain.finish(leave);
        counts += deposit(chunks);
    }
    return counts;
}

}  // namespace sunfleck::engine
