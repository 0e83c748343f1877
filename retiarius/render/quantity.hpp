// What the colour of the threads tells.
#pragma once

#include <string>
#include <vector>

#include "retiarius/record/run_file.hpp"
#include "retiarius/render/colour.hpp"

namespace retiarius::render {

enum class Quantity { tension, strain, curvature, speed, contact, none };

const std::vector<std::string>& quantity_names();
// Throws InputError that lists the names.
Quantity quantity_named(const std::string& name);

// "Tension (N)"; empty for none.
std::string quantity_title(Quantity quantity);

// The value on each segment: its own, or the mean of its two nodes' (of contact the greater). Empty
// for none. Throws InputError where the recording has no contact.
std::vector<double> segment_values(Quantity quantity, const NetDrawing& net,
                                   const FrameData& frame);

// The upper end of the colours' range: a round number above 98 % of the positive values in frames
// spread over the run. The lower end is 0.
double usual_range(Quantity quantity, const NetDrawing& net, const RunFile& run);

// The next of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten; 1 for what is not positive.
double rounded_up(double value);

Colour value_colour(Quantity quantity, double value, double high);

}  // namespace retiarius::render
