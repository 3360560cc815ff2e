// SPDX-License-Identifier: GPL-3.0-or-later
// What a page is made of: axes, thinned curves, small pictures, and the blocks that its script reads.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "reports/axis.hpp"
#include "reports/defect_view.hpp"
#include "reports/html.hpp"
#include "reports/live_figure.hpp"
#include "reports/page_picture.hpp"
#include "reports/thinned_curve.hpp"

namespace mdana {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Axis, EnclosesItsValuesBetweenRoundNumbers) {
  EXPECT_EQ(Axis({0, 38.3}, false).ticks(), (std::vector<double>{0, 5, 10, 15, 20, 25, 30, 35, 40}));
  EXPECT_EQ(Axis({0.02, 3}, true).ticks(), (std::vector<double>{0.01, 0.1, 1, 10}));
  for (const double scale : {1e-300, 1e-9, 1.0, 1e9, 1e300})
    for (const double least : {-7.3, 0.0, 2.2, 9.99}) {
      const Axis axis({least * scale, 10 * scale}, false);
      EXPECT_LE(axis.place(axis.ticks().front()), 1e-12);
      EXPECT_LE(axis.ticks().front(), least * scale * (1 + 1e-12 * (least < 0 ? -1 : 1)));
      EXPECT_GE(axis.ticks().back(), 10 * scale * (1 - 1e-12));
      EXPECT_GE(axis.ticks().size(), 4u);
      EXPECT_LE(axis.ticks().size(), 13u);
    }
}

TEST(Axis, TakesWhatHasNoLengthAndLeavesOutWhatHasNoPlace) {
  const Axis one({5, 5, nan}, false);
  EXPECT_LT(one.ticks().front(), 5);
  EXPECT_GT(one.ticks().back(), 5);
  EXPECT_NEAR(one.place(5), 0.5, 0.2);
  EXPECT_TRUE(Axis({0, -1, nan}, true).empty());
  EXPECT_TRUE(Axis({}, false).empty());
  EXPECT_TRUE(Axis({-1.7e308, 1.7e308}, false).empty());
  EXPECT_FALSE(Axis({0}, false).empty());
}

TEST(ThinnedCurve, StaysWithinTheToleranceAndKeepsTheEnds) {
  std::vector<Eigen::Vector2d> circle, line;
  for (int i = 0; i <= 1000; ++i) {
    circle.emplace_back(100 * std::cos(0.006 * i), 100 * std::sin(0.006 * i));
    line.emplace_back(i, 2 * i);
  }
  EXPECT_EQ(thinned_curve(line, 1e-9).size(), 2u);
  const auto kept = thinned_curve(circle, 0.1);
  EXPECT_EQ(kept.front(), circle.front());
  EXPECT_EQ(kept.back(), circle.back());
  // A chord of a circle of radius r that sags by s spans 2 acos(1 - s/r): 6 rad need at least 68.
  EXPECT_GE(kept.size(), 68u);
  EXPECT_LE(kept.size(), 140u);
  for (std::size_t k = 0; k + 1 < kept.size(); ++k) EXPECT_GE((kept[k] + kept[k + 1]).norm() / 2, 100 - 0.1);
}

Figure straight() {
  Figure figure{"straight", "A </script> line", "x", "y", "Straight.", {}};
  figure.series.push_back({"<b>line</b>", {0, 0.5, 1}, {0, 0.5, 1}});
  return figure;
}

TEST(PagePicture, DrawsAStraightLineFromCornerToCorner) {
  const std::string svg = page_picture(straight());
  EXPECT_NE(svg.find("d='M80.0,400.0L700.0,60.0'"), std::string::npos) << svg;
  EXPECT_NE(svg.find("&lt;b&gt;line"), std::string::npos);
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
}

TEST(PagePicture, BreaksACurveWhereThereIsNoNumber) {
  Figure figure = straight();
  figure.series[0] = {"line", {0, 1, nan, 2, 3}, {0, 1, 5, 2, 3}};
  const std::string svg = page_picture(figure);
  EXPECT_NE(svg.find("L286.7,286.7M493.3,173.3L"), std::string::npos) << svg;
  figure.series[0].x.assign(5, nan);
  EXPECT_EQ(page_picture(figure), "");
}

TEST(LiveFigure, TellsTheScriptWhatToDraw) {
  Figure figure = straight();
  figure.log_y = true;
  figure.series[0].y[1] = nan;
  figure.series[0].y_error = {0.1, 0.1, 1.0 / 3};
  figure.series[0].run = "r";
  figure.series[0].style = Series::Style::points;
  EXPECT_EQ(figure_json(figure).dump(),
            R"({"title":"A </script> line","alt":"Straight.","x":{"label":"x","log":false},)"
            R"("y":{"label":"y","log":true},"series":[{"label":"<b>line</b>","run":"r","style":"points",)"
            R"("x":[0.0,0.5,1.0],"y":[0.0,null,1.0],"y_error":[0.1,0.1,0.333333]}]})");
}

TEST(LiveFigure, ABlockEndsOnlyAtItsEnd) {
  const std::string block = html::data_block("a\"b", R"({"t":"</script><!--"})");
  EXPECT_EQ(block, "<script type=\"application/json\" id=\"a&quot;b\">"
                   "{\"t\":\"\\u003c/script>\\u003c!--\"}</script>\n");
}

// Box 0 to 1: the ends are 32767 steps from its centre; little-endian 0x8001 and 0x7fff.
TEST(DefectView, PacksPositionsIn16Bits) {
  DefectView view{"v", "t", "a", "σ", {{"frame", {}, {viewed_line("hirth", {{0, 0, 0}, {1, 0, 0}})}, {}}}};
  const auto line = view_json(view)["frames"][0]["lines"][0];
  EXPECT_EQ(line["colour"], "#d8b800");
  EXPECT_EQ(line["at"]["int16"], "AYAAAAAA/38AAAAA");
  EXPECT_EQ(line["at"]["origin"], (std::vector<double>{0.5, 0, 0}));
  EXPECT_DOUBLE_EQ(line["at"]["step"], 1.0 / 65534);
  EXPECT_EQ(viewed_line("no such family", {}).colour, "#e02020");
}

/// Three atoms along x: fcc, hcp, bulk defect.
struct ThreeAtoms : LabelledAtoms {
  std::size_t size() const override { return 3; }
  void for_blocks(const std::function<void(const FrameAtoms&, const AtomLabels&)>& use) const override {
    AtomLabels labels;
    labels.structure = {Structure::fcc, Structure::hcp, Structure::other};
    labels.site = {Site::crystal, Site::crystal, Site::bulk_defect};
    use({{0, 1, 2}, {0, 0, 0}, {0, 0, 0}, {1, 1, 1}, {}, {}}, labels);
  }
};

TEST(DefectView, ShowsHcpAtomsDefectsAndFaults) {
  FrameDefects defects;
  defects.atoms = std::make_shared<ThreeAtoms>();
  defects.spacing = 1.1;
  DislocationSegment segment;
  segment.family = LineFamily::shockley;
  segment.burgers = {1.0 / 6, 1.0 / 6, -1.0 / 3};
  segment.points = {{0, 0, 0}, {2, 0, 0}};
  segment.length = {2, 0.1, dimension::length};
  defects.lines.segments.push_back(segment);
  defects.planes.push_back({PlanarFault::twin, 1, {0, 0, 1}, {5, 5, 5}, 4, 0, 9});
  const ViewedFrame frame = viewed_frame(defects, "step 7");
  ASSERT_EQ(frame.atoms.size(), 2u);
  EXPECT_EQ(frame.atoms[0].at, (std::vector<Eigen::Vector3d>{{1, 0, 0}}));
  EXPECT_EQ(frame.atoms[1].at, (std::vector<Eigen::Vector3d>{{2, 0, 0}}));
  EXPECT_DOUBLE_EQ(frame.atoms[0].diameter, 0.88);
  ASSERT_EQ(frame.planes.size(), 1u);
  EXPECT_EQ(frame.planes[0].area, 4);
  ASSERT_EQ(frame.lines.size(), 1u);
  EXPECT_EQ(frame.lines[0].name, "Shockley partials");
  EXPECT_EQ(frame.lines[0].burgers, "[0.167 0.167 -0.333]");
  EXPECT_EQ(frame.lines[0].length, 2);
  double area = 0;  // of the polygon, in the plane z = 5
  const auto& c = frame.planes[0].corners;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const Eigen::Vector3d& next = c[(k + 1) % c.size()];
    EXPECT_DOUBLE_EQ(c[k].z(), 5);
    area += (c[k].x() * next.y() - c[k].y() * next.x()) / 2;
  }
  EXPECT_NEAR(std::abs(area), 4, 1e-12);
}

TEST(DefectView, LimitsKeepGuidesAndTellWhatIsLeftOut) {
  ViewedFrame frame{"end", {{"hcp atoms", "#e0574f", 1, std::vector<Eigen::Vector3d>(10, {1, 2, 3})}}, {}, {}};
  for (const char* family : {"perfect", "shockley", "frank"}) frame.lines.push_back(viewed_line(family, {{0, 0, 0}, {1, 0, 0}}));
  for (ViewedLine& circle : viewed_sphere("sphere", {1, 2, 3}, 5, {1, 1, 0})) {
    for (const Eigen::Vector3d& p : circle.at) EXPECT_NEAR((p - Eigen::Vector3d(1, 2, 3)).norm(), 5, 1e-12);
    frame.lines.push_back(std::move(circle));
  }
  frame.planes.resize(4);
  ViewedFrame whole = frame;
  limit(whole, {10, 3, 4});
  EXPECT_EQ(shown_label(whole), "end");
  EXPECT_EQ(whole.lines.size(), 5u);
  limit(frame, {4, 2, 1});
  EXPECT_EQ(shown_label(frame), "end, one atom of 3, without the 4 smallest lines and faults");
  EXPECT_EQ(frame.atoms[0].at.size(), 4u);
  EXPECT_EQ(frame.planes.size(), 1u);
  ASSERT_EQ(frame.lines.size(), 4u);
  EXPECT_EQ(frame.lines[1].name, "Shockley partials");
  EXPECT_TRUE(frame.lines[2].guide && frame.lines[3].guide);
}

TEST(DefectView, StillPictureTakesNothingAndOnePoint) {
  EXPECT_EQ(still_picture({}).find("circle"), std::string::npos);
  const std::string one = still_picture({"", {{"hcp atoms", "#e0574f", 1, {{3, 4, 5}}}}, {}, {}});
  EXPECT_NE(one.find("x='360' y='230'"), std::string::npos) << one;
}

}  // namespace
}  // namespace mdana
