// A render that is killed at random moments and resumed, until it is done.
#pragma once

#include "app/program.h"
#include "core/random.h"
#include "render/checkpoint.h"

namespace sunfleck::engine::testing_support {

class KillTest : public ProgramTest {
protected:
    /// Kills a render of `passes` passes that many times. After each kill the checkpoint, if there
    /// is one, is whole and holds no less than before; the picture in the end has the bytes of a
    /// render that was left alone.
    /// @param every  times between checkpoints, taken in turn.
    void expect_survives(int kills, int passes, const Words& every) const {
        const Words render{"render",       "room.pbrt", "--quiet",  "--photons-per-pass",  "500",
                           "--resolution", "64x48",     "--passes", std::to_string(passes)};
        ASSERT_EQ(run(render + Words{"-o", "whole.exr", "-o", "whole.film"}).code, 0);
        // The same files each time: what a render leaves half-written that was killed at its very
        // end is cleared away by the next one.
        const Words to{"-o", "x.exr", "-o", "x.film"};
        std::uint64_t held = 0;  // passes in the checkpoint
        for (int kill = 0; kill < kills; ++kill) {
            const Words more{"--every", every[static_cast<std::size_t>(kill) / 2 % every.size()],
                             "--nthreads", std::to_string(1 + kill % 3)};
            const auto before = written();
            Process process(path(""), render + resume() + to + more);
            RandomStream random(5, Purpose::test, 0, static_cast<std::uint32_t>(kill));
            for (int i = 0; kill % 2 == 0 && written() == before && i < 6000; ++i)
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
            std::this_thread::sleep_for(std::chrono::duration<double>(0.15 * random.next()));
            process.send(SIGKILL);
            const Ran ran = process.wait();
            ASSERT_TRUE(ran.code == 1000 + SIGKILL || ran.code == 0) << ran.code << ran.err;
            if (!exists("x.ckpt")) continue;
            const auto now = read_checkpoint(path("x.ckpt")).state.film.pass_count();
            ASSERT_GE(now, held) << "kill " << kill;
            if (now > held) ++gained_;
            held = now;
        }
        std::printf("%d kills: %d checkpoints held more than the one before, %ld of %d passes\n",
                    kills, gained_, static_cast<long>(held), passes);
        const Ran ran = run(render + resume() + to);
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_TRUE(read_text(path("x.exr")) == read_text(path("whole.exr")));
        EXPECT_TRUE(read_text(path("x.film")) == read_text(path("whole.film")));
        EXPECT_EQ(names(), "whole.exr whole.film x.ckpt x.exr x.film") << "nothing is left over";
        EXPECT_GT(gained_, 0) << "or the kills came when there was no work";
    }

private:
    /// When the checkpoint was written; the epoch's lowest time if there is none.
    std::filesystem::file_time_type written() const {
        std::error_code code;
        return std::filesystem::last_write_time(path("x.ckpt"), code);
    }
    Words resume() const {
        const Words keep{"--checkpoint", "x.ckpt"};
        return exists("x.ckpt") ? keep + Words{"--resume", "x.ckpt"} : keep;
    }

    mutable int gained_ = 0;
};

}  // namespace sunfleck::engine::testing_support
