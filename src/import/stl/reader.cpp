// Both forms of STL; the form by the size of the file.
#include "import/stl/reader.h"

#include "core/file_content.h"
#include "core/float_range.h"
#include "core/printable.h"
#include "core/small_letters.h"
#include "core/text_cursor.h"
#include "geometry/weld.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kHeader = 80;  // bytes
constexpr std::size_t kBegin = kHeader + 4;
constexpr std::size_t kRow = 50;

constexpr std::string_view kNoEnd = "the file ends without endsolid";
constexpr std::string_view kColours = "colours of triangles (attribute bytes) are left out";

/// Collects triangles.
class Collector {
public:
    /// @param corners  finite.
    void add(const std::array<Vec3, 3>& corners) {
        const std::array<std::uint32_t, 3> t = {welder_.number_of(corners[0]),
                                                welder_.number_of(corners[1]),
                                                welder_.number_of(corners[2])};
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
            ++flat_;
        else
            mesh_.triangles.push_back(t);
    }
    void reserve(std::size_t triangles) { mesh_.triangles.reserve(triangles); }
    void remark(std::string_view text) { mesh_.remarks.emplace_back(text); }

    StlMesh finished(const std::string& name) {
        if (mesh_.triangles.empty())
            throw Error({name}, flat_ > 0 ? "has triangles without area alone" : "has no triangle",
                        "export the part again");
        if (flat_ > 0)
            remark("triangles with two corners at one place were left out (" +
                   std::to_string(flat_) + ")");
        mesh_.positions = welder_.take_positions();
        return std::move(mesh_);
    }

private:
    Welder welder_;
    StlMesh mesh_;
    std::size_t flat_ = 0;
};

std::uint32_t word_at(const char* bytes) {
    std::array<unsigned char, 4> b{};
    std::memcpy(b.data(), bytes, b.size());
    return b[0] | std::uint32_t{b[1]} << 8U | std::uint32_t{b[2]} << 16U |
           std::uint32_t{b[3]} << 24U;
}

std::array<Vec3, 3> corners_at(const char* row) {
    std::array<float, 9> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers.at(i) = std::bit_cast<float>(word_at(row + 12 + 4 * i));
    return {Vec3(numbers[0], numbers[1], numbers[2]), Vec3(numbers[3], numbers[4], numbers[5]),
            Vec3(numbers[6], numbers[7], numbers[8])};
}

bool are_finite(const std::array<Vec3, 3>& corners) {
    return std::all_of(corners.begin(), corners.end(), [](const Vec3& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
}

/// @param count  of triangles, which the bytes have.
StlMesh read_binary(std::string_view bytes, std::size_t count, const std::string& name) {
    Collector collector;
    collector.reserve(count);
    bool has_colours = bytes.substr(0, kHeader).find("COLOR=") != std::string_view::npos;
    for (std::size_t i = 0; i < count; ++i) {
        const char* const row = bytes.data() + kBegin + i * kRow;
        const std::array<Vec3, 3> corners = corners_at(row);
        if (!are_finite(corners))
            throw Error({name},
                        "triangle " + std::to_string(i) + " (byte " +
                            std::to_string(kBegin + i * kRow) + "): a corner that is not finite",
                        "export the part again without it");
        collector.add(corners);
        has_colours = has_colours || row[48] != 0 || row[49] != 0;
    }
    if (has_colours) collector.remark(kColours);
    if (bytes.size() > kBegin + count * kRow)
        collector.remark("bytes behind the last triangle were left out (" +
                         std::to_string(bytes.size() - kBegin - count * kRow) + ")");
    return collector.finished(name);
}

/// Reads the statements of ASCII files.
class TextReader {
public:
    TextReader(std::string_view text, const std::string& name) : cursor_(text, name), name_(name) {}

    StlMesh read() {
        bool is_open = false;  // between solid and endsolid
        for (std::string_view word = next(); !word.empty(); word = next()) {
            if (is(word, "solid") || is(word, "endsolid")) {
                is_open = is(word, "solid");
                cursor_.next_line();  // the name
            } else if (is(word, "facet")) {
                read_facet();
            } else if (!is(word, "color")) {
                refuse(word, "facet");
            } else {
                cursor_.next_line();
            }
        }
        if (is_open) collector_.remark(kNoEnd);
        return collector_.finished(name_);
    }

private:
    static bool is(std::string_view word, std::string_view statement) {
        return word.size() == statement.size() && small_letters(std::string(word)) == statement;
    }
    std::string_view next() {
        const std::string_view word = cursor_.word_of_text();
        begin_ = cursor_.offset() - word.size();
        return word;
    }
    void expect(std::string_view statement) {
        const std::string_view word = next();
        if (!is(word, statement)) refuse(word, statement);
    }
    [[noreturn]] void refuse(std::string_view word, std::string_view statement) {
        if (word.empty())
            cursor_.fail(begin_, "the file ends within a facet", "export or copy the file again");
        cursor_.fail(begin_,
                     in_quotes(word, 40) + " where " + std::string(statement) + " is expected",
                     "export the part again");
    }

    /// Facets are triangles; the normal may be anything.
    void read_facet() {
        cursor_.next_line();
        expect("outer");
        expect("loop");
        std::array<Vec3, 3> corners;
        for (Vec3& corner : corners) {
            expect("vertex");
            for (int c = 0; c < 3; ++c) corner[c] = coordinate();
        }
        const std::string_view word = next();
        if (is(word, "vertex"))
            cursor_.fail(begin_, "a facet of more than three corners", "export triangles");
        if (!is(word, "endloop")) refuse(word, "endloop");
        expect("endfacet");
        collector_.add(corners);
    }

    float coordinate() {
        const std::size_t begin = cursor_.offset();
        const double number = cursor_.number("a coordinate");
        if (!is_finite_float(number))
            cursor_.fail(begin + 1, "a corner that is not finite", "export the part without it");
        return static_cast<float>(number);
    }

    TextCursor cursor_;
    const std::string& name_;
    Collector collector_;
    std::size_t begin_ = 0;  // of the current word
};

/// Returns whether the bytes begin as ASCII STL does: solid, a line, and facet or endsolid soon.
bool is_text(std::string_view bytes) {
    constexpr std::size_t kLooked = 4096;  // names may be long
    const std::string head = small_letters(std::string(bytes.substr(0, kLooked)));
    const std::size_t begin = head.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) return false;
    const std::string_view text = std::string_view(head).substr(begin);
    if (text.starts_with("facet")) return true;
    const std::size_t line = text.find_first_of("\r\n");
    return text.starts_with("solid") && line != std::string_view::npos &&
           (text.find("facet", line) != std::string_view::npos ||
            text.find("endsolid", line) != std::string_view::npos);
}

}  // namespace

StlMesh parse_stl(std::string_view bytes, const std::string& name) {
    const std::size_t rows = bytes.size() < kBegin ? 0 : (bytes.size() - kBegin) / kRow;
    const std::size_t stated = bytes.size() < kBegin ? 0 : word_at(bytes.data() + kHeader);
    const bool is_exact = bytes.size() == kBegin + rows * kRow;
    if (rows > std::numeric_limits<std::uint32_t>::max() / 6)
        throw Error({name}, "has more than 700 million triangles", "divide the part");
    if (is_exact && stated == rows && rows > 0) return read_binary(bytes, rows, name);
    const std::string_view text = without_mark(bytes);
    if (is_text(text)) return TextReader(text, name).read();
    // Writers that cannot go back leave 0 or -1 as the count.
    constexpr std::size_t kUnknown = 0xFFFFFFFF;
    if (is_exact && rows > 0 && (stated == 0 || stated == kUnknown))
        return read_binary(bytes, rows, name);
    refuse_other_content(bytes, name, "an STL mesh");
    if (bytes.size() < kBegin)
        throw Error({name},
                    "has " + std::to_string(bytes.size()) +
                        " bytes, and is neither ASCII STL nor binary STL of 84 or more",
                    "export or copy the file again");
    if (stated > rows)
        throw Error({name},
                    "claims " + std::to_string(stated) + " triangles, and has bytes for " +
                        std::to_string(rows),
                    "it is truncated, or no STL: export or copy it again");
    return read_binary(bytes, stated, name);
}

}  // namespace sunfleck::engine
