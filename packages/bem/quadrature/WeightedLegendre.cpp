#include "bem/quadrature/WeightedLegendre.hpp"

#include "bem/quadrature/Gauss.hpp"

namespace epafi::bem {

namespace {

std::vector<WeightedLegendre> makeTables() {
  std::vector<WeightedLegendre> tables;
  for (int order = 1; order <= largestGaussOrder; ++order) {
    const Rule& rule = gaussLegendre(order);
    WeightedLegendre table(rule.points.size());
    for (std::size_t q = 0; q < table.size(); ++q) {
      legendreValues(largestDegree + 2, rule.points[q], table[q].data());
      for (double& value : table[q])
        value *= rule.weights[q];
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace

const WeightedLegendre& weightedLegendre(int order) {
  static const std::vector<WeightedLegendre> tables = makeTables();
  return tables[static_cast<std::size_t>(order - 1)];
}

}  // namespace epafi::bem
