// The folder of a render: picture.exr, log.txt, and seconds.txt once it is done.
#include "evenness/renders.h"

#include "core/parallel.h"
#include "experiment/child.h"
#include "image/atomic_file.h"
#include "image/read_file.h"

#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <filesystem>

namespace sunfleck::engine::bench {
namespace {

namespace fs = std::filesystem;

std::string record_of(const Render& render) {
    return render.folder + "/seconds.txt";
}

void make(const Render& render) {
    fs::create_directories(render.folder);
    std::vector<std::string> words = {render.method.program, "render", render.scene_file};
    words.insert(words.end(), render.method.flags.begin(), render.method.flags.end());
    const std::vector<std::string> usual = {
        "--seed",       std::to_string(render.seed),
        "--cpu-time",   fmt::format("{:.3f}s", render.cpu_seconds),
        "--nthreads",   "1",
        "--resolution", fmt::format("{0}x{0}", render.resolution),
        "-o",           render.picture()};
    words.insert(words.end(), usual.begin(), usual.end());
    const std::string log = render.folder + "/log.txt";
    const ChildEnd end = run_child(words, log, nullptr);
    check_render(end, log);
    write_file(record_of(render), fmt::format("{}\n", end.cpu_seconds));
}

}  // namespace

bool Render::is_done() const {
    return fs::exists(record_of(*this));
}

double Render::taken() const {
    return std::stod(read_file(record_of(*this)));
}

void make_renders(const std::vector<Render>& renders, std::size_t at_once) {
    std::vector<const Render*> missing;
    for (const Render& render : renders)
        if (!render.is_done()) missing.push_back(&render);
    std::atomic<std::size_t> next = 0;
    const ThreadLimit limit(at_once);
    parallel_for(at_once, [&](std::size_t) {
        for (std::size_t i = next++; i < missing.size(); i = next++) {
            fmt::print(stderr, "{} of {}: {}\n", i + 1, missing.size(), missing[i]->folder);
            make(*missing[i]);
        }
    });
}

}  // namespace sunfleck::engine::bench
