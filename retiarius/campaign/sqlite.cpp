#include "retiarius/campaign/sqlite.hpp"

#include <utility>

#include <fmt/format.h>
#include <sqlite3.h>

#include "retiarius/base/error.hpp"

namespace retiarius {

Database::Database(const std::filesystem::path& path, bool create) : path_(path) {
  const int flags = SQLITE_OPEN_READWRITE | (create ? SQLITE_OPEN_CREATE : 0);
  if (sqlite3_open_v2(path.c_str(), &handle_, flags, nullptr) != SQLITE_OK) {
    const std::string why = handle_ ? sqlite3_errmsg(handle_) : "not enough memory";
    sqlite3_close(handle_);
    throw RunError(fmt::format("{}: {}", path.string(), why));
  }
  sqlite3_extended_result_codes(handle_, 1);
  sqlite3_busy_timeout(handle_, 60'000);
}

Database::~Database() { sqlite3_close_v2(handle_); }

void Database::fail() const {
  const int code = sqlite3_errcode(handle_);
  std::string why = sqlite3_errmsg(handle_);
  if ((code & 0xff) == SQLITE_IOERR)
    why += " (a full disk, a limit on file sizes, or a failing device)";
  throw RunError(fmt::format("{}: {}", path_.string(), why));
}

void Database::execute(const std::string& sql) {
  if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

Statement Database::prepare(const std::string& sql) {
  sqlite3_stmt* statement = nullptr;
  const auto size = static_cast<int>(sql.size());
  if (sqlite3_prepare_v2(handle_, sql.c_str(), size, &statement, nullptr) != SQLITE_OK) fail();
  return {*this, statement};
}

bool Database::has_table(const std::string& name) {
  Statement find = prepare("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?");
  find.bind(1, name);
  return find.step();
}

Statement::Statement(Statement&& other) noexcept
    : database_(other.database_), handle_(std::exchange(other.handle_, nullptr)) {}

Statement::~Statement() { sqlite3_finalize(handle_); }

Statement& Statement::bind(int parameter, std::int64_t value) {
  if (sqlite3_bind_int64(handle_, parameter, value) != SQLITE_OK) database_->fail();
  return *this;
}

Statement& Statement::bind(int parameter, double value) {
  if (sqlite3_bind_double(handle_, parameter, value) != SQLITE_OK) database_->fail();
  return *this;
}

Statement& Statement::bind(int parameter, const std::string& value) {
  const auto size = static_cast<int>(value.size());
  // The text is copied, for it may be gone before the statement is run: SQLite writes that as -1.
  // NOLINTNEXTLINE(performance-no-int-to-ptr)
  const auto copied = reinterpret_cast<sqlite3_destructor_type>(-1);
  if (sqlite3_bind_text(handle_, parameter, value.data(), size, copied) != SQLITE_OK)
    database_->fail();
  return *this;
}

Statement& Statement::bind_null(int parameter) {
  if (sqlite3_bind_null(handle_, parameter) != SQLITE_OK) database_->fail();
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(handle_);
  if (code != SQLITE_ROW && code != SQLITE_DONE) database_->fail();
  return code == SQLITE_ROW;
}

void Statement::reset() { sqlite3_reset(handle_); }

void Statement::run() {
  step();
  reset();
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(handle_, column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(handle_, column); }

double Statement::real(int column) const { return sqlite3_column_double(handle_, column); }

std::string Statement::text(int column) const {
  const void* bytes = sqlite3_column_blob(handle_, column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(handle_, column));
  return bytes ? std::string(static_cast<const char*>(bytes), size) : std::string();
}

int Statement::kind(int column) const { return sqlite3_column_type(handle_, column); }

std::optional<double> Statement::number(int column) const {
  if (is_null(column)) return std::nullopt;
  return real(column);
}

std::string sql_name(const std::string& name) {
  std::string out = "\"";
  for (const char c : name) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace retiarius
