// What a case computes with: missions, simulations, reference tables; and where it puts results.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "retiarius/mission/mission.hpp"
#include "retiarius/mission/observer.hpp"
#include "retiarius/mission/run.hpp"
#include "retiarius/motion/simulation.hpp"
#include "verification/framework/fault.hpp"
#include "verification/framework/results.hpp"

namespace retiarius::verification {

// A mission that was run, with every row of its history.
struct MissionRun {
  Mission mission;
  std::shared_ptr<const MissionModel> model;
  std::vector<HistoryRow> rows;
  std::vector<State> frames;  // at frame times
  State last;
  RunReport report;

  // The row at `time` (s). Throws Error where there is none.
  const HistoryRow& at(double time) const;
  std::vector<double> times() const;
  std::vector<double> column(double HistoryRow::*value) const;
  double measure(const std::string& name) const;  // a number of the whole run; throws Error
  bool flag(const std::string& name) const;       // the same for a truth value
};

// A table of numbers with named columns.
struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;

  const std::vector<double>& operator[](const std::string& name) const;  // throws Error
  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
};

struct Case;

class Context {
 public:
  Context(const Case& of, bool quick, Fault fault = {})
      : case_(of), quick_(quick), fault_(std::move(fault)) {}

  // True in the quick form: the same comparisons where they are cheap, fewer where they are not.
  bool quick() const { return quick_; }

  // The case's NAME.toml, read with overrides.
  Mission mission(const std::string& name, const std::vector<std::string>& overrides = {}) const;
  // Runs a mission. Throws Error where its outcome is not `finished`, unless it `may_fail`.
  MissionRun run(const Mission& mission, bool may_fail = false) const;
  MissionRun run(const std::string& name, const std::vector<std::string>& overrides = {}) const;

  // A simulation of a net and bodies that must outlive it, not yet configured. The net is changed
  // where the present fault says so.
  Simulation simulation(Network& network, const std::vector<Body>& bodies) const;
  // The contact settings, changed where the present fault says so.
  ContactSpec contact(ContactSpec spec) const;
  // For cases that take a law by itself, without simulation: wrapped by the present fault.
  std::unique_ptr<Law> law(std::unique_ptr<Law> law) const;

  // The case's NAME.csv: a line of names, lines of numbers (NaN for words); lines that begin with #
  // say the source.
  Table table(const std::string& name) const;

  // Adds a comparison whose source is the case's unless one is given.
  void relative(const std::string& quantity, const std::string& unit, double ours, double reference,
                double bound, const std::string& argument, const std::string& source = {});
  void absolute(const std::string& quantity, const std::string& unit, double ours, double reference,
                double bound, const std::string& argument, const std::string& source = {});
  void chart(Chart chart) { result_.charts.push_back(std::move(chart)); }
  void note(std::string text) { result_.notes.push_back(std::move(text)); }

  CaseResult& result() { return result_; }

 private:
  void compare(ErrorKind kind, const std::string& quantity, const std::string& unit, double ours,
               double reference, double bound, const std::string& argument,
               const std::string& source);
  const std::string& file(const std::string& name) const;

  const Case& case_;
  bool quick_;
  Fault fault_;
  CaseResult result_;
};

// Contents of the case's files that are built into the program, by "case/name.toml".
const std::map<std::string, std::string>& embedded_files();

}  // namespace retiarius::verification
