// Which files of a run's folder a server may hand out.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace retiarius::program {

// The regular file that a request's path ("/replay.bin", already decoded) means below a folder;
// none where there is no such file or where it lies outside: by "..", by an absolute path, by a
// symbolic link that leads out. Hidden files (a name that begins with a dot) are not handed out.
std::optional<std::filesystem::path> served_file(const std::filesystem::path& folder,
                                                 std::string_view path);

// "text/plain; charset=utf-8" for .toml and so on, by the name's end.
std::string media_type(const std::filesystem::path& file);

// Whether an address means this machine only: 127.x.x.x, ::1 or localhost.
bool is_loopback(const std::string& host);

// Whether a request's header Host (with or without port) names this machine. A page from elsewhere
// whose name was made to lead here (DNS rebinding) has another one.
bool names_loopback(std::string_view host_header);

}  // namespace retiarius::program
