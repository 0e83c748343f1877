#include "retiarius/render/movie.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/render/canvas.hpp"
#include "retiarius/render/encoder.hpp"
#include "retiarius/render/picture_page.hpp"

namespace retiarius::render {

namespace {

constexpr std::size_t kFramedBy = 48;  // frames that the camera's place is chosen from

struct Selection {
  std::vector<std::size_t> frames;
  double rate = 0.0;
};

Selection select(const std::vector<double>& times, double speed, double fastest) {
  Selection selection;
  const double seconds = (times.back() - times.front()) / speed;
  const double all = static_cast<double>(times.size() - 1) / seconds;
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(all / fastest - 1e-9)));
  selection.rate = all / static_cast<double>(stride);
  for (std::size_t k = 0; k < times.size(); k += stride) selection.frames.push_back(k);
  return selection;
}

Camera steady_camera(const DrawnRun& run, const PictureOptions& options, double size) {
  std::vector<Vec3> points;
  const std::size_t count = run.times.size(), samples = std::min(count, kFramedBy);
  for (std::size_t k = 0; k < samples; ++k)
    add_points(run, run.file.frame(k * (count - 1) / std::max<std::size_t>(1, samples - 1)), true,
               points);
  return {options.view, points,
          drawing_area({0.0, 0.0, double(options.width), double(options.height)}, size)};
}

std::vector<std::string> ffmpeg_command(FilmForm form, const PictureOptions& options, double rate,
                                        const std::filesystem::path& out) {
  std::vector<std::string> words = {"ffmpeg",   "-hide_banner", "-loglevel", "error", "-y", "-f",
                                    "rawvideo", "-pix_fmt",     "bgr0",      "-s",    "",   "-r",
                                    "",         "-i",           "-",         "-an"};
  words[10] = fmt::format("{}x{}", options.width, options.height);
  words[12] = fmt::format("{:.6f}", rate);
  const std::vector<std::string> coding =
      form == FilmForm::mp4
          ? std::vector<std::string>{"-c:v",      "libx264",    "-crf",    "18",       "-preset",
                                     "medium",    "-pix_fmt",   "yuv420p", "-threads", "1",
                                     "-movflags", "+faststart", "-f",      "mp4"}
          : std::vector<std::string>{"-vf",
                                     "split[a][b];[a]palettegen=stats_mode=diff[p];"
                                     "[b][p]paletteuse=dither=bayer:bayer_scale=4",
                                     "-f", "gif"};
  words.insert(words.end(), coding.begin(), coding.end());
  // Without these the file would hold the encoder's version.
  words.insert(words.end(), {"-fflags", "+bitexact", "-flags:v", "+bitexact"});
  words.push_back("file:" + out.string());
  return words;
}

}  // namespace

FilmReport render_film(const std::filesystem::path& folder, const std::filesystem::path& out,
                       FilmForm form, const PictureOptions& options, const FilmOptions& film) {
  check_size(options);
  if (!(film.speed > 0.0 && std::isfinite(film.speed)))
    throw InputError(fmt::format("the film's speed is {:g}; it must be above 0", film.speed));
  if (form == FilmForm::mp4 && (options.width % 2 != 0 || options.height % 2 != 0))
    throw InputError(fmt::format("an mp4 needs an even width and height, not {}x{}", options.width,
                                 options.height));
  const DrawnRun run(folder);
  if (run.times.size() < 2 || !(run.times.back() > run.times.front()))
    throw InputError("a film needs at least two frames at different times; this run has fewer");
  require_ffmpeg();
  const Selection selection = select(run.times, film.speed, form == FilmForm::mp4 ? 50.0 : 25.0);
  const Look look{options.colour, usual_range(options.colour, run.net, run.file),
                  usual_size(options)};
  const Camera camera = steady_camera(run, options, look.size);
  Encoder encoder(ffmpeg_command(form, options, selection.rate, out));
  for (std::size_t k : selection.frames) {
    Canvas canvas(Form::png, options.width, options.height);
    draw_page(canvas.context(), run, run.file.frame(k), camera, options, look);
    encoder.write(canvas.pixels());
  }
  encoder.finish();
  return {static_cast<int>(selection.frames.size()), selection.rate};
}

}  // namespace retiarius::render
