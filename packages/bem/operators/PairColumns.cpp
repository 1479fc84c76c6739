#include "bem/operators/PairColumns.hpp"

#include <algorithm>

namespace epafi::bem {

PairColumns::PairColumns(const Space& space)
    : space_(space), components_(space.components()) {
  for (int k = 0; k <= largestDegree; ++k)
    functionSlopes_[static_cast<std::size_t>(k)] = DisplacementBasis::slope(k);
  int functions = 1;
  for (const Element& element : space.mesh().elements())
    functions = std::max(functions, element.densities);
  longest_ = components_ * (lanes * functions + 1);
  for (Vector* columns : {&single_, &double_, &hypersingular_, &transposed_})
    columns->resize(static_cast<std::size_t>(components_ * (functions + 1) * longest_));
}

bool PairColumns::setRun(const ElementLanes& run, int trial) {
  trial_ = trial;
  if (run_ == &run)
    return false;
  const Mesh& mesh = space_.mesh();
  run_ = &run;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const int e = run.first + static_cast<int>(lane);
    const bool isThere = e < run.last;
    degrees_[lane] = isThere ? mesh[e].degree : 0;
    densityCounts_[lane] = isThere ? mesh[e].densities : 0;
    densityStarts_[lane + 1] = densityStarts_[lane] + components_ * densityCounts_[lane];
    displacementStarts_[lane + 1] =
        displacementStarts_[lane] + components_ * degrees_[lane];
  }
  return true;
}

void PairColumns::addHalf(const Matrix& mass) {
  for (Index k = 0; k < mass.columns(); ++k)
    for (Index c = 0; c < components_; ++c) {
      double* to = first(double_, asInt(k)) + c * longest_ +
                   densityStarts_[at(trial_ - run_->first)] + c;
      for (Index i = 0; i < mass.rows(); ++i)
        to[components_ * i] += 0.5 * mass(i, k);
    }
}

}  // namespace epafi::bem
