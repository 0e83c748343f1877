#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/run_h5.hpp"
#include "retiarius/render/encoder.hpp"
#include "retiarius/render/movie.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius::render {
namespace {

using testing::error_text;
using ::testing::HasSubstr;
using testing::SampleRun;
using ::testing::StartsWith;
using testing::TemporaryFolder;

bool ffmpeg_is_there() {
  try {
    require_ffmpeg();
    return true;
  } catch (const InputError&) {
    return false;
  }
}

class Film : public ::testing::Test {
 protected:
  Film() {
    RunH5 recorder(folder_.path(), "", "0.1.0");
    sample_.feed(recorder, 11);  // six frames within 1 s
    recorder.end(sample_.report());
  }
  FilmReport film(FilmForm form, const std::string& name, double speed = 1.0) {
    return render_film(folder_.path(), folder_ / name, form, options_, {speed});
  }

  SampleRun sample_;
  TemporaryFolder folder_;
  PictureOptions options_{View::iso, Quantity::speed, 160, 120};
};

TEST_F(Film, ShowsEachFrameInRealTime) {
  if (!ffmpeg_is_there()) GTEST_SKIP() << "ffmpeg is not found";
  const FilmReport report = film(FilmForm::mp4, "a.mp4");
  EXPECT_EQ(report.pictures, 6);
  EXPECT_NEAR(report.rate, 5.0, 1e-9);
  const std::string bytes = read_whole_file(folder_ / "a.mp4");
  EXPECT_EQ(bytes.substr(4, 4), "ftyp");
  film(FilmForm::mp4, "b.mp4");
  EXPECT_TRUE(bytes == read_whole_file(folder_ / "b.mp4")) << "two films of one run differ";
}

TEST_F(Film, SpeedChangesTheRateAndThinsFramesOutAboveTheLimit) {
  if (!ffmpeg_is_there()) GTEST_SKIP() << "ffmpeg is not found";
  const FilmReport report = film(FilmForm::gif, "a.gif", 10.0);
  EXPECT_EQ(report.pictures, 3);
  EXPECT_NEAR(report.rate, 25.0, 1e-9);
  EXPECT_THAT(read_whole_file(folder_ / "a.gif"), StartsWith("GIF89a"));
}

TEST_F(Film, WithoutFfmpegNamesThePackage) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder_.path().c_str(), 1);
  const std::string text = error_text<InputError>([&] { film(FilmForm::mp4, "a.mp4"); });
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_THAT(text, HasSubstr("apt-get install ffmpeg"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.mp4"));
}

TEST_F(Film, RefusesWhatCannotBeAFilm) {
  EXPECT_THAT(error_text<InputError>([&] { film(FilmForm::mp4, "a.mp4", 0.0); }),
              HasSubstr("speed is 0; it must be above 0"));
  options_.width = 161;
  EXPECT_THAT(error_text<InputError>([&] { film(FilmForm::mp4, "a.mp4"); }),
              HasSubstr("even width and height, not 161x120"));
}

TEST(Encoder, TellsWhatTheProgramSaidWhenItFails) {
  const std::string text = error_text<RunError>([] {
    Encoder encoder({"sh", "-c", "echo the disk is full >&2; exit 3"});
    for (int k = 0; k < 1000; ++k) encoder.write(std::string(10000, 'x'));
    encoder.finish();
  });
  EXPECT_EQ(text, "sh failed: the disk is full");
}

TEST(Encoder, PassesOnEveryByte) {
  TemporaryFolder folder;
  const std::string file = (folder / "bytes").string();
  Encoder encoder({"sh", "-c", "cat > " + file});
  std::string all;
  for (int k = 0; k < 300; ++k) {
    const std::string part(1000, static_cast<char>('a' + k % 26));
    encoder.write(part);
    all += part;
  }
  encoder.finish();
  EXPECT_TRUE(read_whole_file(file) == all);
}

}  // namespace
}  // namespace retiarius::render
