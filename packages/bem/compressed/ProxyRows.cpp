#include "bem/compressed/ProxyRows.hpp"

#include "bem/kernel/PointKernels.hpp"
#include "bem/moments/FarOrder.hpp"
#include "bem/operators/LocalFunctions.hpp"
#include "bem/simd/Dispatch.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <map>

namespace epafi::bem {

namespace {

/// The fields of all functions of an element at all points.
struct Fields {
  const KernelConstants& constants;
  int packs;  ///< of points
  const AlignedLane* x;
  const AlignedLane* y;
  int nodes;
  int densities;
  int inner;             ///< Gauss points
  const double* places;  ///< y and tangent at each
  const double* values;  ///< functions there
  AlignedLane* sums;     ///< packs x (K: nodes x 4, -V: densities x 3)

  template <Division How>
  EPAFI_INLINE void run() const {
    const int width = 4 * nodes + 3 * densities;
    for (int p = 0; p < packs; ++p) {
      AlignedLane* to = sums + p * width;
      for (int i = 0; i < width; ++i)
        store(to[i].lane, Pack{});
      const Pack zero{};
      for (int q = 0; q < inner; ++q) {
        const double* s = places + 4 * q;
        const double* value = values + q * (nodes + densities);
        PointKernels g;
        g.evaluate<How>(constants, load(x[p].lane) - s[0], load(y[p].lane) - s[1], zero,
                        zero, s[2], s[3]);
        for (int j = 0; j < nodes; ++j)
          for (int i = 0; i < 4; ++i)
            add(to[4 * j + i].lane, value[j] * g.k[i]);
        for (int j = 0; j < densities; ++j)
          for (int i = 0; i < 3; ++i)
            add(to[4 * nodes + 3 * j + i].lane, value[nodes + j] * g.v[i]);
      }
    }
  }
};

/// Where a function's components stand among an element's sums: of a displacement xx, yx,
/// xy, yy, of a density xx, xy, yy.
int sumOf(const LocalFunctions& local, int function, int component) {
  const int c = function % 2;
  if (function < local.displacements)
    return 4 * (function / 2) + 2 * c + component;
  const int start = 2 * local.displacements + 3 * ((function - local.displacements) / 2);
  return start + c + component;
}

}  // namespace

ProxyRows::ProxyRows(const Space& space, const Lame& lame,
                     const std::vector<Unknown>& unknowns, double ratio, double tolerance)
    : space_(space), lame_(lame), unknowns_(unknowns), ratio_(ratio) {
  const double wanted = 2 * std::log(1 / tolerance) / std::log(ratio);
  points_ = lanes * static_cast<int>(std::ceil(std::max(24.0, wanted) / lanes));
}

Matrix ProxyRows::operator()(const ClusterTree& tree, int cluster,
                             const std::vector<Index>& columns, InstructionSet set) {
  constexpr double pi = boost::math::constants::pi<double>();
  const double radius = ratio_ * tree[cluster].radius;
  const int packs = points_ / lanes;
  std::vector<AlignedLane> x(packs);
  std::vector<AlignedLane> y(x.size());
  const KernelConstants constants(lame_);
  std::map<int, std::vector<std::pair<int, Index>>> wanted;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const Unknown& unknown = unknowns_[columns[j]];
    if (unknown.local < 0)
      continue;
    wanted[unknown.element].emplace_back(unknown.local, static_cast<Index>(j));
    if (unknown.isNode)
      wanted[space_.mesh()[unknown.element].previous].emplace_back(unknown.local + 2,
                                                                   static_cast<Index>(j));
  }
  Matrix out(2 * points_, static_cast<Index>(columns.size()));
  std::vector<AlignedLane> sums;
  for (const auto& [f, functions] : wanted) {
    const Element& element = space_.mesh()[f];
    const Vec2 middle = tree.fromCentre(cluster, space_.mesh().at(f, 0));
    for (int p = 0; p < points_; ++p) {
      const double angle = 2 * pi * p / points_;
      x[p / lanes].lane[p % lanes] = radius * std::cos(angle) - middle.x;
      y[p / lanes].lane[p % lanes] = radius * std::sin(angle) - middle.y;
    }
    const double distance = radius - length(middle);
    const Rule& rule = gaussLegendre(
        gaussPoints(farOrder(element.curve.angle(), distance / element.half),
                    element.degree, element.densities));
    std::vector<double> places;
    for (const double t : rule.points) {
      const Vec2 place = element.curve.fromMiddle(t);
      const Vec2 tangent = element.curve.tangent(t);
      places.insert(places.end(), {place.x, place.y, tangent.x, tangent.y});
    }
    const std::vector<double> values =
        weightedFunctions(rule, element.degree, element.densities, element.half);
    const LocalFunctions local(element);
    const int width = 2 * local.displacements + 3 * element.densities;
    sums.resize(packs * width);
    dispatch(set, Fields{constants, packs, x.data(), y.data(), element.degree + 1,
                         element.densities, rule.size(), places.data(), values.data(),
                         sums.data()});
    for (const auto& [function, column] : functions)
      for (int c = 0; c < 2; ++c) {
        const int sum = sumOf(local, function, c);
        double* to = out.column(column) + c * points_;
        for (int p = 0; p < points_; ++p)
          to[p] += sums[p / lanes * width + sum].lane[p % lanes];
      }
  }
  return out;
}

}  // namespace epafi::bem
