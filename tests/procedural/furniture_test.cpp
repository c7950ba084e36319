// Furniture: closed but for the net, and standing on the floor.

#include "procedural/furniture.h"

#include "mesh_checks.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

std::vector<Mesh> closed_pieces() {
    const Seat seat = sofa(2);
    return {seat.cloth,   seat.wood, round_table(), shelves(), books(0), lamp_stem(),
            lamp_shade(), pot(),     leaves(),      bowl(),    fruit(),  folded_curtain(0.4, 2)};
}

TEST(Furniture, is_closed_and_faces_out) {
    for (const Mesh& piece : closed_pieces()) {
        EXPECT_TRUE(open_edges(piece).empty());
        EXPECT_GT(volume(piece), 0);
    }
}

TEST(Furniture, stands_on_the_floor) {
    for (const Mesh& piece : closed_pieces())
        for (const auto& p : piece.points) ASSERT_GT(p[2], 0);
}

TEST(Furniture, every_book_has_one_cover) {
    std::size_t all = 0;
    for (int kind = 0; kind < 3; ++kind) {
        EXPECT_GT(books(kind).triangles.size(), 12 * 20);
        all += books(kind).triangles.size();
    }
    EXPECT_EQ(all % 12, 0);
}

TEST(Furniture, the_net_is_one_layer) {
    EXPECT_EQ(open_edges(net_curtain(1.5, 2)).size(), 2 * (240 + 16));
}

}  // namespace
}  // namespace sunfleck::engine
