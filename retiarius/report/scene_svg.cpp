#include "retiarius/report/scene_svg.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "retiarius/report/svg_plot.hpp"

namespace retiarius {

namespace {

constexpr double kWidth = 340, kHeight = 300, kMargin = 16, kBarSpace = 22;
constexpr int kShades = 8;  // CSS classes b0 ... b7, dark to light

// From world to paper: right, up, and towards the viewer.
struct Camera {
  Vec3 right, up, towards;
};

Camera camera() {
  const double azimuth = radians(-58.0), elevation = radians(24.0);
  const Vec3 towards(std::cos(elevation) * std::cos(azimuth),
                     std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  const Vec3 right = Vec3::UnitZ().cross(towards).normalized();
  return {right, towards.cross(right), towards};
}

// A straight piece of thread or a triangle, on paper.
struct Piece {
  double depth = 0.0;  // towards the viewer
  int style = 0;       // shade of a triangle; kShades for thread, kShades + 1 for the border
  int count = 0;       // corners
  std::array<Eigen::Vector2d, 3> corner = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(),
                                           Eigen::Vector2d::Zero()};
};

class Drawing {
 public:
  Drawing(const Scene& scene, const Picture& picture) {
    for (std::size_t k = 0; k < scene.threads.size(); ++k)
      add_thread(scene.threads[k], scene.border[k], picture.x);
    for (std::size_t k = 0; k < scene.bodies.size() && k < picture.bodies.size(); ++k)
      add_body(scene.bodies[k], picture.bodies[k]);
    fit();
  }

  std::string svg() {
    std::stable_sort(pieces_.begin(), pieces_.end(),
                     [](const Piece& a, const Piece& b) { return a.depth < b.depth; });
    std::string text;
    for (std::size_t begin = 0; begin < pieces_.size();) {
      std::size_t end = begin;
      while (end < pieces_.size() && pieces_[end].style == pieces_[begin].style) ++end;
      text += path(begin, end);
      begin = end;
    }
    return text + scale_bar();
  }

 private:
  void add_thread(const std::vector<Index>& line, bool border, const std::vector<Vec3>& x) {
    const auto at = [&](Index k) { return x[static_cast<std::size_t>(k)]; };
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      add({at(line[k]), at(line[k + 1])}, border ? kShades + 1 : kShades);
  }

  void add_body(const TriangleMesh& mesh, const BodyState& pose) {
    for (const auto& triangle : mesh.triangles) {
      std::vector<Vec3> corners;
      for (Index k : triangle)
        corners.push_back(to_world(pose, mesh.vertices[static_cast<std::size_t>(k)]));
      const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
      // Back sides are hidden by front sides, except where a surface is open (a plane).
      if (normal.dot(camera_.towards) <= 0.0 && mesh.triangles.size() > 2) continue;
      const Vec3 lamp = (camera_.towards + 0.9 * camera_.up - 0.5 * camera_.right).normalized();
      const double light = std::abs(normal.dot(lamp));
      add(corners, std::clamp(static_cast<int>(light * kShades), 0, kShades - 1));
    }
  }

  void add(const std::vector<Vec3>& corners, int style) {
    Piece piece;
    piece.style = style;
    piece.count = static_cast<int>(corners.size());
    for (std::size_t k = 0; k < corners.size(); ++k) {
      piece.corner[k] = {corners[k].dot(camera_.right), corners[k].dot(camera_.up)};
      piece.depth += corners[k].dot(camera_.towards) / piece.count;
    }
    pieces_.push_back(piece);
  }

  void fit() {
    Eigen::Vector2d low(INFINITY, INFINITY), high = -low;
    for (const Piece& piece : pieces_)
      for (int k = 0; k < piece.count; ++k) {
        low = low.cwiseMin(piece.corner[static_cast<std::size_t>(k)]);
        high = high.cwiseMax(piece.corner[static_cast<std::size_t>(k)]);
      }
    if (pieces_.empty()) return;
    const Eigen::Vector2d size = (high - low).cwiseMax(1e-9);
    scale_ =
        std::min((kWidth - 2 * kMargin) / size.x(), (kHeight - 2 * kMargin - kBarSpace) / size.y());
    middle_ = 0.5 * (low + high);
  }

  std::string point(const Eigen::Vector2d& p) const {
    return fmt::format("{:.1f} {:.1f}", 0.5 * kWidth + scale_ * (p.x() - middle_.x()),
                       0.5 * (kHeight - kBarSpace) - scale_ * (p.y() - middle_.y()));
  }

  // One path for pieces of one style that follow each other in depth.
  std::string path(std::size_t begin, std::size_t end) const {
    std::string data;
    for (std::size_t n = begin; n < end; ++n) {
      const Piece& piece = pieces_[n];
      for (int k = 0; k < piece.count; ++k) {
        data += k == 0 ? 'M' : 'L';
        data += point(piece.corner[static_cast<std::size_t>(k)]);
      }
      if (piece.count == 3) data += 'Z';
    }
    const int style = pieces_[begin].style;
    const std::string name = style == kShades       ? "net"
                             : style == kShades + 1 ? "net border"
                                                    : fmt::format("b{}", style);
    return fmt::format("<path class=\"{}\" d=\"{}\"/>", name, data);
  }

  // The longest of 1, 2, 5 times a power of ten that fits into a third of the width.
  std::string scale_bar() const {
    const double limit = kWidth / 3.0 / scale_;
    double length = std::pow(10.0, std::floor(std::log10(limit)));
    for (double factor : {5.0, 2.0})
      if (factor * length <= limit) {
        length *= factor;
        break;
      }
    const double y = kHeight - 10;
    return fmt::format(
        "<path class=\"axis\" d=\"M{0} {1}v4H{2:.1f}v-4\"/><text x=\"{3:.1f}\" y=\"{4}\">{5:g} "
        "m</text>",
        kMargin, y - 4, kMargin + scale_ * length, kMargin + scale_ * length + 6, y + 2, length);
  }

  Camera camera_ = camera();
  std::vector<Piece> pieces_;
  double scale_ = 1.0;
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();
};

}  // namespace

std::string scene_svg(const Scene& scene, const Picture& picture, const std::string& alternative) {
  return fmt::format("<svg class=\"scene\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">",
                     kWidth, kHeight, escape_html(alternative)) +
         Drawing(scene, picture).svg() + "</svg>";
}

}  // namespace retiarius
