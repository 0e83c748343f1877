#include "program/live_server.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <optional>
#include <thread>

#include <fmt/format.h>
#include <httplib.h>

#include "program/console.hpp"
#include "program/served_folder.hpp"
#include "retiarius/base/error.hpp"
#include "retiarius/report/replay_page.hpp"

namespace retiarius::program {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kThreads = 8;
constexpr std::size_t kBlock = 1 << 18;  // bytes read at a time
constexpr auto kWatched = std::chrono::seconds(3);

// The one range of a request, within a file of `size` bytes; none where it asks for nothing that is
// there. Several ranges at once are not given.
std::optional<httplib::Range> part_of(const httplib::Ranges& ranges, std::uintmax_t size) {
  if (ranges.size() != 1 || size == 0) return {};
  const auto end = static_cast<ssize_t>(size);
  auto [first, last] = ranges[0];
  if (first < 0) {  // the last bytes
    if (last <= 0) return {};
    return httplib::Range{std::max<ssize_t>(0, end - last), end - 1};
  }
  last = last < 0 ? end - 1 : std::min(last, end - 1);
  if (first > last) return {};
  return httplib::Range{first, last};
}

void send_file(const fs::path& file, const httplib::Request& request, httplib::Response& response) {
  const auto stream = std::make_shared<std::ifstream>(file, std::ios::binary);
  std::error_code error;
  // What is added to a growing file from here on belongs to the next request.
  const std::uintmax_t size = fs::file_size(file, error);
  if (error || !*stream) {
    response.status = 404;
    return;
  }
  const std::string type = media_type(file);
  if (!request.ranges.empty()) {
    const std::optional<httplib::Range> part = part_of(request.ranges, size);
    if (!part) {
      response.status = 416;
      response.set_header("Content-Range", fmt::format("bytes */{}", size));
      return;
    }
    // The library takes a range as it stands, also beyond the file's end. The request is the
    // library's own object and not constant.
    const_cast<httplib::Request&>(request).ranges = {*part};
  }
  if (size == 0) return response.set_content("", type);
  response.set_content_provider(
      size, type, [stream](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
        std::string block(std::min(length, kBlock), '\0');
        stream->seekg(static_cast<std::streamoff>(offset));
        if (!stream->read(block.data(), static_cast<std::streamsize>(block.size()))) return false;
        return sink.write(block.data(), block.size());
      });
}

}  // namespace

void ServerArguments::add_to(CLI::App& command, const std::string& needs) {
  CLI::Option* h = command.add_option("--host", host,
                                      "Address to listen on; default 127.0.0.1: this machine only");
  CLI::Option* p = command.add_option("--port", port, "Port to listen on; default a free one");
  h->type_name("ADDRESS");
  p->type_name("N")->check(CLI::Range(0, 65535));
  if (needs.empty()) return;
  h->needs(needs);
  p->needs(needs);
}

class LiveServer::Impl {
 public:
  Impl(const fs::path& folder, const std::string& title, const ServerArguments& arguments)
      : folder_(fs::absolute(folder)),
        page_(live_page(title)),
        host_(arguments.host),
        local_(is_loopback(arguments.host)) {
    set_up();
    errno = 0;
    port_ = arguments.port;
    if (port_ == 0)
      port_ = server_.bind_to_any_port(host_);
    else if (!server_.bind_to_port(host_, port_))
      port_ = -1;
    if (port_ < 0)
      throw InputError(fmt::format("cannot listen on {} port {}: {}; choose another --port", host_,
                                   arguments.port,
                                   errno != 0 ? std::strerror(errno) : "no such address"));
    thread_ = std::thread([this] { server_.listen_after_bind(); });
    while (!server_.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  ~Impl() {
    server_.stop();
    if (thread_.joinable()) thread_.join();
  }

  std::string address() const {
    const bool six = host_.find(':') != std::string::npos;
    return fmt::format("http://{}{}{}:{}/", six ? "[" : "", host_, six ? "]" : "", port_);
  }
  int port() const { return port_; }

  bool watched() const {
    const auto last = Clock::time_point(Clock::duration(last_request_.load()));
    return last_request_ != 0 && Clock::now() - last < kWatched;
  }

 private:
  void set_up() {
    server_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    // One request a connection: idle connections of browsers would hold threads.
    server_.set_keep_alive_max_count(1);
    server_.set_read_timeout(2, 0);
    server_.set_write_timeout(10, 0);
    server_.set_payload_max_length(1024);
    // The usual options of the library let two servers share a port.
    server_.set_socket_options([](socket_t socket) {
      const int yes = 1;
      ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server_.set_default_headers(
        {{"Cache-Control", "no-store"}, {"X-Content-Type-Options", "nosniff"}});
    server_.Get(".*", [this](const httplib::Request& request, httplib::Response& response) {
      answer(request, response);
    });
    // The library answers 416 to a range of a file that is not there.
    server_.set_post_routing_handler(
        [this](const httplib::Request& request, httplib::Response& response) {
          if (response.status == 416 && !served_file(folder_, request.path)) response.status = 404;
        });
  }

  void answer(const httplib::Request& request, httplib::Response& response) {
    if (local_ && !names_loopback(request.get_header_value("Host"))) {
      response.status = 403;
      return response.set_content("This server answers to this machine only.\n", "text/plain");
    }
    last_request_ = Clock::now().time_since_epoch().count();
    if (request.path == "/") return response.set_content(page_, "text/html; charset=utf-8");
    const std::optional<fs::path> file = served_file(folder_, request.path);
    if (file) return send_file(*file, request, response);
    response.status = 404;
  }

  fs::path folder_;
  std::string page_, host_;
  bool local_;
  int port_ = -1;
  std::atomic<Clock::rep> last_request_{0};
  httplib::Server server_;
  std::thread thread_;
};

LiveServer::LiveServer(const fs::path& folder, const std::string& title,
                       const ServerArguments& arguments)
    : impl_(std::make_unique<Impl>(folder, title, arguments)) {
  if (!is_loopback(arguments.host))
    tell_warning(fmt::format("everyone who can reach {} can read the files in {}", arguments.host,
                             folder.string()));
}

LiveServer::~LiveServer() = default;

std::string LiveServer::address() const { return impl_->address(); }
int LiveServer::port() const { return impl_->port(); }

void LiveServer::let_watchers_finish() const {
  if (impl_->watched()) std::this_thread::sleep_for(kWatched);
}

}  // namespace retiarius::program
