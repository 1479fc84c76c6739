// Pointwise residuals of the two integral equations: exact solutions,
// and the Galerkin matrices, which are integrals of the same fields.
#include "bem/fields/BoundaryFields.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/basis/Legendre.hpp"
#include "bem/moments/RelativeTarget.hpp"
#include "bem/operators/Assembly.hpp"
#include "reference/ExactFields.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace epafi::reference {

namespace {

using bem::Vec2;
using bem::Vector;

bem::Lame lameOf(double nu) { return bem::Lame({1, nu, false}); }

/// Numbers without any symmetry.
Vector anyVector(bem::Index size, double seed) {
  Vector v;
  for (bem::Index i = 0; i < size; ++i)
    v.push_back(std::sin(seed + 1.7 * static_cast<double>(i)));
  return v;
}

struct Errors {
  double traction = 0;  ///< L² norms relative to the traction's
  double mismatch = 0;
};

/// Of an exact field's Cauchy data on a mesh.
Errors errorsOf(const bem::Mesh& mesh, const bem::Lame& lame, const ExactField& field) {
  const bem::Space space(mesh);
  const Vector u = displacementOf(space, field);
  const Vector psi = tractionOf(space, field);
  const bem::BoundaryFields fields(space, lame, {{u, psi}});
  Errors errors;
  double size = 0;
  for (int e = 0; e < mesh.size(); ++e) {
    const auto values = fields.on(e).front();
    for (const bem::BoundaryValue& value : values) {
      const Vec2 exact = field.stress(mesh.scaledPoint(e, value.place.t)) *
                         mesh[e].curve.normal(value.place.t);
      const Vec2 off = value.traction - exact;
      errors.traction += value.weight * dot(off, off);
      errors.mismatch += value.weight * dot(value.mismatch, value.mismatch);
      size += value.weight * dot(exact, exact);
    }
  }
  return {std::sqrt(errors.traction / size), std::sqrt(errors.mismatch / size)};
}

TEUCHOS_UNIT_TEST(BoundaryFields, ofConstantStressAreExactToRounding) {
  for (const Sample& sample : hardSamples())
    for (double nu : {0.3, 0.4999})
      for (const PlaneStressTensor sigma :
           {PlaneStressTensor{1, 0, 0}, PlaneStressTensor{0, 1, 0},
            PlaneStressTensor{0, 0, 1}}) {
        const Errors errors =
            errorsOf(sample.mesh, lameOf(nu), constantStress(lameOf(nu), sigma, 0.3));
        out << sample.name << ", nu = " << nu << ": ";
        TEST_COMPARE(errors.traction, <, 1e-11);
        TEST_COMPARE(errors.mismatch, <, 1e-11);
      }
}

TEUCHOS_UNIT_TEST(BoundaryFields, ofAPointForceConvergeExponentiallyInP) {
  for (const auto& shape : {outlineOf(square()), squareWithHole()}) {
    const std::vector<int> two(shape->edges().size(), 2);
    const auto errors = [&](int p) {
      return errorsOf(bem::makeMesh(shape, two, p), lameOf(0.3),
                      pointForce(lameOf(0.3), {0.8, 0.5}, {0.6, -0.8}));
    };
    Errors before = errors(2);
    for (int p = 6; p <= 18; p += 4) {
      const Errors now = errors(p);
      out << "p = " << p << ": ";
      TEST_COMPARE(now.traction, <, std::max(0.05 * before.traction, 1e-10));
      TEST_COMPARE(now.mismatch, <, std::max(0.05 * before.mismatch, 1e-10));
      before = now;
    }
    TEST_COMPARE(before.traction + before.mismatch, <, 2e-10);
  }
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

TEUCHOS_UNIT_TEST(SoftenedRule, integratesWhatJumpsAtItsCuts) {
  const bem::Vector cuts = {0.3, -1, -0.999, 0.3 + 1e-9};
  double sum = 0;
  const bem::GradedRule rule = bem::softenedRule({{-1, 0}, {1, 0}}, 7, cuts);
  for (std::size_t q = 0; q < rule.points.size(); ++q)
    sum += rule.weights[q] * (rule.points[q].t < 0.3 ? 1 : 5);
  TEST_FLOATING_EQUALITY(sum, 1.3 + 5 * 0.7, 1e-13);
}

// Nodes of neighbours, tiny ones too, and of a side that lies opposite.
TEUCHOS_UNIT_TEST(SoftenedRule, integratesSquaresOfLogarithms) {
  using Profile = std::function<double(const bem::EndPoint&)>;
  const auto distance = [](double t, bem::Feature f) {
    return std::hypot(t - f.t, f.distance);
  };
  const auto claim = [&](const std::vector<bem::Feature>& features, const Profile& f) {
    const auto integral = [&](const bem::GradedRule& rule) {
      double sum = 0;
      for (std::size_t q = 0; q < rule.points.size(); ++q)
        sum += rule.weights[q] * f(rule.points[q]) * f(rule.points[q]);
      return sum;
    };
    const double exact = integral(bem::gradedRule(features, 24, 1e-13));
    TEST_COMPARE(std::abs(integral(bem::softenedRule(features, 7)) - exact), <,
                 1e-5 * std::max(exact, 0.1));
  };
  claim({{-1, 0}, {1, 0}},
        [](const bem::EndPoint& x) { return std::log(x.fromStart * x.toEnd); });
  for (const double size : {0.3, 1e-2, 1e-3, 1e-5}) {
    const bem::Feature next{1 + size, 0};
    claim({{1, 0}, next}, [&](const bem::EndPoint& x) {
      return std::log(x.toEnd) - std::log(x.toEnd + size);
    });
    const bem::Feature left{0.1, 0.1 * size};
    const bem::Feature right{0.1 + size, 0.1 * size};
    claim({left, right}, [&](const bem::EndPoint& x) {
      return std::log(distance(x.t, left)) - std::log(distance(x.t, right));
    });
  }
}

// What near pairs have at a corner and along an edge, times a polynomial.
TEUCHOS_UNIT_TEST(TouchingRule, integratesLogarithms) {
  const auto claim = [&](const std::vector<bem::Feature>& others, int power) {
    const auto profile = [&](const bem::EndPoint& x) {
      double sum = std::log(x.toEnd) * std::pow(x.toEnd, power == 5 ? 1 : 0);
      for (const bem::Feature& feature : others) {
        const double along =
            feature.t < 0 ? x.fromStart - (1 + feature.t) : 1 - feature.t - x.toEnd;
        sum += 0.5 * std::log(std::pow(along, 2) + std::pow(feature.distance, 2));
      }
      return sum * x.fromStart;
    };
    const auto integral = [&](const bem::GradedRule& rule) {
      double sum = 0;
      for (std::size_t q = 0; q < rule.points.size(); ++q)
        sum += rule.weights[q] * profile(rule.points[q]);
      return sum;
    };
    std::vector<bem::Feature> features = others;
    features.push_back({1, 0});
    const double exact = integral(bem::gradedRule(features, 30, 1e-15));
    const bem::GradedRule rule = bem::touchingRule(features, power == 5 ? 7 : 2, power);
    TEST_COMPARE(std::abs(integral(rule) - exact), <, 2e-14);
  };
  for (const int power : {5, 7}) {
    claim({{3, 0}}, power);
    claim({{1.5, 1}}, power);
    claim({{1, 0.1}}, power);
    claim({{0.3, 1e-4}, {-1.1, 0}}, power);
    claim({{0.999, 1e-9}}, power);
    claim({{-1, 0}}, power);
    claim({{-1, 0}, {-1.2, 0}}, power);
  }
}

double squareOf(const std::vector<bem::BoundaryValue>& values) {
  double square = 0;
  for (const bem::BoundaryValue& value : values)
    square += value.weight *
              (dot(value.traction, value.traction) + dot(value.mismatch, value.mismatch));
  return square;
}

// Near, by points, and by the moments of groups, which a mesh of 520 elements has.
TEUCHOS_UNIT_TEST(BoundaryFields, ofSeveralStatesAreThoseOfEach) {
  const bem::Lame lame = lameOf(0.3);
  std::vector<Sample> samples = hardSamples();
  samples.push_back(
      {"many elements", bem::makeMesh(outlineOf(square()), {130, 130, 130, 130}, 1)});
  for (const Sample& sample : samples) {
    const bem::Space space(sample.mesh);
    std::vector<Vector> u;
    std::vector<Vector> psi;
    for (const double seed : {0.3, 0.9, 1.7, 2.2, 3.1}) {
      u.push_back(anyVector(space.displacements(), seed));
      psi.push_back(anyVector(space.densities(), seed + 1));
    }
    std::vector<bem::BoundaryState> states;
    for (std::size_t k = 0; k < u.size(); ++k)
      states.push_back({u[k], psi[k]});
    const bem::BoundaryFields all(space, lame, states);
    double error = 0;
    double size = 0;
    for (std::size_t k = 0; k < states.size(); ++k) {
      const bem::BoundaryFields own(space, lame, {states[k]});
      for (int e = 0; e < sample.mesh.size(); e += 1 + sample.mesh.size() / 20) {
        const auto together = all.on(e)[k];
        const auto alone = own.on(e).front();
        for (std::size_t q = 0; q < alone.size(); ++q) {
          error = std::max({error, norm(together[q].traction - alone[q].traction),
                            norm(together[q].mismatch - alone[q].mismatch)});
          size = std::max({size, norm(alone[q].traction), norm(alone[q].mismatch)});
        }
      }
    }
    out << sample.name << ": ";
    TEST_COMPARE(error, <=, 1e-12 * size);
  }
}

// The fields have logarithms at nodes.
TEUCHOS_UNIT_TEST(BoundaryFields, haveTheirSquaresIntegratedByAFewPoints) {
  const bem::Lame lame = lameOf(0.3);
  for (const Sample& sample : hardSamples()) {
    const bem::Mesh& mesh = sample.mesh;
    const bem::Space space(mesh);
    const Vector u = anyVector(space.displacements(), 0.3);
    const Vector psi = anyVector(space.densities(), 1.1);
    const bem::BoundaryFields fields(space, lame, {{u, psi}});
    double worst = 0;
    std::size_t count = 0;
    for (int e = 0; e < mesh.size(); ++e) {
      const auto coarse = fields.on(e).front();
      std::vector<bem::Feature> nodes;
      for (const bem::Element& other : mesh.elements()) {
        const bem::Complex z =
            bem::seenFrom(mesh, e, {other.piece.edge, other.piece.start, 0}).z;
        nodes.push_back({z.real(), std::abs(z.imag())});
      }
      const bem::GradedRule rule = bem::gradedRule(nodes, 20, 1e-12);
      auto fine = fields.at(e, rule.points).front();
      for (std::size_t q = 0; q < fine.size(); ++q)
        fine[q].weight = mesh[e].half * rule.weights[q];
      const double exact = squareOf(fine);
      worst = std::max(worst, std::abs(squareOf(coarse) - exact) / exact);
      count += coarse.size();
    }
    out << sample.name << ", " << count / static_cast<std::size_t>(mesh.size())
        << " points: ";
    TEST_COMPARE(worst, <, 1e-5);
  }
}

// For bubbles phi on an element,  <W u + (K' + 1/2) psi, phi>  is a row of W and of
// (K + 1/2)';  <d/ds (V psi - (K + 1/2) u), phi> = -<V psi - (K + 1/2) u, phi'>  is a row
// of V and K + 1/2.
TEUCHOS_UNIT_TEST(BoundaryFields, integrateToTheGalerkinMatrices) {
  const bem::Lame lame = lameOf(0.3);
  for (const Sample& sample : hardSamples()) {
    const bem::Mesh& mesh = sample.mesh;
    const bem::Space space(mesh);
    const Vector u = anyVector(space.displacements(), 0.3);
    const Vector psi = anyVector(space.densities(), 1.1);
    const bem::BoundaryFields fields(space, lame, {{u, psi}});
    const bem::Operators operators = bem::assembleOperators(space, lame);
    Vector force = bem::multiplySymmetric(operators.hypersingular, u);
    for (std::size_t j = 0; j < force.size(); ++j)
      for (std::size_t i = 0; i < psi.size(); ++i)
        force[j] += operators.doubleLayer(static_cast<bem::Index>(i),
                                          static_cast<bem::Index>(j)) *
                    psi[i];
    Vector gap = bem::multiplySymmetric(operators.singleLayer, psi);
    const Vector ku = bem::product(operators.doubleLayer, u);
    for (std::size_t i = 0; i < gap.size(); ++i)
      gap[i] -= ku[i];

    double error = 0;
    double size = 0;
    for (int e = 0; e < mesh.size(); ++e) {
      const int p = mesh[e].degree;
      if (p < 2)
        continue;
      std::array<Vec2, bem::largestDegree + 1> forces{};
      std::array<Vec2, bem::largestDegree + 1> gaps{};
      const auto values = fields.on(e).front();
      for (const bem::BoundaryValue& value : values) {
        std::array<double, bem::largestDegree + 1> phi{};
        bem::DisplacementBasis::values(p, value.place.t, phi.data());
        for (int k = 2; k <= p; ++k) {
          forces[k] = forces[k] + value.weight * phi[k] * value.traction;
          gaps[k] = gaps[k] + value.weight * phi[k] * value.mismatch;
        }
      }
      for (int k = 2; k <= p; ++k)
        for (int c = 0; c < 2; ++c) {
          const auto part = [c](Vec2 v) { return c == 0 ? v.x : v.y; };
          const std::size_t i = space.displacement(e, k, c);
          const std::size_t j = space.density(e, k - 1, c);
          const double slope = bem::DisplacementBasis::slope(k) / mesh[e].half;
          error = std::max({error, std::abs(part(forces[k]) - force[i]),
                            std::abs(part(gaps[k]) + slope * gap[j])});
          size = std::max({size, std::abs(force[i]), std::abs(slope * gap[j])});
        }
    }
    out << sample.name << ": ";
    TEST_COMPARE(error, <=, 1e-6 * size);
  }
}

}  // namespace

}  // namespace epafi::reference
