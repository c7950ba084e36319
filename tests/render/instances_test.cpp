// Objects placed by ObjectInstance are what their shapes are, written out where they stand: of
// every kind of shape, with holes, materials and media.
#include "core/random.h"
#include "import/pbrt/scene_text.h"
#include "scene/pass_scene.h"

namespace sunfleck::engine {
namespace {

/// A shape of every kind, each of another grey, beside one another along x.
const std::string kObject = R"(
AttributeBegin Translate 0 0 0 Material "diffuse" "rgb reflectance" [.1 .1 .1]
Shape "trianglemesh" "point3 P" [-.5 -1 0 .5 -1 .2 .5 1 0 -.5 1 -.3]
    "normal N" [0 .3 1 .2 0 1 0 0 1 -.3 0 1] "point2 uv" [0 0 1 0 1 1 0 1]
    "integer indices" [0 1 2 0 2 3] "texture alpha" "holes" AttributeEnd
AttributeBegin Translate 1 0 0 Rotate 40 1 1 0 Material "diffuse" "rgb reflectance" [.2 .2 .2]
Shape "sphere" "float radius" .6 "float zmax" .4 "texture alpha" "holes" AttributeEnd
AttributeBegin Translate 2 0 0 Rotate 70 0 1 0 Material "diffuse" "rgb reflectance" [.3 .3 .3]
ReverseOrientation Shape "cylinder" "float radius" .5 "float phimax" 300 "texture alpha" "holes"
AttributeEnd
AttributeBegin Translate 3 0 0 Rotate 20 0 1 0 Material "diffuse" "rgb reflectance" [.4 .4 .4]
Shape "disk" "float radius" .6 "float innerradius" .1 "texture alpha" "holes" AttributeEnd
AttributeBegin Translate 4 0 0 Material "diffuse" "rgb reflectance" [.5 .5 .5]
Shape "bilinearmesh" "point3 P" [-.5 -1 0 .5 -1 .6 -.5 1 .5 .5 1 -.3]
    "texture alpha" "holes" AttributeEnd
AttributeBegin Translate 5 0 0 Material "diffuse" "rgb reflectance" [.6 .6 .6]
Shape "curve" "point3 P" [-.4 -1 0 .4 -.3 .5 -.4 .3 -.5 .4 1 0] "float width" .3 AttributeEnd
AttributeBegin Translate 6 0 0 Material "diffuse" "rgb reflectance" [.7 .7 .7]
Shape "curve" "point3 P" [-.4 -1 0 .4 -.3 .5 -.4 .3 -.5 .4 1 0] "string type" "cylinder"
    "float width" .3 AttributeEnd
AttributeBegin Translate 7 0 0 Material "diffuse" "rgb reflectance" [.8 .8 .8]
Shape "curve" "point3 P" [-.4 -1 0 .4 -.3 .5 -.4 .3 -.5 .4 1 0] "string type" "ribbon"
    "normal N" [0 0 1 0 1 1] "float width" .3 AttributeEnd
AttributeBegin Translate 8 0 0 Material "diffusetransmission" "rgb reflectance" [.9 .9 .9]
    "rgb transmittance" [.1 .1 .1]
MediumInterface "tea" "" Shape "sphere" "float radius" .7 AttributeEnd
AttributeBegin Translate 9 0 0 Material "diffusetransmission" "rgb reflectance" [.95 .95 .95]
    "rgb transmittance" [.05 .05 .05]
MediumInterface "" "tea" Shape "loopsubdiv" "integer levels" 2 "point3 P" [-1 -1 -1
    1.2 0 0 0 1.2 0 0 0 1.2] "integer indices" [0 2 1 0 1 3 0 3 2 1 2 3] AttributeEnd
)";
constexpr int kShapes = 10;

const std::string kBefore = R"(
LightSource "point"
Texture "holes" "float" "checkerboard" "float uscale" 4 "float vscale" 6
    "float tex1" 0 "float tex2" 1
MakeNamedMedium "tea" "string type" "homogeneous" "rgb sigma_a" [1 2 3] "rgb sigma_s" [0 0 0]
)";

const std::array<std::string, 2> kPlaces = {
    "Translate 1 2 3 Rotate 30 1 2 3 Scale 1.5 1 .7\n",
    "Translate -3 -4 1 Rotate 200 0 1 1 Scale 1 -1 1.2\n"};  // mirrored

Scene instanced() {
    std::string text = kBefore + "ObjectBegin \"it\"\n" + kObject + "ObjectEnd\n";
    for (const std::string& place : kPlaces)
        text += "AttributeBegin\n" + place + "ObjectInstance \"it\"\nAttributeEnd\n";
    return Scene(read_world(text));
}

bool is_met_in_its_own_frame(const Shape& shape) {
    return !std::holds_alternative<TriangleMesh>(shape) &&
           !std::holds_alternative<BilinearMesh>(shape);
}

Scene written_out() {
    std::string text = kBefore;
    for (const std::string& place : kPlaces)
        text += "AttributeBegin\n" + place + kObject + "AttributeEnd\n";
    SceneDescription flat = read_world(text);
    // A matrix that mirrors turns the normals of such shapes, and an instance does not.
    for (ShapeDescription& shape : flat.shapes)
        if (is_met_in_its_own_frame(shape.placed.shape) &&
            Affine(shape.placed.to_world).determinant() < 0)
            shape.placed.flip = !shape.placed.flip;
    return Scene(std::move(flat));
}

/// What tells the shape of a hit: its grey, in tenths and halves of them.
int kind_at(const PassScene& pass, const Hit& hit) {
    const auto& material = pass.scene.materials().at(pass.scene.material_of(hit));
    const auto* through = std::get_if<DiffuseTransmissionMaterial>(&material);
    const auto& grey =
        through ? through->reflectance : std::get<DiffuseMaterial>(material).reflectance;
    return static_cast<int>(std::lround(grey.curve()(550) * 20));
}

float absorption_beyond(const PassScene& pass, const Hit& hit, const Vec3& direction) {
    return pass.media.at(pass.scene.medium_beyond(hit, direction, 0)).absorption[0];
}

class Rays {
public:
    /// Past the shapes of one of the places.
    Ray next() {
        const Matrix& place = places_.at(random_.next() < 0.5 ? 0 : 1);
        const Vec3d target = Vec3d(random_.next() * kShapes - 0.5, box(), box()) * place;
        Vec3d way(box(), box(), box());
        way.normalize();
        return {Vec3(target - way * 6), Vec3(way)};
    }

private:
    double box() { return random_.next() * 1.6 - 0.8; }
    static Matrix place_of(const std::string& text) {
        return read_world(text + "Shape \"sphere\"").shapes.at(0).placed.to_world;
    }

    std::array<Matrix, 2> places_ = {place_of(kPlaces[0]), place_of(kPlaces[1])};
    RandomStream random_{7, Purpose::test, 0, 0};
};

void expect_alike(const PassScene& a, const Hit& one, const PassScene& b, const Hit& other,
                  const Vec3& direction) {
    const float slack = 2e-5F / std::max(0.01F, std::abs(one.normal.dot(direction)));
    EXPECT_LT((one.position - other.position).length(), slack);
    EXPECT_NEAR(one.distance, other.distance, slack);
    EXPECT_GT(one.normal.dot(other.normal), 0.9999F);
    EXPECT_GT(one.shading_normal.dot(other.shading_normal), 0.9999F);
    EXPECT_LT((one.tangent - other.tangent).length(), 2e-3F * other.tangent.length());
    for (const Vec3& way : {direction, -direction})
        EXPECT_EQ(absorption_beyond(a, one, way), absorption_beyond(b, other, way));
}

/// A few rays may pass an edge on another side, by rounding. (Seen: none.)
TEST(Instances, are_hit_like_what_is_written_out) {
    const Scene two = instanced();
    const Scene flat = written_out();
    EXPECT_TRUE(two.warnings().entries().empty()) << two.warnings().entries()[0].line();
    const PassScene a(two, {1, 0});
    const PassScene b(flat, {1, 0});
    Rays rays;
    std::map<int, int> hits;
    int different = 0;
    int in_medium = 0;
    constexpr int kRays = 100'000;
    for (int i = 0; i < kRays; ++i) {
        const Ray ray = rays.next();
        const auto one = two.geometry().intersect(ray);
        const auto other = flat.geometry().intersect(ray);
        EXPECT_EQ(two.geometry().occluded(ray), one.has_value());
        const bool alike = one.has_value() == other.has_value() &&
                           (!one || (kind_at(a, *one) == kind_at(b, *other) &&
                                     std::abs(one->distance - other->distance) < 0.01F));
        if (!alike) ++different;
        if (!one || !alike) continue;
        ++hits[kind_at(a, *one)];
        in_medium += absorption_beyond(a, *one, ray.direction) > 0 ? 1 : 0;
        expect_alike(a, *one, b, *other, ray.direction);
        if (HasFailure()) FAIL() << "shape " << kind_at(a, *one) << ", ray " << i;
    }
    EXPECT_EQ(hits.size(), std::size_t{kShapes});
    for (const auto& [kind, count] : hits) EXPECT_GT(count, 300) << kind;
    EXPECT_GT(in_medium, 300);
    EXPECT_LT(different, 10);
}

}  // namespace
}  // namespace sunfleck::engine
