// The differential tester: random small scenes, rendered by several estimators, compared.
// Usage, and what the report says: docs/develop/testing.md. Exit code 1 if there is any fault.
#include "differential/campaign.h"
#include "sunfleck/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>

int main(int argc, char** argv) {
    using namespace sunfleck::engine::differential;  // NOLINT(google-build-using-namespace): all of
                                                     // main
    Campaign campaign;
    std::vector<std::string> left_out;
    CLI::App app("Renders random small scenes by several estimators and compares them");
    app.add_option("--program", campaign.program, "The program sunfleck")->required();
    app.add_option("--scenes", campaign.scenes, "Number of scenes");
    app.add_option("--first", campaign.first, "Number of the first scene that is rendered");
    app.add_option("--seed", campaign.seed, "Seed of the scenes and of their renders");
    app.add_option("--out", campaign.folder, "Folder for scenes that fail, and the report");
    app.add_option("--jobs", campaign.jobs, "Scenes at a time")->check(CLI::PositiveNumber);
    app.add_option("--seconds", campaign.seconds, "Processor time that one render may take");
    app.add_option("--bytes-every", campaign.bytes_every,
                   "Compare bytes (threads, interrupt, resume) of every so-manieth scene");
    app.add_option("--discs-every", campaign.discs_every,
                   "Check discs of the default radius, and error bars, of every so-manieth scene");
    app.add_option("--tries", campaign.tries, "Renders of smaller scenes, for each fault");
    app.add_option("--leave-out", left_out, "FEATURE=VALUE that no scene takes; may be repeated");
    app.add_option("--only", campaign.only,
                   "FEATURE=VALUE of the scenes to render; may be repeated");
    app.add_flag("--keep", campaign.keep, "Keep scenes that have no fault, too");
    app.add_flag("--until-decided", campaign.until_decided,
                 "Render more where a first look cannot decide");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(campaign, scene_features(left_out)) ? 0 : 1;
    } catch (const sunfleck::Error& error) {
        fmt::print(stderr, "differential: {}\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "differential: {}\n", error.what());
        return 1;
    }
}
