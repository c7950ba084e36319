// First look, second look, and which of light, discs and error bars is at fault.
#include "differential/check_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sunfleck::engine::differential {
namespace {

constexpr std::uint64_t kFirstLook = 4;
/// Of a first look, which only says where to look twice: where the mean is off by more than its
/// error, or a block by much.
constexpr double kFirstMean = 0.15;
constexpr double kFirstBlocks = 0.05;
constexpr double kFirstBlockBand = 0.2;
/// Renders of each estimator of a second look, while it is undecided.
constexpr std::array<std::uint64_t, 2> kSecondLooks = {8, 24};
/// Share of pixels that may lie beyond three of their errors: of four batches 6% do. All pixels of
/// a picture may do so together, where what they have in common, as the wavelengths of a spiky
/// light, is their only noise: so all pictures but one must have more.
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
        examine(ways::with_small_discs(ways::adaptive()), reference, findings);
        findings.excess = first_excess_;
        findings.light = verdict_.verdict;
        findings.mean = verdict_.of_mean;
        findings.light_text = verdict_.text;
        if (second == "bdpt") examine(ways::pairs(), reference, findings);
        if (second == "uniform" || second == "random" || second == "direct photons")
            examine(ways::with_small_discs(ways::photons(second)), reference, findings);
        if (effort_.with_discs && findings.faults.empty()) check_discs(findings);
    }

private:
    void examine(const Way& way, const std::vector<Look>& reference, Findings& findings) {
        if (way.name == reference_.name) return;
        verdict_ = compare(renders_->looks(way, 0, kFirstLook), reference,
                           {.block = kFirstBlockBand,
                            .mean_significance = kFirstMean,
                            .block_significance = kFirstBlocks,
                            .allowance = {}});
        first_excess_ = verdict_.excess;
        const bool is_open = verdict_.verdict == Verdict::undecided && effort_.until_decided;
        if (verdict_.verdict == Verdict::different || is_open) look_twice(way, findings);
    }

    Bands sure() const {
        const double half = effort_.significance / (2 * kSecondLooks.size());
        return {.mean_significance = half, .block_significance = half, .allowance = {}};
    }

    void look_twice(const Way& way, Findings& findings) {
        std::vector<Look> looks;
        std::vector<Look> reference;
        const Way longer = with_passes(reference_, 2);
        for (const std::uint64_t count : kSecondLooks) {
            const std::uint64_t first = 100 + looks.size();
            append(looks, renders_->looks(way, first, count - looks.size()));
            append(reference, renders_->looks(longer, first, count - reference.size()));
            verdict_ = compare(looks, reference, sure());
            if (verdict_.verdict != Verdict::undecided) break;
        }
        if (verdict_.verdict == Verdict::different && is_confirmed(way, looks))
            findings.faults.push_back(
                {Kind::light, way.name + " and " + reference_.name + ": " + verdict_.text});
    }

    /// Each reference misses some light: path tracing what comes by rare paths, bidirectional what
    /// is seen through glass by way of glass, photons what falls near edges. Two must differ.
    bool is_confirmed(const Way& way, const std::vector<Look>& looks) {
        const Way judge = way.name == other_reference_.name
                              ? ways::with_small_discs(ways::adaptive())
                              : other_reference_;
        const Comparison other = compare(looks, renders_->looks(judge, 200, looks.size()), sure());
        if (other.verdict == Verdict::different) return true;
        verdict_.verdict = Verdict::undecided;
        verdict_.text += "; but " + judge.name + ": " + other.text;
        return false;
    }

    /// Discs of the default radius against small ones, and against what they report of themselves.
    void check_discs(Findings& findings) {
        std::vector<Look> raw;
        std::vector<Look> corrected;
        std::vector<Picture> pictures;
        Look bias;
        for (std::uint64_t i = 0; i < kFirstLook; ++i) {
            pictures.push_back(renders_->render(ways::with_bias(ways::adaptive()), 300 + i));
            const Look own = look_at(pictures.back(), "bias.");
            raw.push_back(look_at(pictures.back()));
            corrected.push_back(sum(raw.back(), own, -1));
            if (i == 0) bias.blocks.assign(own.blocks.size(), 0);
            bias = sum(bias, own, 1.0 / static_cast<double>(kFirstLook));
        }
        std::vector<Look> small;
        std::vector<std::vector<double>> truth;
        for (std::uint64_t i = 0; i < kSecondLooks.front(); ++i) {
            const Picture picture =
                renders_->render(ways::with_small_discs(ways::adaptive()), 300 + i);
            small.push_back(look_at(picture));
            truth.push_back(luminances(picture));
        }
        Bands bands = sure();
        bands.allowance = bias;
        const Comparison found = compare(raw, small, bands);
        if (found.verdict == Verdict::different &&
            compare(corrected, small, sure()).verdict == Verdict::different)
            findings.faults.push_back(
                {Kind::discs,
                 fmt::format("default and small discs: {}; reported bias of mean {:.2g}",
                             found.text, bias.mean)});
        check_error_bars(pictures, truth, findings);
    }

    static void check_error_bars(const std::vector<Picture>& pictures,
                                 const std::vector<std::vector<double>>& truth,
                                 Findings& findings) {
        std::vector<double> shares;
        for (const Picture& picture : pictures) shares.push_back(share_beyond(picture, truth));
        std::sort(shares.begin(), shares.end());
        const double second = shares.at(1);
        if (second > kBeyondThree)
            findings.faults.push_back(
                {Kind::error_bars,
                 fmt::format("{:.0f}% of the pixels or more lie beyond three of their errors",
                             100 * second)});
    }

    /// Returns which share of the pixels that are not dim lies beyond three of their errors.
    static double share_beyond(const Picture& picture,
                               const std::vector<std::vector<double>>& truth) {
        const Channel* errors = picture.find("error.Y");
        if (errors == nullptr) return 0;
        std::size_t pixels = 0;
        std::size_t beyond = 0;
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
        return pixels > 0 ? static_cast<double>(beyond) / static_cast<double>(pixels) : 0;
    }

    Renders* renders_;
    Effort effort_;
    Way reference_;
    Way other_reference_;
    Comparison verdict_;
    std::optional<Excess> first_excess_;  // of the first look of what was examined last
};

}  // namespace

void check_light(Renders& renders, const Witnesses& witnesses, const Effort& effort,
                 Findings& findings) {
    LightCheck(renders, witnesses, effort).run(witnesses.second, findings);
}

}  // namespace sunfleck::engine::differential
