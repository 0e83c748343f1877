#include "retiarius/record/run_h5.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <hdf5.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/export_run.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/history_csv.hpp"
#include "retiarius/record/run_file.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using testing::error_text;
using ::testing::HasSubstr;
using testing::SampleRun;
using testing::TemporaryFolder;

void record(const std::filesystem::path& folder, const SampleRun& run, int rows) {
  RunH5 recorder(folder, "title = \"Sample\"\n", "0.1.0");
  run.feed(recorder, rows);
  recorder.end(run.report());
}

TEST(RunH5, HoldsHistoryAndFramesAsTheyWere) {
  TemporaryFolder folder;
  const SampleRun run;
  record(folder.path(), run, 600);
  const RunFile file(folder / "run.h5");
  EXPECT_EQ(file.resolved(), "title = \"Sample\"\n");
  EXPECT_EQ(file.history_names(), history_header(run.mission));
  const auto time = file.history("time");
  ASSERT_EQ(time.size(), 600u);
  EXPECT_EQ(time[599], 0.1 * 599);
  EXPECT_TRUE(std::isnan(file.history("smallest_distance")[0]));
  EXPECT_EQ(file.history("smallest_distance")[7], *run.row(0.1 * 7).smallest_distance);
  EXPECT_EQ(file.history("corner0.fz")[3], 2.5);
  ASSERT_EQ(file.frame_count(), 300u);
  const FrameData frame = file.frame(3);
  const State state = run.state(0.1 * 6);
  EXPECT_EQ(frame.time, 0.1 * 6);
  EXPECT_EQ(frame.phase, 1);
  EXPECT_EQ(frame.x, state.x);
  EXPECT_EQ(frame.v, state.v);
  EXPECT_EQ(frame.tension, run.frame(state).tension);
  EXPECT_EQ(frame.strain, run.frame(state).strain);
  EXPECT_EQ(frame.curvature, run.frame(state).curvature);
  ASSERT_EQ(frame.bodies.size(), 1u);
  EXPECT_EQ(frame.bodies[0].position, state.bodies[0].position);
  EXPECT_EQ(frame.bodies[0].attitude.coeffs(), state.bodies[0].attitude.coeffs());
  EXPECT_EQ(frame.bodies[0].velocity, state.bodies[0].velocity);
  EXPECT_EQ(frame.bodies[0].angular_momentum, state.bodies[0].angular_momentum);
  EXPECT_EQ(file.net().segments.size(), 40u);
  EXPECT_EQ(file.net().radius[0], 0.002f);
  EXPECT_EQ(file.corners(), run.network.corners);
  EXPECT_EQ(file.bullets(), run.network.bullets);
  EXPECT_EQ(file.mass(), run.network.mass);
  EXPECT_EQ(frame.contact, contact_of_nodes(state));
  EXPECT_EQ(frame.contact[3], 2);
  EXPECT_EQ(frame.contact[4], 0);
  EXPECT_EQ(file.bodies().at(0).name, "target");
  EXPECT_EQ(file.bodies().at(0).mesh.triangles, run.bodies[0].shape->triangles().triangles);
}

TEST(RunH5, WorksWithoutBodies) {
  TemporaryFolder folder;
  SampleRun run;
  run.bodies.clear();
  record(folder.path(), run, 3);
  const RunFile file(folder / "run.h5");
  EXPECT_TRUE(file.bodies().empty());
  EXPECT_EQ(file.frame_count(), 2u);
  EXPECT_TRUE(file.frame(1).bodies.empty());
}

TEST(RunH5, RefusesAFrameThatDoesNotFitTheNet) {
  TemporaryFolder folder;
  const SampleRun run;
  RunH5 recorder(folder.path(), "", "");
  recorder.begin(run.model());
  const State state = run.state(0.0);
  Frame frame = run.frame(state);
  frame.tension.pop_back();
  EXPECT_THAT(error_text<RunError>([&] { recorder.frame(frame); }),
              HasSubstr("a frame has 39 values of tension where 40 are expected"));
}

// A second process writes without ever closing the file and kills itself without warning.
void write_and_die(const std::filesystem::path& folder, int rows) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const SampleRun run;
    RunH5 recorder(folder, "", "");
    run.feed(recorder, rows);
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  ASSERT_EQ(WTERMSIG(status), SIGKILL);
}

TEST(RunH5, IsReadableAfterItsWriterWasKilled) {
  for (int rows : {1, 2, 5, 40}) {
    TemporaryFolder folder;
    write_and_die(folder.path(), rows);
    const RunFile file(folder / "run.h5");
    const auto frames = static_cast<std::size_t>((rows + 1) / 2);
    ASSERT_EQ(file.frame_count(), frames);
    EXPECT_EQ(file.frame(frames - 1).x, SampleRun().state(0.1 * (2.0 * (frames - 1.0))).x);
    EXPECT_EQ(file.history("time").size(), 2 * frames - 1);
  }
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

// Where objects' headers of HDF5's second version begin.
std::vector<std::size_t> headers_in(const std::string& bytes) {
  std::vector<std::size_t> places;
  for (std::size_t at = bytes.find("OHDR"); at != std::string::npos;
       at = bytes.find("OHDR", at + 1))
    places.push_back(at);
  return places;
}

// The system stops a killed writer between pages only, so that none of these is ever written in
// part.
TEST(RunH5, KeepsObjectHeadersWithinPages) {
  TemporaryFolder folder;
  write_and_die(folder.path(), 5);
  const std::string bytes = bytes_of(folder / "run.h5");
  const std::vector<std::size_t> headers = headers_in(bytes);
  EXPECT_GT(headers.size(), 20u);
  for (const std::size_t at : headers) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes[at + k]); };
    const int flags = byte(5);
    std::size_t begin = 6 + ((flags & 0x20) != 0 ? 16 : 0) + ((flags & 0x10) != 0 ? 4 : 0);
    std::size_t size = 0;
    for (std::size_t k = 0; k < (1u << (flags & 3)); ++k) size += byte(begin++) << (8 * k);
    EXPECT_EQ(at / 4096, (at + begin + size + 3) / 4096) << at;  // a checksum of four bytes ends it
  }
}

// What was torn all the same is told.
TEST(RunH5, RefusesATornBlockInsteadOfWaitingForIt) {
  TemporaryFolder folder;
  write_and_die(folder.path(), 5);
  const std::filesystem::path path = folder / "run.h5";
  std::string bytes = bytes_of(path);
  const std::vector<std::size_t> headers = headers_in(bytes);
  ASSERT_GT(headers.size(), 1u);
  for (std::size_t k = 1; k < headers.size(); ++k) bytes[headers[k] + 30] ^= 1;  // not the root's
  std::ofstream(path, std::ios::binary) << bytes;
  EXPECT_THAT(error_text<InputError>([&] { const RunFile file(path); }), HasSubstr("run.h5"));
}

// Killed from outside at arbitrary instants, in the middle of writing: at most one frame is lost.
TEST(RunH5, LosesAtMostOneFrameWhenKilledAtAnyInstant) {
  for (int delay = 1; delay <= 20; ++delay) {
    TemporaryFolder folder;
    int channel[2];
    ASSERT_EQ(pipe(channel), 0);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      const SampleRun run(12);
      RunH5 recorder(folder.path(), "", "");
      recorder.begin(run.model());
      for (int k = 0;; ++k) {
        recorder.history(run.row(0.1 * k));
        const State state = run.state(0.1 * k);
        recorder.frame(run.frame(state));
        if (write(channel[1], "x", 1) != 1) _exit(1);  // tells that frame k is complete
      }
    }
    close(channel[1]);
    std::size_t complete = 0;
    char byte = 0;
    while (complete < 3 && read(channel[0], &byte, 1) == 1) ++complete;
    usleep(static_cast<useconds_t>(370 * delay));
    ASSERT_EQ(kill(child, SIGKILL), 0);
    waitpid(child, nullptr, 0);
    while (read(channel[0], &byte, 1) == 1) ++complete;
    close(channel[0]);
    ASSERT_GE(complete, 3u);
    const RunFile file(folder / "run.h5");
    ASSERT_GE(file.frame_count(), complete);
    EXPECT_LE(file.frame_count(), complete + 1);
    EXPECT_EQ(file.frame(complete - 1).x, SampleRun(12).state(0.1 * (complete - 1.0)).x);
  }
}

TEST(RunH5, ColumnsHaveUnitsAndTheTimeScale) {
  TemporaryFolder folder;
  record(folder.path(), SampleRun(), 2);
  const hid_t file = H5Fopen((folder / "run.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  const hid_t column = H5Dopen2(file, "history/mouth_area", H5P_DEFAULT);
  EXPECT_GT(H5Aexists(column, "units"), 0);
  EXPECT_GT(H5Aexists(column, "DIMENSION_LIST"), 0);
  const hid_t positions = H5Dopen2(file, "frames/positions", H5P_DEFAULT);
  EXPECT_GT(H5Aexists(positions, "DIMENSION_LIST"), 0);
  H5Dclose(positions);
  H5Dclose(column);
  H5Fclose(file);
}

// A disk of its own that is soon full, for as long as the process lives. Needs the right to mount.
bool mount_small_disk(const std::filesystem::path& place) {
  return unshare(CLONE_NEWNS) == 0 && mount("none", "/", nullptr, MS_REC | MS_PRIVATE, "") == 0 &&
         mount("none", place.c_str(), "tmpfs", 0, "size=400k") == 0;
}

// What a process of its own does on a full disk; tells through `channel` what it met.
[[noreturn]] void fill_the_disk(const std::filesystem::path& folder, int channel) {
  alarm(20);
  if (!mount_small_disk(folder)) _exit(77);
  const SampleRun run(12);
  std::string text = "no error";
  try {
    RunH5 recorder(folder, "", "");
    run.feed(recorder, 400);
  } catch (const RunError& error) {
    text = error.what();
  }
  const std::size_t frames = RunFile(folder / "run.h5").frame_count();
  text += frames > 3 ? "; frames are kept" : "; frames are lost";
  if (write(channel, text.data(), text.size()) < 0) _exit(3);
  exit(7);  // through HDF5's own clean-up, if it has any
}

TEST(RunH5, SaysWhenTheDiskIsFullKeepsTheFramesAndLetsTheProcessEnd) {
  TemporaryFolder folder;
  int channel[2];
  ASSERT_EQ(pipe(channel), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) fill_the_disk(folder.path(), channel[1]);
  close(channel[1]);
  std::string text(1000, '\0');
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(channel[0], text.data(), 1000))));
  close(channel[0]);
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status)) << WTERMSIG(status);
  if (WEXITSTATUS(status) == 77) GTEST_SKIP() << "mounting a small disk is not allowed here";
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(text, "cannot write " + (folder / "run.h5").string() +
                      ": No space left on device; frames are kept");
}

// A limit on the file size fails a write as a full disk does, where mounting is not allowed.
TEST(RunH5, SaysWhichFileMayNotGrow) {
  TemporaryFolder folder;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{200000, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const SampleRun run(12);
  const std::string text = error_text<RunError>([&] {
    RunH5 recorder(folder.path(), "", "");
    run.feed(recorder, 400);
  });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(text, "cannot write " + (folder / "run.h5").string() + ": File too large");
}

TEST(RunFile, SaysWhatItCannotRead) {
  TemporaryFolder folder;
  EXPECT_THAT(error_text<InputError>([&] { RunFile file(folder / "run.h5"); }),
              HasSubstr("run.h5: No such file or directory"));
  write_atomically(folder / "run.h5", "not HDF5");
  EXPECT_THAT(error_text<InputError>([&] { RunFile file(folder / "run.h5"); }),
              HasSubstr("cannot read the run file " + (folder / "run.h5").string()));
}

TEST(RunFile, RefusesAnotherFormat) {
  TemporaryFolder folder;
  record(folder.path(), SampleRun(), 1);
  const hid_t file = H5Fopen((folder / "run.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t format = H5Aopen(file, "format", H5P_DEFAULT);
  const std::int64_t other = 99;
  H5Awrite(format, H5T_NATIVE_INT64, &other);
  H5Aclose(format);
  H5Fclose(file);
  EXPECT_THAT(error_text<InputError>([&] { RunFile f(folder / "run.h5"); }),
              HasSubstr("it has format 99, this version reads format 1"));
}

TEST(ExportVtk, WritesTheSameFilesAsTheRun) {
  TemporaryFolder folder, out;
  const SampleRun run;
  record(folder.path(), run, 5);
  VtkFrames direct(folder.path());
  run.feed(direct, 5);
  direct.end(run.report());
  export_vtk(folder.path(), out.path());
  for (const char* name :
       {"frames.pvd", "frames/frame_000002.vtp", "frames/body_target_000002.vtp"})
    EXPECT_EQ(read_whole_file(out / name), read_whole_file(folder / name)) << name;
}

TEST(ExportCsv, WritesTheSameHistoryAndAllFrames) {
  TemporaryFolder folder, out;
  const SampleRun run;
  record(folder.path(), run, 5);
  HistoryCsv direct(folder.path());
  run.feed(direct, 5);
  export_csv(folder.path(), out.path());
  EXPECT_EQ(read_whole_file(out / "history.csv"), read_whole_file(folder / "history.csv"));
  const auto count_lines = [&](const char* name) {
    const std::string text = read_whole_file(out / name);
    return std::count(text.begin(), text.end(), '\n');
  };
  EXPECT_EQ(count_lines("nodes.csv"), 1 + 3 * 25);
  EXPECT_EQ(count_lines("segments.csv"), 1 + 3 * 40);
  EXPECT_EQ(count_lines("bodies.csv"), 1 + 3);
  const State s = run.state(0.1 * 4);
  EXPECT_THAT(read_whole_file(out / "nodes.csv"),
              HasSubstr(csv_line({2, 0.1 * 4, 24, s.x[24].x(), s.x[24].y(), s.x[24].z(), 0, 0, 1,
                                  run.frame(s).curvature[24]})));
}

TEST(Export, RefusesAFolderThatIsNotEmpty) {
  TemporaryFolder folder;
  record(folder.path(), SampleRun(), 1);
  EXPECT_THAT(error_text<InputError>([&] { export_csv(folder.path(), folder.path()); }),
              HasSubstr("is not empty"));
}

}  // namespace
}  // namespace retiarius
