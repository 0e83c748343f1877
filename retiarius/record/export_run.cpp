#include "retiarius/record/export_run.hpp"

#include <string>

#include <fmt/format.h>

#include "retiarius/record/file.hpp"
#include "retiarius/record/history_csv.hpp"
#include "retiarius/record/output_folder.hpp"
#include "retiarius/record/run_file.hpp"

namespace retiarius {

namespace {

RunFile open_run(const std::filesystem::path& run) { return RunFile(run / "run.h5"); }

void export_history(const RunFile& run, const std::filesystem::path& out) {
  const std::vector<std::string> names = run.history_names();
  std::vector<std::vector<double>> columns;
  for (const std::string& name : names) columns.push_back(run.history(name));
  OutputFile file(out / "history.csv");
  file.write(fmt::format("{}\n", fmt::join(names, ",")));
  std::vector<double> row(columns.size());
  for (std::size_t r = 0; !columns.empty() && r < columns[0].size(); ++r) {
    for (std::size_t k = 0; k < columns.size(); ++k) row[k] = columns[k][r];
    file.write(csv_line(row));
  }
  file.close();
}

std::string node_lines(const FrameData& frame, std::size_t number) {
  std::string text;
  for (std::size_t k = 0; k < frame.x.size(); ++k)
    text += csv_line({static_cast<double>(number), frame.time, static_cast<double>(k),
                      frame.x[k].x(), frame.x[k].y(), frame.x[k].z(), frame.v[k].x(),
                      frame.v[k].y(), frame.v[k].z(), frame.curvature[k]});
  return text;
}

std::string segment_lines(const FrameData& frame, std::size_t number) {
  std::string text;
  for (std::size_t k = 0; k < frame.tension.size(); ++k)
    text += csv_line({static_cast<double>(number), frame.time, static_cast<double>(k),
                      frame.tension[k], frame.strain[k]});
  return text;
}

std::string body_lines(const FrameData& frame, std::size_t number) {
  std::string text;
  for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
    const BodyState& b = frame.bodies[k];
    text +=
        csv_line({static_cast<double>(number), frame.time, static_cast<double>(k), b.position.x(),
                  b.position.y(), b.position.z(), b.attitude.x(), b.attitude.y(), b.attitude.z(),
                  b.attitude.w(), b.velocity.x(), b.velocity.y(), b.velocity.z(),
                  b.angular_momentum.x(), b.angular_momentum.y(), b.angular_momentum.z()});
  }
  return text;
}

}  // namespace

void export_vtk(const std::filesystem::path& run, const std::filesystem::path& out) {
  const RunFile file = open_run(run);
  prepare_output_folder(out);
  VtkSeries series(out, file.net(), file.bodies());
  for (std::size_t k = 0; k < file.frame_count(); ++k) series.add(file.frame(k));
  series.finish();
}

void export_csv(const std::filesystem::path& run, const std::filesystem::path& out) {
  const RunFile file = open_run(run);
  prepare_output_folder(out);
  export_history(file, out);
  OutputFile nodes(out / "nodes.csv"), segments(out / "segments.csv"), bodies(out / "bodies.csv");
  nodes.write("frame,time,node,x,y,z,vx,vy,vz,curvature\n");
  segments.write("frame,time,segment,tension,strain\n");
  bodies.write("frame,time,body,x,y,z,qx,qy,qz,qw,vx,vy,vz,lx,ly,lz\n");
  for (std::size_t k = 0; k < file.frame_count(); ++k) {
    const FrameData frame = file.frame(k);
    nodes.write(node_lines(frame, k));
    segments.write(segment_lines(frame, k));
    bodies.write(body_lines(frame, k));
  }
  for (OutputFile* f : {&nodes, &segments, &bodies}) f->close();
}

}  // namespace retiarius
