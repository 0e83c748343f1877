// Plays files to a fuzz target: each as it is, cut at many places, and with bytes changed in a
// fixed way, so that the entry functions are exercised wherever the tests run.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/target.hpp"
#include "retiarius/base/random.hpp"

namespace {

namespace fs = std::filesystem;

constexpr int kMutants = 150;  // of each file

std::string content(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

void add_files(const fs::path& path, std::vector<fs::path>& files) {
  if (!fs::is_directory(path)) {
    files.push_back(path);
    return;
  }
  for (const auto& entry : fs::directory_iterator(path))
    if (entry.is_regular_file()) files.push_back(entry.path());
}

void play(const std::string& bytes) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

std::string mutant(std::string bytes, std::uint64_t number) {
  std::uint64_t draw = 0;
  const auto below = [&](std::size_t n) { return retiarius::random_bits(1, number, draw++) % n; };
  for (std::size_t count = 1 + below(4); count > 0 && !bytes.empty(); --count) {
    const std::size_t at = below(bytes.size());
    switch (below(4)) {
      case 0:
        bytes[at] = static_cast<char>(below(256));
        break;
      case 1:
        bytes.resize(at);
        break;
      case 2:
        bytes.erase(at, 1 + below(8));
        break;
      default:
        bytes.insert(at, bytes.substr(below(bytes.size()), below(32)));
        break;
    }
  }
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<fs::path> files;
  int played = 0;
  fs::path now;
  try {
    for (int k = 1; k < argc; ++k) add_files(argv[k], files);
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
      now = file;
      const std::string bytes = content(file);
      play(bytes);
      for (int k = 0; k < kMutants; ++k) play(mutant(bytes, static_cast<std::uint64_t>(k)));
      played += 1 + kMutants;
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", now.c_str(), error.what());
    return 1;
  }
  if (played == 0) {
    std::fprintf(stderr, "no file to play\n");
    return 1;
  }
  std::printf("%d inputs from %zu files\n", played, files.size());
  return 0;
}
