// The numbering of multipliers that belong to the displacement's nodes.
#include "contact/multiplier/MultiplierSpace.hpp"

#include "Rectangle.hpp"
#include "bem/base/Error.hpp"
#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "contact/multiplier/SharedNodes.hpp"
#include "contact/opposite/Obstacle.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace epafi {

namespace {

using contact::at;
using contact::Conditions;
using contact::Index;
using contact::MultiplierSpace;

/// Three elements on every side.
bem::Mesh squareMesh(int degree) { return test::squareMesh({3, 3, 3, 3}, degree); }

double zero(bem::Vec2) { return 0; }

Conditions::Contact frictional() {
  return {{}, contact::makeFriction("Tresca", {[](bem::Vec2) { return 1.0; }})};
}

const contact::MultiplierBasis& dual() {
  return contact::multiplierBasis("Biorthogonal");
}

/// Normal and tangential coefficients.
struct Counts {
  Index normal;
  Index tangential;
};

Counts countsOf(const Conditions& conditions, int degree) {
  const MultiplierSpace space(squareMesh(degree), dual(), conditions);
  std::set<Index> used;
  for (const auto& element : space.elements(0))
    for (int i = 0; i <= element.degree; ++i) {
      used.insert(element.normalOf(i));
      if (element.shears())
        used.insert(element.tangentialOf(i));
    }
  const Index all = space.size();  // numbered without gaps
  const bool whole = static_cast<Index>(used.size()) == all && *used.begin() == 0 &&
                     *used.rbegin() == all - 1;
  return whole ? Counts{space.normals(), all - space.normals()} : Counts{-1, -1};
}

// Pressures of all bodies, then all other coefficients, with the numbers that each has alone.
TEUCHOS_UNIT_TEST(MultiplierSpace, bodiesAreNumberedTogether) {
  const bem::Mesh meshes[] = {squareMesh(2), squareMesh(1), squareMesh(3)};
  Conditions conditions[3];
  conditions[0].contact["bottom"] = frictional();
  conditions[0].contact["right"] = {{}, contact::makeFriction("Tied", {})};
  conditions[2].contact["top"] = frictional();
  for (const contact::MultiplierBasis& basis : contact::multiplierBases()) {
    std::vector<MultiplierSpace::Body> bodies;
    for (const std::size_t b : {0, 1, 2})
      bodies.push_back({meshes[b], conditions[b]});
    const MultiplierSpace all(bodies, basis);
    Index normal = 0;
    Index other = all.normals();
    Index point = 0;
    for (const std::size_t b : {0, 1, 2}) {
      const MultiplierSpace alone(meshes[b], basis, conditions[b]);
      const auto number = [&](Index own) {
        return own < alone.normals() ? normal + own : other + own - alone.normals();
      };
      TEST_EQUALITY(all.elements(b).size(), alone.elements(0).size());
      TEST_EQUALITY(all.columns(b).size(), alone.columns(0).size());
      for (const Index own : alone.columns(0))
        TEST_EQUALITY(all.columns(b)[at(own)], number(own));
      for (std::size_t k = 0; k < alone.elements(0).size(); ++k) {
        const auto& mine = alone.elements(0)[k];
        const auto& here = all.elements(b)[k];
        TEST_EQUALITY(here.body, static_cast<int>(b));
        TEST_EQUALITY(here.mesh, &meshes[b]);
        TEST_EQUALITY(here.point, point + mine.point);
        TEST_EQUALITY(here.coefficients(), mine.coefficients());
        for (int i = 0; i < mine.coefficients(); ++i)
          TEST_EQUALITY(here.numberOf(i), number(mine.numberOf(i)));
      }
      normal += alone.normals();
      other += alone.size() - alone.normals();
      point += alone.points();
    }
    TEST_EQUALITY(normal, all.normals());
    TEST_EQUALITY(other, all.size());
    TEST_EQUALITY(point, all.points());
  }
}

// At a corner of two sides in contact normals come first.
TEUCHOS_UNIT_TEST(MultiplierSpace,
                  sharedNodesHaveOneCoefficientWhereNothingIsPrescribed) {
  Conditions one;
  one.contact["bottom"] = frictional();
  Conditions clamped = one;
  clamped.dirichlet["left"] = {zero, zero};
  clamped.dirichlet["right"] = {zero, {}};  // stops sliding, not lifting
  Conditions corner = one;
  corner.contact["right"] = frictional();
  for (const int p : {1, 2, 4, 5})
    for (const auto& [conditions, normal, tangential] :
         {std::tuple(one, 3 * p + 1, 3 * p + 1), std::tuple(clamped, 3 * p, 3 * p - 1),
          std::tuple(corner, 2 * (3 * p + 1), 2 * 3 * p)}) {
      const Counts counts = countsOf(conditions, p);
      TEST_EQUALITY(counts.normal, normal);
      TEST_EQUALITY(counts.tangential, tangential);
    }
}

/// ∫ f θ_i dt of the displacement's Lagrange functions at the Gauss-Lobatto points.
template <class Function>
bem::Vector momentsOf(int degree, const Function& f) {
  const auto& theta = contact::multiplierBasis("Gauss-Lobatto-Lagrange");
  const bem::Rule& rule = bem::gaussLegendre(2 * degree + 2);
  bem::Vector moments(degree + 1, 0.0);
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const bem::Vector values = theta.values(degree, rule.points[q]);
    for (std::size_t i = 0; i < moments.size(); ++i)
      moments[i] += rule.weights[q] * f(rule.points[q]) * values[i];
  }
  return moments;
}

bem::Vector lobattoWeights(int degree) {
  return momentsOf(degree, [](double) { return 1.0; });
}

double legendre(int degree, double t) {
  bem::Vector values(degree + 1);
  bem::legendreValues(degree, t, values.data());
  return values.back();
}

struct MissingEnds {
  std::array<contact::Coefficients::End, 2> ends;
  bool last = false;
  int lost = 0;  ///< degrees
};

const MissingEnds missingEnds[] = {{{{{false}, {true}}}, false, 1},
                                   {{{{true}, {false}}}, true, 1},
                                   {{{{false}, {false}}}, false, 2},
                                   {{{{false}, {false}}}, true, 2}};

TEUCHOS_UNIT_TEST(SharedNodes, endWeightsReproduceOneDegreeLessForEachMissingEnd) {
  for (int p = 1; p <= 12; ++p)
    for (const MissingEnds& missing : missingEnds)
      for (int k = 0; k <= p - missing.lost; ++k) {
        const bem::Vector a = contact::endWeights({p, missing.ends}, missing.last);
        const bem::Vector w = lobattoWeights(p);
        const bem::Vector moments =
            momentsOf(p, [k](double t) { return legendre(k, t); });
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
          sum += a[i] * moments[i] / w[i];
        const std::size_t end = missing.last ? a.size() - 1 : 0;
        TEST_COMPARE(std::abs(sum - moments[end] / w[end]), <, 1e-12);
      }
}

TEUCHOS_UNIT_TEST(SharedNodes, extendedFunctionsStayDualToAllFreeDisplacements) {
  for (int p = 2; p <= 9; ++p)
    for (const MissingEnds& missing : missingEnds) {
      const bem::Vector a = contact::endWeights({p, missing.ends}, missing.last);
      const bem::Vector w = lobattoWeights(p);
      const std::size_t end = missing.last ? a.size() - 1 : 0;
      for (std::size_t i = 0; i < a.size(); ++i) {
        if (!contact::Coefficients{p, missing.ends}.isOwn(static_cast<int>(i)))
          continue;
        const bem::Vector products = momentsOf(p, [&](double t) {
          const bem::Vector chi = dual().values(p, t);
          return chi[i] + a[i] * chi[end];
        });
        for (std::size_t j = 0; j < a.size(); ++j)
          if (j != end)
            TEST_COMPARE(std::abs(products[j] - (i == j ? w[i] : 0.0)), <, 1e-12);
      }
    }
}

/// Coefficients of a function of the place, node by node.
bem::Vector coefficientsOf(const MultiplierSpace& space, const bem::Mesh& mesh,
                           double (*f)(bem::Vec2)) {
  bem::Vector result(space.size(), 0.0);
  for (const auto& element : space.elements(0)) {
    const bem::Vector w = lobattoWeights(element.degree);
    const bem::Vector moments = momentsOf(element.degree, [&](double t) {
      return f(mesh.physicalPoint(element.element, t));
    });
    for (int i = 0; i <= element.degree; ++i) {
      const double value = moments[i] / w[i];
      if (element.normal.isOwn(i))
        result[element.normalOf(i)] = value;
      if (element.tangential.isOwn(i))
        result[element.tangentialOf(i)] = value;
    }
  }
  return result;
}

double cubic(bem::Vec2 x) {
  const double s = x.x - 0.5 * x.y;
  return 1 + s * (2 - s * (3 - 5 * s));
}

/// By how much the multiplier with the cubic's coefficients misses it.
double worstOfCubic(const bem::Mesh& mesh, const MultiplierSpace& space) {
  const bem::Vector multiplier = coefficientsOf(space, mesh, cubic);
  double worst = 0;
  for (const auto& element : space.elements(0))
    for (const double t : {-1.0, -0.4, 0.3, 1.0}) {
      const double exact = cubic(mesh.physicalPoint(element.element, t));
      const auto value = space.at(multiplier, element, t);
      worst = std::max(
          {worst, std::abs(value.normal - exact), std::abs(value.tangential - exact)});
    }
  return worst;
}

TEUCHOS_UNIT_TEST(SharedNodes, besideAClampPolynomialsOfOneDegreeLessAreInTheSpace) {
  Conditions conditions;
  conditions.contact["bottom"] = frictional();
  conditions.dirichlet["left"] = {zero, zero};
  const bem::Mesh mesh = squareMesh(4);
  TEST_COMPARE(worstOfCubic(mesh, MultiplierSpace(mesh, dual(), conditions)), <, 1e-12);
}

// The clamp takes the horizontal; the contact normal is (cos 0.005, sin 0.005).
TEUCHOS_UNIT_TEST(SharedNodes, besideANearlyParallelClampPolynomialsAreInTheSpace) {
  Conditions conditions;
  conditions.contact["right"] = frictional();
  conditions.dirichlet["top"] = {zero, {}};
  const bem::Loop leaning{{{0, 0}, {1, 0}, {1 - std::tan(0.005), 1}, {0, 1}},
                          {"bottom", "right", "top", "left"}};
  const bem::Mesh mesh = bem::makeMesh(test::outlineOf(leaning), {3, 3, 3, 3}, 4);
  const MultiplierSpace space(mesh, dual(), conditions);
  TEST_ASSERT(!space.elements(0).back().normal.ends[1].isUnknown);
  TEST_ASSERT(space.elements(0).back().normal.ends[1].clamped);
  TEST_COMPARE(worstOfCubic(mesh, space), <, 1e-12);
}

TEUCHOS_UNIT_TEST(SharedNodes, eachFreeNodeKeepsItsOwnGapBesideAClamp) {
  Conditions conditions;
  conditions.contact["bottom"] = {[](bem::Vec2) { return 0.7; }, nullptr, {}};
  conditions.dirichlet["left"] = {zero, zero};
  for (const int p : {1, 2, 5}) {
    const bem::Mesh mesh = squareMesh(p);
    const MultiplierSpace space(mesh, dual(), conditions);
    const double length = mesh.outline().diameter();
    bem::Vector weights(space.size(), 0.0);
    for (const auto& element : space.elements(0))
      for (int i = 0; i <= p; ++i)
        if (element.normal.isOwn(i))
          weights[element.normalOf(i)] +=
              mesh[element.element].half * lobattoWeights(p)[i];
    const bem::Vector gap =
        contact::makeObstacle(space, std::make_shared<const contact::Opposite>(length),
                              {length, 1})
            .gap;
    for (std::size_t i = 0; i < gap.size(); ++i)
      TEST_COMPARE(std::abs(gap[i] - weights[i] * 0.7 / length), <, 1e-14);
  }
}

/// Force of the multiplier on a node: as a function, and by what is numbered there.
struct NodeForces {
  bem::Vec2 ofFunction{0, 0};
  bem::Vec2 ofCoefficients{0, 0};
};

NodeForces forcesOn(int node, const bem::Mesh& mesh, const MultiplierSpace& space,
                    const bem::Vector& multiplier) {
  NodeForces forces;
  for (const auto& element : space.elements(0)) {
    const bem::Element& geometry = mesh[element.element];
    for (const int i : {0, element.degree}) {
      if ((i == 0 ? geometry.startNode : geometry.endNode) != node)
        continue;
      const double w = geometry.half * lobattoWeights(element.degree)[i];
      const bem::Vec2 n = geometry.segment().normal;
      const bem::Vec2 t = bem::turnLeft(n);
      const auto part = [&](double MultiplierSpace::Value::*component) {
        return geometry.half * momentsOf(element.degree, [&](double s) {
                 return space.at(multiplier, element, s).*component;
               })[i];
      };
      forces.ofFunction = forces.ofFunction + part(&MultiplierSpace::Value::normal) * n +
                          part(&MultiplierSpace::Value::tangential) * t;
      forces.ofCoefficients = forces.ofCoefficients +
                              w * multiplier[element.normalOf(i)] * n +
                              w * multiplier[element.tangentialOf(i)] * t;
    }
  }
  return forces;
}

TEUCHOS_UNIT_TEST(SharedNodes, atACornerTheFunctionKeepsTheForceOfTheInequalities) {
  Conditions conditions;
  conditions.contact["bottom"] = frictional();
  conditions.contact["right"] = frictional();
  const bem::Loop slanted{{{0, 0}, {1, 0}, {1.4, 1.1}, {0, 1}},
                          {"bottom", "right", "top", "left"}};
  const bem::Mesh mesh = bem::makeMesh(test::outlineOf(slanted), {2, 5, 3, 3}, 3);
  const MultiplierSpace space(mesh, dual(), conditions);
  bem::Vector multiplier;
  for (Index i = 0; i < space.size(); ++i)
    multiplier.push_back(std::sin(1 + 3.7 * static_cast<double>(i)));
  const int corner = mesh[mesh.elementsOf("right").front()].startNode;
  const NodeForces forces = forcesOn(corner, mesh, space, multiplier);
  TEST_COMPARE(norm(forces.ofFunction), >, 1e-3);
  TEST_COMPARE(norm(forces.ofFunction - forces.ofCoefficients), <, 1e-14);
}

TEUCHOS_UNIT_TEST(MultiplierSpace, anElementWithoutFreeNodesIsRefused) {
  Conditions conditions;
  conditions.contact["bottom"] = frictional();
  conditions.dirichlet["left"] = {zero, zero};
  conditions.dirichlet["right"] = {zero, zero};
  TEST_THROW(MultiplierSpace(test::squareMesh({1, 1, 1, 1}, 1), dual(), conditions),
             bem::InputError);
  TEST_NOTHROW(MultiplierSpace(test::squareMesh({2, 1, 1, 1}, 1), dual(), conditions));
}

}  // namespace

}  // namespace epafi
