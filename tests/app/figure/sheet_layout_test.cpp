// Where things go on a sheet.
#include "app/figure/sheet_layout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/figure/sheet_cells.h"
#include "tests/support/headless_ui.h"

namespace whorl::app {
namespace {

TEST(Sheet, ArrangesLanesByTheirNumberAndShape) {
    const int square[] = {1, 2, 3, 2, 3, 3};
    for (int n = 1; n <= 6; ++n) {
        EXPECT_EQ(columns_for(n, {128, 128}), square[n - 1]) << n;
        EXPECT_EQ(columns_for(n, {32, 128}), n) << "tall ones stand in a row";
    }
    EXPECT_EQ(columns_for(2, {128, 32}), 1) << "wide ones lie on each other";
    EXPECT_EQ(columns_for(4, {128, 32}), 1);

    const Field field(8, 8, Site::Centre);
    std::vector<SheetCell> cells;
    for (int k = 0; k < 5; ++k) cells.push_back(lane(field, k));
    const std::vector<SheetRow> rows = arranged(cells);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].cells.size(), 3u);
    ASSERT_EQ(rows[1].cells.size(), 2u);
    EXPECT_EQ(rows[1].cells[1].title, "lane 4");
    EXPECT_TRUE(arranged({}).empty());
}

class Layouts : public ::testing::Test {
  protected:
    HeadlessUi ui_{64, 64, 1.0f};
};

void expect_disjoint(const SheetLayout& layout) {
    for (std::size_t a = 0; a < layout.cells.size(); ++a) {
        const PixelRect& p = layout.cells[a].field;
        EXPECT_GE(p.x, static_cast<int>(layout.left));
        EXPECT_LE(p.x + p.width, layout.width - static_cast<int>(layout.left));
        EXPECT_LT(static_cast<float>(p.y + p.height), layout.bar.y);
        for (std::size_t b = 0; b < a; ++b) {
            const PixelRect& q = layout.cells[b].field;
            EXPECT_TRUE(q.x + q.width < p.x || p.x + p.width < q.x || q.y + q.height < p.y ||
                        p.y + p.height < q.y);
        }
        if (const auto& head = layout.cells[a].head) {
            EXPECT_LT(head->title.y, head->note_y);
            EXPECT_LT(head->note_y, static_cast<float>(p.y));
        }
    }
    for (const auto& place : layout.plots) {
        EXPECT_GT(place.corner.y, layout.bar.y);
        EXPECT_LE(place.corner.x + place.size.x, static_cast<float>(layout.width) - layout.left + 1.0f);
        EXPECT_LT(place.corner.y + place.size.y, static_cast<float>(layout.height));
    }
}

TEST_F(Layouts, KeepTheDomainsShapeAndOverlapNowhere) {
    for (const auto& [nx, ny] : {std::pair{64, 64}, {128, 32}, {32, 128}, {48, 32}, {33, 100}}) {
        const Field field(nx, ny, Site::Centre);
        for (int n = 1; n <= 6; ++n) {
            std::vector<SheetCell> cells;
            for (int k = 0; k < n; ++k) cells.push_back(lane(field, k));
            SheetRequest request = request_of(arranged(cells));
            request.plots.resize(static_cast<std::size_t>(n));
            for (const bool crisp : {false, true}) {
                request.crisp = crisp;
                const SheetLayout layout = lay_out(request, ui_.theme);
                ASSERT_EQ(layout.cells.size(), static_cast<std::size_t>(n));
                ASSERT_EQ(layout.plots.size(), static_cast<std::size_t>(n));
                expect_disjoint(layout);
                const PixelRect& field_rect = layout.cells.front().field;
                const double slope = static_cast<double>(ny) / nx;
                const double rounding = 0.5 + 0.5 * slope;  // of either side to whole pixels
                EXPECT_NEAR(field_rect.height, field_rect.width * slope, rounding);
                EXPECT_LE(field_rect.height, 250 + rounding) << "a tall one is no giant";
                if (crisp && field_rect.width >= 2 * nx) {
                    EXPECT_EQ(field_rect.width % nx, 0);
                    EXPECT_EQ(field_rect.height % ny, 0);
                }
            }
        }
    }
}

TEST_F(Layouts, DrawAllResolutionsInOneSizeOfWholeSquares) {
    const Field coarse(40, 40, Site::Centre), fine(80, 80, Site::Centre), middle(60, 60, Site::Centre);
    SheetRequest request = request_of({{"", {lane(coarse, 0), lane(fine, 1)}}});
    request.crisp = true;
    SheetLayout layout = lay_out(request, ui_.theme);
    EXPECT_EQ(layout.cells[0].field.width, 160);
    EXPECT_EQ(layout.cells[1].field.width, 160);
    request.cell_width = 500;
    request.rows[0].cells.push_back(lane(middle, 2));
    layout = lay_out(request, ui_.theme);
    EXPECT_EQ(layout.cells[2].field.width, 480);
}

TEST_F(Layouts, NameALaneOnceInAColumn) {
    const Field field(8, 8, Site::Centre);
    std::vector<SheetRow> rows;
    for (int step = 0; step < 3; ++step) {
        rows.push_back({"step 240 · t = 4.00", {lane(field, 0), lane(field, 1)}});
    }
    SheetRequest request = request_of(rows);
    SheetLayout layout = lay_out(request, ui_.theme);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(layout.cells[k].head.has_value(), k < 2) << k;
    ASSERT_EQ(layout.labels.size(), 6u);
    EXPECT_EQ(layout.labels[2].text, "step 240");
    EXPECT_EQ(layout.labels[3].text, "t = 4.00");
    EXPECT_TRUE(layout.labels[2].first);
    const PixelRect& second = layout.cells[2].field;
    EXPECT_GT(layout.labels[2].at.y, static_cast<float>(second.y));
    EXPECT_LT(layout.labels[3].at.y, static_cast<float>(second.y + second.height));
    EXPECT_LT(layout.labels[2].at.x + 40, static_cast<float>(second.x)) << "left of the fields";
    EXPECT_EQ(layout.bar.x, static_cast<float>(second.x));

    request.rows[2].cells[1].title = "another lane";
    layout = lay_out(request, ui_.theme);
    EXPECT_TRUE(layout.cells[5].head.has_value());
    EXPECT_FALSE(layout.cells[4].head.has_value());
}

}  // namespace
}  // namespace whorl::app
