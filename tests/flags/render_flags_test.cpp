// The flags of a render: one table, and what it refuses.
#include "flags/render_flags.h"

#include "flags/renamed_flags.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>

#include <set>

namespace sunfleck::engine {
namespace {

using Given = std::vector<std::pair<std::string, std::string>>;

RenderRequest request_of(const Given& given) {
    RenderFlags flags;
    for (const auto& [name, text] : given) flags.set(name, text);
    return flags.finish();
}

/// What is said of these flags; empty: they are taken.
std::string fault_of(const Given& given) {
    try {
        request_of(given);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// Some text that the flag takes.
std::string example_of(const RenderFlag& flag) {
    if (!flag.value.choices.empty()) return flag.value.choices.back().name;
    if (!flag.value.range.empty()) return flag.value.range.substr(0, flag.value.range.find(' '));
    const std::map<std::string, std::string> by_form = {{"WxH", "64x48"},
                                                        {"X0,X1,Y0,Y1", "0,1,0,1"},
                                                        {"X%", "5%"},
                                                        {"NAME=LIGHTS|each", "sun=1"},
                                                        {"TIME", "60s"},
                                                        {"A:B", "0:16"},
                                                        {"adaptive|THETA", "adaptive"},
                                                        {"STOPS|auto", "auto"},
                                                        {"all|NAME,...", "all"},
                                                        {"X", "0.3"},
                                                        {"N", "7"}};
    return by_form.at(flag.value.form);
}

/// The flag as a user gives it, and what else must be given with it.
Given with_needs(const RenderFlag& flag) {
    Given given{{flag.name, example_of(flag)}};
    for (const FlagNeed& need : flag.needs)
        if (need.values.size() == 1 && need.flag != "--integrator" &&
            render_flag(need.flag).default_value != need.values[0])
            given.emplace_back(need.flag, need.values[0]);
    return given;
}

TEST(RenderFlags, have_names_of_their_own_and_help) {
    std::set<std::string> names;
    for (const RenderFlag& flag : render_flags()) {
        EXPECT_TRUE(flag.name.starts_with("--"));
        EXPECT_TRUE(names.insert(flag.name).second) << flag.name;
        EXPECT_TRUE(flag.alias.empty() || names.insert(flag.alias).second) << flag.alias;
        EXPECT_FALSE(flag.group.empty()) << flag.name;
        EXPECT_GT(flag.help.size(), 5U) << flag.name;
        EXPECT_TRUE(help_text(flag).starts_with(flag.help));
    }
    EXPECT_GT(names.size(), 30U);
}

TEST(RenderFlags, switch_each_part_of_the_sampler_adaptive_off) {
    for (const AdaptivePart& part : kAdaptiveParts) {
        EXPECT_TRUE(request_of({}).settings.photon.*part.is_on) << part.name;
        const RenderRequest off = request_of({{std::string(part.name), "off"}});
        EXPECT_FALSE(off.settings.photon.*part.is_on) << part.name;
    }
}

TEST(RenderFlags, need_what_other_flags_can_say) {
    for (const RenderFlag& flag : render_flags())
        for (const FlagNeed& need : flag.needs) {
            const RenderFlag& other = render_flag(need.flag);
            EXPECT_EQ(need.flag, other.name) << flag.name;
            for (const std::string& value : need.values)
                EXPECT_NE(("|" + other.value.form + "|").find("|" + value + "|"), std::string::npos)
                    << flag.name << " needs " << need.flag << " " << value;
        }
}

/// A choice that is the standard is one of the choices, and it changes nothing.
TEST(RenderFlags, stand_by_default_at_one_of_their_choices) {
    const std::string plain = request_of({{"--passes", "1"}}).settings.text();
    for (const RenderFlag& flag : render_flags()) {
        if (flag.value.choices.empty() || flag.default_value.empty()) continue;
        RenderRequest request;
        flag.value.read(request, flag.default_value, flag.name);
        EXPECT_EQ(request.settings.text(), plain) << flag.name;
        EXPECT_NE(("|" + flag.value.form + "|").find("|" + flag.default_value + "|"),
                  std::string::npos);
    }
}

TEST(RenderFlags, are_each_taken_alone_and_once) {
    for (const RenderFlag& flag : render_flags()) {
        Given given = with_needs(flag);
        EXPECT_EQ(fault_of(given), "") << flag.name;
        given.push_back(given.front());
        given.back().second += flag.value.repeats ? "-2" : "";
        given.back().second.insert(0, flag.value.repeats ? "b" : "");
        EXPECT_EQ(fault_of(given),
                  flag.value.repeats ? "" : flag.name + ": is given twice; give it once");
    }
}

/// Each need of each flag, broken by the values of the other flag that it does not name.
TEST(RenderFlags, are_refused_where_they_have_no_meaning) {
    int refused = 0;
    for (const RenderFlag& flag : render_flags())
        for (const FlagNeed& need : flag.needs) {
            if (!need.of_value.empty()) continue;
            const RenderFlag& other = render_flag(need.flag);
            Given given = with_needs(flag);
            std::erase_if(given, [&](const auto& one) { return one.first == need.flag; });
            std::vector<std::string> bad;
            for (const FlagChoice& choice : other.value.choices)
                if (std::find(need.values.begin(), need.values.end(), choice.name) ==
                    need.values.end())
                    bad.push_back(choice.name);
            if (need.values.empty()) bad = {example_of(other)};
            if (need.flag == "--mutation-size") bad = {"0.5"};
            for (const std::string& text : bad) {
                Given broken = given;
                broken.emplace_back(need.flag, text);
                const std::string fault = fault_of(broken);
                EXPECT_TRUE(fault.starts_with("--"))
                    << flag.name << " beside " << need.flag << " " << text << ": " << fault;
                ++refused;
            }
            EXPECT_FALSE(bad.empty()) << flag.name << " " << need.flag;
        }
    EXPECT_GT(refused, 100);
}

TEST(RenderFlags, say_why_they_are_refused) {
    struct Row {
        Given given;
        std::string fault;
    };
    const std::vector<Row> rows = {
        {{{"--alpha", "0.5"}, {"--integrator", "bdpt"}},
         "--alpha: has no meaning with --integrator bdpt; leave it out"},
        {{{"--splitting", "off"}, {"--photon-sampler", "random"}},
         "--splitting: has a meaning with the sampler adaptive alone; leave it out"},
        {{{"--mutation-size", "1"}},
         "--mutation-size: has a meaning with the sampler paper alone; leave it out, or add "
         "--mode paper"},
        {{{"--guide-search", "off"}, {"--emission-guide", "off"}},
         "--guide-search: is a part of the emission guide, which is off; leave it out"},
        {{{"--passes", "4"}, {"--pass-range", "0:4"}},
         "--pass-range: given together with --passes; give one"},
        {{{"--mode", "paper"}, {"--direct", "sampled"}},
         "--direct: is photons with the sampler paper; leave it out"},
        {{{"--mode", "paper"}, {"--target-error", "1%"}},
         "--target-error: the sampler paper has no error bars; use --passes or --time"},
        {{{"--mode", "paper"}, {"--integrator", "path"}},
         "--mode: has no meaning with --integrator path; leave it out"},
        {{{"--mode", "paper"}, {"--photon-sampler", "random"}},
         "--mode: is the sampler paper, and --photon-sampler names another; leave one of them out"},
        {{{"--isa", "sse"}}, "--isa: does not take \"sse\"; use avx2 or native"},
        {{{"--passes", "0"}},
         "--passes: \"0\" is no whole number from 1 to 1073741824; write such a number"},
    };
    for (const Row& row : rows) EXPECT_EQ(fault_of(row.given), row.fault);
    EXPECT_EQ(fault_of({{"--mode", "paper"}, {"--direct", "photons"}}), "");
    EXPECT_EQ(fault_of({{"--mode", "paper"}, {"--photon-sampler", "paper"}}), "");
}

TEST(RenderFlags, have_names_as_python_writes_them) {
    EXPECT_EQ(&render_flag("photons_per_pass"), &render_flag("--photons-per-pass"));
    EXPECT_EQ(&render_flag("spp"), &render_flag("--passes"));
    EXPECT_EQ(fault_of({{"no_such", "1"}}).find("--no-such: is no flag of a render"), 0U);
    for (const RenamedFlag& row : kRenamedFlags)
        EXPECT_NE(fault_of({{std::string(row.before), "off"}}).find(row.now), std::string::npos);
}

TEST(RenderFlags, aovs_are_a_list_of_names) {
    const AovSet aovs = request_of({{"aovs", "depth,caustic"}}).settings.aovs;
    for (const AovRow& row : kAovs)
        EXPECT_EQ(aovs.at(static_cast<std::size_t>(row.aov)),
                  row.aov == Aov::depth || row.aov == Aov::caustic)
            << row.name;
    EXPECT_EQ(request_of({{"aovs", ""}}).settings.aovs, AovSet{});
    for (const char* text : {"colour", "depth,,caustic", "depth;caustic", "total"})
        EXPECT_EQ(fault_of({{"aovs", text}}).find("--aovs: does not take \""), 0U) << text;
}

TEST(RenderFlags, without_an_end_there_are_two_and_a_chain_has_one) {
    const RenderRequest plain = request_of({});
    EXPECT_TRUE(plain.ends_by_default);
    EXPECT_EQ(plain.stop.seconds, 600);
    EXPECT_EQ(plain.stop.target_error, 0.02);
    const RenderRequest paper = request_of({{"--mode", "paper"}});
    EXPECT_TRUE(paper.ends_by_default);
    EXPECT_FALSE(paper.stop.target_error);
    EXPECT_FALSE(request_of({{"--time", "1s"}}).ends_by_default);
}

/// What the paper prescribes gives way to what a user says, in any order of the flags.
TEST(RenderFlags, of_the_paper_are_changed_by_others) {
    EXPECT_EQ(request_of({{"--mode", "paper"}}).settings.alpha, 0.7);
    for (const Given& given : {Given{{"--alpha", "0.5"}, {"--mode", "paper"}},
                               Given{{"--photon-sampler", "paper"}, {"--alpha", "0.5"}}}) {
        const RenderRequest request = request_of(given);
        EXPECT_EQ(request.settings.alpha, 0.5);
        EXPECT_EQ(request.settings.camera.radius_pixels, 2);
        EXPECT_EQ(request.settings.transport.direct, DirectLight::photons);
    }
}

}  // namespace
}  // namespace sunfleck::engine
