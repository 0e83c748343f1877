#include "program/text_table.hpp"

#include <gtest/gtest.h>

namespace retiarius::program {
namespace {

TEST(TextTable, AlignsColumnsAndTrimsLines) {
  TextTable table;
  EXPECT_TRUE(table.empty());
  EXPECT_EQ(table.text(), "");
  table.add("a", "1 kg");
  table.add({"long name", "2", "third"});
  table.add({"b", ""});
  EXPECT_EQ(table.text(), "  a          1 kg\n  long name  2     third\n  b\n");
}

TEST(Quantity, HasFourDigitsAndItsUnit) {
  EXPECT_EQ(quantity(3.14159265, "m"), "3.142 m");
  EXPECT_EQ(quantity(0.5, ""), "0.5");
}

TEST(ByteCount, UsesDecimalUnits) {
  EXPECT_EQ(byte_count(0), "0 B");
  EXPECT_EQ(byte_count(999), "999 B");
  EXPECT_EQ(byte_count(999.6), "1 kB");
  EXPECT_EQ(byte_count(8.5e9), "8.5 GB");
  EXPECT_EQ(byte_count(1e21), "1e+06 PB");
}

TEST(Duration, GrowsFromSecondsToDays) {
  EXPECT_EQ(duration(0.0), "0 s");
  EXPECT_EQ(duration(0.423), "0.42 s");
  EXPECT_EQ(duration(9.97), "10 s");
  EXPECT_EQ(duration(59.4), "59 s");
  EXPECT_EQ(duration(59.7), "1 min 00 s");
  EXPECT_EQ(duration(185), "3 min 05 s");
  EXPECT_EQ(duration(7620), "2 h 07 min");
  EXPECT_EQ(duration(86400 * 3), "3 days");
  EXPECT_NE(duration(1e300), "");
}

}  // namespace
}  // namespace retiarius::program
