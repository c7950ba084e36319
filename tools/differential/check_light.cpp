// First look, second look, and which of light, discs and error bars is at fault.
#include "differential/check_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sunfleck::differential {
namespace {

constexpr std::uint64_t kFirstLook = 4;
/// Renders of each estimator of a second look, while it is undecided.
constexpr std::uint64_t kSecondLooks[] = {8, 24};
/// Of a first look: wider than discs of the default radius are wrong in most scenes, and sure
/// enough that noise sends one scene in a hundred to the second look.
constexpr double kFirstMeanBand = 0.03;
constexpr double kFirstBlockBand = 0.2;
constexpr double kFirstSignificance = 0.01;
/// Share of pixels that may lie beyond three of their errors: of four batches 6% do.
constexpr double kBeyondThree = 0.15;

void append(std::vector<Look>& all, std::vector<Look> more) {
    all.insert(all.end(), more.begin(), more.end());
}

Way with_passes(Way way, int factor) {
    way.passes *= factor;
    return way;
}

class LightCheck {
public:
    LightCheck(Renders& renders, const Witnesses& witnesses, const Effort& effort)
        : renders_(&renders), effort_(effort) {
        if (witnesses.found_by_path) {
            reference_ = ways::path();
            other_reference_ = ways::pairs();
        } else {
            reference_ = ways::pairs();
            other_reference_ = ways::with_small_discs(ways::photons("direct photons"));
        }
    }

    void run(const std::string& second, Findings& findings) {
        const std::vector<Look> reference = renders_->looks(reference_, 0, kFirstLook);
        examine(ways::adaptive(), reference, findings);
        findings.light = verdict_.verdict;
        findings.light_text = verdict_.text;
        if (second == "bdpt") examine(ways::pairs(), reference, findings);
        if (second == "uniform" || second == "random" || second == "direct photons")
            examine(ways::photons(second), reference, findings);
        if (effort_.with_error_bars && findings.faults.empty()) check_error_bars(findings);
    }

private:
    void examine(const Way& way, const std::vector<Look>& reference, Findings& findings) {
        if (way.name == reference_.name) return;
        verdict_ = compare(renders_->looks(way, 0, kFirstLook), reference,
                           {.mean = kFirstMeanBand,
                            .block = kFirstBlockBand,
                            .significance = kFirstSignificance,
                            .allowance = {}});
        const bool is_open = verdict_.verdict == Verdict::undecided && effort_.until_decided;
        if (verdict_.verdict != Verdict::different && !is_open) return;
        look_twice(way, findings);
    }

    Bands sure() const {
        return {.significance = effort_.significance / std::size(kSecondLooks), .allowance = {}};
    }

    /// Discs that hardly have a bias: what still differs is light.
    void look_twice(const Way& way, Findings& findings) {
        const Way small = way.has_discs() ? ways::with_small_discs(way) : way;
        std::vector<Look> looks;
        std::vector<Look> reference;
        const Way longer = with_passes(reference_, 4);
        for (const std::uint64_t count : kSecondLooks) {
            const std::uint64_t first = 100 + looks.size();
            append(looks, renders_->looks(small, first, count - looks.size()));
            append(reference, renders_->looks(longer, first, count - reference.size()));
            verdict_ = compare(looks, reference, sure());
            if (verdict_.verdict != Verdict::undecided) break;
        }
        if (verdict_.verdict == Verdict::different && is_confirmed(way, looks))
            findings.faults.push_back(
                {Kind::light, way.name + " and " + reference_.name + ": " + verdict_.text});
        else if (verdict_.verdict == Verdict::equal && way.has_discs())
            check_discs(way, reference, findings);
    }

    /// Each reference misses some light: path tracing what comes by rare paths, bidirectional what
    /// is seen through glass by way of glass, photons what falls near edges. Two must differ.
    bool is_confirmed(const Way& way, const std::vector<Look>& looks) {
        const Way judge = way.name == other_reference_.name
                              ? ways::with_small_discs(ways::adaptive())
                              : with_passes(other_reference_, 2);
        const Comparison other = compare(looks, renders_->looks(judge, 200, looks.size()), sure());
        if (other.verdict == Verdict::different) return true;
        verdict_.verdict = Verdict::undecided;
        verdict_.text += "; but " + judge.name + ": " + other.text;
        return false;
    }

    /// The default radius, against what it reports as its bias.
    void check_discs(const Way& way, const std::vector<Look>& reference, Findings& findings) {
        const Way large = ways::with_bias(way);
        std::vector<Look> raw;
        std::vector<Look> corrected;
        Look bias;
        bias.blocks.assign(reference.front().blocks.size(), 0);
        for (std::uint64_t i = 0; i < kSecondLooks[0]; ++i) {
            const Picture picture = renders_->render(large, i);
            const Look own = look_at(picture, "bias.");
            raw.push_back(look_at(picture));
            corrected.push_back(sum(raw.back(), own, -1));
            bias = sum(bias, own, 1.0 / static_cast<double>(kSecondLooks[0]));
        }
        Bands bands = sure();
        bands.allowance = bias;
        const Comparison with_bias = compare(raw, reference, bands);
        if (with_bias.verdict != Verdict::different) return;
        if (compare(corrected, reference, sure()).verdict != Verdict::different) return;
        findings.faults.push_back(
            {Kind::discs, fmt::format("{} and {}: {}; reported bias of mean {:.2g}", way.name,
                                      reference_.name, with_bias.text, bias.mean)});
    }

    void check_error_bars(Findings& findings) {
        const Way longer = with_passes(reference_, 4);
        std::vector<std::vector<double>> truth;
        for (std::uint64_t i = 0; i < kSecondLooks[0]; ++i)
            truth.push_back(luminances(renders_->render(longer, 300 + i)));
        std::size_t pixels = 0;
        std::size_t beyond = 0;
        for (std::uint64_t i = 0; i < kFirstLook; ++i) {
            const Picture picture = renders_->render(ways::with_bias(ways::adaptive()), 300 + i);
            count_beyond(picture, truth, pixels, beyond);
        }
        if (static_cast<double>(beyond) > kBeyondThree * static_cast<double>(pixels))
            findings.faults.push_back(
                {Kind::error_bars,
                 fmt::format("{} of {} pixels lie beyond three of their errors", beyond, pixels)});
    }

    static void count_beyond(const Picture& picture, const std::vector<std::vector<double>>& truth,
                             std::size_t& pixels, std::size_t& beyond) {
        const Channel* errors = picture.find("error.Y");
        if (errors == nullptr) return;
        const std::vector<double> seen = luminances(picture);
        const std::vector<double> bias = luminances(picture, "bias.");
        const double dim = look_at(picture).mean / 100;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            std::vector<double> values;
            for (const std::vector<double>& one : truth) values.push_back(one[i]);
            const MeanOf right = mean_of(values);
            if (right.mean <= dim) continue;
            const double error = std::hypot(static_cast<double>(errors->values[i]), right.error);
            ++pixels;
            beyond += std::abs(seen[i] - right.mean) > 3 * error + std::abs(bias[i]);
        }
    }

    Renders* renders_;
    Effort effort_;
    Way reference_;
    Way other_reference_;
    Comparison verdict_;
};

}  // namespace

void check_light(Renders& renders, const Witnesses& witnesses, const Effort& effort,
                 Findings& findings) {
    LightCheck(renders, witnesses, effort).run(witnesses.second, findings);
}

}  // namespace sunfleck::differential
