// Accessors of all storages: strides, normalised integers, sparse values.
#include "import/gltf/accessors.h"

#include "gltf_files.h"

namespace sunfleck::engine {
namespace {

using testing_support::buffer_json;
using testing_support::bytes_of;

class GltfAccessors : public testing_support::GltfFiles {
protected:
    /// Calls with the accessors of a file of one buffer and accessor 0.
    template <class Ask>
    auto asked(const std::string& bytes, const std::string& accessor, const Ask& ask,
               const std::string& of_view = "") const {
        std::string members = buffer_json(bytes);
        members.insert(members.size() - 2, of_view);
        const GltfDocument document(
            gltf(members + R"(,"accessors":[)" + accessor + R"(],"use":0)"));
        return ask(Accessors(document), document.root().at("use"));
    }
    static constexpr auto kTriples = [](const Accessors& all, const JsonPlace& use) {
        return all.triples(use);
    };
    static constexpr auto kScalars = [](const Accessors& all, const JsonPlace& use) {
        return all.scalars(use);
    };
};

TEST_F(GltfAccessors, floats_are_read_with_offset_and_stride) {
    const std::string bytes = bytes_of<float>({9, 1, 2, 3, 9, 4, 5, 6, 9, 7, 8, 9});
    EXPECT_EQ(
        asked(bytes,
              R"({"bufferView":0,"byteOffset":4,"componentType":5126,"type":"VEC3","count":3})",
              kTriples, R"(,"byteStride":16)"),
        (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
}

TEST_F(GltfAccessors, integers_are_normalised_by_their_largest) {
    const auto scalars = [&](const std::string& bytes, int type, bool normalized) {
        return asked(bytes,
                     R"({"bufferView":0,"type":"SCALAR","count":3,"componentType":)" +
                         std::to_string(type) + R"(,"normalized":)" +
                         (normalized ? "true" : "false") + "}",
                     kScalars);
    };
    using Values = std::vector<float>;
    EXPECT_EQ(scalars(bytes_of<std::int8_t>({-128, 127, 0}), 5120, true), (Values{-1, 1, 0}));
    EXPECT_EQ(scalars(bytes_of<std::uint8_t>({0, 51, 255}), 5121, true), (Values{0, 0.2F, 1}));
    EXPECT_EQ(scalars(bytes_of<std::int16_t>({-32768, -32767, 32767}), 5122, true),
              (Values{-1, -1, 1}));
    EXPECT_EQ(scalars(bytes_of<std::uint16_t>({0, 13107, 65535}), 5123, true),
              (Values{0, 0.2F, 1}));
    EXPECT_EQ(scalars(bytes_of<std::int8_t>({-128, 127, 5}), 5120, false), (Values{-128, 127, 5}));
    EXPECT_EQ(scalars(bytes_of<std::uint32_t>({7, 8, 9}), 5125, false), (Values{7, 8, 9}));
}

TEST_F(GltfAccessors, sparse_values_replace_others) {
    const std::string bytes =
        bytes_of<float>({1, 2, 3, 4, 40, 10}) + bytes_of<std::uint16_t>({3, 0});
    const std::string sparse =
        R"(,"sparse":{"count":2,"indices":{"bufferView":0,"byteOffset":24,"componentType":5123},
"values":{"bufferView":0,"byteOffset":16}}})";
    const std::string type = R"("componentType":5126,"type":"SCALAR","count":4)";
    EXPECT_EQ(asked(bytes, R"({"bufferView":0,)" + type + sparse, kScalars),
              (std::vector<float>{10, 2, 3, 40}));
    EXPECT_EQ(asked(bytes, "{" + type + sparse, kScalars), (std::vector<float>{10, 0, 0, 40}))
        << "without a view the others are zero";
    const std::string points = R"({"componentType":5126,"type":"VEC3","count":2})";
    EXPECT_EQ(asked(bytes, points, kTriples), (std::vector<Vec3>(2, Vec3(0))));
}

TEST_F(GltfAccessors, indices_are_integers) {
    const auto indices = [](const Accessors& all, const JsonPlace& use) {
        return all.indices(use);
    };
    EXPECT_EQ(asked(bytes_of<std::uint32_t>({7, 0xFFFFFFFE}),
                    R"({"bufferView":0,"componentType":5125,"type":"SCALAR","count":2})", indices),
              (std::vector<std::uint32_t>{7, 0xFFFFFFFE}));
    EXPECT_THROW(
        asked(bytes_of<float>({0.5F}),
              R"({"bufferView":0,"componentType":5126,"type":"SCALAR","count":1})", indices),
        Error);
}

TEST_F(GltfAccessors, what_does_not_fit_is_refused) {
    const std::string twelve = bytes_of<float>({1, 2, 3});
    const auto is_refused = [&](const std::string& accessor, const std::string& of_view = "") {
        EXPECT_THROW(asked(twelve, accessor, kTriples, of_view), Error) << accessor;
    };
    is_refused(R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":2})");
    is_refused(R"({"bufferView":0,"byteOffset":4,"componentType":5126,"type":"VEC3","count":1})");
    is_refused(R"({"bufferView":0,"byteOffset":99,"componentType":5126,"type":"VEC3","count":1})");
    is_refused(R"({"bufferView":0,"componentType":5126,"type":"VEC2","count":1})");
    is_refused(R"({"bufferView":0,"componentType":5124,"type":"VEC3","count":1})");
    is_refused(R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":1})",
               R"(,"byteStride":0)");
    is_refused(R"({"bufferView":1,"componentType":5126,"type":"VEC3","count":1})");
    is_refused(R"({"componentType":5126,"type":"VEC3","count":4294967295})");
    EXPECT_THROW(
        asked(bytes_of<float>({1, NAN, 3}),
              R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":1})", kTriples),
        Error);
}

}  // namespace
}  // namespace sunfleck::engine
