// Bootstrap, chains, and what their states bring.
#include "reference/metropolis_integrator.h"

#include "core/parallel.h"
#include "random_numbers/sobol.h"
#include "reference/path_pair.h"

#include <cmath>
#include <mutex>

namespace sunfleck::engine {
namespace {

/// Of steps that start afresh (pbrt-v4's "largestepprobability").
constexpr double kLargeSteps = 0.3;
constexpr std::size_t kChainSteps = 256;
constexpr std::size_t kLeastSteps = 4096;  // of a pass

/// A pair of subpaths by its numbers, and what it brings.
struct State {
    std::array<std::vector<double>, 3> numbers;
    std::vector<FilmLight> lights;
    double target = 0;  // sum of `lights`, over wavelengths

    void clear() {
        for (std::vector<double>& stream : numbers) stream.clear();
        lights.clear();
        target = 0;
    }
};

/// Makes states; one for each thread.
class StateMaker {
public:
    /// @param shift  of the bootstrap's points of the film.
    StateMaker(const ReferencePass& pass, const Projection& camera, const Splatter& splatter,
               const Vec2d& shift)
        : id_(pass.id),
          shift_(shift),
          reach_(splatter.reach()),
          area_((reach_[1] - reach_[0]) * (reach_[3] - reach_[2])),
          pair_(pass, camera, splatter, area_) {}

    /// Pair `index` of the bootstrap: independent, but for the spread of their points of the film.
    void make(std::size_t index, State& state) {
        make(Purpose::metropolis_bootstrap, index, nullptr, state);
    }
    /// A step. @param index  of the step, in the pass. @param near  null for one that starts
    /// afresh.
    void make(std::size_t index, const State* near, State& state) {
        make(Purpose::metropolis_step, index, near, state);
    }

    void count(Statistics& statistics) const {
        statistics[Count::camera_rays] += pair_.camera_rays();
        statistics[Count::photon_rays] += pair_.light_rays();
        statistics[Count::dropped_nonfinite] += not_finite_;
    }

private:
    void make(Purpose purpose, std::size_t index, const State* near, State& state) {
        state.clear();
        const auto stream = [&](std::size_t which) {
            return PathNumbers(id_.stream(purpose, 4 * index + which),
                               near != nullptr ? &near->numbers.at(which) : nullptr,
                               &state.numbers.at(which));
        };
        PathPair::Numbers numbers{stream(0), stream(1), stream(2)};
        Vec2d u = numbers.eye.next_two();
        if (purpose == Purpose::metropolis_bootstrap) {
            u = spread(index);
            state.numbers[0] = {u.x, u.y};
        }
        const Vec2d film(reach_[0] + u.x * (reach_[1] - reach_[0]),
                         reach_[2] + u.y * (reach_[3] - reach_[2]));
        const SampledSpectrum radiance = pair_.trace(film, numbers);
        state.lights.push_back({film, radiance * static_cast<float>(area_)});
        for (const FilmLight& splat : pair_.splats()) state.lights.push_back(splat);
        for (const FilmLight& light : state.lights)
            state.target += static_cast<double>(light.light.mean());
        if (std::isfinite(state.target)) return;
        ++not_finite_;
        state.target = 0;
    }

    /// Sobol' points, shifted anew in each pass.
    Vec2d spread(std::size_t index) const {
        const auto along = [&](std::size_t dimension, double shift) {
            const std::uint32_t point = sobol(static_cast<std::uint32_t>(index), dimension);
            const double sum = (static_cast<double>(point) + 0.5) * 0x1p-32 + shift;
            return sum < 1 ? sum : sum - 1;
        };
        return {along(0, shift_.x), along(1, shift_.y)};
    }

    PassId id_;
    Vec2d shift_;
    std::array<double, 4> reach_;
    double area_;  // of the film that pixels see
    PathPair pair_;
    std::uint64_t not_finite_ = 0;
};

/// Which pairs of the bootstrap chains start from, and what a state is worth.
struct Start {
    std::vector<std::size_t> seeds;  // by chain
    double mean = 0;                 // of the target
    std::size_t visible = 0;
};

/// By one random offset: a pair starts floor or ceiling of its share of the chains.
Start resample(const std::vector<double>& targets, std::size_t chains, double u) {
    Start start;
    double sum = 0;
    for (const double target : targets) {
        sum += target;
        start.visible += target > 0 ? 1 : 0;
    }
    if (!(sum > 0)) return start;
    start.mean = sum / static_cast<double>(targets.size());
    double before = 0;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        before += targets[i];
        const double reached = before / sum * static_cast<double>(chains);
        while (start.seeds.size() < chains && static_cast<double>(start.seeds.size()) + u < reached)
            start.seeds.push_back(i);
    }
    return start;
}

/// One chain from a state of the bootstrap.
class Chain {
public:
    Chain(StateMaker& maker, const Splatter& splatter, double worth)
        : maker_(maker), splatter_(splatter), worth_(worth) {}

    /// Expected values: the state and the proposal both bring their share of each step.
    /// @param numbers  of the choices alone. @return the proposals accepted.
    std::uint64_t walk(std::size_t seed, std::size_t chain, std::size_t steps,
                       RandomStream numbers) {
        maker_.make(seed, state_);
        double stay = 0;
        std::uint64_t accepted = 0;
        for (std::size_t step = 0; step < steps; ++step) {
            const bool is_large = numbers.next() < kLargeSteps;
            maker_.make(chain * steps + step, is_large ? nullptr : &state_, proposal_);
            const double acceptance = std::min(1.0, proposal_.target / state_.target);
            stay += 1 - acceptance;
            if (numbers.next() < acceptance) {
                bring(state_, stay);
                std::swap(state_, proposal_);
                stay = acceptance;
                ++accepted;
            } else {
                bring(proposal_, acceptance);
            }
        }
        bring(state_, stay);
        return accepted;
    }

private:
    void bring(const State& state, double times) const {
        if (!(times > 0)) return;
        const auto scale = static_cast<float>(times * worth_ / state.target);
        for (const FilmLight& light : state.lights)
            if (!light.light.is_zero()) splatter_.add(light.film, light.light * scale);
    }

    StateMaker& maker_;
    const Splatter& splatter_;
    double worth_;
    State state_;
    State proposal_;
};

}  // namespace

MetropolisPlan metropolis_plan(std::size_t pixels) {
    const std::size_t chains = (std::max(pixels, kLeastSteps) + kChainSteps - 1) / kChainSteps;
    return {chains * kChainSteps / 2, chains, kChainSteps};
}

double trace_metropolis_chains(const ReferencePass& pass, PassImage& image,
                               Statistics& statistics) {
    trace_emitters(pass, image, statistics);
    const MetropolisPlan plan = metropolis_plan(pass.window.pixels());
    const Projection camera(pass.scene.scene.camera());
    const Splatter splatter(pass, image);
    RandomStream offsets = pass.id.stream(Purpose::metropolis_choice, plan.chains);
    const double across = offsets.next();
    const Vec2d shift(across, offsets.next());
    std::mutex guard;
    std::vector<double> targets(plan.bootstrap);
    parallel_blocks(plan.bootstrap, 256, [&](std::size_t begin, std::size_t end) {
        StateMaker maker(pass, camera, splatter, shift);
        State state;
        for (std::size_t i = begin; i < end; ++i) {
            maker.make(i, state);
            targets[i] = state.target;
        }
        const std::lock_guard lock(guard);
        maker.count(statistics);
    });
    const Start start = resample(targets, plan.chains, offsets.next());
    statistics[Count::uniform_paths] += plan.bootstrap;
    statistics[Count::uniform_visible] += start.visible;
    const auto steps = static_cast<double>(plan.chains * plan.steps);
    parallel_for(start.seeds.size(), [&](std::size_t chain) {
        StateMaker maker(pass, camera, splatter, shift);
        Chain states(maker, splatter, start.mean / steps);
        const std::uint64_t accepted =
            states.walk(start.seeds[chain], chain, plan.steps,
                        pass.id.stream(Purpose::metropolis_choice, chain));
        const std::lock_guard lock(guard);
        maker.count(statistics);
        statistics[Count::mutated_paths] += plan.steps;
        statistics[Count::visible_states] += plan.steps;
        statistics[Count::accepted_paths] += accepted;
        statistics[Count::distinct_visible] += accepted + 1;
    });
    return static_cast<double>(start.visible) / static_cast<double>(plan.bootstrap);
}

}  // namespace sunfleck::engine
