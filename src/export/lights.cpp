// One overload for each light.
#include "export/lights.h"

#include "export/light_colours.h"
#include "export/light_images.h"
#include "export/spectra.h"
#include "geometry/quadrature.h"
#include "scene/description.h"

#include <fmt/format.h>

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Returns an angle in degrees.
double angle_of(double cosine) {
    return arc_cosine(std::clamp(cosine, -1.0, 1.0)) / kPiDouble * 180;
}

Matrix placed_at(Affine turn, const Vec3d& position) {
    turn.origin = position;
    return matrix_of(turn);
}

Matrix moved_to(const Vec3d& position) {
    return placed_at(Affine(), position);
}

/// Returns the picture of a light with one channel, or with RGB.
std::shared_ptr<const Image> picture_of(const LightImage& image, int channels) {
    std::vector<float> texels;
    for (int y = 0; y < image.resolution().y; ++y)
        for (int x = 0; x < image.resolution().x; ++x) {
            const TexelLight texel = image.texel(x, y);
            const Vec3 rgb = texel.rgb * static_cast<float>(texel.luminance);
            texels.push_back(rgb.x);
            if (channels == 3) texels.insert(texels.end(), {rgb.y, rgb.z});
        }
    return std::make_shared<const Image>(image.resolution(), channels, std::move(texels));
}

/// Returns whether a light behind a portal is the same from all directions.
bool is_even(const LightImage& image) {
    for (int y = 0; y < image.resolution().y; ++y)
        for (int x = 0; x < image.resolution().x; ++x) {
            const TexelLight texel = image.texel(x, y);
            const Vec3 off = texel.rgb * static_cast<float>(texel.luminance) - Vec3(1);
            if (std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}) > 1e-5F) return false;
        }
    return true;
}

/// Returns where the edge of pbrt-v4's spot begins, which is a smoothstep: for a square edge there
/// where the power is the same, if it can be.
double cos_start_of(const SpotLight& light) {
    if (light.edge == SpotEdge::smoothstep) return light.cos_start;
    return std::min(1.0, light.cos_start + (light.cos_start - light.cos_total) / 3);
}

struct StatementOfLight {
    PictureFiles& pictures;
    Warnings& warnings;
    const SourceLocation& where;

    std::string operator()(const PointLight& light) const {
        StatementText statement("LightSource", "point");
        statement.add("point3", "from", light.position);
        add_emission(statement, "I", light.curve);
        return statement.text();
    }

    std::string operator()(const SpotLight& light) const {
        StatementText statement("LightSource", "spot");
        statement.add("point3", "to", light.axis);
        if (light.edge == SpotEdge::square)
            warnings.add(where,
                         "pbrt-v4's spot has another soft edge: it differs by up to 0.3 of "
                         "the intensity on the axis");
        const double cone = angle_of(light.cos_total);
        statement.add("coneangle", cone);
        statement.add("conedeltaangle", cone - angle_of(cos_start_of(light)));
        add_emission(statement, "I", light.curve);
        return placed(moved_to(light.position), statement);
    }

    std::string operator()(const GoniometricLight& light) const {
        StatementText statement("LightSource", "goniometric");
        statement.add_word("string", "filename",
                           pictures.add_light("intensity", picture_of(*light.image, 1)));
        add_emission(statement, "I", light.curve);
        Affine turn = light.to_world;
        std::swap(turn.y, turn.z);
        return placed(placed_at(turn, light.position), statement);
    }

    std::string operator()(const ProjectionLight& light) const {
        StatementText statement("LightSource", "projection");
        const double tangent = std::min(light.half.x, light.half.y);
        const double half = arc_cosine(1 / std::sqrt(1 + tangent * tangent));
        statement.add("fov", 2 * half / kPiDouble * 180);
        const LightColours colours(light.curve);
        const auto image = under(colours, *picture_of(*light.image, 3));
        statement.add_word("string", "filename", pictures.add_light("projection", image));
        statement.add("scale", colours.scale());
        Affine turn = light.to_world;
        turn.y = -turn.y;
        return placed(placed_at(turn, light.position), statement);
    }

    std::string operator()(const DistantLight& light) const {
        return distant(light.direction, light.curve);
    }

    std::string operator()(const SunLight& light) const {
        const LightColours colours(light.curve);
        const auto sun = sun_image(light);
        if (!sun) {
            warnings.add(where,
                         "pbrt-v4 has no sun with a width: a narrow one is written as a "
                         "distant light, with sharp shadows");
            return distant(light.direction, light.curve);
        }
        warnings.add(where,
                     "pbrt-v4 has no sun with a width: it is written as a picture of the "
                     "sky, of its colour and irradiance");
        return infinite("sun", under(colours, *sun->image), colours.scale() * sun->peak,
                        matrix_of(sun->to_world));
    }

    std::string operator()(const InfiniteLight& light) const {
        StatementText statement("LightSource", "infinite");
        add_emission(statement, "L", light.curve);
        return statement.text();
    }

    std::string operator()(const ImageInfiniteLight& light) const {
        const LightColours colours(light.curve);
        if (!colours.are_kept())
            warnings.add(where,
                         "the spectrum of a light with a picture is written as the colours "
                         "of its texels");
        if (!light.map.has_equal_areas())
            warnings.add(where,
                         "a picture of latitude and longitude is written as one of equal "
                         "areas, twice as high: texels are means, of the same light");
        return infinite("environment", under(colours, *equal_area_image(light)), colours.scale(),
                        matrix_of(light.to_world));
    }

    std::string operator()(const PortalLight& light) const {
        StatementText statement("LightSource", "infinite");
        const Vec3d corner = light.frame.origin;
        const Vec3d x = light.frame.x * light.extent.x;
        const Vec3d y = light.frame.y * light.extent.y;
        std::string corners;
        for (const Vec3d& p : {corner, corner + y, corner + x + y, corner + x})
            corners += fmt::format("{} {} {}  ", p.x, p.y, p.z);
        statement.add("point3", "portal", corners);
        if (is_even(light.image->through())) {
            add_emission(statement, "L", light.curve);
            return statement.text();
        }
        warnings.add(where,
                     "the sky behind a portal is written as what is seen through it, "
                     "resampled");
        const LightColours colours(light.curve);
        statement.add_word("string", "filename",
                           pictures.add_light("portal", under(colours, *portal_view(light))));
        statement.add("scale", colours.scale());
        Affine turn = light.frame;
        turn.origin = Vec3d(0);
        return placed(matrix_of(turn), statement);
    }

    std::string operator()(const AreaLight&) const { return {}; }    // those are of their shapes
    std::string operator()(const MediumLight&) const { return {}; }  // those are of their media

private:
    static std::string placed(const Matrix& to_world, const StatementText& statement) {
        return placed_text(to_world, statement.text());
    }

    static std::string distant(const Vec3d& direction, const Spectrum& curve) {
        StatementText statement("LightSource", "distant");
        statement.add("point3", "from", Vec3d(0));
        statement.add("point3", "to", direction);
        add_emission(statement, "L", curve);
        return statement.text();
    }

    std::string infinite(std::string_view what, std::shared_ptr<const Image> image, float scale,
                         const Matrix& to_world) const {
        StatementText statement("LightSource", "infinite");
        statement.add_word("string", "filename", pictures.add_light(what, std::move(image)));
        statement.add("scale", scale);
        return placed(to_world, statement);
    }
};

}  // namespace

std::string LightStatements::of(const Light& light, const SourceLocation& where) {
    return std::visit(StatementOfLight{pictures_, warnings_, where}, light);
}

std::string LightStatements::area(const AreaEmission& emission) {
    StatementText statement("AreaLightSource", "diffuse");
    if (emission.image) {
        const LightColours colours(emission.radiance);
        std::string& file = surface_images_[emission.image];
        if (file.empty())
            file = pictures_.add_light("emission", under(colours, emission.image->image()));
        statement.add_word("string", "filename", file);
        statement.add("scale", colours.scale());
    } else {
        add_emission(statement, "L", emission.radiance);
    }
    if (emission.two_sided) statement.add("twosided", true);
    if (emission.power > 0) statement.add("power", emission.power);
    return statement.text();
}

}  // namespace sunfleck::engine
