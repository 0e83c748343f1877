// What `retiarius export` does: the recorded data in other forms.
#pragma once

#include <filesystem>

namespace retiarius {

// Writes the frames of DIR/run.h5 as frames/*.vtp and frames.pvd below `out` (created if needed).
// `out` must be new or empty.
// Throws InputError when the run cannot be read, RunError when the result cannot be written.
void export_vtk(const std::filesystem::path& run, const std::filesystem::path& out);

// Writes below `out`: history.csv, as the run writes it; nodes.csv (frame, time, node, position,
// velocity, curvature), segments.csv (frame, time, segment, tension, strain) and bodies.csv
// (frame, time, body, position, attitude, velocity, angular momentum). Throws as export_vtk.
void export_csv(const std::filesystem::path& run, const std::filesystem::path& out);

}  // namespace retiarius
