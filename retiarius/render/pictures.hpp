// Pictures of a recorded run, drawn without a display.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "retiarius/render/camera.hpp"
#include "retiarius/render/quantity.hpp"

namespace retiarius::render {

enum class Form { png, svg, pdf };

struct PictureOptions {
  View view = View::iso;
  Quantity colour = Quantity::tension;
  int width = 1200, height = 900;  // pixels (png), CSS pixels (svg), points (pdf)
};

// Throws InputError unless both are within 100 and 8000.
void check_size(const PictureOptions& options);

// The frames of DIR/run.h5 nearest to the given times (s; the last frame where there is none), each
// a file's content; of a pdf one file with a page for each. Every picture is framed by what it
// shows; colours have the same range in all. The same run, program and fonts give the same bytes.
// Throws InputError for a run that cannot be read and for a time that was not recorded.
std::vector<std::string> render_pictures(const std::filesystem::path& run,
                                         const std::vector<double>& times, Form form,
                                         const PictureOptions& options);

// The run's phases in one picture: its start and each phase's end, with name, time and a key
// measure. `width` is the page's; its height follows from the number of panels, `height` is not
// used. Throws as render_pictures.
std::string render_storyboard(const std::filesystem::path& run, Form form,
                              const PictureOptions& options);

}  // namespace retiarius::render
