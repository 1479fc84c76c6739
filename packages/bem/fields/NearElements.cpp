#include "bem/fields/NearElements.hpp"

#include "bem/moments/ElementPotential.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

/// Adds what carriers have of the fields of each state at eight points.
struct Combination {
  const ElementPotential& kernels;
  const std::vector<Complex>& shares;
  PointSources::Sums* sums;

  template <Division>
  EPAFI_INLINE void run() const {
    const auto count = static_cast<std::size_t>(kernels.size());
    for (std::size_t k = 0; k < shares.size() / count; ++k) {
      Pack sum[6] = {};
      for (std::size_t i = 0; i < count; ++i) {
        const KernelLanes& of = kernels[static_cast<int>(i)];
        PointSources::addProducts(shares[k * count + i], of.overConj.load(),
                                  of.cubic.load(), sum);
      }
      for (std::size_t part = 0; part < 6; ++part)
        add(sums[k / 2].of[k % 2][part].lane, sum[part]);
    }
  }
};

}  // namespace

NearElements::NearElements(const Mesh& mesh, int element,
                           const std::vector<EndPoint>& points, std::size_t states)
    : mesh_(mesh),
      element_(element),
      points_(points),
      states_(states),
      sums_((points.size() + lanes - 1) / lanes * states) {}

void NearElements::add(int source, const LocalField* fields, InstructionSet set) {
  const Element& y = mesh_[source];
  const SeenPoints seen(mesh_, element_, source, points_);
  ElementPotential kernels(y.curve, std::max(y.degree, y.densities));
  std::vector<Complex> shares;  // densities and slopes of the first state, and so on
  for (std::size_t state = 0; state < states_; ++state)
    for (const auto series : {&LocalField::density, &LocalField::slope})
      for (int k = 0; k < kernels.size(); ++k)
        shares.push_back(kernels.share(fields[state].*series, k));
  for (std::size_t first = 0; first < points_.size(); first += lanes) {
    kernels.evaluate(seen, first, set);
    dispatch(set, Combination{kernels, shares, sums_.data() + first / lanes * states_});
  }
}

}  // namespace epafi::bem
