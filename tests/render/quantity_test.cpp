#include "retiarius/render/quantity.hpp"

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius::render {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Quantity, SegmentsShowTheirOwnValueOrThatOfTheirNodes) {
  NetDrawing net;
  net.segments = {{0, 1}, {1, 2}};
  FrameData frame;
  frame.x.resize(3);
  frame.v = {Vec3(3, 4, 0), Vec3(0, 0, 1), Vec3(0, 0, 0)};
  frame.tension = {7.0, 8.0};
  frame.strain = {0.1, 0.2};
  frame.curvature = {2.0, 4.0, 0.0};
  frame.contact = {0, 1, 2};
  EXPECT_THAT(segment_values(Quantity::tension, net, frame), ElementsAre(7.0, 8.0));
  EXPECT_THAT(segment_values(Quantity::strain, net, frame), ElementsAre(0.1, 0.2));
  EXPECT_THAT(segment_values(Quantity::curvature, net, frame), ElementsAre(3.0, 2.0));
  EXPECT_THAT(segment_values(Quantity::speed, net, frame), ElementsAre(3.0, 0.5));
  EXPECT_THAT(segment_values(Quantity::contact, net, frame), ElementsAre(1.0, 2.0));
  EXPECT_TRUE(segment_values(Quantity::none, net, frame).empty());
  frame.contact.clear();
  EXPECT_THAT(
      testing::error_text<InputError>([&] { segment_values(Quantity::contact, net, frame); }),
      HasSubstr("this run's recording has no contact"));
}

TEST(Quantity, RangesEndAtRoundNumbers) {
  EXPECT_DOUBLE_EQ(rounded_up(0.0), 1.0);
  EXPECT_DOUBLE_EQ(rounded_up(1.0), 1.0);
  EXPECT_DOUBLE_EQ(rounded_up(1.01), 1.5);
  EXPECT_DOUBLE_EQ(rounded_up(0.034), 0.04);
  EXPECT_DOUBLE_EQ(rounded_up(930.0), 1000.0);
}

TEST(Quantity, NamesThemWhereThereIsNone) {
  EXPECT_EQ(quantity_named("speed"), Quantity::speed);
  EXPECT_THAT(testing::error_text<InputError>([] { quantity_named("heat"); }),
              HasSubstr("tension, strain, curvature, speed, contact, none"));
}

}  // namespace
}  // namespace retiarius::render
