// SQLite, as far as campaigns use it: a database, its statements, every error an exception that
// names the file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace retiarius {

class Statement;

class Database {
 public:
  // Opens the file, which is made where `create` says so. Throws RunError.
  explicit Database(const std::filesystem::path& path, bool create = false);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  void execute(const std::string& sql);
  Statement prepare(const std::string& sql);
  bool has_table(const std::string& name);
  const std::filesystem::path& path() const { return path_; }
  [[noreturn]] void fail() const;  // throws RunError with SQLite's message

 private:
  std::filesystem::path path_;
  sqlite3* handle_ = nullptr;
};

// Parameters count from 1, columns from 0. Throws RunError.
class Statement {
 public:
  Statement(Database& database, sqlite3_stmt* handle) : database_(&database), handle_(handle) {}
  Statement(Statement&& other) noexcept;
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, double value);
  Statement& bind(int parameter, const std::string& value);
  Statement& bind_null(int parameter);

  bool step();  // whether there is a row
  void reset();
  void run();  // step, then reset

  bool is_null(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;
  int kind(int column) const;  // SQLITE_INTEGER, SQLITE_FLOAT, SQLITE_TEXT, SQLITE_NULL, ...
  std::optional<double> number(int column) const;  // none where it is null

 private:
  Database* database_;
  sqlite3_stmt* handle_;
};

// A name as an identifier in SQL, whatever its characters.
std::string sql_name(const std::string& name);

}  // namespace retiarius
