// The far kernel of tractions against closed forms of the inner integrals.
#include "bem/tractions/FarTractions.hpp"

#include "bem/kernel/ElementSums.hpp"
#include "bem/moments/ElementRuns.hpp"
#include "bem/moments/RelativeTarget.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

namespace {

using bem::Complex;
using Operator = bem::FarTractions::Operator;

/// ∫ K' (P_j e_c) · P̂_i e_a ds, or with W, by 40 points on E and the closed form on F.
class Slow {
 public:
  Slow(const bem::Mesh& mesh, const bem::Lame& lame, int e, int f)
      : mesh_(mesh), lame_(lame), e_(e), f_(f) {}

  Complex value(Operator op, int i, int j, Complex unit) const {
    const bem::Element& source = mesh_[f_];
    const bem::Rule& rule = bem::gaussLegendre(40);
    const double half = mesh_[e_].half;
    Complex sum = 0;
    for (int q = 0; q < rule.size(); ++q) {
      const double t = rule.points[q];
      const auto target = bem::seenFrom(mesh_, f_, mesh_.at(e_, t));
      bem::ElementSums sums;
      sums.evaluate(source.curve, target, source.degree);
      const auto in = sums[j];
      const Complex normal = bem::asComplex(mesh_[e_].curve.normal(t));
      std::array<double, bem::largestDegree + 2> legendre{};
      bem::legendreValues(i, t, legendre.data());
      sum += rule.weights[q] * std::sqrt(half * (2 * i + 1) / 2) * legendre[i] *
             (op == Operator::Adjoint
                  ? bem::adjointDoubleLayer(lame_, normal, unit * in)
                  : bem::hypersingular(lame_, normal, 0.5 / source.half * unit * in));
    }
    return sum;
  }

 private:
  const bem::Mesh& mesh_;
  bem::Lame lame_;
  int e_;
  int f_;
};

/// The largest difference of a lane's values from the slow ones, relative to the largest.
double error(const bem::FarTractions& fast, const Slow& slow, int lane, int moments,
             int degree) {
  double largest = 0;
  double difference = 0;
  for (const auto op : {Operator::Adjoint, Operator::Hypersingular})
    for (int i = 0; i < moments; ++i)
      for (int j = 0; j < degree; ++j)
        for (int c = 0; c < 2; ++c) {
          const Complex exact = slow.value(op, i, j, c == 0 ? 1 : Complex(0, 1));
          const Complex value(fast.at(op, i, j, 0)[2 * lane + c],
                              fast.at(op, i, j, 1)[2 * lane + c]);
          largest = std::max(largest, std::abs(exact));
          difference = std::max(difference, std::abs(value - exact));
        }
  return difference / largest;
}

TEUCHOS_UNIT_TEST(FarTractions, equalThoseOfClosedForms) {
  const bem::Lame lame(bem::Material{1, 0.3, false});
  for (const auto& sample : reference::hardSamples()) {
    const bem::Mesh& mesh = sample.mesh;
    const bem::ElementRuns runs(mesh);
    double worst = 0;
    for (int e = 0; e < mesh.size(); e += std::max(1, mesh.size() / 3))
      for (const int moments : {mesh[e].degree + 1, 14}) {
        bem::FarTractions fast(mesh[e], lame, moments);
        for (int r = 0; r < runs.size(); ++r) {
          bem::FarBatch batch{};
          const auto chosen = runs.choose(e, r, {runs[r].first, runs[r].last}, batch, 7);
          if (chosen.count == 0)
            continue;
          for (const auto set : bem::instructionSets()) {
            fast.evaluate(batch, chosen, set);
            for (int f = runs[r].first; f < runs[r].last; ++f)
              if (chosen.far[f - runs[r].first])
                worst =
                    std::max(worst, error(fast, Slow(mesh, lame, e, f), f - runs[r].first,
                                          moments, mesh[f].degree));
          }
        }
      }
    out << sample.name << ": ";
    TEST_COMPARE(worst, <, 2e-12);
  }
}

}  // namespace

}  // namespace epafi
