#include "program/served_folder.hpp"

#include <gtest/gtest.h>

#include "tests/program/subprocess.hpp"

namespace retiarius::program {
namespace {

namespace fs = std::filesystem;
using testing::WorkFolder;

class ServedFolder : public ::testing::Test {
 protected:
  ServedFolder() {
    fs::create_directories(folder_ / "run/frames");
    fs::create_directories(folder_ / "run-2");
    folder_.write("run/replay.bin", "recording");
    folder_.write("run/frames/frame_000000.vtp", "frame");
    folder_.write("run/.hidden", "secret");
    folder_.write("run/two..dots", "fine");
    folder_.write("secret.txt", "secret");
    folder_.write("run-2/secret.txt", "secret");
    fs::create_symlink(folder_ / "secret.txt", folder_ / "run/link.txt");
    fs::create_directory_symlink(folder_.path(), folder_ / "run/up");
    fs::create_symlink("replay.bin", folder_ / "run/same.bin");
    fs::create_symlink("nowhere", folder_ / "run/dangling");
  }
  bool serves(std::string_view path) const {
    return served_file(folder_ / "run", path).has_value();
  }

  WorkFolder folder_;
};

TEST_F(ServedFolder, GivesFilesOfTheRun) {
  EXPECT_EQ(served_file(folder_ / "run", "/replay.bin"), fs::canonical(folder_ / "run/replay.bin"));
  EXPECT_TRUE(serves("/frames/frame_000000.vtp"));
  EXPECT_TRUE(serves("/two..dots"));
  EXPECT_TRUE(serves("/same.bin"));  // a link within the folder
}

TEST_F(ServedFolder, GivesNothingOutsideIt) {
  for (const char* path :
       {"/../secret.txt", "/frames/../../secret.txt", "/..", "/.", "/./replay.bin", "../secret.txt",
        "/link.txt", "/up/secret.txt", "/up/run-2/secret.txt", "/../run-2/secret.txt",
        "//etc/passwd", "/etc/passwd", "etc/passwd", "/..\\secret.txt", "/dangling", "", "/"})
    EXPECT_FALSE(serves(path)) << path;
  EXPECT_FALSE(serves((folder_ / "secret.txt").string()));
  EXPECT_FALSE(serves(std::string("/").append((folder_ / "secret.txt").string())));
  EXPECT_FALSE(serves(std::string_view("/replay.bin\0.txt", 16)));
}

TEST_F(ServedFolder, GivesNoFoldersAndNothingHidden) {
  EXPECT_FALSE(serves("/frames"));
  EXPECT_FALSE(serves("/frames/"));
  EXPECT_FALSE(serves("/.hidden"));
  EXPECT_FALSE(serves("/missing"));
}

TEST(Loopback, IsToldFromOtherAddresses) {
  for (const char* host : {"127.0.0.1", "localhost", "::1", "127.1.2.3"})
    EXPECT_TRUE(is_loopback(host)) << host;
  for (const char* host : {"0.0.0.0", "::", "192.168.1.5", "example.org"})
    EXPECT_FALSE(is_loopback(host)) << host;
}

TEST(Loopback, IsNamedByTheHeaderHost) {
  for (const char* host : {"127.0.0.1:8000", "localhost:1", "localhost", "[::1]:80", "127.0.0.1"})
    EXPECT_TRUE(names_loopback(host)) << host;
  for (const char* host : {"", "example.org:80", "127.0.0.1.example.org",
                           "localhost.example.org:80", "[::2]:80", "[::1", "10.0.0.1:80"})
    EXPECT_FALSE(names_loopback(host)) << host;
}

}  // namespace
}  // namespace retiarius::program
