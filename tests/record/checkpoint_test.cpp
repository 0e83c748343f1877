#include "retiarius/record/checkpoint.hpp"

#include <cstring>

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/file.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using testing::error_text;
using ::testing::HasSubstr;
using testing::SampleRun;
using testing::TemporaryFolder;

State small_state() {
  State s = SampleRun(1).state(0.3);
  s.x[0].x() = 5e-324;  // the smallest double
  s.x[1].y() = -0.0;
  s.account.prescribed_work = 1.0 / 3.0;
  s.account.outside_angular_impulse = Vec3(4, 5, 6);
  s.memory.acceleration.assign(s.x.size(), Vec3(0.1, -9.81, 1e9));
  s.memory.outside_force = Vec3(7, 8, 9);
  s.memory.outside_moment = Vec3(-7, 0.3, 9);
  s.memory.next_step = 1.25e-3;
  return s;
}

Checkpoint of_state(const State& s) {
  Checkpoint c;
  c.state = s;
  return c;
}

bool same_bits(const Vec3& a, const Vec3& b) {
  return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
}

void expect_same_bits(const State& a, const State& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.step, b.step);
  ASSERT_EQ(a.x.size(), b.x.size());
  for (std::size_t k = 0; k < a.x.size(); ++k) {
    EXPECT_TRUE(same_bits(a.x[k], b.x[k]));
    EXPECT_TRUE(same_bits(a.v[k], b.v[k]));
    EXPECT_TRUE(same_bits(a.support[k], b.support[k]));
  }
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t k = 0; k < a.bodies.size(); ++k) {
    EXPECT_TRUE(same_bits(a.bodies[k].position, b.bodies[k].position));
    EXPECT_EQ(a.bodies[k].attitude.coeffs(), b.bodies[k].attitude.coeffs());
    EXPECT_TRUE(same_bits(a.bodies[k].velocity, b.bodies[k].velocity));
    EXPECT_TRUE(same_bits(a.bodies[k].angular_momentum, b.bodies[k].angular_momentum));
  }
  ASSERT_EQ(a.touches.size(), b.touches.size());
  for (std::size_t k = 0; k < a.touches.size(); ++k) {
    EXPECT_EQ(a.touches[k].node, b.touches[k].node);
    EXPECT_EQ(a.touches[k].body, b.touches[k].body);
    EXPECT_EQ(a.touches[k].sticks, b.touches[k].sticks);
    EXPECT_TRUE(same_bits(a.touches[k].reaction, b.touches[k].reaction));
  }
  EXPECT_EQ(a.account.material_loss, b.account.material_loss);
  EXPECT_EQ(a.account.environment_loss, b.account.environment_loss);
  EXPECT_EQ(a.account.friction_loss, b.account.friction_loss);
  EXPECT_EQ(a.account.impact_loss, b.account.impact_loss);
  EXPECT_EQ(a.account.prescribed_work, b.account.prescribed_work);
  EXPECT_EQ(a.account.outside_impulse, b.account.outside_impulse);
  EXPECT_EQ(a.account.outside_angular_impulse, b.account.outside_angular_impulse);
  EXPECT_EQ(a.memory.acceleration, b.memory.acceleration);
  EXPECT_EQ(a.memory.outside_force, b.memory.outside_force);
  EXPECT_EQ(a.memory.outside_moment, b.memory.outside_moment);
  EXPECT_EQ(a.memory.next_step, b.memory.next_step);
}

// Published test vectors of the 64-bit FNV-1a hash.
TEST(Fnv1a, GivesThePublishedValues) {
  EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325u);
  EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8u);
}

TEST(Checkpoint, ComesBackBitForBit) {
  State s = small_state();
  s.account.environment_loss = 2.0;
  s.account.friction_loss = 3.0;
  s.account.impact_loss = 4.0;
  SavedRun saved;
  saved.checkpoint.state = s;
  saved.checkpoint.rows = 7;
  saved.checkpoint.frames = 3;
  saved.checkpoint.ended = true;
  saved.checkpoint.fresh = false;
  saved.checkpoint.progress = std::string("a\0b", 3);
  saved.identity = {"1.2", "abc", "avx2", 17, 18};
  const SavedRun back = decode_checkpoint(encode_checkpoint(saved), "c");
  expect_same_bits(back.checkpoint.state, s);
  EXPECT_EQ(back.checkpoint.rows, 7);
  EXPECT_EQ(back.checkpoint.frames, 3);
  EXPECT_TRUE(back.checkpoint.ended);
  EXPECT_FALSE(back.checkpoint.fresh);
  EXPECT_EQ(back.checkpoint.progress, saved.checkpoint.progress);
  EXPECT_EQ(back.identity.version, "1.2");
  EXPECT_EQ(back.identity.revision, "abc");
  EXPECT_EQ(back.identity.kernels, "avx2");
  EXPECT_EQ(back.identity.mission, 17u);
  EXPECT_EQ(back.identity.model, 18u);
}

TEST(Checkpoint, IsRefusedWhenTornAtAnyByte) {
  const std::string bytes = encode_checkpoint({{}, of_state(small_state())});
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(decode_checkpoint(bytes.substr(0, size), "c"), InputError) << size;
  EXPECT_THROW(decode_checkpoint(bytes + "x", "c"), InputError);
}

TEST(Checkpoint, IsRefusedWhenAnyByteIsChanged) {
  const std::string bytes = encode_checkpoint({{}, of_state(small_state())});
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    std::string changed = bytes;
    changed[k] = static_cast<char>(changed[k] ^ 0x10);
    EXPECT_THROW(decode_checkpoint(changed, "c"), InputError) << k;
  }
}

TEST(Checkpoint, SaysWhatIsWrong) {
  std::string bytes = encode_checkpoint({{}, of_state(small_state())});
  EXPECT_EQ(error_text<InputError>([&] { decode_checkpoint("time,step\n0,1\n", "h.csv"); }),
            "cannot use the checkpoint h.csv: it is not a checkpoint");
  EXPECT_THAT(error_text<InputError>([&] { decode_checkpoint("", "c"); }),
              HasSubstr("ends too early"));
  bytes[8] = 9;
  EXPECT_EQ(error_text<InputError>([&] { decode_checkpoint(bytes, "c"); }),
            "cannot use the checkpoint c: it has format 9, this version reads format 3");
}

TEST(ReadCheckpoint, UsesThePreviousOneWhenTheNewestIsTornAtAnyByte) {
  TemporaryFolder folder;
  CheckpointFile file(folder.path());
  State s = small_state();
  file.save(of_state(s), true);
  s.time = 0.5;
  file.save(of_state(s), false);
  EXPECT_EQ(read_checkpoint(folder.path()).time, 0.5);
  EXPECT_EQ(read_checkpoint(folder / "checkpoint").time, 0.5);
  const std::string bytes = read_whole_file(folder / "checkpoint");
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    OutputFile(folder / "checkpoint").write(std::string_view(bytes).substr(0, size));
    EXPECT_EQ(read_checkpoint(folder.path()).time, 0.3) << size;
  }
  std::filesystem::remove(folder / "checkpoint");  // died between the two renames
  EXPECT_EQ(read_checkpoint(folder.path()).time, 0.3);
}

// Between two that outlive the machine there may be many that outlive the process only.
TEST(CheckpointFile, KeepsADurableOneAmongTheTwo) {
  TemporaryFolder folder;
  CheckpointFile file(folder.path());
  State s = small_state();
  const auto save = [&](double time, bool durable) {
    s.time = time;
    file.save(of_state(s), durable);
  };
  const auto newest = [&] { return read_checkpoint(folder / "checkpoint").time; };
  const auto previous = [&] { return read_checkpoint(folder / "checkpoint.previous").time; };
  save(1.0, true);
  EXPECT_FALSE(std::filesystem::exists(folder / "checkpoint.previous"));
  for (double time : {2.0, 3.0}) {
    save(time, false);
    EXPECT_EQ(newest(), time);
    EXPECT_EQ(previous(), 1.0);
  }
  save(4.0, true);
  EXPECT_EQ(newest(), 4.0);
  EXPECT_EQ(previous(), 1.0);
  save(5.0, true);
  EXPECT_EQ(newest(), 5.0);
  EXPECT_EQ(previous(), 4.0);
}

TEST(ReadCheckpoint, NamesBothFilesWhenNeitherCanBeUsed) {
  TemporaryFolder folder;
  write_atomically(folder / "checkpoint", "torn");
  write_atomically(folder / "checkpoint.previous", "RETC");
  const std::string text = error_text<InputError>([&] { read_checkpoint(folder.path()); });
  EXPECT_THAT(text, HasSubstr("checkpoint: it is not a checkpoint; "));
  EXPECT_THAT(text, HasSubstr("checkpoint.previous: it ends too early"));
}

TEST(ReadCheckpoint, SaysWhenThereIsNone) {
  TemporaryFolder folder;
  EXPECT_EQ(error_text<InputError>([&] { read_checkpoint(folder.path()); }),
            "cannot read " + (folder / "checkpoint").string() + ": No such file or directory");
}

}  // namespace
}  // namespace retiarius
