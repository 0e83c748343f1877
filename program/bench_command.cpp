// retiarius bench: step times of the hexagon family on this machine.
#include <memory>

#include <fmt/format.h>

#include "benchmarks/results.hpp"
#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/console.hpp"
#include "retiarius/record/file.hpp"

namespace retiarius::program {

namespace {

using namespace benchmarks;

struct BenchArguments {
  ComputingArguments computing;
  int largest = 10000;
  bool json = false, quick = false;
  std::string csv;
};

// From the net of 631 nodes up, doubling.
std::vector<Member> family(int largest) {
  std::vector<Member> members;
  for (const auto& [s, across] : {std::pair{0, true}, {3, true}, {9, true}, {9, false}}) {
    for (double n = s == 0 ? 7.0 : 5.0; n < 200.0; n *= 1.414) {
      Member m;
      m.n = static_cast<int>(n);
      m.s = s;
      m.across = across;
      if (count_network(net_of(m)).nodes > 1.05 * largest) break;
      members.push_back(m);
    }
  }
  return members;
}

void bench(const BenchArguments& arguments) {
  arguments.computing.apply();
  std::vector<Measurement> all;
  if (!arguments.json) print(heading_text());
  for (const Member& member : family(arguments.largest)) {
    for (const auto& [h, newton] :
         {std::pair{0.01, Newton::converged}, {0.001, Newton::converged}, {0.01, Newton::single}}) {
      Settings settings;
      settings.h = h;
      settings.newton = newton;
      settings.steps = arguments.quick ? 10 : 100;
      settings.repeats = arguments.quick ? 1 : 5;
      all.push_back(measure(member, settings));
      if (!arguments.json) print(measurement_text(all.back()));
      flush_output();
    }
  }
  if (arguments.json) print(results_json(all));
  if (!arguments.csv.empty()) write_atomically(arguments.csv, results_csv(all));
}

}  // namespace

void add_bench_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("bench", "Time the solver on nets of growing size");
  auto arguments = std::make_shared<BenchArguments>();
  command->add_option("--largest", arguments->largest, "Nodes of the largest net; default 10000")
      ->type_name("N")
      ->check(quiet(CLI::Range(600, 1000000)));
  command->add_flag("--quick", arguments->quick, "10 steps once instead of 100 steps five times");
  command->add_flag("--json", arguments->json, "Print JSON instead of a table");
  command->add_option("--csv", arguments->csv, "Also write the results to a CSV file")
      ->type_name("FILE");
  arguments->computing.add_to(*command);
  command->callback([arguments] { bench(*arguments); });
}

}  // namespace retiarius::program
