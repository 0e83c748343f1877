// Serves the viewer's page and the files of one run's folder, while the run goes on or afterwards.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

namespace retiarius::program {

// --host and --port.
struct ServerArguments {
  std::string host = "127.0.0.1";
  int port = 0;  // 0: a free one

  void add_to(CLI::App& command, const std::string& needs = "");
};

// Answers from construction to destruction, on threads of its own. GET and HEAD only: "/" is the
// page, everything else a file of the folder, whole or one byte range of it.
class LiveServer {
 public:
  // Throws InputError where it cannot listen there, Error where the program lacks the viewer.
  // Warns where others than this machine can reach it.
  LiveServer(const std::filesystem::path& folder, const std::string& title,
             const ServerArguments& arguments);
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  std::string address() const;  // "http://127.0.0.1:PORT/"
  int port() const;

  // Gives pages that watch now, if any, the time to fetch a run's last files: a page asks about
  // every 0.7 s.
  void let_watchers_finish() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace retiarius::program
