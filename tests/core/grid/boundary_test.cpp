// Ghost values, closed faces and solid cells.
#include "core/grid/boundary.h"

#include <gtest/gtest.h>

namespace whorl {
namespace {

Field numbered(const Boundary& boundary, Site site) {
    Field q = boundary.field(site);
    for (int j = 0; j < q.height(); ++j) {
        for (int i = 0; i < q.width(); ++i) q(i, j) = Real(100 * j + i);
    }
    return q;
}

TEST(Boundary, FaceFieldsOfABoxHaveBothWalls) {
    const Boundary box(Grid{5, 3, 1}, sides::box);
    EXPECT_EQ(box.field(Site::FaceX).width(), 6);
    EXPECT_EQ(box.field(Site::FaceY).height(), 4);
    const Boundary periodic(Grid{5, 3, 1}, sides::periodic);
    EXPECT_EQ(periodic.field(Site::FaceX).width(), 5);
    EXPECT_EQ(periodic.field(Site::FaceY).height(), 3);
}

TEST(Boundary, PeriodicGhostsAreTheOtherSide) {
    const Boundary periodic(Grid{5, 3, 1}, sides::periodic);
    for (const Site site : {Site::Centre, Site::FaceX, Site::FaceY}) {
        Field q = numbered(periodic, site);
        periodic.fill(q);
        for (int j = -2; j < q.height() + 2; ++j) {
            for (int i = -2; i < q.width() + 2; ++i) EXPECT_EQ(q(i, j), q((i + 5) % 5, (j + 3) % 3));
        }
    }
}

TEST(Boundary, BoxGhostsAreTheNearestSample) {
    const Boundary box(Grid{5, 3, 1}, sides::box);
    for (const Site site : {Site::Centre, Site::FaceX, Site::FaceY}) {
        Field q = numbered(box, site);
        box.fill(q);
        for (int j = -2; j < q.height() + 2; ++j) {
            for (int i = -2; i < q.width() + 2; ++i) {
                EXPECT_EQ(q(i, j), q(std::clamp(i, 0, q.width() - 1), std::clamp(j, 0, q.height() - 1)));
            }
        }
    }
}

TEST(Boundary, WallsAndObstaclesCloseTheirFaces) {
    Boundary box(Grid{5, 5, 1}, sides::box);
    std::vector<std::uint8_t> mask(25, 0);
    mask[2 * 5 + 2] = 1;
    box.set_solids(mask);
    EXPECT_EQ(box.fluid_cells(), 24);
    FaceVelocity velocity = box.velocity();
    velocity.u.set_all(1);
    velocity.v.set_all(1);
    box.enforce(velocity);
    for (int j = 0; j < 5; ++j) {
        EXPECT_EQ(velocity.u(0, j), 0);
        EXPECT_EQ(velocity.u(5, j), 0);
    }
    EXPECT_EQ(velocity.u(2, 2), 0);
    EXPECT_EQ(velocity.u(3, 2), 0);
    EXPECT_EQ(velocity.v(2, 2), 0);
    EXPECT_EQ(velocity.v(2, 3), 0);
    EXPECT_EQ(velocity.u(2, 1), 1);
}

TEST(Boundary, SolidCellsTakeTheNearestFluidValueAtAnyDepth) {
    Boundary box(Grid{9, 9, 1}, sides::box);
    std::vector<std::uint8_t> mask(81, 0);
    for (int j = 2; j < 7; ++j) {
        for (int i = 2; i < 7; ++i) mask[j * 9 + i] = 1;
    }
    box.set_solids(mask);
    Field q = box.field(Site::Centre, Real(7));
    for (int j = 2; j < 7; ++j) {
        for (int i = 2; i < 7; ++i) q(i, j) = -1;
    }
    q(1, 4) = 3;
    box.fill(q);
    EXPECT_EQ(q(2, 4), 3);
    for (int j = 2; j < 7; ++j) {
        for (int i = 2; i < 7; ++i) EXPECT_GT(q(i, j), 0) << i << ", " << j;
    }
}

/// Free slip: beside an obstacle the velocity along its side is the fluid's.
TEST(Boundary, TangentialVelocitySlips) {
    Boundary box(Grid{6, 6, 1}, sides::box);
    std::vector<std::uint8_t> mask(36, 0);
    for (int i = 0; i < 6; ++i) mask[i] = mask[6 + i] = 1;  // a floor of two rows
    box.set_solids(mask);
    FaceVelocity velocity = box.velocity();
    velocity.u.set_all(2);
    box.enforce(velocity);
    for (int i = 1; i < 6; ++i) {
        EXPECT_EQ(velocity.u(i, 1), 2);
        EXPECT_EQ(velocity.u(i, 0), 2);
    }
}

TEST(Boundary, AnAllSolidDomainHoldsNoFlow) {
    Boundary box(Grid{4, 4, 1}, sides::box);
    box.set_solids(std::vector<std::uint8_t>(16, 1));
    EXPECT_EQ(box.fluid_cells(), 0);
    FaceVelocity velocity = box.velocity();
    velocity.u.set_all(1);
    box.enforce(velocity);
    for (int i = 0; i <= 4; ++i) EXPECT_EQ(velocity.u(i, 2), 0);
}

}  // namespace
}  // namespace whorl
