#include "bem/operators/PairColumns.hpp"

#include <algorithm>

namespace epafi::bem {

PairColumns::PairColumns(const Space& space) : space_(space) {
  for (int k = 0; k <= largestDegree; ++k)
    functionSlopes_[static_cast<std::size_t>(k)] = DisplacementBasis::slope(k);
  int functions = 1;
  for (const Element& element : space.mesh().elements())
    functions = std::max(functions, element.densities);
  longest_ = 2 * lanes * functions + 2;
  for (Vector* columns : {&single_, &double_, &hypersingular_, &transposed_})
    columns->resize(static_cast<std::size_t>(2 * (functions + 1) * longest_));
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
    densityStarts_[lane + 1] = densityStarts_[lane] + 2 * densityCounts_[lane];
    displacementStarts_[lane + 1] = displacementStarts_[lane] + 2 * degrees_[lane];
  }
  return true;
}

void PairColumns::addHalf(const Matrix& mass) {
  for (Index k = 0; k < mass.columns(); ++k)
    for (Index c = 0; c < 2; ++c) {
      double* to = double_.data() + (2 * k + c) * longest_ +
                   densityStarts_[at(trial_ - run_->first)] + c;
      for (Index i = 0; i < mass.rows(); ++i)
        to[2 * i] += 0.5 * mass(i, k);
    }
}

}  // namespace epafi::bem
