#include "program/output_guard.hpp"

#include <gtest/gtest.h>

#include "tests/program/subprocess.hpp"

namespace retiarius::program {
namespace {

namespace fs = std::filesystem;

TEST(OutputGuard, TakesBackTheEmptyFoldersThatWereNotThere) {
  const testing::WorkFolder folder;
  fs::create_directory(folder / "old");
  {
    const OutputGuard guard(folder / "old/new/newer/");
    fs::create_directories(folder / "old/new/newer");
  }
  EXPECT_TRUE(folder.has("old"));
  EXPECT_FALSE(folder.has("old/new"));
}

TEST(OutputGuard, NeverRemovesAFileOrAFolderThatWasThere) {
  const testing::WorkFolder folder;
  fs::create_directory(folder / "old");
  {
    const OutputGuard there(folder / "old"), filled(folder / "filled/in");
    fs::create_directories(folder / "filled/in");
    folder.write("filled/in/file", "x");
  }
  EXPECT_TRUE(folder.has("old"));
  EXPECT_TRUE(folder.has("filled/in/file"));
}

TEST(OutputGuard, LeavesWhatIsKept) {
  const testing::WorkFolder folder;
  {
    OutputGuard guard(folder / "new");
    fs::create_directory(folder / "new");
    guard.keep();
  }
  EXPECT_TRUE(folder.has("new"));
}

}  // namespace
}  // namespace retiarius::program
