// Two bodies in one compressed system: cut together where they face each other, products and
// solutions are the dense ones.
#include "CompressedSamples.hpp"
#include "Processes.hpp"
#include "bem/algebra/Products.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace epafi::reference {

namespace {

using bem::Index;
using bem::Matrix;

/// Two squares of different stiffness, the upper side of the first along the lower side of the
/// second, and further unknowns of the first that act on both.
struct Pair {
  bem::Space first;
  bem::Space second;
  bem::Lame soft{bem::Material{1, 0.3, false}, 1.0};
  bem::Lame stiff{bem::Material{1000, 0.2, false}, 1.0};
  bem::LocalCoupling local;
  Matrix whole;

  Pair()
      : first(bem::makeMesh(outlineOf(square()), {24, 40, 24, 24}, 1)),
        second(bem::makeMesh(outlineOf(square()), {16, 16, 16, 30}, 2)) {
    couple();
    const Matrix a = wholeSystem(first, soft);
    const Matrix b = wholeSystem(second, stiff);
    const Index n = a.rows() + b.rows();
    whole = Matrix(n + static_cast<Index>(local.elements.size()),
                   n + static_cast<Index>(local.elements.size()));
    for (Index j = 0; j < a.columns(); ++j)
      std::copy_n(a.column(j), a.rows(), whole.column(j));
    for (Index j = 0; j < b.columns(); ++j)
      std::copy_n(b.column(j), b.rows(), whole.column(a.rows() + j) + a.rows());
    for (const auto& entry : local.entries) {
      whole(entry.row, entry.column) += entry.value;
      whole(entry.column, entry.row) += entry.value;
    }
  }

  Index size() const { return whole.rows(); }
  Index split() const { return first.displacements() + first.densities(); }

 private:
  // elements 24 to 63 of the first against 48 to 77 of the second, from the other end
  void couple() {
    const Index further = split() + second.displacements() + second.densities();
    const auto meets = [&](int e) { return 77 - (e - 24) * 30 / 40; };
    for (int e = 24; e < 64; ++e)
      for (int c = 0; c < 2; ++c) {
        const Index k = further + static_cast<Index>(local.elements.size());
        local.elements.push_back(e);
        local.bodies.push_back(0);
        const double h = first.mesh()[e].half;
        local.entries.push_back({first.displacement(e, 0, c), k, h});
        local.entries.push_back({first.displacement(e, 1, c), k, 0.4 * h});
        for (const int i : {0, 1, 2})
          local.entries.push_back(
              {split() + second.displacement(meets(e), i, c), k, -(0.6 - 0.2 * i) * h});
      }
  }
};

TEUCHOS_UNIT_TEST(Compressed, bodiesThatFaceEachOtherAreCutTogether) {
  const Pair pair;
  const bem::CompressedOperators z({{pair.first, pair.soft}, {pair.second, pair.stiff}},
                                   smallLeaves(), pair.local);
  // what is one over its diagonal entry is of one size
  bem::Vector scales;
  for (Index i = 0; i < pair.size(); ++i)
    scales.push_back(i < pair.split() ? 1 : i < z.range(1).densities ? 0.03 : 30);
  double worst = 0;
  std::size_t most = 0;
  for (int c = 1; c < z.tree().size(); ++c) {
    std::vector<Index> own;
    const Matrix weights = nestedWeights(z, c, own);
    const std::vector<Index>& skeleton = z.part(c).skeleton;
    std::vector<char> isOwn(pair.size());
    for (const Index i : own)
      isOwn[i] = 1;
    double error = 0;
    double size = 0;
    for (Index i = 0; i < pair.size(); ++i)
      for (std::size_t j = 0; j < own.size() && isOwn[i] == 0; ++j) {
        double sum = pair.whole(i, own[j]);
        size = std::max(size, scales[i] * scales[own[j]] * std::abs(sum));
        for (std::size_t k = 0; k < skeleton.size(); ++k)
          sum -= pair.whole(i, skeleton[k]) *
                 weights(static_cast<Index>(k), static_cast<Index>(j));
        error = std::max(error, scales[i] * scales[own[j]] * std::abs(sum));
      }
    worst = std::max(worst, error / size);
    // what acts across the cluster's end; all 80 where a side is alone
    std::set<Index> across;
    for (const auto& entry : pair.local.entries)
      if (isOwn[entry.column] != 0 && isOwn[entry.row] == 0 && entry.row >= pair.split())
        across.insert(entry.column);
    most = std::max(most, across.size());
  }
  out << "clusters " << worst << ", across " << most << "\n";
  TEST_COMPARE(worst, <, 1e-11);
  TEST_COMPARE(most, <=, 8);

  const bem::CompressedOperators shared(
      {{pair.first, pair.soft}, {pair.second, pair.stiff}}, smallLeaves(), pair.local,
      test::processes());
  Matrix x = oscillating(pair.size(), 2);
  for (Index j = 0; j < 2; ++j)
    for (Index i = 0; i < pair.size(); ++i)
      x(i, j) *= scales[i];
  const auto scaled = [&](Matrix a, double power) {
    for (Index j = 0; j < a.columns(); ++j)
      for (Index i = 0; i < a.rows(); ++i)
        a(i, j) *= std::pow(scales[i], power);
    return a;
  };
  TEST_COMPARE(relativeDifference(scaled(shared.times(x), 1),
                                  scaled(bem::product(pair.whole, x), 1)),
               <, 1e-11);

  // the lower side of the first and the upper one of the second held: 0 to 23, 16 to 31
  bem::Restriction clamp = clamped(pair.first, 0, 24);
  clamp.held.resize(pair.size());
  const bem::Restriction above = clamped(pair.second, 16, 32);
  std::copy(above.held.begin(), above.held.end(),
            clamp.held.begin() + static_cast<std::ptrdiff_t>(pair.split()));
  const Matrix b = scaled(oscillating(pair.size(), 1), -1);
  bem::CompressedFactor factor(shared, clamp);
  const double error =
      relativeDifference(scaled(factor.solve(b), -1),
                         scaled(denseSolution(pair.whole.copy(), clamp, b.copy()), -1));
  out << "solution " << error << "\n";
  TEST_COMPARE(error, <, 1e-8);
}

}  // namespace

}  // namespace epafi::reference
