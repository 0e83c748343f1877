// Aligned columns of text for the terminal.
#pragma once

#include <string>
#include <vector>

namespace retiarius::program {

// A name and a value a line, the values under each other.
class TextTable {
 public:
  void add(std::string name, std::string value) {
    rows_.push_back({std::move(name), std::move(value)});
  }
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  bool empty() const { return rows_.empty(); }

  // Every line begins with two blanks; columns are two blanks apart; ends with a line end.
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

// A number with four significant digits, and its unit if there is one.
std::string quantity(double value, const std::string& unit);

// "1.2 GB"; decimal units.
std::string byte_count(double bytes);

// "0.42 s", "12 s", "3 min 05 s", "2 h 07 min".
std::string duration(double seconds);

}  // namespace retiarius::program
