// PaperChain: the Markov chain of "Robust Adaptive Photon Tracing using Photon Path Visibility"
// (Hachisuka and Jensen 2011): replica exchange with uniform paths (eq. 4), adaptive mutation (eqs
// 9 to 11), Fig. 3.
//
// In:  a path space, uniform paths with their visibility. Out: the path that Fig. 3 splats in each
// iteration, and the counts that normalise it (eq. 5). The visible points may change between
// passes, while counts, theta and the current path are kept, as in the paper. That is biased.
// Equations: docs/method/references.md, eq. (35).
#pragma once

#include "chains/path_space.h"
#include "chains/stored_sample.h"
#include "photon/settings.h"

#include <cmath>
#include <utility>

namespace sunfleck::engine {

/// Moves by xi^exponent to either side with wrap-around (eq. 9), symmetric to the last bit.
/// @param exponent  1/theta + 1, at least 1.
/// @param random    uniform: its lowest bit selects the side, its highest bits are xi.
inline std::uint64_t paper_step(std::uint64_t dimension, float exponent, std::uint64_t random) {
    const float events = std::pow(to_unit_float(random), exponent);
    const auto step = static_cast<std::uint64_t>(static_cast<double>(events) * 0x1p64);
    return (random & 1U) != 0 ? dimension + step : dimension - step;
}

/// Applies eq. 9 to one dimension after the other.
class PaperMove {
public:
    /// @param theta  positive.
    PaperMove(double theta, RandomStream& stream)
        : exponent_(static_cast<float>(1 / theta + 1)), stream_(stream) {}

    std::uint64_t operator()(std::uint32_t /*dimension*/, std::uint64_t value) {
        return paper_step(value, exponent_, stream_.next_fraction());
    }

private:
    float exponent_;
    RandomStream& stream_;
};

/// theta by eq. 11: theta_1 = 1, theta_{i+1} = theta_i + (A_i - A*) / i after mutation i, where A_i
/// is the accepted fraction of all mutations so far (section 5.2). Fig. 3 counts the first path,
/// which is not a mutation, as accepted; theta then begins to rise, and in close-ups is still far
/// from A* after 10^6 mutations (docs/method/references.md).
class MutationSize {
public:
    /// Lower bound of theta, which the paper's rule can make negative. At this bound 4% of all
    /// steps are as large as the last bit of a dimension, so in most paths one dimension or none
    /// moves (docs/develop/decisions.md).
    static constexpr double kFloor = 1.0 / 1024;

    explicit MutationSize(const PaperSettings& settings)
        : fixed_(settings.mutation_size.has_value()),
          target_(settings.target_acceptance),
          theta_(settings.mutation_size.value_or(1)) {}

    double theta() const { return theta_; }
    /// Returns how often eq. 11 gave less than kFloor.
    std::uint64_t floor_held() const { return floor_held_; }

    void count_mutation(bool accepted) {
        ++mutated_;
        accepted_ += accepted ? 1 : 0;
        if (fixed_) return;
        const auto i = static_cast<double>(mutated_);
        theta_ += (static_cast<double>(accepted_) / i - target_) / i;
        if (theta_ >= kFloor) return;
        theta_ = kFloor;
        ++floor_held_;
    }

    /// Archives the data; see StoredSample::visit().
    template <class Self, class Archive>
    static void visit(Self& self, Archive& archive) {
        archive(self.fixed_, self.target_, self.theta_, self.mutated_, self.accepted_,
                self.floor_held_);
    }
    bool is_sound() const { return theta_ > 0 && std::isfinite(theta_) && std::isfinite(target_); }

private:
    bool fixed_;
    double target_;
    double theta_;
    std::uint64_t mutated_ = 0;
    std::uint64_t accepted_ = 0;
    std::uint64_t floor_held_ = 0;
};

/// The state that Fig. 3 keeps from pass to pass.
struct PaperState {
    explicit PaperState(const PaperSettings& settings) : size(settings) {}

    /// Returns Vc of eq. 5: UniformCount / i; zero before the first path.
    double visible_fraction() const {
        return uniform == 0 ? 0
                            : static_cast<double>(uniform_visible) / static_cast<double>(uniform);
    }

    template <class Self, class Archive>
    static void visit(Self& self, Archive& archive) {
        archive(self.found, self.uniform, self.uniform_visible, self.splatted);
        StoredSample::visit(self.current, archive);
        MutationSize::visit(self.size, archive);
    }
    bool is_sound() const { return current.is_sound() && size.is_sound(); }

    bool found = false;    // a first visible path was found
    StoredSample current;  // CurrentPath, once found
    MutationSize size;
    std::uint64_t uniform = 0;          // uniform paths, including the search for the first
    std::uint64_t uniform_visible = 0;  // UniformCount; the first one found is its initial 1
    std::uint64_t splatted = 0;         // iterations since then
};

enum class PaperStep { searching, exchanged, accepted, rejected };

template <PathSpace Space>
class PaperChain {
public:
    using Path = typename Space::Path;
    using Tally = typename Space::Tally;

    /// Continues from the state; its current path is traced again for the present visible points.
    /// @param stream  for the mutations of these iterations.
    PaperChain(const Space& space, bool replica_exchange, PaperState& state, RandomStream stream,
               Tally& tally)
        : space_(space), replica_exchange_(replica_exchange), state_(state), stream_(stream) {
        if (state_.found) space_.trace(RepeatingReader(state_.current, stream_), path_, tally);
    }

    /// Runs one iteration of Fig. 3. Without replica exchange, a uniform path is taken over only as
    /// the first path of the chain; all of them are counted.
    /// @param visible  V of a uniform path.
    /// @param take     take(sample, path) stores that path and the dimensions that it has read:
    /// called if the chain takes it over.
    /// @param splat    called with a path that is left and its number of iterations.
    template <class Take, class Splat>
    PaperStep step(bool visible, const Take& take, const Splat& splat, Tally& tally) {
        ++state_.uniform;
        state_.uniform_visible += visible ? 1 : 0;
        const bool exchange = visible && (replica_exchange_ || !state_.found);
        if (!exchange && !state_.found) return PaperStep::searching;
        const bool moves = exchange || mutate(tally);
        if (moves) {
            finish(splat);
            state_.found = true;
            if (exchange) take(candidate_, candidate_path_);
            std::swap(state_.current, candidate_);
            std::swap(path_, candidate_path_);
        }
        ++state_.splatted;
        ++steps_;
        if (exchange) return PaperStep::exchanged;
        return moves ? PaperStep::accepted : PaperStep::rejected;
    }

    /// Splats the current path for its iterations so far.
    template <class Splat>
    void finish(const Splat& splat) {
        if (steps_ > 0) splat(std::as_const(path_), steps_);
        steps_ = 0;
    }

private:
    /// Proposes a mutation, which is accepted if it is visible (eq. 10).
    bool mutate(Tally& tally) {
        candidate_.clear();
        space_.trace(MutatingReader(state_.current, candidate_, stream_,
                                    PaperMove(state_.size.theta(), stream_)),
                     candidate_path_, tally);
        const bool accepted = space_.height(candidate_path_) == kVisible;
        state_.size.count_mutation(accepted);
        return accepted;
    }

    const Space& space_;
    bool replica_exchange_;
    PaperState& state_;
    RandomStream stream_;
    StoredSample candidate_;
    Path path_;
    Path candidate_path_;
    std::uint32_t steps_ = 0;
};

}  // namespace sunfleck::engine
