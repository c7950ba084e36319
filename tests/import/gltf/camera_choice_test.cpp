// The camera that is asked for, by name and number.
#include "import/gltf/camera_choice.h"

#include "gltf_files.h"

namespace sunfleck::engine {
namespace {

class GltfCameraChoice : public testing_support::GltfFiles {
protected:
    /// Returns the number of the node whose camera is chosen, or what the Error says.
    std::string chosen(const std::string& camera) const {
        const std::string members = R"("cameras":[{"name":"Wide"},{"name":"2"},{}],
"scenes":[{"nodes":[0,1,2,3]}],"nodes":[{},{"camera":0,"name":"Front"},{"camera":2,"name":"Top"},
{"camera":1,"name":"Wide"}])";
        const GltfDocument document(gltf(members));
        const Accessors accessors(document);
        const GltfNodes nodes(document, accessors);
        try {
            return chosen_camera(document, nodes, camera)
                ->place.where()
                .file.substr(document.path().size() + 2);
        } catch (const Error& error) {
            return std::string(error.what()).substr(document.path().size() + 2);
        }
    }
};

TEST_F(GltfCameraChoice, is_the_first_unless_told) {
    EXPECT_EQ(chosen(""), "nodes[1]");
}

TEST_F(GltfCameraChoice, goes_by_the_cameras_name_then_its_nodes_then_its_number) {
    EXPECT_EQ(chosen("Wide"), "nodes[1]");
    EXPECT_EQ(chosen("Top"), "nodes[2]");
    EXPECT_EQ(chosen("2"), "nodes[3]") << "a name goes before a number";
    EXPECT_EQ(chosen("1"), "nodes[1]");
}

TEST_F(GltfCameraChoice, lists_what_there_is) {
    EXPECT_EQ(chosen("Back"),
              "has no camera \"Back\" (--camera); write one of 1 \"Wide\", 2 \"Top\", 3 \"2\"");
    ImportSettings settings;
    settings.camera = "1";
    EXPECT_THROW(read_gltf(gltf(""), settings), Error);
}

}  // namespace
}  // namespace sunfleck::engine
