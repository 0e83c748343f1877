// Films of a recorded run.
#pragma once

#include <filesystem>

#include "retiarius/render/pictures.hpp"

namespace retiarius::render {

enum class FilmForm { mp4, gif };

struct FilmOptions {
  double speed = 1.0;  // simulated seconds in one of the film
};

struct FilmReport {
  int pictures = 0;
  double rate = 0.0;  // pictures a second
};

// Writes the run's frames as a film, seen from one place that has all of them in view: each frame
// once where that is at most 50 (mp4) or 25 (gif) a second, else evenly chosen ones. Nothing is
// interpolated. Throws as render_pictures; InputError without ffmpeg, for a single frame, or for an
// mp4 of odd width or height; RunError where ffmpeg fails.
FilmReport render_film(const std::filesystem::path& run, const std::filesystem::path& out,
                       FilmForm form, const PictureOptions& options, const FilmOptions& film);

}  // namespace retiarius::render
