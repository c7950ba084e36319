// `sunfleck experiment`: what it lists and what it refuses (experiment_slow_test.cpp: renders).
#include "app/program.h"

namespace sunfleck::engine {
namespace {

using namespace testing_support;
using Experiment = ProgramTest;

TEST_F(Experiment, lists_all_figures) {
    const Ran ran = run({"experiment"});
    EXPECT_EQ(ran.code, 0);
    for (const char* name : {"table1", "fig1", "fig5", "fig13"})
        EXPECT_NE(ran.out.find(name), std::string::npos);
}

TEST_F(Experiment, refuses_what_it_cannot_do) {
    const auto refused = [&](const Words& words, const std::string& what) {
        const Ran ran = run(Words{"experiment"} + words);
        EXPECT_EQ(ran.code, 2);
        EXPECT_NE(ran.err.find(what), std::string::npos) << ran.err;
        EXPECT_FALSE(exists("experiment"));
    };
    refused({"fig2"}, "there is no figure \"fig2\"; use some of: table1, fig1");
    refused({"fig8", "--passes", "1", "--minutes", "1"}, "--minutes: given together with --passes");
    refused({"fig8", "--other", "room=x"}, "\"room=x\" is no SCENE=LABEL=FILE");
    refused({"fig8", "--scale", "2"}, "--scale");
}

}  // namespace
}  // namespace sunfleck::engine
