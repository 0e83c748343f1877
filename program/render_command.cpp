// retiarius render DIR: pictures and films of a run, without a browser or a display.
#include <charconv>
#include <memory>

#include <fmt/format.h>

#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/console.hpp"
#include "retiarius/base/error.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/render/movie.hpp"
#include "retiarius/render/pictures.hpp"

namespace retiarius::program {

namespace {

namespace fs = std::filesystem;

struct RenderArguments {
  std::string run, form = "png", view = "iso", colour = "tension", size, out;
  std::vector<double> times;
  double speed = 1.0;
  bool storyboard = false;
};

// "1200x900".
void read_size(const std::string& text, render::PictureOptions& options) {
  const char* const end = text.data() + text.size();
  const auto [x, error] = std::from_chars(text.data(), end, options.width);
  if (error == std::errc() && x != end && *x == 'x') {
    const auto [last, other] = std::from_chars(x + 1, end, options.height);
    if (other == std::errc() && last == end) return check_size(options);
  }
  throw InputError(
      fmt::format("--size {} is not of the form WIDTHxHEIGHT, such as 1200x900", text));
}

render::PictureOptions picture_options(const RenderArguments& arguments) {
  render::PictureOptions options;
  options.view = render::view_named(arguments.view);
  options.colour = render::quantity_named(arguments.colour);
  if (!arguments.size.empty()) read_size(arguments.size, options);
  return options;
}

bool is_film(const RenderArguments& arguments) {
  return arguments.form == "mp4" || arguments.form == "gif";
}

void check_combination(const RenderArguments& arguments) {
  if (is_film(arguments) && (arguments.storyboard || !arguments.times.empty()))
    throw InputError("a film shows the whole run: leave out --time and --storyboard");
  if (arguments.storyboard && !arguments.times.empty())
    throw InputError("a storyboard shows each phase's end: leave out --time");
  if (!is_film(arguments) && arguments.speed != 1.0)
    throw InputError("--speed is for films: add --to mp4 or --to gif");
}

// One name where there is one file, else "name-1.png", "name-2.png" and so on.
fs::path numbered(const fs::path& out, std::size_t number, std::size_t count) {
  if (count == 1) return out;
  return out.parent_path() /
         fmt::format("{}-{}{}", out.stem().string(), number + 1, out.extension().string());
}

void render_run(const RenderArguments& arguments) {
  check_combination(arguments);
  const render::PictureOptions options = picture_options(arguments);
  const fs::path run = arguments.run;
  const char* const name = is_film(arguments)     ? "film"
                           : arguments.storyboard ? "storyboard"
                                                  : "picture";
  const fs::path out = arguments.out.empty() ? run / fmt::format("{}.{}", name, arguments.form)
                                             : fs::path(arguments.out);
  if (is_film(arguments)) {
    const auto form = arguments.form == "mp4" ? render::FilmForm::mp4 : render::FilmForm::gif;
    const render::FilmReport film = render_film(run, out, form, options, {arguments.speed});
    print(fmt::format("{} written: {} pictures, {:.3g} a second\n", out.string(), film.pictures,
                      film.rate));
    return;
  }
  const auto form = arguments.form == "png"   ? render::Form::png
                    : arguments.form == "svg" ? render::Form::svg
                                              : render::Form::pdf;
  const std::vector<std::string> files = arguments.storyboard
                                             ? std::vector{render_storyboard(run, form, options)}
                                             : render_pictures(run, arguments.times, form, options);
  for (std::size_t k = 0; k < files.size(); ++k) {
    const fs::path file = numbered(out, k, files.size());
    write_atomically(file, files[k]);
    print(fmt::format("{} written\n", file.string()));
  }
}

}  // namespace

void add_render_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("render", "Draw pictures or a film of a run, without a display");
  auto arguments = std::make_shared<RenderArguments>();
  command->add_option("DIR", arguments->run, "Folder of a run")->required()->type_name("");
  command
      ->add_option("--time", arguments->times,
                   "Times to draw, s: the frames nearest to them; default the last one")
      ->type_name("T...");
  command->add_flag("--storyboard", arguments->storyboard,
                    "Draw the start and every phase's end in one picture with captions");
  command
      ->add_option("--to", arguments->form,
                   "Form: png (default), svg, pdf; mp4 and gif are films and need ffmpeg")
      ->type_name("FORM")
      ->check(quiet(CLI::IsMember({"png", "svg", "pdf", "mp4", "gif"})));
  command->add_option("--view", arguments->view, "From where: iso (default), front, side, top")
      ->type_name("NAME")
      ->check(quiet(CLI::IsMember(render::view_names())));
  command
      ->add_option("--color", arguments->colour,
                   "What threads show: tension (default), strain, curvature, speed, contact, none")
      ->type_name("NAME")
      ->check(quiet(CLI::IsMember(render::quantity_names())));
  command
      ->add_option("--size", arguments->size,
                   "Pixels, of a pdf points; default 1200x900; a storyboard takes the width only")
      ->type_name("WxH");
  command
      ->add_option("--speed", arguments->speed,
                   "Of a film: simulated seconds in one second; default 1")
      ->type_name("X");
  command
      ->add_option("--out", arguments->out,
                   "File to write; default picture, storyboard or film in DIR; several pictures "
                   "are numbered")
      ->type_name("FILE");
  command->callback([arguments] { render_run(*arguments); });
}

}  // namespace retiarius::program
