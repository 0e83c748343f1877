#include "retiarius/render/pictures.hpp"

#include <cstring>
#include <regex>
#include <set>

#include <cairo.h>
#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/run_h5.hpp"
#include "retiarius/record/summary_json.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius::render {
namespace {

using testing::error_text;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::SampleRun;
using ::testing::StartsWith;
using testing::TemporaryFolder;

struct Image {
  int width = 0, height = 0;
  std::set<std::uint32_t> colours;
};

Image decoded(const std::string& png) {
  std::string_view rest = png;
  cairo_surface_t* surface = cairo_image_surface_create_from_png_stream(
      [](void* data, unsigned char* to, unsigned int length) {
        auto& bytes = *static_cast<std::string_view*>(data);
        if (bytes.size() < length) return CAIRO_STATUS_READ_ERROR;
        std::memcpy(to, bytes.data(), length);
        bytes.remove_prefix(length);
        return CAIRO_STATUS_SUCCESS;
      },
      &rest);
  Image image{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  for (int y = 0; y < image.height; ++y) {
    std::vector<std::uint32_t> row(static_cast<std::size_t>(image.width));
    std::memcpy(row.data(),
                cairo_image_surface_get_data(surface) +
                    static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface),
                4 * row.size());
    image.colours.insert(row.begin(), row.end());
  }
  cairo_surface_destroy(surface);
  return image;
}

std::size_t count_of(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  return static_cast<std::size_t>(std::distance(
      std::sregex_iterator(text.begin(), text.end(), expression), std::sregex_iterator()));
}

class Pictures : public ::testing::Test {
 protected:
  Pictures() {
    RunH5 recorder(folder_.path(), "", "0.1.0");
    sample_.feed(recorder, 11);  // frames at 0, 0.2 ... 1.0 s
    recorder.end(sample_.report());
  }
  std::vector<std::string> draw(const std::vector<double>& times, Form form) const {
    return render_pictures(folder_.path(), times, form, options_);
  }

  SampleRun sample_;
  TemporaryFolder folder_;
  PictureOptions options_{View::iso, Quantity::tension, 400, 300};
};

TEST_F(Pictures, PngHasTheSizeAskedForAndShowsSomething) {
  const Image image = decoded(draw({0.4}, Form::png).at(0));
  EXPECT_EQ(image.width, 400);
  EXPECT_EQ(image.height, 300);
  EXPECT_GT(image.colours.size(), 500u);
}

TEST_F(Pictures, EachTimeIsAFileOfItsOwnAndOfAPdfAPage) {
  const auto files = draw({0.0, 0.4, 1.0}, Form::png);
  ASSERT_EQ(files.size(), 3u);
  EXPECT_TRUE(files[0] != files[1]);
  const auto pdf = draw({0.0, 0.4, 1.0}, Form::pdf);
  ASSERT_EQ(pdf.size(), 1u);
  EXPECT_THAT(pdf[0], StartsWith("%PDF"));
  EXPECT_EQ(count_of(pdf[0], "/Type */Page[^s]"), 3u);
  EXPECT_THAT(pdf[0], HasSubstr("/Count 3"));
}

TEST_F(Pictures, WithoutATimeTheLastFrameIsDrawn) {
  EXPECT_TRUE(draw({}, Form::png) == draw({1.0}, Form::png));
  EXPECT_TRUE(draw({0.41}, Form::png) == draw({0.4}, Form::png));
}

TEST_F(Pictures, AreTheSameBytesEachTime) {
  for (Form form : {Form::png, Form::svg, Form::pdf})
    EXPECT_TRUE(draw({0.6}, form) == draw({0.6}, form)) << static_cast<int>(form);
  EXPECT_THAT(draw({0.6}, Form::pdf).at(0), Not(HasSubstr("CreationDate")));
}

TEST_F(Pictures, ColoursAndViewsMakeDifferentPictures) {
  std::set<std::string> seen;
  for (const char* name : {"tension", "strain", "curvature", "speed", "contact", "none"}) {
    options_.colour = quantity_named(name);
    EXPECT_TRUE(seen.insert(draw({0.6}, Form::png).at(0)).second) << name;
  }
  for (const char* name : {"front", "side", "top"}) {
    options_.view = view_named(name);
    EXPECT_TRUE(seen.insert(draw({0.6}, Form::png).at(0)).second) << name;
  }
}

TEST_F(Pictures, SvgIsInPixels) {
  EXPECT_THAT(draw({0.6}, Form::svg).at(0), HasSubstr("viewBox=\"0 0 400 300\""));
}

TEST_F(Pictures, ATimeThatWasNotRecordedIsAnError) {
  EXPECT_THAT(error_text<InputError>([&] { draw({3.0}, Form::png); }),
              HasSubstr("there is no frame at 3 s: the recording has frames from 0 to 1 s"));
  EXPECT_THAT(error_text<InputError>([&] { draw({-1.0}, Form::png); }), HasSubstr("at -1 s"));
  EXPECT_THAT(error_text<InputError>([&] { draw({std::nan("")}, Form::png); }), HasSubstr("nan"));
}

TEST_F(Pictures, SizesOutOfBoundsAreErrors) {
  options_.width = 99;
  EXPECT_THAT(error_text<InputError>([&] { draw({}, Form::png); }),
              HasSubstr("99x300 cannot be drawn: width and height must be from 100 to 8000"));
  options_.width = 8001;
  EXPECT_THROW(draw({}, Form::png), InputError);
}

TEST_F(Pictures, AFolderWithoutRecordingIsAnError) {
  EXPECT_THAT(
      error_text<InputError>([&] { render_pictures(folder_ / "no", {}, Form::png, options_); }),
      HasSubstr("no/run.h5"));
}

TEST_F(Pictures, TheStoryboardHasAPanelForTheStartAndEachPhase) {
  options_.width = 600;
  const Image image = decoded(render_storyboard(folder_.path(), Form::png, options_));
  EXPECT_EQ(image.width, 600);
  EXPECT_GT(image.colours.size(), 500u);
  // start, shoot, spread: three panels in a row, which is lower than it is wide.
  EXPECT_LT(image.height, 300);
  EXPECT_TRUE(render_storyboard(folder_.path(), Form::svg, options_) ==
              render_storyboard(folder_.path(), Form::svg, options_));
}

TEST_F(Pictures, WorkWithoutBodiesAndWithOneFrame) {
  TemporaryFolder folder;
  SampleRun sample;
  sample.bodies.clear();
  RunH5 recorder(folder.path(), "", "0.1.0");
  sample.feed(recorder, 1);
  recorder.end(sample.report());
  EXPECT_EQ(render_pictures(folder.path(), {}, Form::png, options_).size(), 1u);
  EXPECT_GT(decoded(render_storyboard(folder.path(), Form::png, options_)).colours.size(), 100u);
}

}  // namespace
}  // namespace retiarius::render
