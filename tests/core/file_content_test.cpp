// What a file is by its first bytes.
#include "core/file_content.h"

#include "sunfleck/error.h"

#include <gtest/gtest.h>

#include <map>

namespace sunfleck::engine {
namespace {

std::string named(const std::string& bytes) {
    const auto content = content_of(bytes);
    return content ? std::string(content->what) : "";
}

TEST(FileContent, is_told_by_the_first_bytes) {
    using std::string_literals::operator""s;
    const std::map<std::string, std::string> files = {
        {"", "empty"},
        {"version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 1\n", "Git LFS"},
        {"version https://hawser.github.com/spec/v1\n", "Git LFS"},
        {"outs:\n- md5: a304afb96060aad90176268345e10355\n", "DVC"},
        {"P6 2 2 255\n", "PPM"},
        {"P3\r\n2 2", "PPM"},
        {"\0\0\0\x1C"
         "ftypavis"s,
         "AVIF"},
        {"\0\0\0\x18"
         "ftypmp42"s,
         "video"},
        {"\xFF\x4F\xFF\x51\0\x29"s, "JPEG 2000"},
        {"\0\5\x16\7\0\2"s, "macOS"},
        {"/annex/objects/SHA256E-s7--00.ply\n", "git-annex"},
        {"\x1F\x8B\x08\0"s, "gzip"},
        {"PK\x03\x04 and more", "ZIP"},
        {"\xFD"
         "7zXZ\0\0"s,
         "xz"},
        {"\x28\xB5\x2F\xFD", "zstd"},
        {"BZh91AY&SY", "bzip2"},
        {"7z\xBC\xAF\x27\x1C", "7z"},
        {"\xFF\xFEL\0o\0"s, "UTF-16"},
        {"\xFE\xFF\0L\0o"s, "UTF-16"},
        {"\xFF\xFE\0\0L\0\0\0"s, "UTF-32"},
        {"L\0o\0o\0k\0A\0t\0 \0 \0"s, "UTF-16"},
        {"\0L\0o\0o\0k\0A\0t\0 \0 "s, "UTF-16"},
        {"\x89PNG\r\n\x1A\n", "PNG"},
        {"\x89PNG\n\x1A\n", "line ends"},
        {"\xFF\xD8\xFF\xE0", "JPEG"},
        {"RIFF\x10\0\0\0WEBPVP8 "s, "WebP"},
        {"BM\x10\0\0\0\0\0\0\0"s, "BMP"},
        {"\0\0\0\x1C"
         "ftypavif"s,
         "AVIF"},
        {"II*\0"s, "TIFF"},
        {"8BPS", "Photoshop"},
        {"ply\nformat", "PLY"},
        {"Kaydara FBX Binary", "FBX"},
        {"<!DOCTYPE html><html>", "web page"},
        {"\n  <HTML lang=en>", "web page"},
        {"\xEF\xBB\xBF<!doctype HTML>", "web page"},
        {"<?xml version=\"1.0\"?>\n<scene version=\"3.0.0\">", "Mitsuba"},
        {"<?xml version=\"1.0\"?><html>", "web page"},
        {"<svg width=\"1\">", "SVG"},
        {"{\"message\": \"Not Found\"}", "JSON"}};
    for (const auto& [bytes, part] : files)
        EXPECT_NE(named(bytes).find(part), std::string::npos) << part << ": " << named(bytes);
}

TEST(FileContent, of_texts_and_numbers_is_left_to_their_readers) {
    for (const char* text :
         {"LookAt 0 0 1", "# a comment\n", "400 0.5\n", "404: Not Found", "BM is no picture",
          "RIFFRAFF", "P", "P6", "P3D 1 2", "\xEF\xBB\xBFLookAt"})
        EXPECT_EQ(named(text), "") << text;
}

TEST(FileContent, is_refused_with_what_to_do) {
    const auto refusal = [](const std::string& bytes) -> std::string {
        try {
            refuse_other_content(bytes, "m.ply", "a PLY mesh");
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refusal("\xFF\xD8\xFF"),
              "m.ply: is a JPEG picture, where a PLY mesh is read; give a PLY mesh");
    EXPECT_NE(refusal("version https://git-lfs.github.com/spec/v1").find("git lfs pull"),
              std::string::npos);
    EXPECT_NE(refusal("PK\x03\x04").find("unpack it"), std::string::npos);
    EXPECT_EQ(refusal("anything else"), "");
}

}  // namespace
}  // namespace sunfleck::engine
