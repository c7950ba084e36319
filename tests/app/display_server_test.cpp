// `render --display-server`: what tev would show, and a render that does not mind who listens.
#include "app/program.h"
#include "display/receiver.h"
#include "image/exr.h"

namespace sunfleck::engine {
namespace {

using testing_support::Images;
using testing_support::Process;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_images;
using testing_support::read_text;
using testing_support::Receiver;
using testing_support::Words;
using testing_support::operator+;

class DisplayServer : public ProgramTest {
protected:
    /// The channel of errors comes with the second batch, on the way.
    static Words words(const Words& more, const std::string& passes = "20") {
        return Words{"render",       "room.pbrt", "--photons-per-pass", "1000",
                     "--resolution", "140x16",    "--passes",           passes} +
               more;
    }

    /// Runs a render that sends to a receiver. @return what came.
    Images shown(Receiver& receiver, const Words& more, const std::string& host = "127.0.0.1") {
        Process process(path(""),
                        words(more) + Words{"--display-server", host + ":" + receiver.port()});
        Images images;
        if (receiver.accept()) images = read_images(bytes_ = receiver.receive_all());
        const Ran ran = process.wait();
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.err.find("warning: --display"), std::string::npos) << ran.err;
        EXPECT_EQ(images.left, 0U);
        process_ = process.id();
        return images;
    }

    /// The image that came, under the name that tells scene and program.
    Picture image(const Images& images) const {
        const std::string name = "room.pbrt - Sunfleck (" + std::to_string(process_) + ")";
        EXPECT_EQ(images.by_name.size(), 1U);
        return images.by_name.contains(name) ? images.by_name.at(name) : Picture{};
    }

    const std::string& bytes() const { return bytes_; }

    /// Numbers and names as the file of the render has them, channel by channel.
    void expect_same(const Picture& image, const std::string& file) const {
        const Picture written = read_exr(path(file));
        EXPECT_EQ(image.width, written.width);
        EXPECT_EQ(image.height, written.height);
        ASSERT_EQ(image.channels.size(), written.channels.size());
        for (const Channel& channel : image.channels) {
            const Channel* const same = written.find(channel.name);
            ASSERT_NE(same, nullptr) << channel.name;
            EXPECT_EQ(channel.values, same->values) << channel.name;
        }
    }

private:
    ::pid_t process_ = 0;
    std::string bytes_;
};

TEST_F(DisplayServer, has_the_floats_of_the_exr_at_the_end_and_leaves_its_bytes_alone) {
    const Words layers{"--aovs", "direct,depth", "--light-group", "lamp=1"};
    ASSERT_EQ(run(words(layers + Words{"-o", "plain.exr", "--quiet"})).code, 0);
    Receiver receiver;
    const Images images = shown(receiver, layers + Words{"-o", "x.exr"});
    expect_same(image(images), "x.exr");
    EXPECT_EQ(read_text(path("x.exr")), read_text(path("plain.exr")));
    ASSERT_FALSE(images.selects.empty());
    EXPECT_TRUE(images.selects.front());
    for (const auto& size : images.sizes)
        EXPECT_EQ(size, std::pair(140, 16));  // the first look, too
    EXPECT_EQ(std::count(images.selects.begin(), images.selects.end(), true), 1);
    const Picture picture = image(images);
    const auto place = [&](const char* name) {
        return picture.find(name) - picture.channels.data();
    };
    EXPECT_EQ(place("R") + place("G") + place("B"), 0 + 1 + 2);
    for (const char* name : {"direct.R", "depth.Z", "lamp.B", "error.Y"})
        EXPECT_NE(picture.find(name), nullptr) << name;
}

TEST_F(DisplayServer, goes_with_the_page_with_snapshots_and_with_a_render_that_goes_on) {
    ASSERT_EQ(run(words({"-o", "a.exr", "--checkpoint", "a.ckpt", "--quiet"}, "3")).code, 0);
    Receiver receiver;
    const Images images = shown(receiver, {"-o", "x.exr", "--resume", "a.ckpt", "--view",
                                           "--snapshots", "shots", "--log-level", "warning"});
    expect_same(image(images), "x.exr");
    EXPECT_TRUE(exists("shots/latest.png"));
    expect_same(image(read_images(bytes(), 5)), "a.exr");  // the checkpoint's: four blocks
}

TEST_F(DisplayServer, may_be_reached_by_ipv6) {
    Receiver receiver(AF_INET6);
    if (!receiver.is_open()) GTEST_SKIP() << "this machine has no ::1";
    expect_same(image(shown(receiver, {"-o", "x.exr"}, "[::1]")), "x.exr");
}

TEST_F(DisplayServer, may_vanish) {
    ASSERT_EQ(run(words({"-o", "plain.exr", "--quiet"})).code, 0);
    Receiver receiver;
    Process process(path(""),
                    words({"-o", "x.exr", "--display-server", "localhost:" + receiver.port()}));
    ASSERT_TRUE(receiver.accept());
    receiver.close();
    const Ran ran = process.wait();
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(read_text(path("x.exr")), read_text(path("plain.exr")));
    const std::string line =
        "warning: --display-server localhost:" + receiver.port() + ": it has gone (";
    const std::size_t said = ran.err.find(line);
    EXPECT_NE(said, std::string::npos) << ran.err;
    EXPECT_EQ(ran.err.find("warning: --display", said + 1), std::string::npos) << ran.err;
}

TEST_F(DisplayServer, must_be_there_at_the_beginning) {
    Receiver gone;
    gone.close();
    for (const std::string& address : {"localhost:" + gone.port(), std::string("localhost")}) {
        const Ran ran = run(words({"-o", "x.exr", "--display-server", address}));
        EXPECT_EQ(ran.code, 2);
        EXPECT_TRUE(ran.err.starts_with("--display-server: ")) << ran.err;
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    }
    EXPECT_FALSE(exists("x.exr"));
}

}  // namespace
}  // namespace sunfleck::engine
