#include "bem/compressed/ProxyRows.hpp"

#include "bem/compressed/CoupledEntries.hpp"
#include "bem/moments/Nearness.hpp"
#include "bem/moments/RingCircle.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace epafi::bem {

ProxyRows::ProxyRows(const Space& space, const Kernel& kernel,
                     const std::vector<Unknown>& unknowns, double ratio, double tolerance)
    : space_(space), unknowns_(unknowns), ratio_(ratio), far_(kernel.far(space)) {
  const double wanted = 2 * std::log(1 / tolerance) / std::log(ratio);
  points_ = lanes * static_cast<int>(std::ceil(std::max(24.0, wanted) / lanes));
}

Matrix ProxyRows::operator()(const ClusterTree& tree, int cluster,
                             const std::vector<Index>& columns) {
  constexpr double pi = boost::math::constants::pi<double>();
  const double radius = ratio_ * tree[cluster].radius;
  std::vector<AlignedLane> circle(2 * points_ / lanes);
  const Mesh& mesh = space_.mesh();
  std::vector<double> angles(at(points_));
  std::vector<double> scales(at(points_), 1);
  for (int p = 0; p < points_; ++p)
    angles[at(p)] = 2 * pi * p / points_;
  if (mesh.outline().isAxisymmetric()) {
    const int e = tree.element(tree[cluster].first);
    const RingCircle around{
        mesh.scaledPoint(e, -1).x - tree.fromCentre(cluster, mesh.at(e, -1)).x, radius};
    for (int p = 0; p < points_; ++p) {
      angles[at(p)] = around.angle(p, points_);
      const double distance = around.middle + radius * std::cos(angles[at(p)]);
      scales[at(p)] = 1 / std::sqrt(2 * pi * distance);  // entries have 2πr of x
    }
  }
  const int components = space_.components();
  Matrix out(components * points_, static_cast<Index>(columns.size()));
  for (const auto& [f, functions] : byElements(space_, unknowns_, columns)) {
    const Element& element = space_.mesh()[f];
    const Vec2 middle = tree.fromCentre(cluster, space_.mesh().at(f, 0));
    for (int p = 0; p < points_; ++p) {
      AlignedLane* to = circle.data() + 2 * (p / lanes);
      to[0].lane[p % lanes] = radius * std::cos(angles[at(p)]) - middle.x;
      to[1].lane[p % lanes] = radius * std::sin(angles[at(p)]) - middle.y;
    }
    const double distance = radius - length(middle);
    far_->evaluateFields(circle, f,
                         farOrder(element.curve.angle(), distance / element.half));
    for (const auto& [function, column] : functions)
      for (int c = 0; c < components; ++c) {
        double* to = out.column(column) + c * points_;
        for (int p = 0; p < points_; p += lanes) {
          const double* from = far_->field(at(p / lanes), function, c);
          for (int lane = 0; lane < lanes; ++lane)
            to[p + lane] += scales[at(p + lane)] * from[lane];
        }
      }
  }
  return out;
}

}  // namespace epafi::bem
