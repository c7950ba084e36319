// Transforms, checked where they are made.
#include "sunfleck/transform.h"

#include "core/default_floats.h"
#include "import/pbrt/transforms.h"
#include "library/matrices.h"
#include "sunfleck/error.h"

namespace sunfleck {
namespace {

engine::Vec3d vector_of(const Vector& v) {
    return {v[0], v[1], v[2]};
}

[[noreturn]] void refuse(const std::string& what, const std::string& mend) {
    throw Error({"Transform"}, what, mend);
}

}  // namespace

engine::Matrix matrix_of(const Transform& transform) {
    engine::Matrix matrix;
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column)
            matrix.x[column][row] = transform.rows().at(row).at(column);
    return matrix;
}

Transform transform_of(const engine::Matrix& matrix) {
    Transform::Rows rows{};
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column)
            rows.at(row).at(column) = matrix.x[column][row];
    return Transform(rows);
}

Transform::Transform(const Rows& rows) : rows_(rows) {
    const engine::DefaultFloats modes;
    if (!engine::is_usable(matrix_of(*this)))
        refuse("the matrix is not affine and finite, or has no inverse",
               "end it in the row 0 0 0 1, and scale by no zeros");
}

Transform Transform::translate(const Vector& by) {
    const engine::DefaultFloats modes;
    return transform_of(engine::translation(vector_of(by)));
}

Transform Transform::scale(const Vector& by) {
    const engine::DefaultFloats modes;
    return transform_of(engine::scaling(vector_of(by)));
}

Transform Transform::rotate(double degrees, const Vector& axis) {
    const engine::DefaultFloats modes;
    if (!(vector_of(axis).length2() > 0)) refuse("the axis has no length", "use {0, 0, 1}");
    return transform_of(engine::rotation(degrees, vector_of(axis)));
}

Transform Transform::look_at(const Vector& eye, const Vector& target, const Vector& up) {
    const engine::DefaultFloats modes;
    const auto world_to_camera = engine::look_at(vector_of(eye), vector_of(target), vector_of(up));
    if (!world_to_camera)
        refuse("eye, target and up make no frame",
               "the eye must not be the target, nor up point at it");
    return transform_of(world_to_camera->inverse());
}

Transform operator*(const Transform& a, const Transform& b) {
    const engine::DefaultFloats modes;
    return transform_of(matrix_of(b) * matrix_of(a));
}

}  // namespace sunfleck
