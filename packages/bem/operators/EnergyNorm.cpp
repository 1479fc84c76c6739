#include "bem/operators/EnergyNorm.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/operators/PairColumns.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::bem {

double energyNorm(const CauchyData& data, const Kernel& kernel) {
  const Space space(data.mesh, kernel.components());
  const ElementRuns runs(space.mesh());
  const Mesh& mesh = space.mesh();
  Vector rows(data.fields.size());
  const Index count = mesh.size();
  constexpr double ofPair = 500;  // ns
  const double work = 0.5 * ofPair * static_cast<double>(count * count);
  parallelFor(
      {count, work}, [&] { return kernel.pairs(space); },
      [&](std::unique_ptr<PairColumns>& pairs, Index k) {  // the longest rows first
        const int e = asInt(count - 1 - k);
        if (mesh.isAxis(e))  // a circle of radius zero: no moments
          return;
        for (int r = 0; r <= runs.runOf(e); ++r) {
          const int last = std::min(runs[r].last, e + 1);
          pairs->integrate(runs, e, r, {runs[r].first, last});
          for (int f = runs[r].first; f < last; ++f)
            if (!mesh.isAxis(f))
              rows[at(e)] +=
                  (e == f ? 1 : 2) * pairs->energy(f - runs[r].first, data.fields[at(e)],
                                                   data.fields[at(f)]);
        }
      });
  return std::sqrt(std::max(0.0, std::accumulate(rows.begin(), rows.end(), 0.0)));
}

}  // namespace epafi::bem
