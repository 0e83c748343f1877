#include "program/live_server.hpp"

#include <csignal>
#include <fstream>
#include <thread>

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>

#include "retiarius/base/error.hpp"
#include "retiarius/report/replay_page.hpp"
#include "tests/program/subprocess.hpp"

namespace retiarius::program {
namespace {

namespace fs = std::filesystem;
using testing::endless_mission;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;
using testing::Process;
using testing::replaced;
using testing::small_mission;
using ::testing::StartsWith;
using testing::WorkFolder;

struct Answer {
  int status = 0;
  std::string head, body;
};

// What the server answers to these bytes.
Answer talk(int port, const std::string& text) {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  Answer answer;
  if (::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) {
    if (::send(socket, text.data(), text.size(), MSG_NOSIGNAL) > 0) {
      std::string all;
      char block[4096];
      for (ssize_t n = 0; (n = ::recv(socket, block, sizeof block, 0)) > 0;)
        all.append(block, static_cast<std::size_t>(n));
      const std::size_t end = all.find("\r\n\r\n");
      answer.head = all.substr(0, end);
      if (end != std::string::npos) answer.body = all.substr(end + 4);
      if (all.size() > 12) answer.status = std::stoi(all.substr(9, 3));
    }
  }
  ::close(socket);
  return answer;
}

Answer get(int port, const std::string& path, const std::string& header = "",
           const std::string& method = "GET") {
  return talk(port, method + " " + path + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
                        "\r\n" + header + "\r\n");
}

class Server : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!viewer_built_in()) GTEST_SKIP() << "built without the viewer";
    fs::create_directories(folder_ / "run");
    folder_.write("secret.txt", "secret");
    folder_.write("run/replay.bin", "0123456789");
    folder_.write("run/empty.csv", "");
    folder_.write("run/mission.toml", "title = 1\n");
    server_ = std::make_unique<LiveServer>(folder_ / "run", "A <run>", ServerArguments{});
  }
  Answer ask(const std::string& path, const std::string& header = "",
             const std::string& method = "GET") const {
    return get(server_->port(), path, header, method);
  }
  Answer part(const std::string& range) const {
    return ask("/replay.bin", "Range: " + range + "\r\n");
  }

  WorkFolder folder_;
  std::unique_ptr<LiveServer> server_;
};

TEST_F(Server, GivesThePageAndFiles) {
  EXPECT_EQ(server_->address(), "http://127.0.0.1:" + std::to_string(server_->port()) + "/");
  const Answer page = ask("/");
  EXPECT_EQ(page.status, 200);
  EXPECT_THAT(page.body, HasSubstr("A &lt;run&gt;"));
  EXPECT_THAT(page.head, HasSubstr("text/html"));
  const Answer file = ask("/replay.bin");
  EXPECT_EQ(file.status, 200);
  EXPECT_EQ(file.body, "0123456789");
  EXPECT_THAT(file.head, HasSubstr("no-store"));
  EXPECT_THAT(file.head, HasSubstr("nosniff"));
  EXPECT_THAT(ask("/mission.toml").head, HasSubstr("text/plain"));
  EXPECT_EQ(ask("/empty.csv").status, 200);
  EXPECT_EQ(ask("/empty.csv").body, "");
}

TEST_F(Server, GivesByteRanges) {
  const Answer rest = part("bytes=4-");
  EXPECT_EQ(rest.status, 206);
  EXPECT_EQ(rest.body, "456789");
  EXPECT_THAT(rest.head, HasSubstr("Content-Range: bytes 4-9/10"));
  EXPECT_EQ(part("bytes=0-").body, "0123456789");
  EXPECT_EQ(part("bytes=2-3").body, "23");
  EXPECT_EQ(part("bytes=9-").body, "9");
  EXPECT_EQ(part("bytes=-3").body, "789");
  folder_.write("run/replay.bin", "0123456789abc");
  EXPECT_EQ(part("bytes=10-").body, "abc");
}

TEST_F(Server, RefusesRangesThatAreNotThere) {
  for (const char* range : {"bytes=10-", "bytes=11-12", "bytes=99999999999-", "bytes=5-2",
                            "bytes=0-1,3-4", "bytes=-0"}) {
    const Answer answer = part(range);
    EXPECT_EQ(answer.status, 416) << range;
    EXPECT_THAT(answer.body, Not(HasSubstr("0")));
  }
  EXPECT_THAT(part("bytes=10-").head, HasSubstr("Content-Range: bytes */10"));
  EXPECT_EQ(ask("/empty.csv", "Range: bytes=0-\r\n").status, 416);
  EXPECT_EQ(ask("/missing.csv", "Range: bytes=0-\r\n").status, 404);
}

TEST_F(Server, ARangeThatReachesBeyondTheEndIsCutThere) {
  const Answer answer = part("bytes=8-1000");
  EXPECT_EQ(answer.status, 206);
  EXPECT_EQ(answer.body, "89");
  EXPECT_EQ(part("bytes=-100").body, "0123456789");
}

TEST_F(Server, GivesNothingOutsideTheFolder) {
  fs::create_symlink(folder_ / "secret.txt", folder_ / "run/link.txt");
  for (const char* path :
       {"/../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/%2e%2e%2fsecret.txt",
        "/link.txt", "//etc/passwd", "/%2fetc/passwd", "/%252e%252e/secret.txt",
        "/x/../../secret.txt", "/replay.bin%00.txt", "/..%5csecret.txt", "/.."}) {
    const Answer answer = ask(path);
    EXPECT_THAT(answer.status, ::testing::AnyOf(404, 400)) << path;
    EXPECT_THAT(answer.body, Not(HasSubstr("secret")));
  }
  EXPECT_EQ(ask("http://127.0.0.1" + (folder_ / "secret.txt").string()).status, 404);
}

TEST_F(Server, OnlyReads) {
  EXPECT_EQ(ask("/replay.bin", "", "HEAD").body, "");
  for (const char* method : {"POST", "PUT", "DELETE"})
    EXPECT_GE(ask("/replay.bin", "Content-Length: 0\r\n", method).status, 400) << method;
  EXPECT_EQ(folder_.read("run/replay.bin"), "0123456789");
}

TEST_F(Server, AnswersToThisMachinesNamesOnly) {
  const std::string begin = "GET /replay.bin HTTP/1.1\r\nHost: ";
  EXPECT_EQ(talk(server_->port(), begin + "evil.example:80\r\n\r\n").status, 403);
  EXPECT_EQ(talk(server_->port(), begin + "localhost:80\r\n\r\n").status, 200);
}

TEST_F(Server, AConnectionThatSaysNothingDoesNotHoldUpOthers) {
  std::vector<int> idle;
  for (int k = 0; k < 4; ++k) {
    idle.push_back(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(server_->port()));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ASSERT_EQ(::connect(idle[static_cast<std::size_t>(k)], reinterpret_cast<sockaddr*>(&address),
                        sizeof address),
              0);
  }
  EXPECT_EQ(ask("/replay.bin").status, 200);
  for (int socket : idle) ::close(socket);
}

TEST_F(Server, APortInUseIsAnError) {
  ServerArguments arguments;
  arguments.port = server_->port();
  try {
    const LiveServer second(folder_ / "run", "", arguments);
    FAIL() << "two servers share a port";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot listen on 127.0.0.1 port"));
    EXPECT_THAT(error.what(), HasSubstr("choose another --port"));
  }
}

// The program itself.
int port_in(const std::string& text) {
  const std::string marker = "http://127.0.0.1:";
  const std::size_t at = text.find(marker);
  return at == std::string::npos ? 0 : std::stoi(text.substr(at + marker.size()));
}

template <class Condition>
bool soon(Condition&& condition) {
  for (int k = 0; k < 400; ++k) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
  }
  return false;
}

TEST(View, ServesUntilItIsInterrupted) {
  if (!viewer_built_in()) GTEST_SKIP() << "built without the viewer";
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  ASSERT_EQ(folder.run({"run", "m.toml", "--out", "run"}).exit_code, 0);
  folder.write("said", "");
  testing::ProcessOptions options;
  options.out = folder / "said";
  Process view({"view", "run"}, folder.path(), options);
  ASSERT_TRUE(soon([&] { return port_in(folder.read("said")) > 0; }));
  const int port = port_in(folder.read("said"));
  EXPECT_THAT(get(port, "/").body, HasSubstr("A small net"));
  EXPECT_EQ(get(port, "/summary.json").body, folder.read("run/summary.json"));
  view.send(SIGINT);
  EXPECT_EQ(view.wait().exit_code, 0);
}

TEST(View, RefusesWhatIsNoFolder) {
  const auto result = WorkFolder().run({"view", "nowhere"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("there is no folder nowhere"));
}

TEST(RunLive, ServesTheRunWhileItGoesOn) {
  if (!viewer_built_in()) GTEST_SKIP() << "built without the viewer";
  const WorkFolder folder;
  folder.write("m.toml", endless_mission());
  folder.write("said", "");
  testing::ProcessOptions options;
  options.out = folder / "said";
  Process run({"run", "m.toml", "--out", "run", "--live"}, folder.path(), options);
  ASSERT_TRUE(soon([&] { return port_in(folder.read("said")) > 0; }));
  const int port = port_in(folder.read("said"));
  std::string first;
  ASSERT_TRUE(soon([&] { return !(first = get(port, "/replay.bin").body).empty(); }));
  EXPECT_THAT(first, StartsWith("RETREPL\n"));
  std::string more;
  ASSERT_TRUE(soon([&] {
    const Answer answer =
        get(port, "/replay.bin", "Range: bytes=" + std::to_string(first.size()) + "-\r\n");
    more = answer.status == 206 ? answer.body : "";
    return !more.empty();
  }));
  EXPECT_EQ(get(port, "/summary.json").status, 404);
  run.send(SIGINT);
  ASSERT_TRUE(soon([&] { return get(port, "/summary.json").status == 200; })) << "lost at the end";
  EXPECT_EQ(run.wait().exit_code, 4);
  EXPECT_EQ(folder.read("run/replay.bin").substr(0, first.size() + more.size()), first + more);
}

TEST(RunLive, OptionsOfTheServerNeedIt) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  const auto result = folder.run({"run", "m.toml", "--port", "8000"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("--live"));
}

}  // namespace
}  // namespace retiarius::program
