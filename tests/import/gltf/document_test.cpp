// Containers, buffers and their faults: each is one line that says where.
#include "import/gltf/document.h"

#include "gltf_files.h"

namespace sunfleck::engine {
namespace {

using testing_support::bytes_of;
using testing_support::square_bytes;
using testing_support::square_json;

class GltfDocuments : public testing_support::GltfFiles {
protected:
    /// A .glb of these chunks.
    static std::string glb(const std::string& json, const std::string& binary) {
        const auto word = [](std::size_t x) {
            return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(x)});
        };
        std::string body = word(json.size()) + "JSON" + json;
        if (!binary.empty()) body += word(binary.size()) + std::string("BIN\0", 4) + binary;
        return "glTF" + word(2) + word(12 + body.size()) + body;
    }
};

TEST_F(GltfDocuments, binary_files_have_their_buffer_within) {
    const std::string json =
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":60}],
"bufferViews":[{"buffer":0,"byteOffset":48,"byteLength":12}]})";
    const GltfDocument document(written("a.glb", glb(json, square_bytes())));
    const JsonPlace view = document.root().elements("bufferViews").front();
    EXPECT_EQ(document.bytes_of(view), square_bytes().substr(48));
    EXPECT_EQ(document.files(), std::vector<std::string>{path("a.glb")});
}

TEST_F(GltfDocuments, damaged_binary_files_are_refused) {
    const std::string whole = glb(R"({"asset":{"version":"2.0"}})", "1234");
    EXPECT_EQ(fault_of_file(written("a.glb", whole)), "");
    for (std::size_t size = 4; size < whole.size(); ++size)
        EXPECT_NE(fault_of_file(written("a.glb", whole.substr(0, size))), "") << size;
    std::string other = whole;
    other[4] = 1;
    EXPECT_EQ(fault_of_file(written("a.glb", other)),
              "a.glb: is a binary glTF file of version 1, not 2; export or copy the file again");
}

TEST_F(GltfDocuments, buffers_are_files_with_escaped_names) {
    written("two words.bin", square_bytes());
    const GltfDocument document(gltf(R"("buffers":[{"byteLength":60,"uri":"two%20words.bin"}],
"bufferViews":[{"buffer":0,"byteLength":60}])"));
    EXPECT_EQ(document.bytes_of(document.root().elements("bufferViews").front()), square_bytes());
    EXPECT_EQ(document.files().size(), 2U);
}

TEST_F(GltfDocuments, all_missing_files_are_named_at_once) {
    const std::string fault =
        fault_of(R"("buffers":[{"byteLength":60,"uri":"a.bin"},{"byteLength":60,"uri":"b.bin"}])");
    EXPECT_NE(fault.find("2 files are missing"), std::string::npos) << fault;
    EXPECT_NE(fault.find("a.bin"), std::string::npos) << fault;
    EXPECT_NE(fault.find("b.bin"), std::string::npos) << fault;
}

TEST_F(GltfDocuments, faults_are_told_with_their_place) {
    EXPECT_EQ(fault_of_file(written("a.gltf", "{\n \"asset\": }")),
              "a.gltf:2:11: is not valid JSON here; export or copy the file again");
    EXPECT_EQ(fault_of_file(written("a.gltf", "{\"a\":1e999}")),
              "a.gltf: has a number that is too large for JSON; export the file again");
    EXPECT_EQ(fault_of_file(written("a.gltf", "[1]")),
              "a.gltf: is JSON, but not a glTF scene; name a scene");
    EXPECT_EQ(fault_of_file(written("a.gltf", R"({"asset":{"version":"1.0"}})")),
              "a.gltf: asset: is of glTF version \"1.0\"; export it as glTF 2.0");
    EXPECT_EQ(fault_of(R"("buffers":[{"byteLength":9,"uri":"data:;base64,Zm9v"}])"),
              "scene.gltf: buffers[0]: has 3 bytes of 9; export or copy the file again");
    EXPECT_EQ(fault_of(R"("buffers":[{"byteLength":3,"uri":"data:;base64,Zm9v?"}])"),
              "scene.gltf: buffers[0].uri: is not valid base64; export the file again");
    EXPECT_EQ(fault_of(R"("nodes":[{"mesh":3}],"scenes":[{"nodes":[0]}],)" + square_json()),
              "scene.gltf: nodes[0].mesh: names mesh 3 of 1; export the file again");
}

/// Sizes are compared with the file before anything is done for them.
TEST_F(GltfDocuments, huge_claims_are_refused) {
    const std::string node = R"("nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],)";
    for (const char* claim : {"4294967296", "9007199254740992", "1e300", "-1", "4.5", "\"4\""}) {
        std::string members = node + square_json();
        const std::string count = R"("count":4)";
        members.replace(members.find(count), count.size(), std::string(R"("count":)") + claim);
        EXPECT_NE(fault_of(members), "") << claim;
        members = node + square_json();
        const std::string size = R"("byteLength":60)";
        members.replace(members.rfind(size), size.size(), std::string(R"("byteLength":)") + claim);
        EXPECT_NE(fault_of(members), "") << claim;
    }
}

/// A length of the head that is less than the file's ends it; chunks of unknown types are passed
/// over, and the JSON may be filled up with zeros and begin with a mark.
TEST_F(GltfDocuments, binary_files_may_have_more_in_them) {
    const auto word = [](std::size_t x) {
        return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(x)});
    };
    const std::string json = R"({"asset":{"version":"2.0"}})";
    const std::string whole = glb(json, square_bytes());
    EXPECT_EQ(fault_of_file(written("a.glb", whole + "more than eight bytes")), "");
    std::string other =
        whole.substr(0, 20 + json.size()) + word(4) + "WHAT1234" + whole.substr(20 + json.size());
    other.replace(8, 4, word(other.size()));
    EXPECT_EQ(fault_of_file(written("a.glb", other)), "");
    EXPECT_EQ(fault_of_file(written("a.glb", glb(json + std::string(3, '\0'), ""))), "");
    EXPECT_EQ(fault_of_file(written("a.glb", glb("\xEF\xBB\xBF" + json, ""))), "");
    EXPECT_EQ(fault_of_file(written("a.gltf", "\xEF\xBB\xBF" + json)), "");
}

/// Names are decoded; else they are taken as they stand, and with the slashes of Windows turned.
TEST_F(GltfDocuments, files_are_found_under_the_names_that_exporters_write) {
    std::filesystem::create_directories(path("parts"));
    written("parts/a.bin", square_bytes());
    written("b%20c.bin", square_bytes());
    for (const char* name : {"parts%5Ca.bin", "parts\\\\a.bin", "./parts/a.bin", "b%20c.bin",
                             "b%2520c.bin", "parts/../parts/%61.bin"}) {
        const std::string members = R"("buffers":[{"byteLength":60,"uri":")" + std::string(name) +
                                    R"("}],"bufferViews":[{"buffer":0,"byteLength":60}])";
        EXPECT_EQ(fault_of(members), "") << name;
    }
    EXPECT_NE(fault_of(R"("buffers":[{"byteLength":60,"uri":"gone%5Ca.bin"}])").find("gone\\a.bin"),
              std::string::npos);
}

/// Some exporters write null for what they leave out.
TEST_F(GltfDocuments, null_is_nothing) {
    EXPECT_EQ(fault_of(R"("scene":null,"cameras":null,"scenes":[{"nodes":[0],"name":null}],
"nodes":[{"mesh":0,"skin":null,"camera":null,"matrix":null}],)" +
                       square_json(R"(,"material":null)")),
              "");
}

}  // namespace
}  // namespace sunfleck::engine
