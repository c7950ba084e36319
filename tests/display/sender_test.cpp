// The sender, against receivers that read, dawdle, go, or are not there.
#include "display/sender.h"

#include "display/receiver.h"
#include "sunfleck/error.h"

namespace sunfleck::engine {
namespace {

using testing_support::Images;
using testing_support::read_images;
using testing_support::Receiver;
using namespace std::chrono_literals;

Picture even(int size, float value, const std::vector<std::string>& names = {"R", "G", "B"}) {
    Picture picture{size, size, {}, {}};
    for (const std::string& name : names)
        picture.channels.push_back({name, std::vector<float>(picture.pixels(), value)});
    return picture;
}

/// What a sender has said.
class Said {
public:
    void add(const std::string& line) {
        const std::lock_guard lock(mutex_);
        lines_.push_back(line);
    }
    std::vector<std::string> lines() const {
        const std::lock_guard lock(mutex_);
        return lines_;
    }

private:
    mutable std::mutex mutex_;
    std::vector<std::string> lines_;
};

SenderSettings settings_for(const std::string& address, Said& said) {
    return {.address = read_display_address(address, "--display-server"),
            .flag = "--display-server",
            .image = "room",
            .warn = [&said](const std::string& line) { said.add(line); },
            .patience = 300ms,
            .most_at_end = 20s};
}

bool comes_true(const std::function<bool()>& condition) {
    for (int i = 0; i < 2000 && !condition(); ++i) std::this_thread::sleep_for(10ms);
    return condition();
}

/// The receiver reads when all are shown: the first is on its way, and the last alone waits.
TEST(DisplaySender, sends_the_last_picture_whole_and_no_queue) {
    Receiver receiver(AF_INET, 4096);
    Said said;
    SenderSettings settings = settings_for("localhost:" + receiver.port(), said);
    settings.patience = 60s;
    settings.most_at_end = 60s;
    std::string bytes;
    std::thread reader;
    {
        DisplaySender sender(settings);
        ASSERT_TRUE(receiver.accept());
        for (int i = 0; i < 10; ++i) sender.show(even(600, static_cast<float>(i)));
        reader = std::thread([&] { bytes = receiver.receive_all(); });
        sender.finish();
        EXPECT_GT(sender.cost(), 0ns);
    }
    reader.join();
    const Images images = read_images(bytes);
    EXPECT_EQ(images.by_name.at("room"), even(600, 9));
    EXPECT_EQ(images.selects, (std::vector<bool>{true}));
    EXPECT_LE(images.updated.size(), 2U * 25);
    EXPECT_EQ(images.left, 0U);
    EXPECT_TRUE(said.lines().empty());
}

/// The channel of errors comes with the second batch. The user may look at another image then.
TEST(DisplaySender, makes_the_image_anew_where_channels_or_size_change) {
    Receiver receiver;
    Said said;
    std::string bytes;
    std::thread reader([&] {
        if (receiver.accept()) bytes = receiver.receive_all();
    });
    {
        DisplaySender sender(settings_for("127.0.0.1:" + receiver.port(), said));
        for (const Picture& picture :
             {even(20, 1), even(20, 2), even(20, 3, {"R", "G", "B", "error.Y"}), even(30, 4)}) {
            sender.show(picture);
            sender.finish();
        }
    }
    reader.join();
    const Images images = read_images(bytes);
    EXPECT_EQ(images.selects, (std::vector<bool>{true, false, false}));
    EXPECT_EQ(images.by_name.at("room"), even(30, 4));
}

TEST(DisplaySender, gives_up_a_receiver_that_never_reads) {
    Receiver receiver(AF_INET, 4096);
    Said said;
    {
        DisplaySender sender(settings_for("127.0.0.1:" + receiver.port(), said));
        ASSERT_TRUE(receiver.accept());
        const auto begin = std::chrono::steady_clock::now();
        for (int i = 0; i < 20; ++i) sender.show(even(1000, 1));
        EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);  // nobody waits to show one
        EXPECT_TRUE(comes_true([&] { return sender.is_over(); }));
        sender.show(even(1000, 2));
        sender.finish();
    }
    ASSERT_EQ(said.lines().size(), 1U);
    EXPECT_EQ(said.lines()[0], "--display-server 127.0.0.1:" + receiver.port() +
                                   ": it has taken nothing for 0.3 s; nothing more is sent to it");
}

TEST(DisplaySender, gives_up_a_receiver_that_has_gone) {
    Receiver receiver;
    Said said;
    {
        DisplaySender sender(settings_for("127.0.0.1:" + receiver.port(), said));
        ASSERT_TRUE(receiver.accept());
        receiver.close();
        EXPECT_TRUE(comes_true([&] {
            sender.show(even(100, 1));
            return sender.is_over();
        }));
    }
    ASSERT_EQ(said.lines().size(), 1U);
    EXPECT_NE(said.lines()[0].find("it has gone ("), std::string::npos) << said.lines()[0];
}

/// As slow as a receiver may be that takes something now and then.
TEST(DisplaySender, waits_at_the_end_no_longer_than_it_is_told) {
    Receiver receiver(AF_INET, 4096);
    Said said;
    SenderSettings settings = settings_for("127.0.0.1:" + receiver.port(), said);
    settings.patience = 1h;
    settings.most_at_end = 200ms;
    DisplaySender sender(settings);
    ASSERT_TRUE(receiver.accept());
    sender.show(even(1000, 1));
    sender.finish();
    ASSERT_EQ(said.lines().size(), 1U);
    EXPECT_NE(said.lines()[0].find("the last picture has not been taken in 0.2 s"),
              std::string::npos)
        << said.lines()[0];
}

TEST(DisplaySender, reaches_ipv6_in_brackets) {
    Receiver receiver(AF_INET6);
    if (!receiver.is_open()) GTEST_SKIP() << "this machine has no ::1";
    Said said;
    DisplaySender sender(settings_for("[::1]:" + receiver.port(), said));
    ASSERT_TRUE(receiver.accept());
    sender.show(even(4, 1));
    EXPECT_FALSE(receiver.receive().empty());
}

TEST(DisplaySender, needs_somebody_who_listens) {
    Said said;
    const auto refusal = [&](const std::string& address) -> std::string {
        try {
            const DisplaySender sender(settings_for(address, said));
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::input);
            return error.what();
        }
        return "taken";
    };
    Receiver gone;
    gone.close();
    EXPECT_EQ(refusal("127.0.0.1:" + gone.port()),
              "--display-server: nobody listens at 127.0.0.1:" + gone.port() +
                  " (Connection refused); start tev first, or name the address where it listens");
    EXPECT_NE(refusal("no such host:14158").find("the host \"no such host\" cannot be found ("),
              std::string::npos);
}

}  // namespace
}  // namespace sunfleck::engine
