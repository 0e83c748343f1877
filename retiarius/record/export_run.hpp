// What `retiarius export` does: the recorded data in other forms.
#pragma once

#include <cstddef>
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

// Writes a glTF 2.0 scene with its motion to the file `out`: the net as tubes (at least 1/2400 of
// its extent thick, so that they are seen), corner masses, bodies. Of a long run frames are left
// out evenly until the net's motion takes at most `most_bytes` (0: 64 MiB). Throws as export_vtk;
// InputError for a net of more than 65,535 nodes.
struct GlbReport {
  std::size_t written = 0, recorded = 0;  // frames
};
GlbReport export_glb(const std::filesystem::path& run, const std::filesystem::path& out,
                     std::size_t most_bytes = 0);

}  // namespace retiarius
