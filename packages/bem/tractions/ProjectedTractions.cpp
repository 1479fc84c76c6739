#include "bem/tractions/ProjectedTractions.hpp"

#include "bem/basis/Legendre.hpp"

#include <cmath>

namespace epafi::bem {

// φ_i = slope(i) (P_i - P_{i-2}) / (2i-1),  P̂_i = √((2i+1)/2h) P_i;  a hat is (P_0 + P_1) / 2
// before its node, (P_0 - P_1) / 2 behind it
TractionKernels projectedTractions(const Space& space, const Lame& lame,
                                   const std::vector<int>& elements) {
  const Mesh& mesh = space.mesh();
  TractionKernels kernels;
  kernels.elements = elements;
  kernels.start.assign(1, 0);
  std::vector<int> moments;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const Element& e = mesh[elements[k]];
    const Index first = kernels.start[k];
    const bool follows = k > 0 && e.previous == elements[k - 1];
    moments.push_back(follows ? 1 : 2);
    for (int c = 0; c < 2 && follows; ++c) {
      const Index before = kernels.start[k - 1] + c;
      const double ratio = mesh[e.previous].half / e.half;
      kernels.raised.push_back({first + 2 + c,
                                {{before, std::sqrt(3 * ratio)},
                                 {before + 2, std::sqrt(ratio)},
                                 {first + c, std::sqrt(3.0)}},
                                space.displacement(elements[k], 0, c),
                                -std::sqrt(6 / e.half)});
    }
    for (int i = 2; i <= e.degree; ++i)
      for (int c = 0; c < 2; ++c) {
        const Index column = first + 2 * i + c;
        kernels.raised.push_back({column,
                                  {{column - 4, std::sqrt((2 * i + 1) / (2 * i - 3.0))}},
                                  space.displacement(elements[k], i, c),
                                  std::sqrt((2 * i + 1) / (2 * e.half)) * (2 * i - 1) /
                                      DisplacementBasis::slope(i)});
      }
    kernels.start.push_back(first + 2 * (e.degree + 1));
  }
  if (!elements.empty())
    kernels.lowest = kernelRows(space, lame, elements, moments, TractionForm::Projected,
                                space.rotation() == nullptr ? 0 : 1);
  return kernels;
}

}  // namespace epafi::bem
