// Portal corners, and the environment behind them.
#include "import/pbrt/portals.h"

#include "image/lookup.h"
#include "import/pbrt/light_images.h"
#include "import/pbrt/light_scale.h"
#include "import/pbrt/reading.h"

namespace sunfleck::engine {
namespace {

/// Cells per axis for a constant environment, where they only guide the sampling.
constexpr int kPlainSide = 64;

std::array<Vec3d, 4> corners_of(const Parameter& portal) {
    const std::vector<double>& v = portal.numbers;
    if (v.size() != 12)
        throw Error(portal.where, "a portal of " + std::to_string(v.size() / 3) + " points",
                    "give its 4 corners");
    std::array<Vec3d, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners.at(i) = {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
    return corners;
}

/// Returns frame and extent as in pbrt-v4: x along p3 - p0, y along p1 - p0.
PortalLight placed(const Parameter& portal) {
    const auto p = corners_of(portal);
    const Vec3d x = p[3] - p[0];
    const Vec3d y = p[1] - p[0];
    PortalLight light;
    light.extent = {x.length(), y.length()};
    const double size = std::max(light.extent.x, light.extent.y);
    const bool is_rectangle = light.extent.x > 0 && light.extent.y > 0 && std::isfinite(size) &&
                              std::abs(x.dot(y)) <= 1e-3 * light.extent.x * light.extent.y &&
                              (p[0] + x + y - p[2]).length() <= 1e-3 * size;
    if (!is_rectangle)
        throw Error(portal.where, "the portal is not a rectangle",
                    "give its corners in their order around it, at right angles");
    light.frame.x = x / light.extent.x;
    light.frame.y = (y - light.frame.x * light.frame.x.dot(y)).normalized();
    light.frame.z = light.frame.x.cross(light.frame.y);
    light.frame.origin = p[0];
    return light;
}

}  // namespace

Light portal_light(const Statement& statement, Reading& reading) {
    PortalLight light = placed(*statement.find("portal", ParameterType::point3));
    if (!statement.find("filename")) {
        const Spectrum curve = emission_of(statement, "L", reading);
        // pbrt-v4 makes an image of one texel, at its zenith, and sums that up.
        const double at_one = 2 * kPiDouble * static_cast<double>(curve.luminance());
        light.curve = scaled_emission(statement, curve, {"illuminance", at_one});
        light.image =
            std::make_shared<const PortalImage>(kPlainSide, [](const Vec3d&) { return Vec3(1); });
        return light;
    }
    const auto [image, map] = environment_image(statement, reading);
    const auto distribution = image_of_directions(image, map);
    const double at_one = illuminance_from_above(*distribution, map) / 2;
    light.curve =
        scaled_emission(statement, Spectrum::d65(), {"illuminance", at_one}, distribution->peak());
    const Affine turn = turn_of(statement, reading);
    const Wraps wraps =
        map.has_equal_areas() ? Wraps(Wrap::octahedral_sphere) : Wraps(Wrap::repeat, Wrap::clamp);
    const auto sky = [&](const Vec3d& w) {
        const Vec3d world = light.frame.vector(w);
        const Vec3d own(turn.x.dot(world), turn.y.dot(world), turn.z.dot(world));
        const auto v = bilinear(image, Vec2(map.place(own)), wraps);
        return image.channels() < 3 ? Vec3(v[0]) : Vec3(v[0], v[1], v[2]);
    };
    light.image = std::make_shared<const PortalImage>(image.resolution().y, sky);
    return light;
}

}  // namespace sunfleck::engine
