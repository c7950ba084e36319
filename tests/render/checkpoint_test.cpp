// Checkpoints come back as they were; what is damaged or lies about its size is refused, and a disk
// that is full leaves the former one.
#include "render/checkpoint.h"

#include "film/error_bars.h"
#include "film/word_hash.h"
#include "image/read_file.h"
#include "image/temporary_folder.h"
#include "photon_samplers/samplers.h"
#include "render/progressive.h"
#include "sunfleck/error.h"
#include "support/renders.h"

#include <sys/resource.h>

#include <csignal>
#include <cstring>
#include <sstream>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

const Origin kOrigin{"0.1.0", "avx2", {{"a scene.pbrt", 17}, {"wood.png", 18}}};

/// A lamp of 1 x 1 above a floor, 4 x 4 pixels.
Scene small_room() {
    return Scene(read_pbrt_text(view("0 0 1.5  0 0 0  0 1 0", 50, 4) + diffuse("0.5 0.6 0.7") +
                                    quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") +
                                    R"(AreaLightSource "diffuse" "rgb L" [4 4 4]
)" + quad("-0.5 -0.5 2  -0.5 0.5 2  0.5 0.5 2  0.5 -0.5 2"),
                                "room.pbrt"));
}

PaperMemory& paper_of(RenderState& state) {
    return std::get<PaperMemory>(state.sampler);
}

class Checkpoints : public TemporaryFolder {
protected:
    RenderJob job(PhotonSampler sampler, std::uint32_t passes) const {
        RenderJob job{scene_, {}, {}, 77};
        if (sampler == PhotonSampler::paper) use_paper_mode(job.settings);
        job.settings.photon.sampler = sampler;
        job.settings.photon.paths_per_pass = 100;
        job.settings.aovs.at(static_cast<std::size_t>(Aov::samples)) = true;
        job.stop.end_pass = passes;
        return job;
    }
    std::string bytes_of(const RenderState& state) const {
        write_checkpoint(path("bytes"), kOrigin, state);
        return read_file(path("bytes"));
    }
    std::string bytes_of(PhotonSampler sampler, std::uint32_t passes) const {
        return bytes_of(render(job(sampler, passes), {}));
    }

private:
    Scene scene_ = small_room();
};

/// What the Error says; "" if there is none.
std::string fault_of(const std::string& bytes) {
    std::istringstream stream(bytes);
    try {
        read_checkpoint(stream, bytes.size(), "x.ckpt");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string with_word(std::string bytes, std::size_t word, std::uint64_t value) {
    std::memcpy(bytes.data() + 8 * word, &value, 8);
    return bytes;
}

/// The same with the checksum that these words have.
std::string signed_again(const std::string& bytes) {
    WordHash hash;
    for (std::size_t i = 0; i + 16 <= bytes.size(); i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, 8);
        hash.add(word);
    }
    return with_word(bytes, bytes.size() / 8 - 1, hash.value());
}

TEST_F(Checkpoints, come_back_as_they_were) {
    for (const PhotonSamplerRow& row : kPhotonSamplers) {
        const std::string bytes = bytes_of(row.sampler, 18);
        std::istringstream stream(bytes);
        const Checkpoint read = read_checkpoint(stream, bytes.size(), "x.ckpt");
        EXPECT_EQ(read.origin, kOrigin);
        EXPECT_EQ(read.state.film.pass_count(), 18U);
        EXPECT_EQ(std::holds_alternative<PaperMemory>(read.state.sampler),
                  row.sampler == PhotonSampler::paper);
        EXPECT_GT(read.state.total_seconds, 0);
        EXPECT_TRUE(bytes_of(read.state) == bytes) << row.name;
    }
}

TEST_F(Checkpoints, go_on_as_if_never_stopped) {
    for (const PhotonSamplerRow& row : kPhotonSamplers) {
        const RenderResult whole = render(job(row.sampler, 40), {});
        ASSERT_GT(image_mean(whole.film), 0);
        for (const std::uint32_t stop : {1U, 16U, 23U, 40U}) {
            write_checkpoint(path("x.ckpt"), kOrigin, render(job(row.sampler, stop), {}));
            const RenderResult result =
                render(job(row.sampler, 40), {}, read_checkpoint(path("x.ckpt")).state);
            EXPECT_TRUE(result.film.sums() == whole.film.sums()) << row.name << " " << stop;
            EXPECT_EQ(result.radius_factor, whole.radius_factor) << row.name << " " << stop;
        }
    }
}

/// The interval counts from the beginning of the last call: no more than it and a pass is lost.
TEST_F(Checkpoints, are_due_when_the_interval_has_passed_and_at_the_end) {
    for (const double every : {0.0, 0.002, 1e6}) {
        std::vector<double> ends;
        std::vector<double> saves;
        RenderHooks hooks;
        hooks.report = [&](const Progress& progress) { ends.push_back(progress.seconds); };
        hooks.save = [&](const RenderState& state) { saves.push_back(state.total_seconds); };
        hooks.save_every = every;
        render(job(PhotonSampler::uniform, 60), hooks);
        std::vector<double> expected;
        for (const double end : ends)
            if (end - (expected.empty() ? 0 : expected.back()) >= every) expected.push_back(end);
        if (expected.empty() || expected.back() != ends.back()) expected.push_back(ends.back());
        EXPECT_EQ(saves, expected) << every;
        EXPECT_EQ(ends.size(), 60U);
    }
}

TEST_F(Checkpoints, limits_that_are_reached_end_without_another_pass) {
    const auto passes_after = [&](const StopSettings& stop) {
        RenderJob more = job(PhotonSampler::uniform, 70);
        const RenderResult earlier = render(more, {});
        more.stop = stop;
        return render(more, {}, static_cast<const RenderState&>(earlier)).film.pass_count();
    };
    EXPECT_EQ(passes_after({0, 70, {}, {}, {}}), 70U);
    EXPECT_EQ(passes_after({0, {}, 1e-9, {}, {}}), 70U);
    EXPECT_EQ(passes_after({0, {}, {}, 1e-9, {}}), 70U);
    // Errors are asked for where batches end, as in one go.
    EXPECT_EQ(passes_after({0, {}, {}, {}, 0.9}), 80U);
    EXPECT_EQ(passes_after({0, 75, 1000, 1000, 1e-9}), 75U);
}

TEST_F(Checkpoints, every_flipped_byte_and_every_cut_is_an_error) {
    const std::string bytes = bytes_of(PhotonSampler::paper, 2);
    EXPECT_EQ(fault_of(bytes), "");
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string broken = bytes;
        broken[i] = static_cast<char>(broken[i] ^ (i % 2 == 0 ? 0x01 : 0x80));
        EXPECT_NE(fault_of(broken), "") << "byte " << i;
        EXPECT_NE(fault_of(bytes.substr(0, i)), "") << i;
    }
    EXPECT_NE(fault_of(bytes + std::string(8, '\0')), "");
}

/// Words that lie, under a checksum that does not: no room is made for what the file cannot fill.
TEST_F(Checkpoints, huge_claims_are_refused) {
    for (const PhotonSampler sampler : {PhotonSampler::uniform, PhotonSampler::paper}) {
        const std::string bytes = bytes_of(sampler, 18);
        ASSERT_EQ(signed_again(bytes), bytes);
        for (std::size_t word = 0; word + 1 < bytes.size() / 8; ++word)
            for (const std::uint64_t claim :
                 {std::uint64_t{1} << 17U, std::uint64_t{1} << 33U, std::uint64_t{1} << 61U,
                  ~std::uint64_t{0}, std::uint64_t{0x7FF8} << 48U, std::uint64_t{0}})
                EXPECT_NO_THROW(fault_of(signed_again(with_word(bytes, word, claim))))
                    << "word " << word;  // no std::bad_alloc
    }
}

/// Each word of the numbers of the sampler `paper`: not finite, negative, or of another picture.
TEST_F(Checkpoints, numbers_that_cannot_be_are_refused) {
    const RenderResult result = render(job(PhotonSampler::paper, 2), {});
    const auto fault_with = [&](const auto& change) {
        RenderState state = static_cast<const RenderState&>(result);
        change(state);
        return fault_of(bytes_of(state));
    };
    const std::string damaged =
        "x.ckpt: is not a checkpoint, or is truncated or damaged; use another copy, "
        "or render anew without --resume";
    EXPECT_EQ(fault_with([](RenderState&) {}), "");
    EXPECT_EQ(fault_with([](RenderState& s) { s.total_seconds = -1; }), damaged);
    EXPECT_EQ(fault_with([](RenderState& s) { s.seconds.camera = std::nan(""); }), damaged);
    EXPECT_EQ(fault_with([](RenderState& s) { s.sampler = NoState(); }), damaged);
    EXPECT_EQ(fault_with([](RenderState& s) { paper_of(s).passes = 3; }), damaged);
    EXPECT_EQ(fault_with([](RenderState& s) { paper_of(s).shown = -1; }), damaged);
    EXPECT_EQ(fault_with([](RenderState& s) { paper_of(s).flux[0].resize(5); }), damaged);
    // A saturated colour has negative channels.
    EXPECT_EQ(fault_with([](RenderState& s) { paper_of(s).flux[0][1].high = -1; }), "");
    EXPECT_EQ(fault_with([](RenderState& s) { paper_of(s).radii = LocalRadii(15, 0.7); }), damaged);
    EXPECT_EQ(fault_with([](RenderState& s) { paper_of(s).radii = LocalRadii(16, 1.5); }), damaged);
    EXPECT_EQ(fault_with([](RenderState& s) {
                  PaperSettings settings;
                  settings.mutation_size = -1;
                  paper_of(s).chain.size = MutationSize(settings);
              }),
              damaged);
    EXPECT_EQ(fault_with([](RenderState& s) { s.film = Film(s.film.key()); }), damaged);
}

TEST_F(Checkpoints, errors_are_one_clear_line) {
    const std::string bytes = bytes_of(PhotonSampler::uniform, 1);
    EXPECT_EQ(fault_of(signed_again(with_word(bytes, 1, 8))),
              "x.ckpt: is a checkpoint of version 8; use the program that wrote it; this one reads "
              "version 10");
    EXPECT_THROW(read_checkpoint(path("none.ckpt")), Error);
}

/// A disk that is full is played by a limit on the size of files.
TEST_F(Checkpoints, a_full_disk_leaves_the_former_one) {
    const RenderResult result = render(job(PhotonSampler::uniform, 3), {});
    write_checkpoint(path("x.ckpt"), kOrigin, render(job(PhotonSampler::uniform, 2), {}));
    const std::string former = read_file(path("x.ckpt"));
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = former.size() / 2;
    setrlimit(RLIMIT_FSIZE, &small);
    EXPECT_THROW(write_checkpoint(path("x.ckpt"), kOrigin, result), Error);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(read_file(path("x.ckpt")), former);
    EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace sunfleck::engine
