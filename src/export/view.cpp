// The view of a scene.
#include "export/view.h"

#include "camera/camera_frame.h"
#include "export/statement_text.h"
#include "geometry/quadrature.h"
#include "scene/framing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr int kMaxDepth = 64;
constexpr int kPixelSamples = 256;
constexpr double kFovSteps = 1e9;           // per degree
constexpr double kGatherShare = 1 / 500.0;  // first gather radius over the size of the scene

bool is_near(const Vec2d& a, const Vec2d& b) {
    const double size = std::max(std::abs(b.x), std::abs(b.y));
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) <= 1e-12 * size;
}

/// Adds the screen where it is not pbrt-v4's. @param screen  as it would be of itself.
void add_window(StatementText& statement, const ScreenCamera& screen,
                const ScreenCamera& of_itself) {
    if (is_near(screen.screen_min, of_itself.screen_min) &&
        is_near(screen.screen_max, of_itself.screen_max))
        return;
    const auto& low = screen.screen_min;
    const auto& high = screen.screen_max;
    statement.add("float", "screenwindow",
                  exact_number(low.x) + ' ' + exact_number(high.x) + ' ' + exact_number(low.y) +
                      ' ' + exact_number(high.y));
}

void add_lens(StatementText& statement, const ScreenCamera& camera) {
    if (!(camera.lens_radius > 0)) return;
    statement.add("lensradius", camera.lens_radius);
    statement.add("focaldistance", camera.focal_distance);
}

double aspect_of(const ScreenCamera& camera) {
    return static_cast<double>(camera.resolution.x) / camera.resolution.y;
}

struct CameraStatement {
    Warnings& warnings;
    const SourceLocation& where;

    /// The angle of the shorter side is written where it gives the screen; else a screen at 90
    /// degrees, where it is as large as it is written.
    StatementText operator()(const PerspectiveCamera& camera) const {
        StatementText statement("Camera", "perspective");
        const Vec2d size = camera.screen_max - camera.screen_min;
        const double tangent = std::min(size.x, size.y) / 2;
        const double angle = arc_cosine(1 / std::sqrt(1 + tangent * tangent)) / kPiDouble * 360;
        const double fov = std::round(angle * kFovSteps) / kFovSteps;
        const auto seen_at = [&](double degrees) {
            return make_perspective(camera.camera_to_world, camera.resolution, degrees,
                                    aspect_of(camera), {});
        };
        const PerspectiveCamera usual = seen_at(fov);
        const bool is_usual = is_near(usual.screen_min, camera.screen_min) &&
                              is_near(usual.screen_max, camera.screen_max);
        statement.add("fov", is_usual ? fov : 90.0);
        add_window(statement, camera, is_usual ? usual : seen_at(90));
        add_lens(statement, camera);
        return statement;
    }

    StatementText operator()(const OrthographicCamera& camera) const {
        StatementText statement("Camera", "orthographic");
        ScreenCamera usual = camera;
        set_screen(usual, aspect_of(camera), {});
        add_window(statement, camera, usual);
        add_lens(statement, camera);
        if (camera.lens_radius > 0)
            warnings.add(where,
                         "the lens of an orthographic camera is that of each point of the "
                         "film here, and one at the camera's place in pbrt-v4");
        return statement;
    }

    StatementText operator()(const SphericalCamera& camera) const {
        StatementText statement("Camera", "spherical");
        statement.add_word("string", "mapping",
                           camera.map == SphereMap::equal_area ? "equalarea" : "equirectangular");
        return statement;
    }
};

}  // namespace

std::string camera_text(const Camera& camera, const std::string& around,
                        const SourceLocation& where, Warnings& warnings) {
    const StatementText statement = std::visit(CameraStatement{warnings, where}, camera);
    return transform_text(frame_of(camera).inverse()) + around + statement.text();
}

std::string film_text(const FilmDescription& film, const std::string& picture) {
    StatementText statement("Film", "rgb");
    statement.add_word("string", "filename", picture);
    statement.add("xresolution", film.resolution.x);
    statement.add("yresolution", film.resolution.y);
    if (film.crop) {
        const auto& edges = *film.crop;
        statement.add("integer", "pixelbounds", fmt::format("{}", fmt::join(edges, " ")));
    }
    if (film.imaging_ratio != 1)
        statement.add("iso", 100 * static_cast<double>(film.imaging_ratio));
    if (film.white) statement.add("whitebalance", *film.white);
    return statement.text();
}

std::string filter_text(const FilterSettings& filter) {
    const auto begun = [&](std::string_view word) {
        StatementText statement("PixelFilter", word);
        statement.add("xradius", filter.radius.x);
        statement.add("yradius", filter.radius.y);
        return statement;
    };
    switch (filter.kind) {
        case FilterKind::box:
            return begun("box").text();
        case FilterKind::triangle:
            return begun("triangle").text();
        case FilterKind::gaussian: {
            StatementText statement = begun("gaussian");
            statement.add("sigma", filter.sigma);
            return statement.text();
        }
        case FilterKind::mitchell: {
            StatementText statement = begun("mitchell");
            statement.add("B", filter.b);
            statement.add("C", filter.c);
            return statement.text();
        }
        case FilterKind::sinc:
            break;
    }
    StatementText statement = begun("sinc");
    statement.add("tau", filter.tau);
    return statement.text();
}

/// pbrt-v4's photon mapping starts with a radius of one unit, whatever the scene's size.
std::string integrator_text(const SceneDescription& scene) {
    const bool is_said = !scene.hints.integrator.empty();
    const std::string usual = scene.media.act() ? "volpath" : "sppm";
    const std::string word = is_said ? scene.hints.integrator : usual;
    StatementText integrator("Integrator", word);
    integrator.add("maxdepth", scene.hints.max_depth.value_or(kMaxDepth));
    const double size = 2 * bounds_of_scene(scene).radius();
    if (word == "sppm" && size > 0 && std::isfinite(size))
        integrator.add("radius", static_cast<float>(size * kGatherShare));
    StatementText sampler("Sampler", "halton");
    sampler.add("pixelsamples", kPixelSamples);
    return sampler.text() + integrator.text();
}

}  // namespace sunfleck::engine
