// Whatever is wrong with the input: exit code 2, an error that helps, nothing written.
#include <gmock/gmock.h>

#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Matcher;
using testing::ProcessResult;
using testing::replaced;
using testing::small_mission;
using ::testing::StartsWith;
using testing::WorkFolder;

// Runs `mission` in the folder with more arguments, expects it to be refused and nothing written.
void expect_refused(const WorkFolder& folder, const std::vector<std::string>& arguments,
                    const Matcher<std::string>& error,
                    const testing::ProcessOptions& options = {}) {
  const std::string before = folder.listing();
  const ProcessResult result = folder.run(arguments, options);
  EXPECT_EQ(result.exit_code, 2) << result.err << result.out;
  EXPECT_EQ(result.signal, 0);
  EXPECT_THAT(result.err, AllOf(StartsWith("retiarius: error: "), error));
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(folder.listing(), before);
}

void expect_mission_refused(const std::string& mission, const Matcher<std::string>& error,
                            const std::vector<std::string>& more = {}) {
  const WorkFolder folder;
  std::vector<std::string> arguments{"", folder.write("m.toml", mission)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  for (const char* command : {"run", "validate"}) {
    arguments[0] = command;
    expect_refused(folder, arguments, error);
  }
}

TEST(BadInput, MissionThatIsNoFile) {
  const WorkFolder folder;
  expect_refused(folder, {"run", "missing.toml"}, HasSubstr("missing.toml"));
  expect_refused(folder, {"run", "."}, HasSubstr("is a folder; a mission file is expected"));
  folder.write("empty.toml", "");
  expect_refused(folder, {"run", "empty.toml"}, HasSubstr("empty.toml"));
  folder.write("binary.toml", std::string("\x7f"
                                          "ELF\x00\x01\xff\xfe",
                                          8));
  expect_refused(folder, {"run", "binary.toml"}, HasSubstr("binary.toml"));
}

TEST(BadInput, ImpossibleValues) {
  expect_mission_refused(replaced(small_mission(), "density = 1000.0", "density = -1000.0"),
                         HasSubstr("m.toml:11:11: net.thread.density = -1000"));
  expect_mission_refused(replaced(small_mission(), "radius = 0.01", "radius = 0.0"),
                         HasSubstr("net.thread.radius = 0"));
  expect_mission_refused(replaced(small_mission(), "radius", "raduis"),
                         HasSubstr("did you mean radius?"));
  expect_mission_refused(replaced(small_mission(), "side = 1.0", "side = \"one\""),
                         HasSubstr("net.side"));
}

TEST(BadInput, MeshThatIsNotClosed) {
  const WorkFolder folder;
  folder.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n");
  folder.write("m.toml", small_mission() +
                             "\n[target]\nshape = \"mesh\"\nfile = \"open.obj\"\n"
                             "mass = 1.0\nposition = [0.0, 0.0, 5.0]\n"
                             "[contact]\nmethod = \"modified-mass\"\n");
  for (const char* command : {"run", "validate", "info"})
    expect_refused(folder, {command, "m.toml"}, AllOf(HasSubstr("open.obj"), HasSubstr("closed")));
}

// One cell is a net: it has a mouth and corners, and runs.
TEST(BadInput, NetOfOneCellRuns) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  const ProcessResult result =
      folder.run({"run", "m.toml", "--set", "net.pattern=square", "--set", "net.mesh=1.0", "--set",
                  "net.segments=1", "--set", "phase[0].fix=corner0"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST(BadInput, Overrides) {
  expect_mission_refused(small_mission(), HasSubstr("did you mean radius?"),
                         {"--set", "net.thread.raduis=0.004"});
  expect_mission_refused(small_mission(), HasSubstr("--set net.thread.radius=thin"),
                         {"--set", "net.thread.radius=thin"});
  expect_mission_refused(small_mission(), HasSubstr("--set phase[7].until=time >= 1"),
                         {"--set", "phase[7].until=time >= 1"});
  expect_mission_refused(small_mission(), HasSubstr("--set net"), {"--set", "net"});
}

TEST(BadInput, NamesThatSelectNothing) {
  expect_mission_refused(small_mission(), HasSubstr("corner9"), {"--set", "phase[0].fix=corner9"});
  expect_mission_refused(small_mission(), HasSubstr("a probe watches one"),
                         {"--set", "probe[0].node=corners"});
}

TEST(BadInput, KernelsThatThisMachineLacks) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  for (const char* name : {"avx2", "avx512"}) {
    const ProcessResult result = folder.run({"run", "m.toml", "--kernels", name, "--out", name});
    if (result.exit_code == 0) continue;  // this machine has them
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr(std::string("--kernels ") + name));
    EXPECT_FALSE(folder.has(name));
  }
}

TEST(BadInput, ExistingOutputFolderStaysAsItIs) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  std::filesystem::create_directory(folder / "mine");
  folder.write("mine/notes.txt", "precious");
  expect_refused(folder, {"run", "m.toml", "--out", "mine"},
                 HasSubstr("mine exists and is not empty; pass another --out or remove it"));
  EXPECT_EQ(folder.read("mine/notes.txt"), "precious");
  std::filesystem::create_directory(folder / "empty");
  EXPECT_EQ(folder.run({"run", "m.toml", "--out", "empty"}).exit_code, 0);
}

TEST(BadInput, OutputPlaceThatTakesNoFolder) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  for (const char* place : {"/proc/retiarius", "m.toml", "m.toml/out", "/dev/full"})
    expect_refused(folder, {"run", "m.toml", "--out", place},
                   AllOf(HasSubstr(place), HasSubstr("pass another --out")));
}

TEST(BadInput, FoldersMadeForARunThatIsRefusedAreTakenBack) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  expect_refused(folder,
                 {"run", "m.toml", "--out", "deep/er/still", "--set", "phase[0].fix=corner9"},
                 HasSubstr("corner9"));
  EXPECT_EQ(folder.listing(), "m.toml");
}

TEST(BadInput, NetTooLargeForTheMachineIsAnEstimateNotACrash) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer needs more address space than the limit leaves";
#endif
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  testing::ProcessOptions small_machine;
  small_machine.address_space = rlim_t{2} << 30;
  for (const char* command : {"run", "validate", "info"})
    expect_refused(folder,
                   {command, "m.toml", "--set", "net.pattern=square", "--set", "net.side=1000.0",
                    "--set", "net.mesh=1.0", "--set", "net.segments=1"},
                   AllOf(HasSubstr("1.002e+06 nodes"), HasSubstr("GB of memory"),
                         HasSubstr("more than the 2.15 GB"), HasSubstr("enlarge net.mesh")),
                   small_machine);
}

}  // namespace
}  // namespace retiarius
