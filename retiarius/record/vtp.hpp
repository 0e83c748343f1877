// VTK XML PolyData (.vtp), as ParaView opens it.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "retiarius/base/vec.hpp"

namespace retiarius {

// A named array with `components` values for each point or cell.
struct VtpArray {
  std::string name;
  int components = 1;
  std::vector<float> values;
};

// Points, with lines or triangles between them.
struct PolyData {
  const std::vector<Vec3>* points = nullptr;
  std::vector<std::array<Index, 2>> lines;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<VtpArray> point_data;
  std::vector<VtpArray> cell_data;  // lines first, then triangles
  double time = 0.0;                // s, written as field TimeValue
};

// The file's text: header, then raw appended little-endian data (coordinates float64, arrays
// float32, indices int64, block sizes uint64), uncompressed. Throws Error when the length of an
// array does not fit.
std::string vtp_text(const PolyData& data);

// Entries of a .pvd file: which file shows what at which time. A body or net is one part.
struct PvdEntry {
  double time = 0.0;
  int part = 0;
  std::string file;  // relative to the .pvd
};
std::string pvd_text(const std::vector<PvdEntry>& entries);

}  // namespace retiarius
