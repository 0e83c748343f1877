#include "retiarius/record/replay_recorder.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "retiarius/base/error.hpp"
#include "retiarius/record/replay_chunk.hpp"
#include "retiarius/record/replay_header.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using testing::error_text;
using ::testing::HasSubstr;
using testing::SampleRun;
using testing::TemporaryFolder;

TEST(ReplayRecorder, LeavesAFileThatAnyReaderFollows) {
  TemporaryFolder folder;
  const SampleRun run;
  ReplayRecorder recorder(folder.path(), "0.1.0");
  run.feed(recorder, 21);
  // Still running: every frame is there already.
  ReplayChunks file;
  const std::string growing = read_whole_file(folder / "replay.bin");
  EXPECT_EQ(read_chunks(growing).chunks.size(), 1u + 11u);
  EXPECT_EQ(read_chunks(growing).size, growing.size());
  recorder.end(run.report());
  const std::string whole = read_whole_file(folder / "replay.bin");
  file = read_chunks(whole);
  ASSERT_EQ(file.chunks.size(), 1u + 11u + 1u);
  EXPECT_EQ(file.chunks.back().name, "ENDS");

  const ReplayHeader header = read_replay_header(file.chunks[0].content);
  EXPECT_EQ(header.shape.nodes, 25u);
  EXPECT_EQ(header.shape.bodies, 1u);
  EXPECT_DOUBLE_EQ(header.scales.quantum, 2.0 * kReplayError * 2.0);  // the net is 2 m wide
  ReplayCodec codec(header.shape, header.scales);
  for (int k = 0; k <= 10; ++k) {
    const ReplayFrame frame = codec.decode(file.chunks[static_cast<std::size_t>(k) + 1].content);
    const State state = run.state(0.2 * k);
    EXPECT_EQ(frame.time, state.time);
    EXPECT_EQ(frame.phase, k < 3 ? 0 : 1);
    for (std::size_t n = 0; n < state.x.size(); ++n)
      EXPECT_LE((frame.x[n] - state.x[n]).cwiseAbs().maxCoeff(), kReplayError * 2.0 * 1.000001);
    EXPECT_NEAR(frame.speed[0], 1.0, 0.008);
    EXPECT_NEAR(frame.tension[5], 10.0 + 5 * state.time, 0.004 * 30);
    EXPECT_EQ(frame.touch[3], 2);
    EXPECT_EQ(frame.touch[4], 0);
  }
}

TEST(ReplayRecorder, SaysHowTheRunEnded) {
  const nlohmann::json end = nlohmann::json::parse(replay_end(SampleRun().report(Outcome::failed)));
  EXPECT_EQ(end.at("outcome"), "failed");
  EXPECT_EQ(end.at("reason"), "step at t = 0.3 s does not converge");
  EXPECT_EQ(end.at("phases").at(1).at("name"), "spread");
  EXPECT_EQ(end.at("phases").at(1).at("end"), 2.0);
}

TEST(ReplayHeader, DescribesNetAndBodies) {
  const SampleRun run;
  const ReplayHeader header = read_replay_header(replay_header(run.model(), "9.9"));
  const nlohmann::json text = nlohmann::json::parse(header.text);
  EXPECT_EQ(text.at("title"), "Sample <net> & box");
  EXPECT_EQ(text.at("program"), "retiarius 9.9");
  EXPECT_EQ(text.at("segments"), run.network.segments.size());
  EXPECT_EQ(text.at("bullets").size(), 4u);
  EXPECT_NEAR(text.at("bullets").at(0).at("radius").get<double>(), 0.0067,
              0.0001);  // 10 g of steel
  EXPECT_EQ(text.at("phases").at(0).at("kind"), "shoot");
  EXPECT_EQ(text.at("bodies").at(0).at("name"), "target");
  EXPECT_EQ(text.at("channels").at(0).at("unit"), "N");
  EXPECT_THAT(error_text<InputError>([] { read_replay_header("\1"); }), HasSubstr("no header"));
}

// A header with one number replaced; every number below was accepted, converted to nonsense, or
// made the reader take memory without bound.
TEST(ReplayHeader, RefusesNumbersThatMakeNoSense) {
  const SampleRun run;
  const std::string whole = replay_header(run.model(), "9.9");
  const std::string text = read_replay_header(whole).text;
  const std::string arrays = whole.substr(4 + text.size());
  const auto refusal = [&](const char* pointer, const nlohmann::json& value) {
    nlohmann::json head = nlohmann::json::parse(text);
    head[nlohmann::json::json_pointer(pointer)] = value;
    const std::string changed = head.dump();
    std::string content;
    append_bytes(content, static_cast<std::uint32_t>(changed.size()));
    return error_text<InputError>([&] { read_replay_header(content + changed + arrays); });
  };
  EXPECT_THAT(refusal("/nodes", 1e30), HasSubstr("nodes is no count"));
  EXPECT_THAT(refusal("/nodes", -1), HasSubstr("nodes is no count"));
  EXPECT_THAT(refusal("/segments", 0xfffffffffffffff0u), HasSubstr("short arrays"));
  EXPECT_THAT(refusal("/channels/0/steps", 2147483647), HasSubstr("without scale"));
  EXPECT_THAT(refusal("/channels/0/steps", 0), HasSubstr("without scale"));
  EXPECT_THAT(refusal("/channels/3/quantum", 0.0), HasSubstr("without scale"));
  EXPECT_THAT(refusal("/quantum", -1.0), HasSubstr("without scale"));
  EXPECT_THAT(refusal("/quantum", "x"), HasSubstr("cannot be used"));
}

TEST(ReplayRecorder, NamesAFileThatCannotBeWritten) {
  TemporaryFolder folder;
  ReplayRecorder recorder(folder / "missing", "");
  const SampleRun run;
  EXPECT_THAT(error_text<RunError>([&] { recorder.begin(run.model()); }), HasSubstr("replay.bin"));
  recorder.end(run.report());  // has nothing to close
}

}  // namespace
}  // namespace retiarius
