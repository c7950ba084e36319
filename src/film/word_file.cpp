// Buffers of words on their way to a file and back.
#include "film/word_file.h"

#include "core/file_content.h"
#include "sunfleck/error.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>
#include <string_view>
#include <utility>

namespace sunfleck::engine {

static_assert(std::endian::native == std::endian::little, "words are stored as they stand");
static_assert(sizeof(FixedPoint) == 16, "sums are stored as two words");

namespace {

/// The first bytes of a stream, which is back at its beginning then.
std::string beginning_of(std::istream& stream, std::uint64_t size) {
    constexpr std::uint64_t kLooked = 512;
    std::string bytes(std::min(size, kLooked), '\0');
    const auto begin = stream.tellg();
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    stream.clear();
    stream.seekg(begin);
    return bytes;
}

bool begins_with(std::string_view bytes, std::uint64_t word) {
    std::uint64_t first = 0;
    std::memcpy(&first, bytes.data(), std::min(bytes.size(), sizeof first));
    return first == word;
}

}  // namespace

std::vector<std::uint64_t> words_of(const std::string& text) {
    std::vector<std::uint64_t> words((text.size() + 7) / 8 + 1, 0);
    words[0] = text.size();
    std::memcpy(words.data() + 1, text.data(), text.size());
    return words;
}

void WordWriter::finish() {
    put(hash_.value());
    flush();
    file_.commit();
}

void WordWriter::flush() {
    file_.write(std::as_bytes(std::span(buffer_)));
    buffer_.clear();
}

WordReader::WordReader(std::istream& stream, std::uint64_t size, std::string path,
                       WordFileKind kind)
    : stream_(stream), path_(std::move(path)), kind_(kind) {
    const std::string bytes = beginning_of(stream, size);
    if (bytes.empty() && size > 0) damaged();
    if (!begins_with(bytes, kind.magic))
        refuse_other_content(bytes, path_, "a " + std::string(kind.name));
    if (size % 8 != 0 || size < 16) damaged();
    left_ = size / 8 - 1;  // the last is the checksum
}

std::string WordReader::text() {
    const std::uint64_t size = word_up_to(left_ * 8);
    if ((size + 7) / 8 > left_) damaged();
    std::string text(size, '\0');
    for (std::size_t i = 0; i < size; i += 8) {
        const std::uint64_t bytes = word();
        std::memcpy(text.data() + i, &bytes, std::min<std::size_t>(8, size - i));
    }
    return text;
}

void WordReader::check_head(std::uint64_t magic, std::uint64_t version) {
    if (word() != magic) damaged();
    const std::uint64_t found = word();
    if (found != version)
        throw Error(
            {path_}, "is a " + std::string(kind_.name) + " of version " + std::to_string(found),
            "use the program that wrote it; this one reads version " + std::to_string(version));
}

void WordReader::finish() {
    if (left_ != 0 || raw_word() != hash_.value()) damaged();
}

void WordReader::damaged() const {
    throw Error({path_}, "is no " + std::string(kind_.name) + ", or is cut or damaged", kind_.mend);
}

void WordReader::refill() {
    buffer_.resize(std::min<std::uint64_t>(kWordsAtOnce, left_ + 2));
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): streams take char alone
    stream_.read(reinterpret_cast<char*>(buffer_.data()),
                 static_cast<std::streamsize>(buffer_.size() * 8));
    buffer_.resize(static_cast<std::size_t>(stream_.gcount()) / 8);
    next_ = 0;
    if (buffer_.empty()) damaged();
}

}  // namespace sunfleck::engine
