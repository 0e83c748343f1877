// Threads as straight runs, cut where they go behind a body.
#include <algorithm>

#include "retiarius/render/painter.hpp"

namespace retiarius::render {

namespace {

constexpr double kStep = 3.0;  // on paper, between the places where hiding is asked for

Place between(const Place& a, const Place& b, double t) {
  // Along a straight line in perspective 1/depth is linear on paper.
  const double nearness = (1.0 - t) / a.depth + t / b.depth;
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 1.0 / nearness,
          a.scale + t * (b.scale - a.scale)};
}

class Cutter {
 public:
  Cutter(const DepthMap& depths, double tolerance, std::vector<ThreadPiece>& pieces)
      : depths_(depths), tolerance_(tolerance), pieces_(pieces) {}

  void add(const Place& a, const Place& b, ThreadPiece piece) {
    const int count =
        std::max(1, std::min(400, static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / kStep)));
    for (int k = 0, begin = 0; k < count; ++k) {
      const bool hidden = hides(a, b, k, count);
      if (k + 1 < count && hides(a, b, k + 1, count) == hidden) continue;
      piece.from = between(a, b, static_cast<double>(begin) / count);
      piece.to = between(a, b, static_cast<double>(k + 1) / count);
      piece.depth = 0.5 * (piece.from.depth + piece.to.depth);
      piece.hidden = hidden;
      pieces_.push_back(piece);
      begin = k + 1;
    }
  }

 private:
  bool hides(const Place& a, const Place& b, int k, int count) const {
    return depths_.hides(between(a, b, (k + 0.5) / count), tolerance_);
  }

  const DepthMap& depths_;
  double tolerance_;
  std::vector<ThreadPiece>& pieces_;
};

}  // namespace

std::vector<ThreadPiece> thread_pieces(const DrawnRun& run, const FrameData& frame,
                                       const Camera& camera, const DepthMap& depths,
                                       const Look& look) {
  std::vector<ThreadPiece> pieces;
  // Contact sees nodes: threads between them dip a little into edges and must not vanish there.
  Cutter cutter(depths, 0.012 * camera.radius(), pieces);
  std::vector<Place> places;
  places.reserve(frame.x.size());
  for (const Vec3& x : frame.x) places.push_back(camera.place(x));
  const std::vector<double> values = segment_values(look.quantity, run.net, frame);
  for (std::size_t k = 0; k < run.net.segments.size(); ++k) {
    const auto a = static_cast<std::size_t>(run.net.segments[k][0]);
    const auto b = static_cast<std::size_t>(run.net.segments[k][1]);
    const Vec3 tangent = (frame.x[b] - frame.x[a]).normalized();
    const double along = tangent.dot(camera.lamp());
    const double scale = 0.5 * (places[a].scale + places[b].scale);
    const double least = (run.border[k] ? 1.9 : 1.25) * look.size *
                         std::clamp(scale / camera.middle_scale(), 0.75, 1.4);
    const double radius = std::max(run.net.radius[a], run.net.radius[b]);
    ThreadPiece piece;
    piece.width = std::max(least, 2.0 * radius * scale);
    piece.colour = value_colour(look.quantity, values.empty() ? 0.0 : values[k], look.high);
    piece.light = std::sqrt(std::max(0.0, 1.0 - along * along));
    cutter.add(places[a], places[b], piece);
  }
  for (const Ball& ball : run.balls) {
    const Place& p = places.at(static_cast<std::size_t>(ball.node));
    ThreadPiece piece;
    piece.from = piece.to = p;
    piece.depth = p.depth - ball.radius;
    piece.width =
        2.0 * std::max(4.2 * look.size * std::clamp(p.scale / camera.middle_scale(), 0.75, 1.4),
                       ball.radius * p.scale);
    piece.hidden = depths.hides(p, 0.012 * camera.radius() + ball.radius);
    piece.ball = true;
    pieces.push_back(piece);
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const ThreadPiece& a, const ThreadPiece& b) {
    return a.hidden != b.hidden ? a.hidden : a.depth > b.depth;
  });
  return pieces;
}

}  // namespace retiarius::render
