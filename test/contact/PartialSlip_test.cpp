// Manufactured partial slip: a smooth exact field, two contact sides, one that sticks and
// one that slips; rates in displacement and contact stress for every basis.
#include "bem/quadrature/Gauss.hpp"
#include "contact/Form.hpp"
#include "contact/SolvedScene.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "contact/results/Solved.hpp"
#include "reference/ExactFields.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace epafi {

namespace {

using bem::Vec2;
using contact::Stabilization;
using reference::PlaneStressTensor;

enum class Law { Tresca, Coulomb };

constexpr double nu = 0.3;
constexpr double twoMu = 1 / (1 + nu);  // E = 1

/// On the unit square: pressure one with shear, no strain along x, the gradient of a harmonic
/// function on top of it, and a translation downwards.  On the bottom u_t = u_x = 0; on the right
/// u_t = u_y < 0 and sigma_t = sigma_xy > 0, so that friction -sigma_t works against the slip.
struct Manufactured {
  std::shared_ptr<const bem::Outline> outline = std::make_shared<const bem::Outline>(
      bem::Loop{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {"stick", "slip", "top", "left"}});

  Vec2 displacement(Vec2 x) const {
    const double wave = 0.1 * std::exp(x.x);
    return {(wave * std::sin(x.y) + 0.5 * x.y) / twoMu,
            (wave * std::cos(x.y) - (1 - 2 * nu) / (1 - nu) * x.y) / twoMu - 2};
  }
  PlaneStressTensor stress(Vec2 x) const {
    const double wave = 0.1 * std::exp(x.x);
    return {wave * std::sin(x.y) - nu / (1 - nu), -wave * std::sin(x.y) - 1,
            wave * std::cos(x.y) + 0.25};
  }

  bem::Function shearOn(Vec2 normal, double factor, Law law) const {
    return [=, *this](Vec2 x) {
      const Vec2 traction = stress(x) * normal;
      const double bound = factor * std::abs(dot(traction, {-normal.y, normal.x}));
      return law == Law::Tresca ? bound : bound / -dot(traction, normal);
    };
  }

  contact::Conditions conditions(Law law) const {
    const auto friction = [law](const bem::Function& f) {
      return contact::makeFriction(law == Law::Tresca ? "Tresca" : "Coulomb", {f});
    };
    contact::Conditions result;
    const auto gap = [=, *this](Vec2 normal) {
      return [=, *this](Vec2 x) { return dot(displacement(x), normal); };
    };
    result.contact["stick"] = {gap({0, -1}), friction(shearOn({0, -1}, 2, law))};
    result.contact["slip"] = {gap({1, 0}), friction(shearOn({1, 0}, 1, law))};
    result.neumann["top"] = {[*this](Vec2 x) { return stress(x).xy; },
                             [*this](Vec2 x) { return stress(x).yy; }};
    result.dirichlet["left"] = {[*this](Vec2 x) { return displacement(x).x; },
                                [*this](Vec2 x) { return displacement(x).y; }};
    return result;
  }
};

struct Errors {
  double displacement = 0;  ///< L2 on the contact sides
  double multiplier = 0;    ///< L2
  bool states = true;       ///< the one sticks, the other slips, all is closed
};

struct Choice {
  const char* basis;
  Stabilization::Form form;
  Law law;
};

Errors errorsOn(const Manufactured& exact, int elements, int degree,
                const Choice& choice) {
  const bem::Mesh mesh =
      bem::makeMesh(exact.outline, {elements, elements, elements, elements}, degree);
  const test::SolvedScene scene({mesh,
                                 {1, nu, false},
                                 exact.conditions(choice.law),
                                 choice.basis,
                                 test::ofForm(choice.form)});
  if (!scene.report().converged())
    throw std::runtime_error(told(scene.report().stages));
  const contact::ContactFields fields(scene.solved());
  const auto rule = bem::gaussLegendre(degree + 6);
  Errors errors;
  for (const auto& element : fields.elements()) {
    const Vec2 normal = mesh[element.element].segment().normal;
    const Vec2 tangent{-normal.y, normal.x};
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      const contact::ContactPoint point = fields.at(element, rule.points[q]);
      const Vec2 traction = exact.stress(point.place) * normal;
      const Vec2 displacement = exact.displacement(point.place);
      const double weight = rule.weights[q] * mesh[element.element].half;
      errors.displacement +=
          weight * (std::pow(point.normal - dot(displacement, normal), 2) +
                    std::pow(point.tangential - dot(displacement, tangent), 2));
      errors.multiplier += weight * (std::pow(point.pressure + dot(traction, normal), 2) +
                                     std::pow(point.shear + dot(traction, tangent), 2));
      const bool sticks = *element.boundary == "stick";
      errors.states = errors.states && point.closed &&
                      point.friction == (sticks ? contact::FrictionKind::Stick
                                                : contact::FrictionKind::Slip);
    }
  }
  errors.displacement = std::sqrt(errors.displacement);
  errors.multiplier = std::sqrt(errors.multiplier);
  return errors;
}

TEUCHOS_UNIT_TEST(PartialSlip, theFieldIsASolutionOfContactWithFriction) {
  const Manufactured exact;
  for (int k = 0; k <= 64; ++k) {
    const double s = k / 64.0;
    const PlaneStressTensor bottom = exact.stress({s, 0});
    const PlaneStressTensor right = exact.stress({1, s});
    TEST_COMPARE(bottom.yy, <, -0.1);
    TEST_COMPARE(right.xx, <, -0.1);
    TEST_COMPARE(std::abs(exact.displacement({s, 0}).x), <, 1e-14);
    TEST_COMPARE(right.xy, >, 0.01);
    TEST_COMPARE(exact.displacement({1, s}).y, <, -0.1);
  }
}

/// p + 1 in the displacement, p in the contact stress; under Coulomb's law the
/// coefficient varies, so that the bounds of Bernstein's coefficients are of second order.
TEUCHOS_UNIT_TEST(PartialSlip, convergesAtFullOrderForEveryBasis) {
  const Manufactured exact;
  for (const Law law : {Law::Tresca, Law::Coulomb})
    for (const contact::MultiplierBasis& basis : contact::multiplierBases())
      for (const auto form : {Stabilization::Form::Projected, Stabilization::Form::Exact})
        for (const int degree : {1, 2, 3}) {
          const bool stabilised = !basis.sharesNodes;
          if (!stabilised && form == Stabilization::Form::Exact)
            continue;  // has no stabilisation of any form
          const Choice choice{basis.name, stabilised ? form : Stabilization::Form::None,
                              law};
          const int finest = degree == 1 ? 64 : 32;
          const Errors coarse = errorsOn(exact, finest / 2, degree, choice);
          const Errors fine = errorsOn(exact, finest, degree, choice);
          const double rate = std::log2(coarse.displacement / fine.displacement);
          const double stressRate = std::log2(coarse.multiplier / fine.multiplier);
          out << (law == Law::Tresca ? "Tresca " : "Coulomb ") << basis.name
              << (form == Stabilization::Form::Exact ? " exact" : " projected")
              << " p = " << degree << ": u " << fine.displacement << " rate " << rate
              << ", lambda " << fine.multiplier << " rate " << stressRate << "\n";
          const bool bounded =
              law == Law::Coulomb && std::string(basis.name) == "Bernstein";
          const int order = bounded ? 2 : degree + 1;
          TEST_COMPARE(rate, >, order - 0.15);
          TEST_COMPARE(stressRate, >, std::min(order, degree) - 0.1);
          TEST_ASSERT(fine.states);
        }
}

}  // namespace

}  // namespace epafi
