#include "retiarius/record/replay_chunk.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/minifloat.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using testing::error_text;
using ::testing::HasSubstr;

TEST(Minifloat, KeepsItsErrorOverManyOrdersOfMagnitude) {
  const Minifloat scale{1e-7, 128};
  for (int k = 0; k < 3600; ++k) {
    const double value = 1e-12 * std::pow(1.0137, k);  // up to 2e9
    const double error = std::abs(scale.value(scale.code(value)) - value);
    EXPECT_LE(error, std::max(0.5e-7, value / 256.0) * (1.0 + 1e-9)) << value;
    EXPECT_EQ(scale.code(-value), -scale.code(value));
  }
}

TEST(Minifloat, HasOneCodeForEachOfItsValuesInOrder) {
  const Minifloat scale{0.5, 8};
  double last = -1.0;
  for (int code = 0; code < 400; ++code) {
    EXPECT_GT(scale.value(code), last);
    last = scale.value(code);
    EXPECT_EQ(scale.code(last), code);
  }
}

TEST(ReplayChunks, AreReadBackAndStopWhereTheFileStops) {
  std::string file = replay_preamble() + replay_chunk("HEAD", "one") + replay_chunk("FRAM", "");
  const std::size_t whole = file.size();
  file += replay_chunk("FRAM", std::string(100, 'x'));
  const ReplayChunks all = read_chunks(file);
  ASSERT_EQ(all.chunks.size(), 3u);
  EXPECT_EQ(all.chunks[0].name, "HEAD");
  EXPECT_EQ(all.chunks[0].content, "one");
  EXPECT_EQ(all.chunks[2].content, std::string(100, 'x'));
  EXPECT_EQ(all.size, file.size());
  for (std::size_t size = whole; size < file.size(); ++size) {
    const ReplayChunks cut = read_chunks(std::string_view(file).substr(0, size));
    EXPECT_EQ(cut.chunks.size(), 2u) << size;
    EXPECT_EQ(cut.size, whole);
  }
  for (std::size_t size = 0; size < replay_preamble().size(); ++size)
    EXPECT_EQ(read_chunks(std::string_view(file).substr(0, size)).size, 0u) << size;
}

TEST(ReplayChunks, RefuseWhatIsDamagedOrForeign) {
  const std::string file = replay_preamble() + replay_chunk("HEAD", "content");
  for (std::size_t k = replay_preamble().size(); k < file.size(); ++k) {
    if (k - replay_preamble().size() >= 4 && k - replay_preamble().size() < 8)
      continue;  // the size
    std::string damaged = file;
    damaged[k] = static_cast<char>(damaged[k] ^ 1);
    EXPECT_THAT(error_text<InputError>([&] { read_chunks(damaged); }),
                HasSubstr("wrong checksum at byte 16"))
        << k;
  }
  EXPECT_THAT(error_text<InputError>([] { read_chunks("PK\3\4 something else"); }),
              HasSubstr("it is no recording"));
  EXPECT_THAT(error_text<InputError>([] { read_chunks("PK"); }), HasSubstr("it is no recording"));
  std::string newer = file;
  newer[8] = 2;
  EXPECT_THAT(error_text<InputError>([&] { read_chunks(newer); }),
              HasSubstr("the recording has format 2, this version reads format 1"));
}

TEST(ReplayChunks, InflateWhatTheyDeflate) {
  std::string text;
  for (int k = 0; k < 30000; ++k) text += static_cast<char>(k * k % 251);
  EXPECT_EQ(inflated(deflated(text)), text);
  EXPECT_EQ(inflated(deflated("")), "");
  const std::string whole = deflated(text);
  EXPECT_THAT(error_text<InputError>([&] { inflated(whole.substr(0, whole.size() / 2)); }),
              HasSubstr("does not inflate"));
}

}  // namespace
}  // namespace retiarius
