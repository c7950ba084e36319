// A folder of one test's own, removed with all that is in it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace sunfleck::engine::testing_support {

class TemporaryFolder : public testing::Test {
protected:
    void SetUp() override {
        static int count = 0;
        folder_ = testing::TempDir() + "/sunfleck_" + std::to_string(::getpid()) + "_" +
                  std::to_string(count++);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return folder_ + "/" + name; }

    /// How many files there are.
    std::ptrdiff_t files() const {
        return std::distance(std::filesystem::directory_iterator(folder_), {});
    }

private:
    std::string folder_;
};

}  // namespace sunfleck::engine::testing_support
