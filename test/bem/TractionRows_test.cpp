// Tractions of the kernels on elements against closed forms of the inner integrals.
#include "bem/tractions/TractionRows.hpp"

#include "bem/kernel/Elasticity.hpp"
#include "bem/moments/ArcRule.hpp"
#include "bem/moments/RelativeTarget.hpp"
#include "bem/quadrature/Graded.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi {

namespace {

using bem::Complex;
using bem::Index;
using bem::Matrix;

/// The same as kernelRows by points graded toward all ends of elements and the closed form by
/// arcs' weights, which holds for segments as well.
class Slow {
 public:
  Slow(const bem::Space& space, const bem::Lame& lame, int element, int moments)
      : rows(space.displacements() + space.densities(), 2 * moments) {
    const bem::Mesh& mesh = space.mesh();
    const double half = mesh[element].half;
    for (int f = 0; f < mesh.size(); ++f) {
      std::vector<bem::Feature> features;
      for (const bem::Position& end : {mesh[f].piece.start, mesh[f].piece.end}) {
        const auto seen = bem::seenFrom(mesh, element, {mesh[f].piece.edge, end, 0});
        features.push_back({seen.z.real(), std::abs(seen.b())});
      }
      const double smallest = 1e-16 * std::min(1.0, mesh[f].half / half);
      const bem::GradedRule rule = bem::gradedRule(features, 40, smallest);
      const bem::ArcRule arc(mesh[f].curve, mesh[f].degree);
      std::array<bem::KernelLanes, bem::ArcRule::largestSize> weights;
      for (int q = 0; q < rule.size(); ++q) {
        const bem::EndPoint& point = rule.points[q];
        const Complex normal = bem::asComplex(mesh[element].curve.normal(point.t));
        bem::RelativeTarget targets[bem::lanes];
        std::fill_n(
            targets, bem::lanes,
            bem::seenFrom(mesh, f, mesh.at(element, point.fromStart, point.toEnd)));
        arc.evaluate(bem::packed(targets), weights.data());
        std::vector<double> tests(static_cast<std::size_t>(moments) + 1);
        bem::legendreValues(moments - 1, point.t, tests.data());
        std::array<double, bem::largestDegree + 2> own{};
        if (f == element)
          bem::legendreValues(mesh[f].degree, point.t, own.data());
        for (int j = 0; j < mesh[f].degree; ++j) {
          bem::SourceSums sums;
          for (int k = 0; k < arc.size(); ++k) {
            const double factor = arc.legendre(k, j);
            sums.overConj += factor * weights[k].overConj[0];
            sums.cubic += factor * weights[k].cubic[0];
          }
          sums.overW = std::conj(sums.overConj);
          for (int c = 0; c < 2; ++c) {
            const Complex unit = c == 0 ? Complex(1, 0) : Complex(0, 1);
            const Complex ofDensity =
                bem::adjointDoubleLayer(lame, normal, unit * sums) + 0.5 * own[j] * unit;
            const Complex ofSlope = bem::hypersingular(lame, normal, unit * sums);
            for (int i = 0; i < moments; ++i) {
              const double factor =
                  rule.weights[q] * std::sqrt(half * (2 * i + 1) / 2) * tests[i];
              add(space.displacements() + space.density(f, j, c), i, factor * ofDensity);
              const auto [first, last] = bem::DisplacementBasis::withDerivative(j);
              for (int k = first; k <= last; ++k)
                add(space.displacement(f, k, c), i,
                    factor * bem::DisplacementBasis::slope(k) / mesh[f].half * ofSlope);
            }
          }
        }
      }
    }
  }

  Matrix rows;

 private:
  void add(Index row, int i, Complex value) {
    rows(row, 2 * i) += value.real();
    rows(row, 2 * i + 1) += value.imag();
  }
};

/// The largest difference of some rows and the columns from `first` on, relative to the largest
/// entry.
double error(const Matrix& fast, Index first, const Matrix& slow, Index from, Index to) {
  double largest = 0;
  double difference = 0;
  for (Index j = 0; j < slow.columns(); ++j)
    for (Index i = from; i < to; ++i) {
      largest = std::max(largest, std::abs(slow(i, j)));
      difference = std::max(difference, std::abs(fast(i, first + j) - slow(i, j)));
    }
  return difference / largest;
}

// Beside elements 1e-9 times as long as the one that is tested; t has an ulp of 1e-16 there.
TEUCHOS_UNIT_TEST(GradedRule, takesAsManyPointsADecadeAtTheEndsAsElsewhere) {
  const double next = std::nextafter(-1.0, 0.0);
  const std::vector<bem::Feature> features = {{-1, 0}, {next, 0}, {1, 0}, {-next, 1e-20}};
  const bem::GradedRule rule = bem::gradedRule(features, 17, 1e-20);
  const int sides = 6;  // of features, from which intervals grow: 25 points a decade
  TEST_COMPARE(rule.size(), <, sides * 25 * 20);
  double sum = 0;
  for (int q = 0; q < rule.size(); ++q)
    sum += rule.weights[q] *
           (std::log(rule.points[q].fromStart) - 2 * std::log(rule.points[q].toEnd));
  TEST_FLOATING_EQUALITY(sum, 2 - 2 * std::log(2), 1e-13);
}

TEUCHOS_UNIT_TEST(TractionRows, ofKernelsEqualThoseOfClosedForms) {
  const bem::Lame lame(bem::Material{1, 0.3, false});
  for (const auto& sample : reference::hardSamples()) {
    const bem::Space space(sample.mesh);
    std::vector<int> elements;
    std::vector<int> moments;
    for (int e = 0; e < sample.mesh.size(); e += std::max(1, sample.mesh.size() / 3)) {
      elements.push_back(e);
      moments.push_back(sample.mesh[e].degree + 1);
    }
    double worst = 0;
    for (const auto form : {bem::TractionForm::Projected, bem::TractionForm::Exact}) {
      const auto rows = bem::kernelRows(space, lame, elements, moments, form);
      for (std::size_t k = 0; k < elements.size(); ++k) {
        const Slow slow(space, lame, elements[k], moments[k]);
        const Index both[] = {0, space.displacements(), slow.rows.rows()};
        for (int part = 0; part < 2; ++part)
          worst = std::max(worst, error(rows.rows, rows.start[k], slow.rows, both[part],
                                        both[part + 1]));
      }
    }
    out << sample.name << ": ";
    TEST_COMPARE(worst, <, 2e-12);
  }
}

}  // namespace

}  // namespace epafi
