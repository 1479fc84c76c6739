#include "adaptivity/estimate/ContactTerms.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::adaptivity {

namespace {

void addChanges(const bem::Profile& f, int degree, Vector& breaks) {
  const Vector changes = bem::signChanges(f, degree);
  breaks.insert(breaks.end(), changes.begin(), changes.end());
}

Vector breaks(const ContactProfiles& c) {
  Vector result = {-0.5, 0, 0.5};  // gap and bound are the user's and may bend anywhere
  result.insert(result.end(), c.nodes.begin(), c.nodes.end());
  addChanges(c.pressure, c.degree, result);
  addChanges(c.opening, c.highest, result);
  addChanges(c.shear, c.degree, result);
  addChanges(c.tangential, c.highest, result);
  addChanges([&](double t) { return std::abs(c.shear(t)) - c.bound(t); }, c.degree,
             result);
  return result;
}

/// The part of the bound that the shear along a slip leaves.
double unusedBound(double bound, double shear, double slip) {
  return bound - std::clamp(slip < 0 ? -shear : shear, -bound, bound);
}

/// Where lostWork bends: where it takes the whole force or the whole length.
void addBends(const bem::Profile& force, const bem::Profile& length, double soft,
              const bem::Profile& fineness, int degree, Vector& breaks) {
  addChanges([&](double t) { return force(t) - 2 * soft * fineness(t) * length(t); },
             degree, breaks);
  addChanges([&](double t) { return 2 * force(t) - soft * length(t); }, degree, breaks);
}

Vector sharpBreaks(const ContactProfiles& c, double stiffness) {
  Vector result = breaks(c);
  addBends(c.pressure, c.opening, stiffness, c.fineness, c.highest, result);
  addBends([&](double t) { return unusedBound(c.bound(t), c.shear(t), c.tangential(t)); },
           [&](double t) { return std::abs(c.tangential(t)); }, stiffness, c.fineness,
           c.highest, result);
  return result;
}

}  // namespace

ContactProfiles contactProfiles(const contact::Solved& solved,
                                const ContactElement& element, const AtEnds& correction) {
  const bem::Mesh& mesh = solved.space.mesh();
  const bem::Element& geometry = mesh[element.element];
  const contact::MultiplierSpace& multiplier = solved.problem.multiplier();
  const int p = element.degree;
  // what is a polynomial on a segment nearly is one on an arc, whose directions turn
  constexpr int forTurning = 8;
  const int degree =
      geometry.curve.isStraight() ? p : std::min(p + forTurning, bem::largestDegree);
  const auto component = [&](const auto& direction, const Vector* before) {
    return Polynomial(
        [&, before](double t) {
          bem::Vec2 u =
              solved.space.displacementAt(solved.displacement, element.element, t);
          if (before != nullptr)
            u = u - solved.space.displacementAt(*before, element.element, t);
          return dot(u, direction(t));
        },
        degree);
  };
  const auto stress = [&](auto part, const auto& direction) {
    return Polynomial(
        [&, part](double t) {
          const double start = dot(correction.start, direction(t)) / geometry.half;
          const double end = dot(correction.end, direction(t)) / geometry.half;
          return multiplier.at(solved.state.multiplier, element, t).*part +
                 start * endValue(p, -t) + end * endValue(p, t);
        },
        degree);
  };
  using Value = contact::MultiplierSpace::Value;
  const auto along = [&geometry](double t) { return geometry.curve.tangent(t); };
  const auto across = [&geometry](double t) { return geometry.curve.normal(t); };
  const Polynomial pressure = stress(&Value::normal, across);
  const Polynomial normal = component(across, nullptr);
  const contact::Conditions::Contact& condition = *element.condition;
  const bem::Units units = solved.units;
  const int e = element.element;
  const contact::Opposite& opposite = solved.problem.opposite();
  const auto motion = [&solved](const contact::Opposite::Point& met) {
    return motionAt(solved.motions, met);
  };
  const auto opening = [&opposite, &element, across, normal, motion](double t) {
    const auto met = opposite.at(element, t);
    return met.gap + dot(motion(met), across(t)) - normal(t);
  };
  // the whole jump of bonded sides is an error, not what a step adds to it
  const bool ties = element.ties();
  const Polynomial own = component(along, ties ? nullptr : solved.displacementBefore);
  const contact::Motions* before = ties ? nullptr : solved.motionsBefore;
  const auto tangential = [&opposite, &element, along, own, motion, before](double t) {
    const auto met = opposite.at(element, t);
    return own(t) - dot(motion(met) - motionAt(before, met), along(t));
  };
  const auto bound = [&mesh, &condition, units, e, pressure](double t) {
    return condition.friction.at(mesh.physicalPoint(e, t), units.stress)
        .bound(pressure(t));
  };
  bem::Profile fineness = [](double) { return 1.0; };
  if (solved.motions != nullptr)
    fineness = [&opposite, &element, &geometry, p, &solved](double t) {
      const auto met = opposite.at(element, t);
      if (met.element < 0)
        return 1.0;
      const bem::Element& other =
          solved.motions->spaces[static_cast<std::size_t>(met.body)]->mesh()[met.element];
      return std::max(1.0, other.degree * geometry.half / (p * other.half));
    };
  return {pressure,
          stress(&Value::tangential, along),
          opposite.isStill() ? bem::Profile(own) : bem::Profile(tangential),
          opening,
          bound,
          p,
          geometry.half,
          opposite.breaks(element),
          std::max(p, opposite.degree(element)),
          element.ties(),
          fineness};
}

namespace {

/// Both kinds of terms; `complementarity` and `slip` are the densities of the first and
/// the last: of pressure and opening, of bound, shear and slip.
template <class Complementarity, class Slip>
Contributions terms(const ContactProfiles& c, const Vector& breaks,
                    const Complementarity& complementarity, const Slip& slip) {
  const bem::Rule rule = bem::piecewiseRule(breaks, c.highest + 6);
  const double size = 2 * c.half / c.degree;  // h/p
  Contributions squares{};
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const double t = rule.points[q];
    const double weight = c.half * rule.weights[q];
    const double pressure = c.pressure(t);
    const double opening = c.opening(t);
    const double shear = c.shear(t);
    const double bound = c.bound(t);
    const double tension = positive(-pressure);
    const double penetration = positive(-opening);
    const double excess = positive(std::abs(shear) - bound);
    const double fineness = c.fineness(t);
    of(squares, Source::Complementarity) +=
        weight * complementarity(positive(pressure), positive(opening), fineness);
    of(squares, Source::Penetration) +=
        weight * fineness / size * penetration * penetration;
    of(squares, Source::Tension) += weight * size * tension * tension;
    of(squares, Source::Bound) += weight * size * excess * excess;
    of(squares, Source::Slip) += weight * slip(bound, shear, c.tangential(t), fineness);
  }
  return squares;
}

/// The jump of bonded sides, which ought to vanish.
Contributions jump(const ContactProfiles& c) {
  const bem::Rule rule = bem::piecewiseRule(c.nodes, c.highest + 6);
  Contributions squares{};
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const double t = rule.points[q];
    const double across = c.opening(t);
    const double along = c.tangential(t);
    of(squares, Source::Penetration) += rule.weights[q] * c.fineness(t) * 0.5 * c.degree *
                                        (across * across + along * along);
  }
  return squares;
}

}  // namespace

Contributions contactTerms(const ContactProfiles& profiles) {
  if (profiles.tied)
    return jump(profiles);
  return terms(
      profiles, breaks(profiles),
      [](double pressure, double opening, double) { return pressure * opening; },
      [](double bound, double shear, double slip, double) {
        return positive(bound - std::abs(shear)) * std::abs(slip) +
               2 * positive(-shear * slip);
      });
}

Contributions sharpContactTerms(const ContactProfiles& profiles, double shearModulus) {
  if (profiles.tied)
    return jump(profiles);
  const double stiffness = shearModulus * profiles.degree / (2 * profiles.half);
  return terms(
      profiles, sharpBreaks(profiles, stiffness),
      [stiffness](double pressure, double opening, double fineness) {
        return lostWork(pressure, opening, stiffness, fineness * stiffness);
      },
      [stiffness](double bound, double shear, double slip, double fineness) {
        return lostWork(unusedBound(bound, shear, slip), std::abs(slip), stiffness,
                        fineness * stiffness);
      });
}

double lostWork(double force, double length, double soft, double stiff) {
  if (soft == stiff)
    return lostWork(force, length, soft);
  // in units in which both squares have the factor one, and work has c
  const double f = force / std::sqrt(soft);
  const double v = length * std::sqrt(stiff);
  const double c = std::sqrt(soft / stiff);
  if (2 * v <= c * f)
    return v * v;
  if (2 * f <= c * v)
    return f * f;
  const double workingForce = (4 * f - 2 * c * v) / (4 - c * c);
  const double workingLength = (4 * v - 2 * c * f) / (4 - c * c);
  return c * workingForce * workingLength +
         0.25 * c * c * (workingForce * workingForce + workingLength * workingLength);
}

}  // namespace epafi::adaptivity
