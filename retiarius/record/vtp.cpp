#include "retiarius/record/vtp.hpp"

#include <bit>
#include <cstring>
#include <iterator>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius {

namespace {

static_assert(std::endian::native == std::endian::little, "raw data are written as they lie");

// Collects the blocks of the appended section and the XML elements that point into it.
class Appended {
 public:
  template <class T>
  std::string element(const char* type, const std::string& name, int components,
                      const std::vector<T>& values) {
    const std::string xml = fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        type, name, components, blocks_.size());
    const std::uint64_t size = values.size() * sizeof(T);
    append(&size, sizeof size);
    append(values.data(), size);
    return xml;
  }

  const std::string& blocks() const { return blocks_; }

 private:
  void append(const void* data, std::size_t size) {
    blocks_.append(static_cast<const char*>(data), size);
  }
  std::string blocks_;
};

template <std::size_t N>
std::string cells_element(Appended& data, const char* kind,
                          const std::vector<std::array<Index, N>>& cells) {
  std::vector<std::int64_t> connectivity, offsets;
  for (const auto& cell : cells) {
    connectivity.insert(connectivity.end(), cell.begin(), cell.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  std::string xml = fmt::format("<{}>\n", kind);
  xml += data.element("Int64", "connectivity", 1, connectivity);
  xml += data.element("Int64", "offsets", 1, offsets);
  return xml + fmt::format("</{}>\n", kind);
}

std::string arrays_element(Appended& data, const char* kind, const std::vector<VtpArray>& arrays,
                           std::size_t count) {
  std::string xml = fmt::format("<{}>\n", kind);
  for (const VtpArray& array : arrays) {
    if (array.values.size() != count * static_cast<std::size_t>(array.components))
      throw Error(fmt::format("{} array {} has {} values for {} elements of {} components", kind,
                              array.name, array.values.size(), count, array.components));
    xml += data.element("Float32", array.name, array.components, array.values);
  }
  return xml + fmt::format("</{}>\n", kind);
}

std::string points_element(Appended& data, const std::vector<Vec3>& points) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vec3& x : points) coordinates.insert(coordinates.end(), x.begin(), x.end());
  return "<Points>\n" + data.element("Float64", "Points", 3, coordinates) + "</Points>\n";
}

}  // namespace

std::string vtp_text(const PolyData& data) {
  Appended appended;
  const std::size_t points = data.points->size();
  std::string xml = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n"
      "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n</FieldData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n",
      data.time, points, data.lines.size(), data.triangles.size());
  xml += arrays_element(appended, "PointData", data.point_data, points);
  xml += arrays_element(appended, "CellData", data.cell_data,
                        data.lines.size() + data.triangles.size());
  xml += points_element(appended, *data.points);
  xml += cells_element(appended, "Lines", data.lines);
  xml += cells_element(appended, "Polys", data.triangles);
  xml += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  xml += appended.blocks();
  return xml + "\n</AppendedData>\n</VTKFile>\n";
}

std::string pvd_text(const std::vector<PvdEntry>& entries) {
  std::string xml =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const PvdEntry& entry : entries)
    fmt::format_to(std::back_inserter(xml),
                   "<DataSet timestep=\"{}\" group=\"\" part=\"{}\" file=\"{}\"/>\n", entry.time,
                   entry.part, entry.file);
  return xml + "</Collection>\n</VTKFile>\n";
}

}  // namespace retiarius
