#include "retiarius/net/network_file.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/net/outline.hpp"

namespace retiarius {
namespace {

struct Word {
  std::string text;
  SourcePlace place;
};

[[noreturn]] void refuse(const Word& word, const std::string& reason) {
  throw InputError(word.place, reason);
}

// Bytes that are no printable ASCII are shown as ?, so that a binary file gives a readable error.
std::string printable(std::string_view text) {
  std::string shown(text.substr(0, 40));
  for (char& c : shown) {
    if (c < ' ' || c > '~') c = '?';
  }
  return shown;
}

std::vector<Word> split(const std::string& line, const std::string& file, int number) {
  std::vector<Word> words;
  const std::size_t end = std::min(line.find('#'), line.size());
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  for (std::size_t i = 0; i < end;) {
    if (blank(line[i])) {
      ++i;
      continue;
    }
    std::size_t stop = i;
    while (stop < end && !blank(line[stop])) ++stop;
    words.push_back({line.substr(i, stop - i), {file, number, static_cast<int>(i) + 1}});
    i = stop;
  }
  return words;
}

double read_number(const Word& word) {
  double value = 0.0;
  const char* end = word.text.data() + word.text.size();
  const auto [stop, error] = std::from_chars(word.text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    refuse(word, fmt::format("\"{}\" is not a number", printable(word.text)));
  }
  return value;
}

struct SegmentLine {
  Word a, b, rest;  // rest: empty text where absent
  bool border = false;
};

// The statements of a file; node numbers are resolved once all nodes are known.
struct Statements {
  std::vector<Vec3> nodes;
  std::vector<double> mass;
  std::vector<SegmentLine> segments;
  std::vector<std::vector<Word>> threads;
  std::vector<Word> corners;
};

void expect_count(const std::vector<Word>& words, std::size_t least, std::size_t most,
                  const char* form) {
  if (words.size() < least) refuse(words.front(), fmt::format("expected: {}", form));
  if (words.size() > most) refuse(words[most], fmt::format("too many words; expected: {}", form));
}

void read_node(const std::vector<Word>& words, Statements& out) {
  expect_count(words, 4, 5, "node X Y Z [MASS]");
  out.nodes.emplace_back(read_number(words[1]), read_number(words[2]), read_number(words[3]));
  const double mass = words.size() == 5 ? read_number(words[4]) : 0.0;
  if (mass < 0.0) refuse(words[4], fmt::format("mass {} must be at least 0 (kg)", words[4].text));
  out.mass.push_back(mass);
}

void read_segment(std::vector<Word> words, Statements& out) {
  const char* form = "segment A B [REST_LENGTH] [border]";
  const bool border = words.size() > 3 && words.back().text == "border";
  if (border) words.pop_back();
  expect_count(words, 3, 4, form);
  SegmentLine segment{words[1], words[2], {}, border};
  if (words.size() == 4) {
    segment.rest = words[3];
    if (!(read_number(words[3]) > 0.0)) {
      refuse(words[3], fmt::format("rest length {} must be greater than 0 (m)", words[3].text));
    }
  }
  out.segments.push_back(std::move(segment));
}

void read_statement(std::vector<Word> words, Statements& out) {
  const std::string& kind = words.front().text;
  if (kind == "node") {
    read_node(words, out);
  } else if (kind == "segment") {
    read_segment(std::move(words), out);
  } else if (kind == "thread") {
    expect_count(words, 3, words.size(), "thread N0 N1 N2 ...");
    words.erase(words.begin());
    out.threads.push_back(std::move(words));
  } else if (kind == "corner") {
    expect_count(words, 2, 2, "corner N");
    out.corners.push_back(words[1]);
  } else {
    refuse(words.front(),
           fmt::format("unknown statement \"{}\"; allowed: node, segment, thread, corner",
                       printable(kind)));
  }
}

std::ifstream opened(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError(fmt::format("net.file = \"{}\": is a directory, not a network file", path));
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw InputError(
        fmt::format("net.file = \"{}\": cannot be read ({})", path, std::strerror(errno)));
  }
  return stream;
}

Statements read_statements(std::istream& stream, const std::string& path) {
  Statements out;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    std::vector<Word> words = split(line, path, number);
    if (!words.empty()) read_statement(std::move(words), out);
  }
  if (stream.bad()) throw InputError(fmt::format("net.file = \"{}\": reading failed", path));
  if (out.segments.empty()) {
    throw InputError(fmt::format("net.file = \"{}\": holds no segment", path));
  }
  return out;
}

// Turns statements into lines of pieces, so that each piece runs along its thread.
class Assembly {
 public:
  explicit Assembly(const Statements& in) : in_(in) {
    layout_.nodes = in.nodes;
    layout_.node_mass = in.mass;
    for (const SegmentLine& segment : in.segments) add_segment(segment);
    used_.assign(file_pieces_.size(), 0);
  }

  Layout layout() {
    for (const std::vector<Word>& thread : in_.threads) add_thread(thread);
    for (std::size_t i = 0; i < file_pieces_.size(); ++i) {
      if (!used_[i]) add_piece_line(file_pieces_[i]);
    }
    check_nodes();
    add_corners();
    layout_.outline = find_outline(layout_);
    return std::move(layout_);
  }

 private:
  Index node(const Word& word) const {
    Index value = 0;
    const char* end = word.text.data() + word.text.size();
    const auto [stop, error] = std::from_chars(word.text.data(), end, value);
    if (error != std::errc() || stop != end || value < 0 || value >= Index(in_.nodes.size())) {
      refuse(word, fmt::format("\"{}\" is not a node; the file has nodes 0 to {}",
                               printable(word.text), Index(in_.nodes.size()) - 1));
    }
    return value;
  }

  static std::uint64_t key(Index a, Index b) {
    return std::uint64_t(std::min(a, b)) << 32 | std::uint64_t(std::max(a, b));
  }

  void add_segment(const SegmentLine& segment) {
    const Index a = node(segment.a), b = node(segment.b);
    if (a == b) refuse(segment.b, fmt::format("segment joins node {} to itself", a));
    const double distance = (in_.nodes[a] - in_.nodes[b]).norm();
    if (!(distance > 0.0)) {
      refuse(segment.a, fmt::format("segment {} {} has both nodes at one place", a, b));
    }
    const double rest = segment.rest.text.empty() ? distance : read_number(segment.rest);
    if (!by_ends_.emplace(key(a, b), file_pieces_.size()).second) {
      refuse(segment.a, fmt::format("segment {} {} appears twice", a, b));
    }
    file_pieces_.push_back({a, b, rest, segment.border});
  }

  void add_thread(const std::vector<Word>& words) {
    Line line;
    line.first_piece = static_cast<Index>(layout_.pieces.size());
    line.border = true;
    line.nodes.push_back(node(words.front()));
    for (std::size_t i = 1; i < words.size(); ++i) {
      const Index a = line.nodes.back(), b = node(words[i]);
      const auto found = by_ends_.find(key(a, b));
      if (found == by_ends_.end())
        refuse(words[i], fmt::format("no segment joins {} and {}", a, b));
      if (used_[found->second]) {
        refuse(words[i], fmt::format("segment {} {} already belongs to a thread", a, b));
      }
      used_[found->second] = 1;
      const Piece& piece = file_pieces_[found->second];
      layout_.pieces.push_back({a, b, piece.rest_length, piece.border});
      line.border = line.border && piece.border;
      line.nodes.push_back(b);
    }
    layout_.lines.push_back(std::move(line));
  }

  void add_piece_line(const Piece& piece) {
    add_line(layout_, {piece.a, piece.b}, piece.rest_length, piece.border);
  }

  // A node without mass cannot move by any law.
  void check_nodes() const {
    std::vector<char> held(layout_.nodes.size(), 0);
    for (const Piece& piece : layout_.pieces) held[piece.a] = held[piece.b] = 1;
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (held[i] || in_.mass[i] > 0.0) continue;
      const SourcePlace place{in_.segments.front().a.place.file};
      throw InputError(place, fmt::format("node {} has neither a segment nor a mass", i));
    }
  }

  void add_corners() {
    for (const Word& word : in_.corners) {
      const Index corner = node(word);
      if (std::count(layout_.corners.begin(), layout_.corners.end(), corner)) {
        refuse(word, fmt::format("corner {} appears twice", corner));
      }
      layout_.corners.push_back(corner);
    }
    if (in_.corners.empty()) layout_.corners = hull_corners(layout_.nodes);
    if (layout_.corners.size() >= 3 && !(doubled_area(layout_.nodes, layout_.corners) > 0.0)) {
      refuse(in_.corners.front(), "corners must run counter-clockwise seen from +z");
    }
  }

  const Statements& in_;
  std::vector<Piece> file_pieces_;  // in the file's order
  std::unordered_map<std::uint64_t, std::size_t> by_ends_;
  std::vector<char> used_;
  Layout layout_;
};

}  // namespace

Layout read_network_file(const std::string& path) {
  std::ifstream stream = opened(path);
  const Statements statements = read_statements(stream, path);
  return Assembly(statements).layout();
}

Layout parse_network(const std::string& content, const std::string& path) {
  std::istringstream stream(content);
  const Statements statements = read_statements(stream, path);
  return Assembly(statements).layout();
}

}  // namespace retiarius
