// Scenes are taken in order by workers; coverage, report and output are theirs together.
#include "differential/campaign.h"

#include "differential/minimise.h"
#include "differential/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <thread>

namespace sunfleck::engine::differential {
namespace {

/// A scene of the campaign.
struct Case {
    std::uint32_t number;
    Choice choice;
};

class Run {
public:
    Run(const Campaign& campaign, const FeatureTable& table)
        : campaign_(campaign),
          table_(&table),
          program_(std::filesystem::absolute(campaign.program), campaign.seconds),
          folder_(std::filesystem::absolute(campaign.folder)),
          choices_(table, campaign.seed),
          covered_(table),
          report_(table) {
        write_files(folder_);
    }

    bool run() {
        const auto start = std::chrono::steady_clock::now();
        std::vector<std::thread> workers;
        for (int worker = 0; worker < campaign_.jobs; ++worker)
            workers.emplace_back([this, worker] {
                while (const auto one = next()) examine_case(*one, worker);
            });
        for (std::thread& worker : workers) worker.join();
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        const std::string text = report_.text(covered_, passed.count());
        std::ofstream(folder_ + "/report.txt", std::ios::app) << text;
        fmt::print("{}", text);
        return report_.faults() == 0;
    }

private:
    std::optional<Case> next() {
        const std::lock_guard lock(mutex_);
        while (next_ < campaign_.first + campaign_.scenes) {
            Case one{next_++, choices_.next()};
            if (one.number < campaign_.first || !is_wanted(one.choice)) continue;
            covered_.add(one.choice);
            return one;
        }
        return {};
    }

    bool is_wanted(const Choice& choice) const {
        return std::all_of(campaign_.only.begin(), campaign_.only.end(), [&](const auto& wish) {
            const std::size_t sign = wish.find('=');
            return sign != std::string::npos &&
                   table_->value(choice, wish.substr(0, sign)) == wish.substr(sign + 1);
        });
    }

    Place place_of(const Case& one, const std::string& name, int worker) const {
        const std::string_view filter = table_->value(one.choice, "filter");
        return {.scene = folder_ + '/' + name,
                .folder = fmt::format("{}/work-{}", folder_, worker),
                .seed = campaign_.seed * 100000 + one.number,
                .may_be_negative = filter == "mitchell" || filter == "sinc"};
    }

    void examine_case(const Case& one, int worker) {
        const SceneText scene = make_scene(*table_, one.choice, campaign_.seed, one.number);
        const Place place = place_of(one, fmt::format("{:04}.pbrt", one.number), worker);
        std::filesystem::create_directories(place.folder);
        std::ofstream(place.scene) << text_of(scene);
        const auto is_due = [&](std::uint32_t every) {
            return every > 0 && one.number % every == 0;
        };
        const Effort effort{.with_bytes = is_due(campaign_.bytes_every),
                            .with_discs = is_due(campaign_.discs_every),
                            .until_decided = campaign_.until_decided,
                            .significance = 0.01 / campaign_.scenes};
        const Witnesses witnesses{is_found_by_path(*table_, one.choice),
                                  std::string(table_->value(one.choice, "second witness"))};
        Renders renders(program_, place);
        const Findings findings = differential::examine(renders, witnesses, effort);
        tell(one, findings);
        for (const Fault& fault : findings.faults)
            make_smaller(one, scene, witnesses, fault, worker);
        if (findings.faults.empty() && !campaign_.keep) std::filesystem::remove(place.scene);
    }

    void tell(const Case& one, const Findings& findings) {
        const std::lock_guard lock(mutex_);
        report_.add(one.choice, findings);
        std::string text =
            fmt::format("{:04} {:.1f} s, {}", one.number, findings.seconds, name(findings.light));
        if (findings.light != Verdict::equal) text += " (" + findings.light_text + ')';
        for (const Fault& fault : findings.faults)
            text += fmt::format("\n{:04} FAULT {}: {}", one.number, name(fault.kind), fault.text);
        fmt::print("{}\n", text);
        std::fflush(stdout);
    }

    void make_smaller(const Case& one, const SceneText& scene, const Witnesses& witnesses,
                      const Fault& fault, int worker) {
        const std::string name_of_small =
            fmt::format("{:04}-{}.pbrt", one.number, name(fault.kind));
        const auto write = [&](const SceneText& text) {
            std::ofstream(folder_ + '/' + name_of_small) << text_of(text);
        };
        const auto still_fails = [&](const SceneText& smaller) {
            write(smaller);
            Renders renders(program_, place_of(one, name_of_small, worker));
            return has_fault(renders, witnesses, fault.kind);
        };
        write(minimised(scene, still_fails, campaign_.tries));
    }

    Campaign campaign_;
    const FeatureTable* table_;
    Program program_;
    std::string folder_;
    CoveringChoices choices_;
    PairCoverage covered_;  // by the scenes that were rendered
    Report report_;
    std::mutex mutex_;
    std::uint32_t next_ = 0;
};

}  // namespace

bool run(const Campaign& campaign, const FeatureTable& table) {
    return Run(campaign, table).run();
}

}  // namespace sunfleck::engine::differential
