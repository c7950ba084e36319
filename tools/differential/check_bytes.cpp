// Few photons, 20 passes: those of a second epoch are among them.
#include "differential/check_bytes.h"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace sunfleck::engine::differential {
namespace {

constexpr int kInterrupted = 130;

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Picture and film of a render that ends, of passes from two epochs (docs/method/method.md).
class Bytes {
public:
    explicit Bytes(Renders& renders) : renders_(&renders) {}

    std::string render(const Words& more) {
        std::filesystem::remove(renders_->place().folder + "/bytes.exr");
        const Ended ended = renders_->run(words(more));
        if (ended.code != 0) throw RenderFault({Kind::refused, ended.text()});
        return picture();
    }

    /// After an interrupt at some time, and a resume on two threads where it came early enough.
    std::string interrupted_render() {
        const std::string kept = renders_->place().folder + "/kept.ckpt";
        std::filesystem::remove(kept);
        const Ended ended =
            renders_->run(words({"--nthreads", "1", "--checkpoint", "kept.ckpt"}),
                          std::chrono::milliseconds(20 + renders_->place().seed * 37 % 300));
        if (ended.code == 0) return picture();
        if (ended.code != kInterrupted) throw RenderFault({Kind::refused, ended.text()});
        const bool has_begun = std::filesystem::exists(kept);
        return render(has_begun ? Words{"--nthreads", "2", "--resume", "kept.ckpt"} : Words{});
    }

private:
    static Words words(const Words& more) {
        Words all = {"-o",   "bytes.exr", "-o", "bytes.film", "--photons-per-pass",
                     "1000", "--passes",  "20", "--seed",     "1"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    std::string picture() const {
        const std::string& folder = renders_->place().folder;
        return bytes_of(folder + "/bytes.exr") + bytes_of(folder + "/bytes.film");
    }

    Renders* renders_;
};

}  // namespace

std::optional<Fault> check_bytes(Renders& renders) {
    Bytes bytes(renders);
    const std::string whole = bytes.render({"--nthreads", "1"});
    if (bytes.render({"--nthreads", "2"}) != whole)
        return Fault{Kind::threads, "two threads give other bytes than one"};
    if (bytes.interrupted_render() != whole)
        return Fault{Kind::resume, "an interrupted and resumed render has other bytes"};
    return {};
}

}  // namespace sunfleck::engine::differential
