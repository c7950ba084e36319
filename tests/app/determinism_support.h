// One render cut in many ways: threads, pass ranges, orders of merging. One hash each.
#pragma once

#include "app/program.h"

namespace sunfleck::engine::testing_support {

class DeterminismTest : public ProgramTest {
protected:
    /// The bytes of a film's picture and of the film itself.
    struct Bytes {
        std::string film;
        std::string exr;
        friend bool operator==(const Bytes&, const Bytes&) = default;
    };

    /// Makes a procedural scene the one that is rendered.
    void use(const std::string& name, const Words& words) {
        ASSERT_EQ(run({"scene", name, "-o", "."}).code, 0);
        render_words_ = Words{"render", name + ".pbrt", "--quiet"} + words;
    }

    /// Renders passes "a:b" into NAME.film and NAME.exr.
    void part(const std::string& name, const std::string& range, int threads,
              const Words& more = {}) const {
        const Ran ran = run(render_words_ + more +
                            Words{"--pass-range", range, "--nthreads", std::to_string(threads),
                                  "-o", name + ".film", "-o", name + ".exr"});
        ASSERT_EQ(ran.code, 0) << ran.err;
    }

    /// The statistics of passes "a:b", whose picture is in x.exr.
    nlohmann::json stats(const std::string& range, const Words& more = {}) const {
        part("x", range, 2, more + Words{"--stats", path("x.json")});
        return json("x.json");
    }

    /// part(), stopped at each of `ends` and resumed by another number of threads.
    void resumed(const std::string& name, const std::string& first, const std::vector<int>& ends,
                 int threads) const {
        const std::string file = path(name + ".ckpt");
        Words resume;
        for (const int end : ends) {
            part(name, first + ":" + std::to_string(end), threads,
                 Words{"--checkpoint", file} + resume);
            resume = {"--resume", file};
            threads = threads == 1 ? 8 : threads - 1;
        }
        std::filesystem::remove(file);
    }

    /// Merges NAMES.film, in this order, into NAME.film and NAME.exr.
    void merge(const std::string& name, const Words& names) const {
        Words words{"merge", "-o", name + ".film", "-o", name + ".exr"};
        for (const std::string& part : names) words.push_back(part + ".film");
        const Ran ran = run(words);
        ASSERT_EQ(ran.code, 0) << ran.err;
    }

    Bytes bytes(const std::string& name) const {
        return {read_text(path(name + ".film")), read_text(path(name + ".exr"))};
    }

    /// Whole, by this number of threads.
    void expect_whole(int threads, const Bytes& expected) const {
        part("whole", "0:16", threads);
        EXPECT_TRUE(bytes("whole") == expected) << "whole, threads " << threads;
    }

    /// Two parts either way round; stopped and resumed, by fewer threads each time.
    void expect_one_render_of_parts(int threads, const Bytes& expected) const {
        part("low", "0:5", threads);
        part("high", "5:16", threads);
        merge("sum", {"low", "high"});
        EXPECT_TRUE(bytes("sum") == expected) << "0:5 + 5:16, threads " << threads;
        merge("sum", {"high", "low"});
        EXPECT_TRUE(bytes("sum") == expected) << "5:16 + 0:5, threads " << threads;
        resumed("resumed", "0", {3, 16}, threads);
        EXPECT_TRUE(bytes("resumed") == expected) << "0:3, then to 16, threads " << threads;
        resumed("high", "5", {6, 11, 16}, threads);
        merge("sum", {"high", "low"});
        EXPECT_TRUE(bytes("sum") == expected) << "0:5 + resumed 5:16, threads " << threads;
    }

    /// Single passes in a shuffled order, each by another number of threads; merges of merges.
    /// @param threads  their numbers, taken in turn.
    void expect_one_render_of_passes(const std::vector<int>& threads, const Bytes& expected) const {
        Words single;
        for (std::size_t i = 0; i < 16; ++i) {
            const std::size_t pass = (11 * i + 3) % 16;  // every pass once, not in order
            single.push_back("pass" + std::to_string(pass));
            part(single.back(), std::to_string(pass) + ":" + std::to_string(pass + 1),
                 threads[i % threads.size()]);
        }
        merge("sum", single);
        EXPECT_TRUE(bytes("sum") == expected) << "single passes";
        merge("first", {single.begin(), single.begin() + 6});
        merge("second", {single.begin() + 6, single.begin() + 9});
        merge("third", {"second", single[9], single[10]});
        merge("fourth", {single.begin() + 11, single.end()});
        merge("sum", {"fourth", "first", "third"});
        EXPECT_TRUE(bytes("sum") == expected) << "nested merges";
    }

    /// Passes 0 .. end - 1 whole, in two parts cut at `cut`, each by other threads, and stopped at
    /// each of `ends`.
    void expect_same_bytes(int end, int cut, const std::vector<int>& ends) const {
        const std::string last = std::to_string(end);
        const std::string middle = std::to_string(cut);
        part("whole", "0:" + last, 1);
        const Bytes whole = bytes("whole");
        part("low", "0:" + middle, 8);
        part("high", middle + ":" + last, 2);
        merge("sum", {"high", "low"});
        EXPECT_TRUE(bytes("sum") == whole) << "two parts";
        resumed("resumed", "0", ends, 2);
        EXPECT_TRUE(bytes("resumed") == whole) << "resumed";
    }

    /// Films of the scene with the part of the renderer that this flag switches off, and without.
    /// @param setting  as it names what differs.
    void expect_films_apart(const std::string& flag, const std::string& setting,
                            const std::string& value = "off") const {
        part("a", "0:1", 1);
        part("b", "1:2", 1, {flag, value});
        const Ran merged = run({"merge", "a.film", "b.film", "-o", "x.exr"});
        EXPECT_EQ(merged.code, 2);
        EXPECT_NE(merged.err.find(setting), std::string::npos) << merged.err;
    }

    /// Renders of the scene with each of these words: one line that names the flag, no picture.
    void expect_refused(const std::string& flag, const std::vector<Words>& bad) const {
        for (const Words& words : bad) {
            const Ran ran =
                run(Words{render_words_[0], render_words_[1], "-o", "refused.exr"} + words);
            EXPECT_EQ(ran.code, 2) << words.back();
            EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
            EXPECT_NE(ran.err.find(flag), std::string::npos) << ran.err;
            EXPECT_FALSE(exists("refused.exr"));
        }
    }

private:
    Words render_words_;  // "render", the scene, and what each render of it has
};

}  // namespace sunfleck::engine::testing_support
