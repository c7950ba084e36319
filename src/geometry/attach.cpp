// Meshes one by one, then all surfaces that are intersected exactly.
#include "geometry/attach.h"

#include "geometry/cover.h"
#include "geometry/exact_shapes.h"

namespace sunfleck::engine {

void attach_shapes(ShapeGroup& group, RTCDevice device, std::uint32_t exact_number) {
    group.scene = embree::new_scene(device);
    for (std::uint32_t k = 0; k < group.shapes.size(); ++k) {
        const std::uint32_t number = group.shapes[k];
        const BuiltShape& shape = (*group.built)[number];
        if (shape.is_empty()) continue;
        group.bounds.extend(shape.bounds());
        if (shape.mesh() != nullptr) {
            if (shape.cover()) attach_cover(shape);
            rtcAttachGeometryByID(group.scene.get(), shape.geometry(), k);
        }
        for (std::uint32_t i = 0; i < shape.exact_count(); ++i)
            if (!shape.bounds_of(i).is_empty()) group.exact.push_back({number, i});
    }
    if (!group.exact.empty()) attach_exact_shapes(group, device, exact_number);
}

}  // namespace sunfleck::engine
