#include "bem/quadrature/WeightedLegendre.hpp"

#include "bem/quadrature/Gauss.hpp"
#include "bem/quadrature/MadeOnce.hpp"

namespace epafi::bem {

namespace {

WeightedLegendre makeTable(int order) {
  const Rule& rule = gaussLegendre(order);
  WeightedLegendre table(rule.points.size());
  for (std::size_t q = 0; q < table.size(); ++q) {
    legendreValues(largestDegree + 2, rule.points[q], table[q].data());
    for (double& value : table[q])
      value *= rule.weights[q];
  }
  return table;
}

}  // namespace

const WeightedLegendre& weightedLegendre(int order) {
  static MadeOnce<WeightedLegendre, largestGaussOrder> tables(makeTable);
  return tables[order];
}

}  // namespace epafi::bem
