#include "benchmarks/results.hpp"

#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "retiarius/base/build_info.hpp"
#include "retiarius/base/instruction_set.hpp"

namespace retiarius::benchmarks {

namespace {

// The processor's own name, where the system tells it.
std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line)) {
    if (line.rfind("model name", 0) != 0) continue;
    const auto colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

std::string results_csv(const std::vector<Measurement>& measurements) {
  const BuildInfo build = build_info();
  std::string text =
      fmt::format("# {} {}, kernels {}, {} ({} processors)\n", build.version, build.revision,
                  kernel_name(), processor_name(), std::thread::hardware_concurrency());
  text +=
      "nodes,n,s,across,bending,h,threads,solver,steps,step,assembly,factor,solve,rest,"
      "iterations,factorisations\n";
  for (const Measurement& m : measurements)
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{:.4e},{:.4e},{:.4e},{:.4e},{:.4e},{:.3f},{:.3f}\n",
                    m.nodes, m.member.n, m.member.s, m.member.across ? 1 : 0,
                    m.member.bending ? 1 : 0, m.h, m.threads, m.solver, m.steps, m.step, m.assembly,
                    m.factor, m.solve, m.rest, m.iterations, m.factorisations);
  return text;
}

std::string results_json(const std::vector<Measurement>& measurements) {
  const BuildInfo build = build_info();
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Measurement& m : measurements)
    list.push_back({{"nodes", m.nodes},
                    {"n", m.member.n},
                    {"s", m.member.s},
                    {"across", m.member.across},
                    {"bending", m.member.bending},
                    {"h", m.h},
                    {"threads", m.threads},
                    {"solver", m.solver},
                    {"steps", m.steps},
                    {"step", m.step},
                    {"assembly", m.assembly},
                    {"factor", m.factor},
                    {"solve", m.solve},
                    {"rest", m.rest},
                    {"iterations", m.iterations},
                    {"factorisations", m.factorisations}});
  const nlohmann::ordered_json all = {{"version", build.version},
                                      {"revision", build.revision},
                                      {"kernels", kernel_name()},
                                      {"processor", processor_name()},
                                      {"measurements", std::move(list)}};
  return all.dump(1) + "\n";
}

std::string heading_text() {
  return fmt::format(
      "{:>8} {:>4} {:>3} {:>7} {:>7} {:>7} {:>7} {:>9} {:>9} {:>8} {:>8} {:>8} {:>6} {:>7}\n",
      "nodes", "n", "s", "knots", "h/s", "threads", "solver", "step/ms", "assembly", "factor",
      "solve", "rest", "iter.", "factor.");
}

std::string measurement_text(const Measurement& m) {
  return fmt::format(
      "{:>8} {:>4} {:>3} {:>7} {:>7} {:>7} {:>7} {:>9.3f} {:>9.3f} {:>8.3f} {:>8.3f} {:>8.3f} "
      "{:>6.2f} "
      "{:>7.2f}\n",
      m.nodes, m.member.n, m.member.s,
      m.member.bending ? m.member.across ? "across" : "hinged" : "none", m.h, m.threads, m.solver,
      1e3 * m.step, 1e3 * m.assembly, 1e3 * m.factor, 1e3 * m.solve, 1e3 * m.rest, m.iterations,
      m.factorisations);
}

}  // namespace retiarius::benchmarks
