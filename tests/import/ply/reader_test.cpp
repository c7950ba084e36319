// PLY files: every way to store the same mesh reads alike, and every fault is an Error.
#include "import/ply/reader.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>

namespace sunfleck::engine {
namespace {

/// Bytes of a value in the byte order asked for.
template <class Value>
std::string stored(Value value, bool big) {
    std::string bytes(sizeof(Value), '\0');
    std::memcpy(bytes.data(), &value, sizeof(Value));
    if (big) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

/// A number as the type of that name stores it; "ascii" byte order is a word and a blank.
std::string number(double value, const std::string& type, const std::string& format) {
    if (format == "ascii") {
        std::string text = std::to_string(value);
        if (type.find("int") != std::string::npos || type.find("char") != std::string::npos ||
            type.find("short") != std::string::npos)
            text = std::to_string(static_cast<long long>(value));
        return text + " ";
    }
    const bool big = format == "binary_big_endian";
    if (type == "char" || type == "int8") return stored(static_cast<std::int8_t>(value), big);
    if (type == "uchar" || type == "uint8") return stored(static_cast<std::uint8_t>(value), big);
    if (type == "short" || type == "int16") return stored(static_cast<std::int16_t>(value), big);
    if (type == "ushort" || type == "uint16") return stored(static_cast<std::uint16_t>(value), big);
    if (type == "int" || type == "int32") return stored(static_cast<std::int32_t>(value), big);
    if (type == "uint" || type == "uint32") return stored(static_cast<std::uint32_t>(value), big);
    if (type == "float" || type == "float32") return stored(static_cast<float>(value), big);
    return stored(value, big);
}

struct Storage {
    std::string format = "ascii";
    std::string vertex = "float";
    std::string count = "uchar";
    std::string index = "int";
};

std::string header_start(const std::string& format) {
    return "ply\nformat " + format + " 1.0\ncomment of no use\nobj_info neither\n";
}

/// Five vertices, a triangle and a quad; skipped things before, between and after.
std::string sample(const Storage& s, const std::string& list = "vertex_indices") {
    std::string text = header_start(s.format);
    text += "element camera 1\nproperty list uchar double pose\nproperty short id\n";
    text += "element vertex 5\n";
    for (const char* name : {"x", "y", "confidence", "z", "nx", "ny", "nz", "s", "t"})
        text += "property " + s.vertex + " " + name + "\n";
    text += "element face 2\nproperty uchar kind\nproperty list " + s.count + " " + s.index + " " +
            list + "\nproperty int face_indices\nend_header\n";
    const auto put = [&](double value, const std::string& type) {
        text += number(value, type, s.format);
    };
    for (const double value : {2.0, 1.0, 5.0}) put(value, value == 2 ? "uchar" : "double");
    put(7, "short");
    for (int v = 0; v < 5; ++v)
        for (int p = 0; p < 9; ++p) put(10 * v + p, s.vertex);
    for (const std::vector<int>& face : {std::vector{0, 1, 2}, std::vector{1, 4, 3, 2}}) {
        put(9, "uchar");
        put(static_cast<double>(face.size()), s.count);
        for (const int corner : face) put(corner, s.index);
        put(33, "int");
    }
    return text;
}

void expect_sample(const PlyMesh& mesh) {
    ASSERT_EQ(mesh.positions.size(), 5U);
    ASSERT_EQ(mesh.normals.size(), 5U);
    ASSERT_EQ(mesh.uvs.size(), 5U);
    for (int v = 0; v < 5; ++v) {
        const auto i = static_cast<std::size_t>(v);
        const auto base = static_cast<float>(10 * v);
        EXPECT_EQ(mesh.positions[i], Vec3d(Vec3(base, base + 1, base + 3)));
        EXPECT_EQ(mesh.normals[i], Vec3(base + 4, base + 5, base + 6));
        EXPECT_EQ(mesh.uvs[i], Vec2(base + 7, base + 8));
    }
    const std::vector<std::array<std::uint32_t, 3>> expected = {{0, 1, 2}, {1, 4, 3}, {1, 3, 2}};
    EXPECT_EQ(mesh.triangles, expected);
}

/// The message of the Error that parsing ends in; empty if there is none.
std::string fault_of(const std::string& bytes) {
    try {
        parse_ply(bytes, "m.ply");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

PlyMesh mesh_of(const std::string& bytes) {
    return parse_ply(bytes, "m.ply");
}

void expect_fault(const std::string& bytes, const std::string& begin) {
    EXPECT_EQ(fault_of(bytes).substr(0, begin.size()), begin) << fault_of(bytes);
}

std::string gzip(const std::string& bytes) {
    std::string packed(compressBound(bytes.size()) + 64, '\0');
    z_stream stream{};
    deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
    std::string input = bytes;
    stream.next_in = static_cast<Bytef*>(static_cast<void*>(input.data()));
    stream.avail_in = static_cast<uInt>(input.size());
    stream.next_out = static_cast<Bytef*>(static_cast<void*>(packed.data()));
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

const std::array<std::string, 3> kFormats = {"ascii", "binary_little_endian", "binary_big_endian"};
const std::array<std::string, 6> kIntegers = {"char", "uchar", "short", "ushort", "int", "uint"};

TEST(Ply, every_list_type_reads_alike) {
    for (const std::string& format : kFormats)
        for (const std::string& count : kIntegers)
            for (const std::string& index : kIntegers) {
                SCOPED_TRACE(testing::Message() << format << " " << count << " " << index);
                expect_sample(mesh_of(sample({format, "float", count, index})));
            }
}

TEST(Ply, every_vertex_type_reads_alike) {
    for (const std::string& format : kFormats)
        for (const std::string type :
             {"char", "uint8", "int16", "ushort", "int32", "uint", "float32", "double"}) {
            SCOPED_TRACE(testing::Message() << format << " " << type);
            expect_sample(mesh_of(sample({format, type, "uint8", "uint32"})));
        }
}

TEST(Ply, the_other_name_of_the_list_is_known) {
    expect_sample(mesh_of(sample({}, "vertex_index")));
}

TEST(Ply, lines_may_end_as_in_windows) {
    std::string text = sample({});
    for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 2))
        text.insert(i, "\r");
    expect_sample(mesh_of(text));
}

TEST(Ply, gzip_is_known_by_content_and_members_are_joined) {
    for (const std::string& format : kFormats) {
        const std::string bytes = sample({format});
        expect_sample(mesh_of(gzip(bytes)));
        expect_sample(mesh_of(gzip(bytes.substr(0, 50)) + gzip(bytes.substr(50))));
    }
}

TEST(Ply, all_names_of_texture_coordinates) {
    for (const std::string name : {"u v", "s t", "texture_u texture_v", "texture_s texture_t"}) {
        const std::size_t blank = name.find(' ');
        const PlyMesh mesh = mesh_of(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float " + name.substr(blank + 1) +
            "\nproperty float x\nproperty float y\nproperty float z\nproperty float " +
            name.substr(0, blank) + "\nelement face 1\n" +
            "property list uchar int vertex_indices\nend_header\n" +
            "1 2 3 4 +5\n-1 -2 -3e0 -4 -5\n0.5 .5 5e-1 0 1e-400\n3 0 1 2");
        ASSERT_EQ(mesh.uvs.size(), 3U) << name;
        EXPECT_EQ(mesh.uvs[0], Vec2(5, 1));
        EXPECT_EQ(mesh.uvs[2], Vec2(0, 0.5F));
        EXPECT_EQ(mesh.positions[1], Vec3d(-2, -3, -4));
        EXPECT_TRUE(mesh.normals.empty());
    }
}

TEST(Ply, positions_keep_the_digits_of_doubles) {
    const PlyMesh mesh = mesh_of(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
        "property double z\nelement face 1\nproperty list uchar int vertex_indices\n"
        "end_header\n1000000.001 0 0\n1000000.002 0 0\n1000000.001 0.001 0\n3 0 1 2\n");
    ASSERT_EQ(mesh.positions.size(), 3U);
    EXPECT_EQ(mesh.positions[1], Vec3d(1000000.002, 0, 0));
}

/// @param rows  the body of a file with three vertices x y z and one face.
std::string small(const std::string& rows, const std::string& vertices = "3",
                  const std::string& faces = "1") {
    return "ply\nformat ascii 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty double y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n" + rows;
}

TEST(Ply, faults_of_the_body_name_element_and_number) {
    const std::string v = "0 0 0\n1 0 0\n0 1 0\n";
    EXPECT_EQ(fault_of(small(v + "3 0 1 2\n")), "");
    expect_fault(small(v + "3 0 1 3\n"), "m.ply: face 0: it names a vertex that does not exist");
    expect_fault(small(v + "3 0 -1 2\n"), "m.ply: face 0: it names a vertex");
    expect_fault(small(v + "3 0 1.5 2\n"), "m.ply: face 0: it names a vertex");
    expect_fault(small(v + "-3 0 1 2\n"),
                 "m.ply: face 0: a list \"vertex_indices\" with an invalid");
    expect_fault(small(v + "2 0 1 0\n"), "m.ply: no face has three corners");
    expect_fault(small("0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"), "m.ply: vertex 1: a number that is");
    expect_fault(small("0 0 0\n1 0 0\n0 1 inf\n3 0 1 2\n"), "m.ply: vertex 2: a number that is");
    expect_fault(small("0 0 0\n1 1e300 0\n0 1 0\n3 0 1 2\n"), "m.ply: vertex 1: a number that");
    expect_fault(small("0 0 0\n1 1e999 0\n0 1 0\n3 0 1 2\n"), "m.ply: vertex 1: a number that");
    expect_fault(small("0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n"), "m.ply: vertex 1: \"zero\" is no");
    expect_fault(small(v + "3 0 1 2", "4000000000"), "m.ply: the header claims 4000000000 of \"ve");
    expect_fault(small(v + "3 0 1 2", "3", "99999999999999999"), "m.ply: the header claims 99999");
}

TEST(Ply, may_begin_with_a_byte_order_mark_and_end_lines_by_cr) {
    expect_sample(mesh_of("\xEF\xBB\xBF" + sample({})));
    std::string text = sample({});
    std::replace(text.begin(), text.end(), '\n', '\r');
    expect_sample(mesh_of(text));
    std::string binary = sample({"binary_little_endian"});
    const std::size_t body = binary.find("end_header\n") + 11;
    std::replace(binary.begin(), binary.begin() + static_cast<std::ptrdiff_t>(body), '\n', '\r');
    expect_sample(mesh_of(binary));
}

TEST(Ply, counts_that_overflow_a_product_are_refused_before_allocating) {
    const std::string le = header_start("binary_little_endian") +
                           "element vertex 3\nproperty float x\nproperty float y\n"
                           "property float z\nelement face ";
    const std::string end = "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const char* count : {"9223372036854775807", "18446744073709551615", "3000000000"})
        expect_fault(std::string(le).append(count).append(end).append(40, '\0'),
                     "m.ply: the header claims ");
}

TEST(Ply, faults_of_the_header_have_line_and_column) {
    const auto with = [](const std::string& statement) {
        return "ply\nformat ascii 1.0\n" + statement + "\nend_header\n";
    };
    expect_fault("", "m.ply: is empty");
    expect_fault("solid stl", "m.ply: is an STL mesh, where a PLY mesh is read");
    expect_fault("plx\n", "m.ply:1:1: this is not a PLY file");
    expect_fault("ply\nformat ascii 1.0\n", "m.ply:3:1: the file ends inside its header");
    expect_fault("ply\nformat utf8 1.0\n", "m.ply:2:8: unknown format \"utf8\"");
    expect_fault("ply\nformat ascii 2.0\n", "m.ply:2:14: unknown version \"2.0\"");
    expect_fault(with("elemnt vertex 3"), "m.ply:3:1: unknown statement \"elemnt\"");
    expect_fault(with("element vertex -3"), "m.ply:3:16: \"-3\" is not a count");
    expect_fault(with("element vertex 3x"), "m.ply:3:16: \"3x\" is not a count");
    expect_fault(with("element vertex 99999999999999999999"), "m.ply:3:16: ");
    expect_fault(with("element vertex"), "m.ply:3:1: \"element\" is cut short");
    expect_fault(with("property float x"), "m.ply:3:1: a property before any element");
    expect_fault(with("element vertex 3\n property flot x"), "m.ply:4:11: unknown type \"flot\"");
    expect_fault(with("element vertex 3\nproperty float x\nproperty float x"), "m.ply:5:16: pro");
    expect_fault(with("element vertex 3\nproperty list uchar float x"), "m.ply:4:27: \"x\" is a");
    expect_fault(with("element face 3\nproperty list float int vertex_indices"), "m.ply:4:15: ");
    expect_fault(with("element face 3\nproperty list int float vertex_index"), "m.ply:4:25: ");
    expect_fault(with("element vertex 3\nproperty float x\nproperty float y"),
                 "m.ply:3:1: vertices have no property \"z\"");
    expect_fault(with("comment nothing"), "m.ply:4:1: the file has no element \"vertex\"");
}

TEST(Ply, a_file_cut_at_any_byte_is_an_error) {
    for (const std::string& format : kFormats) {
        std::string bytes = sample({format});
        if (format == "ascii") bytes.resize(bytes.find_last_not_of(" \n"));  // "33" cut to "3"
        for (std::size_t size = 0; size < bytes.size(); ++size)
            EXPECT_NE(fault_of(bytes.substr(0, size)), "") << format << " cut at " << size;
        const std::string packed = gzip(sample({format}));
        for (std::size_t size = 0; size < packed.size(); ++size)
            EXPECT_NE(fault_of(packed.substr(0, size)), "") << format << " packed, at " << size;
    }
}

TEST(Ply, a_flipped_byte_is_a_mesh_or_an_error) {
    for (const std::string& format : kFormats) {
        const std::string bytes = sample({format});
        for (std::size_t i = 0; i < bytes.size(); ++i)
            for (const int flip : {0x01, 0x40, 0x80, 0xFF}) {
                std::string broken = bytes;
                broken[i] = static_cast<char>(broken[i] ^ flip);
                const std::string fault = fault_of(broken);  // anything but an Error ends the test
                EXPECT_EQ(fault.find('\n'), std::string::npos);
            }
    }
}

}  // namespace
}  // namespace sunfleck::engine
