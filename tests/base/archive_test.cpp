#include "retiarius/base/archive.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"

namespace retiarius {
namespace {

enum class Colour { red, green = 7 };

struct Everything {
  double number = 0.0;
  std::int32_t small = 0;
  std::int64_t large = 0;
  std::uint64_t bits = 0;
  bool truth = false;
  Colour colour = Colour::red;
  Vec3 vector = Vec3::Zero();
  Quat attitude = Quat::Identity();
  std::string text;
  std::vector<bool> flags;
  std::vector<double> numbers;
  std::vector<Vec3> vectors;
  std::deque<std::vector<double>> lists;
  std::optional<double> present, absent = 1.0;

  void transfer(Archive& archive) {
    archive(number, small, large, bits, truth, colour, vector, attitude, text, flags, numbers,
            vectors, lists, present, absent);
  }
};

Everything sample() {
  Everything e;
  e.number = 5e-324;
  e.small = -3;
  e.large = std::numeric_limits<std::int64_t>::min();
  e.bits = 0xfedcba9876543210u;
  e.truth = true;
  e.colour = Colour::green;
  e.vector = Vec3(1, -0.0, 1e300);
  e.attitude = Quat(0.5, 0.5, -0.5, 0.5);
  e.text = std::string("a\0b", 3);
  e.flags = {true, false, true};
  e.numbers = {0.1, std::numeric_limits<double>::infinity()};
  e.vectors = {Vec3(1, 2, 3), Vec3(4, 5, 6)};
  e.lists = {{1.0}, {}, {2.0, 3.0}};
  e.present = 0.25;
  e.absent.reset();
  return e;
}

std::string bytes_of(Everything e) {
  Archive archive;
  archive(e);
  return archive.take();
}

TEST(Archive, GivesBackWhatItWasGiven) {
  const std::string bytes = bytes_of(sample());
  Everything back;
  back.numbers = {9.0};  // replaced
  Archive archive(bytes);
  EXPECT_TRUE(archive.reads());
  archive(back);
  EXPECT_TRUE(archive.finished());
  const Everything e = sample();
  EXPECT_EQ(back.number, e.number);
  EXPECT_EQ(back.small, e.small);
  EXPECT_EQ(back.large, e.large);
  EXPECT_EQ(back.bits, e.bits);
  EXPECT_TRUE(back.truth);
  EXPECT_EQ(back.colour, Colour::green);
  EXPECT_EQ(back.vector, e.vector);
  EXPECT_TRUE(std::signbit(back.vector.y()));
  EXPECT_EQ(back.attitude.coeffs(), e.attitude.coeffs());
  EXPECT_EQ(back.text, e.text);
  EXPECT_EQ(back.flags, e.flags);
  EXPECT_EQ(back.numbers, e.numbers);
  EXPECT_EQ(back.vectors, e.vectors);
  EXPECT_EQ(back.lists, e.lists);
  EXPECT_EQ(back.present, e.present);
  EXPECT_FALSE(back.absent);
}

TEST(Archive, WritesNumbersLittleEndian) {
  Archive archive;
  std::int32_t number = 0x01020304;
  archive(number);
  EXPECT_EQ(archive.take(), "\x04\x03\x02\x01");
}

TEST(Archive, RefusesBytesThatEndTooEarly) {
  const std::string bytes = bytes_of(sample());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    Everything e;
    Archive archive(std::string_view(bytes).substr(0, size));
    EXPECT_THROW(archive(e), Error) << size;
  }
}

// A length of nonsense must not ask for memory.
TEST(Archive, RefusesAListLongerThanItsBytes) {
  Archive writer;
  std::uint64_t length = std::uint64_t{1} << 60;
  writer(length);
  const std::string bytes = writer.take();
  std::vector<double> numbers;
  Archive first{bytes};
  EXPECT_THROW(first(numbers), Error);
  std::string text;
  Archive second{bytes};
  EXPECT_THROW(second(text), Error);
}

}  // namespace
}  // namespace retiarius
