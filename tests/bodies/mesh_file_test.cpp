#include "retiarius/bodies/mesh_file.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "tests/bodies/sample_meshes.hpp"

namespace retiarius {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::string text_stl(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  text << "solid part\n";
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    text << "  facet normal 0 0 0\n    outer loop\n";
    for (const Vec3& p : test::corners_of(mesh, k)) {
      text << "      vertex " << p.x() << " " << p.y() << " +" << std::abs(p.z()) << "\r\n";
    }
    text << "    endloop\n  endfacet\n";
  }
  text << "endsolid part\n";
  return text.str();
}

std::string binary_stl(const TriangleMesh& mesh) {
  std::string bytes = "solid is also how some binary files begin";
  bytes.resize(80, ' ');
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (std::size_t k = 0; k < count; ++k) {
    std::array<float, 12> numbers{};
    std::size_t next = 3;
    for (const Vec3& p : test::corners_of(mesh, k)) {
      for (const double x : p) numbers[next++] = static_cast<float>(x);
    }
    bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
    bytes.append(2, '\0');
  }
  return bytes;
}

// A folder of its own that goes with the test.
class MeshFile : public testing::Test {
 protected:
  MeshFile() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("mesh_") + info->name());
    std::filesystem::create_directories(folder_);
  }
  ~MeshFile() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return (folder_ / name).string();
  }
  void refused(const std::string& name, const std::string& content, const std::string& text) const {
    const std::string path = write(name, content);
    EXPECT_THAT([&] { read_mesh(path); }, ThrowsMessage<InputError>(HasSubstr(path + ":" + text)));
  }

  std::filesystem::path folder_;
};

// The upper half only has z of one sign, so that text may write it with a plus.
TriangleMesh upper_box() { return test::shifted(test::box(Vec3::Ones()), Vec3(0.0, 0.0, 2.0)); }

TEST_F(MeshFile, ReadsTextStl) {
  const TriangleMesh mesh = read_mesh(write("a.stl", text_stl(upper_box())));
  ASSERT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(mesh.vertices.size(), 36u);
  EXPECT_EQ(mesh.vertices[1], test::corners_of(upper_box(), 0)[1]);
}

TEST_F(MeshFile, ReadsBinaryStl) {
  const TriangleMesh mesh = read_mesh(write("a.STL", binary_stl(upper_box())));
  ASSERT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(mesh.vertices[35], test::corners_of(upper_box(), 11)[2]);
}

TEST_F(MeshFile, ReadsObjWithDoublePrecisionAndPolygons) {
  const TriangleMesh mesh = read_mesh(write("a.obj",
                                            "# a pyramid\no p\nv 0.1 0 0\nv 1 0 0\nv 1 1 0\n"
                                            "v 0 1 0\nv 0.5 0.5 1e-1\nvn 0 0 1\nf 4 3 2 1\n"
                                            "f 1//1 2//1 5//1\nf 2 3 5\nf -3 -2 -1\nf 4 1 5\n"));
  ASSERT_EQ(mesh.vertices.size(), 5u);
  EXPECT_EQ(mesh.vertices[0].x(), 0.1);
  EXPECT_EQ(mesh.triangles.size(), 6u);
}

TEST_F(MeshFile, NamesFilesThatAreNone) {
  const std::string gone = (folder_ / "gone.stl").string();
  EXPECT_THAT([&] { read_mesh(gone); }, ThrowsMessage<InputError>(gone + ": no such mesh file"));
  const std::string folder = (folder_ / "sub.obj").string();
  std::filesystem::create_directory(folder);
  EXPECT_THAT([&] { read_mesh(folder); },
              ThrowsMessage<InputError>(folder + ": is a directory; an STL or OBJ file is wanted"));
  refused("a.ply", "ply", " the name of a mesh file must end in .stl or .obj");
  refused("empty.stl", "", " the mesh file is empty");
  refused("empty.obj", "", " the mesh file is empty");
}

TEST_F(MeshFile, RefusesJunk) {
  std::string junk;
  for (int k = 0; k < 300; ++k) junk.push_back(static_cast<char>(k * 37));
  refused("junk.stl", junk,
          " not an STL file: it does not begin with \"solid\" as text does, and "
          "has 300 bytes, where binary STL of");
  refused("short.stl", "hello",
          " not an STL file: it does not begin with \"solid\" as text does, "
          "and is too short for binary STL");
  refused("junk.obj", junk, " not an OBJ file: it holds binary data");
  std::string cut = binary_stl(upper_box());
  cut.resize(cut.size() - 7);
  refused("cut.stl", cut, " not an STL file");
  refused("words.stl", "solid x\nlorem ipsum\n", "2: unknown word \"lorem\"");
  refused("words.obj", "lorem ipsum\n", " the mesh has no triangles");
}

TEST_F(MeshFile, NamesTheLineOfABadNumber) {
  refused("nan.stl", "solid x\nouter loop\nvertex 0 nan 0\n",
          "3: the coordinate \"nan\" is not "
          "finite");
  refused("word.stl", "solid x\nouter loop\nvertex 0 1m 0\n", "3: \"1m\" is not a number");
  refused("inf.obj", "v 0 0 0\nv 1 inf 0\n", "2: the coordinate \"inf\" is not finite");
  refused("word.obj", "\nv 0 zero 0\n", "2: \"zero\" is not a number");
  refused("few.obj", "v 0 1\n", "1: a vertex needs three numbers");
  refused("few.stl", "solid x\nouter loop\nvertex 0 1\n", "3: a vertex needs three numbers");
  TriangleMesh mesh = upper_box();
  mesh.vertices[0].x() = std::nan("");
  refused("nan_binary.stl", binary_stl(mesh), " triangle 1 has a coordinate that is not finite");
}

TEST_F(MeshFile, RefusesFacetsThatAreNoTriangles) {
  const std::string start = "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  refused("two.stl", start + "endloop\n", "6: a facet has 2 vertices; it must have 3");
  refused("four.stl", start + "vertex 1 1 0\nvertex 0 1 0\nendloop\n",
          "8: a facet has 4 vertices; it must have 3");
  refused("open.stl", start, "5: the file ends within a facet");
  refused("outside.stl", "solid x\nvertex 0 0 0\n", "2: \"vertex\" outside of \"outer loop\"");
  refused("none.stl", "solid x\nendsolid x\n", " the mesh has no triangles");
  refused("range.obj", "v 0 0 0\nv 1 0 0\nf 1 2 7\n",
          " a face names vertex 7, but the file has 2 "
          "vertices");
}

}  // namespace
}  // namespace retiarius
