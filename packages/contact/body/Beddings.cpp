#include "contact/body/Beddings.hpp"

#include "bem/compressed/Skeletons.hpp"
#include "bem/compressed/Slices.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace epafi::contact {

namespace {

// Of what a bedding stands on: r falls by this factor in a step of defect correction.
constexpr double share = 1e-3;
constexpr double worth = 100;

double complianceOf(const bem::Mesh& mesh, const bem::Lame& lame) {
  const double s = bem::slenderness(mesh) / 16;
  return (1 + s * s * s) / bem::youngOf(lame);
}

/// Of a body, by the other one: the coefficients that bond them; by itself: to what does not deform.
using Bonds = std::map<std::size_t, std::vector<Index>>;

std::vector<Bonds> bondsOf(const MultiplierSpace& multiplier,
                           const std::vector<Coupling>& couplings) {
  std::vector<char> isBonded(at(multiplier.size()));
  multiplier.forEachElement([&](const MultiplierSpace::ContactElement& element) {
    for (int i = 0; element.ties() && i < element.coefficients(); ++i)
      isBonded[at(element.numberOf(i))] = 1;
  });
  std::vector<std::vector<std::size_t>> bodies(isBonded.size());
  for (std::size_t b = 0; b < couplings.size(); ++b)
    for (const Index i : couplings[b].columns())
      if (isBonded[at(i)] != 0)
        bodies[at(i)].push_back(b);
  std::vector<Bonds> bonds(couplings.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (const std::size_t b : bodies[i])
      bonds[b][bodies[i].front() == b ? bodies[i].back() : bodies[i].front()].push_back(
          static_cast<Index>(i));
  return bonds;
}

}  // namespace

Beddings makeBeddings(const std::vector<const bem::Space*>& spaces,
                      const std::vector<bem::Lame>& lames,
                      const MultiplierSpace& multiplier,
                      const std::vector<Coupling>& couplings) {
  Beddings result;
  result.of.resize(spaces.size());
  Vector compliances;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    result.order.push_back(b);
    compliances.push_back(complianceOf(spaces[b]->mesh(), lames[b]));
  }
  std::stable_sort(
      result.order.begin(), result.order.end(),
      [&](std::size_t a, std::size_t b) { return compliances[a] < compliances[b]; });
  const std::vector<Bonds> bonds = bondsOf(multiplier, couplings);
  const Vector lengths = multiplier.lengths();
  std::vector<int> depths(spaces.size());
  Vector known(spaces.size(), std::numeric_limits<double>::infinity());
  for (const std::size_t b : result.order) {
    double least = std::numeric_limits<double>::infinity();
    Bonds::const_iterator best;
    for (auto bond = bonds[b].begin(); bond != bonds[b].end(); ++bond) {
      const double below =
          bond->first == b ? 1 / bem::youngOf(lames[b]) : known[bond->first];
      if (below < least) {
        least = below;
        best = bond;
      }
    }
    known[b] = compliances[b];
    if (!(compliances[b] * share >= worth * least))
      continue;
    known[b] = least;
    depths[b] = 1 + (best->first == b ? 0 : depths[best->first]);
    result.depth = std::max(result.depth, depths[b]);
    Bedding& bedding = result.of[b];
    bedding.holder = best->first;
    for (const Index i : bedding.rows = best->second)
      bedding.stiffness.push_back(share / (least * lengths[at(i)]));
  }
  std::stable_partition(result.order.begin(), result.order.end(),
                        [&](std::size_t b) { return result.of[b].rows.empty(); });
  return result;
}

}  // namespace epafi::contact
