#include "adaptivity/estimate/ContactTerms.hpp"

#include "contact/results/ContactPlace.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace epafi::adaptivity {

bem::Vec2 valueAt(const AtEnds& factors, const bem::Element& element, double t) {
  const bem::EndValues e = bem::endValues(element.degree, t);
  return (e.start / element.half) * factors.start + (e.end / element.half) * factors.end;
}

namespace {

/// Values of the profiles.
enum Number { Pressure, Opening, Shear, Bound, Slip, Fineness, Numbers };

double valueAt(const ContactProfiles& c, Number number, double t) {
  switch (number) {
    case Pressure:
      return c.pressure(t);
    case Opening:
      return c.opening(t);
    case Shear:
      return c.shear(t);
    case Bound:
      return c.bound(t);
    case Slip:
      return c.tangential(t);
    default:
      return c.fineness(t);
  }
}

/// All of them at a point, and what sides yield there.
struct Values {
  std::array<double, Numbers> numbers{};
  double yield = 0;
  double shearYield = 0;

  double operator()(Number number) const { return numbers[bem::at(number)]; }
};

Values valuesAt(const ContactProfiles& c, double t) {
  Values values;
  for (const Number number : {Pressure, Opening, Shear, Bound, Slip, Fineness})
    values.numbers[bem::at(number)] = valueAt(c, number, t);
  values.yield = c.yield(t, values(Opening));
  values.shearYield = c.shearYield(t);
  return values;
}

/// A stiffness in series with surfaces that yield.
double softened(double stiffness, double yield) {
  return stiffness / (1 + stiffness * yield);
}

/// Where functions of the values change their signs; all look at the same samples, since a
/// gap and a bound are the user's expressions, and between them at what they depend on.
class Changes {
 public:
  explicit Changes(const ContactProfiles& profiles)
      : profiles_(profiles), places_(bem::signSamples(profiles.highest)) {
    for (const double t : places_)
      samples_.push_back(valuesAt(profiles, t));
  }

  template <class Function>
  void add(const Function& f, Vector& breaks) const {
    constexpr double ofBreaks = 1e-9;
    Vector values;
    for (const Values& sample : samples_)
      values.push_back(f(sample));
    const Vector changes = bem::signChanges(
        [&](double t) {
          return f([&](Number number) { return valueAt(profiles_, number, t); });
        },
        places_, values, ofBreaks);
    breaks.insert(breaks.end(), changes.begin(), changes.end());
  }

 private:
  const ContactProfiles& profiles_;
  Vector places_;
  std::vector<Values> samples_;
};

Vector breaks(const ContactProfiles& c, const Changes& changes) {
  Vector result = {-0.5, 0, 0.5};  // gap and bound are the user's and may bend anywhere
  result.insert(result.end(), c.nodes.begin(), c.nodes.end());
  changes.add([](const auto& v) { return v(Pressure); }, result);
  changes.add([](const auto& v) { return v(Opening); }, result);
  changes.add([](const auto& v) { return v(Shear); }, result);
  changes.add([](const auto& v) { return v(Slip); }, result);
  changes.add([](const auto& v) { return std::abs(v(Shear)) - v(Bound); }, result);
  return result;
}

/// The part of the bound that the shear along a slip leaves.
double unusedBound(double bound, double shear, double slip) {
  return bound - std::clamp(slip < 0 ? -shear : shear, -bound, bound);
}

Vector sharpBreaks(const ContactProfiles& c, double stiffness) {
  const Changes changes(c);
  Vector result = breaks(c, changes);
  // where lostWork bends: where it takes the whole force or the whole length
  const auto addBends = [&](const auto& force, const auto& length) {
    changes.add(
        [&](const auto& v) { return force(v) - 2 * stiffness * v(Fineness) * length(v); },
        result);
    changes.add([&](const auto& v) { return 2 * force(v) - stiffness * length(v); },
                result);
  };
  addBends([](const auto& v) { return v(Pressure); },
           [](const auto& v) { return v(Opening); });
  addBends([](const auto& v) { return unusedBound(v(Bound), v(Shear), v(Slip)); },
           [](const auto& v) { return std::abs(v(Slip)); });
  return result;
}

}  // namespace

ContactProfiles contactProfiles(const contact::Solved& solved,
                                const ContactElement& element, const AtEnds& correction,
                                KnownPlaces& places) {
  const bem::Mesh& mesh = solved.space.mesh();
  const bem::Element& geometry = mesh[element.element];
  const contact::MultiplierSpace& multiplier = solved.problem.multiplier();
  const int p = element.degree;
  // what is a polynomial on a segment nearly is one on an arc, whose directions turn
  constexpr int forTurning = 8;
  const int degree = std::min(p + std::min(forTurning, geometry.curve.pointsOfTurning()),
                              bem::largestDegree);
  // that of a particular solution is of another degree than the element
  const bool acts = solved.conditions.inside || solved.insideBefore();
  const int degreeOfMotion =
      acts ? std::min(std::max(degree, p + forTurning), bem::largestDegree) : degree;
  const auto projected = [&](const auto& displacement) {
    return bem::project([&](double t) { return asComplex(displacement(t)); },
                        degreeOfMotion);
  };
  const auto motion = [degreeOfMotion](const bem::LegendreSeries<bem::Complex>& series) {
    return [series, degreeOfMotion](double t) {
      return bem::asVector(bem::evaluate(series, degreeOfMotion, t));
    };
  };
  // several profiles ask for the same point one after the other
  const auto last = std::make_shared<std::optional<contact::ContactPlace>>();
  const auto at = [&solved, &element, &places,
                   last](double t) -> const contact::ContactPlace& {
    if (!*last || (*last)->t != t)
      last->emplace(places.at(solved, element, t));
    return **last;
  };
  const auto across = [at](double t) { return at(t).opposite.direction.unit; };
  // both components at once
  const auto stress = bem::project(
      [&](double t) {
        const auto own = multiplier.at(solved.state.multiplier, element, t);
        const bem::Vec2 more = valueAt(correction, geometry, t);
        const bem::Vec2 normal = across(t);
        return bem::Complex(own.normal + dot(more, normal),
                            own.tangential + dot(more, turnLeft(normal)));
      },
      degree);
  const auto part = [&](const auto& of) {
    bem::LegendreSeries<double> series{};
    std::transform(stress.begin(), stress.end(), series.begin(), of);
    return Polynomial(series, degree);
  };
  const Polynomial pressure = part([](const bem::Complex& c) { return c.real(); });
  const Polynomial shear = part([](const bem::Complex& c) { return c.imag(); });
  bem::LegendreSeries<bem::Complex> displacement =
      projected([&](double t) { return solved.displacementAt(element.element, t); });
  const auto whole = motion(displacement);
  // the whole jump of bonded sides is an error, not what a step adds to it
  if (!element.ties() && solved.displacementBefore != nullptr) {
    const auto before = projected(
        [&](double t) { return solved.displacementBeforeAt(element.element, t); });
    for (std::size_t k = 0; k < before.size(); ++k)
      displacement[k] -= before[k];
  }
  const auto slid = motion(displacement);
  const double stiffness = 0.5 * p / geometry.half;  // p/h for Young's modulus 1
  const contact::Opposite& opposite = solved.problem.opposite();
  return {pressure, shear,
          // without friction it does nothing
          [=, shears = element.shears()](double t) {
            return shears ? at(t).slip(slid(t), shear(t)) : 0;
          },
          [=](double t) { return at(t).opening(pressure(t), whole(t)); },
          [=](double t) { return at(t).bound(pressure(t)); }, p, geometry.half,
          [&mesh, e = element.element](double t) { return mesh.measure(e, t); },
          opposite.breaks(element), std::max(p, opposite.degree(element)), element.ties(),
          [=](double t) { return at(t).fineness(); },
          [=](double t, double opening) {
            return at(t).yield(pressure(t), opening, stiffness);
          },
          [=](double t) { return at(t).shearYield(); }, across};
}

namespace {

/// Both kinds of terms; `complementarity` and `slip` are the densities of the first and
/// the last, `softness` what surfaces yield in units of p/h.
template <class Complementarity, class Slip>
Contributions terms(const ContactProfiles& c, const Vector& breaks, double softness,
                    const Complementarity& complementarity, const Slip& slip) {
  const bem::Rule rule = bem::piecewiseRule(breaks, c.highest + 6);
  const double size = 2 * c.half / c.degree;  // h/p
  Contributions squares{};
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const Values v = valuesAt(c, rule.points[q]);
    const double weight = c.measure(rule.points[q]) * rule.weights[q];
    if (weight == 0)  // on the axis
      continue;
    const double tension = positive(-v(Pressure));
    const double penetration = positive(-v(Opening));
    const double excess = positive(std::abs(v(Shear)) - v(Bound));
    of(squares, Source::Complementarity) += weight * complementarity(v);
    of(squares, Source::Penetration) +=
        softened(weight * v(Fineness) / size, softness * v.yield / weight) * penetration *
        penetration;
    of(squares, Source::Tension) += weight * size * tension * tension;
    of(squares, Source::Bound) += weight * size * excess * excess;
    of(squares, Source::Slip) += weight * slip(v);
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
                                        (c.measure(t) / c.half) *
                                        (across * across + along * along);
  }
  return squares;
}

}  // namespace

Contributions contactTerms(const ContactProfiles& profiles) {
  if (profiles.tied)
    return jump(profiles);
  return terms(
      profiles, breaks(profiles, Changes(profiles)), 0,
      [](const Values& v) { return positive(v(Pressure)) * positive(v(Opening)); },
      [](const Values& v) {
        return positive(v(Bound) - std::abs(v(Shear))) * std::abs(v(Slip)) +
               2 * positive(-v(Shear) * v(Slip));
      });
}

Contributions sharpContactTerms(const ContactProfiles& profiles, double shearModulus) {
  if (profiles.tied)
    return jump(profiles);
  const double stiffness = shearModulus * profiles.degree / (2 * profiles.half);
  return terms(
      profiles, sharpBreaks(profiles, stiffness), shearModulus,
      [stiffness](const Values& v) {
        return lostWork(positive(v(Pressure)), positive(v(Opening)),
                        softened(stiffness, v.yield),
                        softened(v(Fineness) * stiffness, v.yield));
      },
      [stiffness](const Values& v) {
        return lostWork(unusedBound(v(Bound), v(Shear), v(Slip)), std::abs(v(Slip)),
                        softened(stiffness, v.shearYield),
                        softened(v(Fineness) * stiffness, v.shearYield));
      });
}

bool isOpen(const Vector& multiplier, const ContactElement& element, double rounding) {
  for (int i = 0; i <= element.degree; ++i)
    if (!element.normal.holdsNothing(i) &&
        std::abs(multiplier[bem::at(element.normalOf(i))]) > rounding)
      return false;
  return !element.ties();
}

void narrow(ContactProfiles& profiles) {
  const Vector changes = bem::signChanges(profiles.opening, profiles.highest);
  Vector ends = changes;
  ends.push_back(1);
  constexpr double rounding = 1e-11;  // drawings have some 12 digits
  double overlap = 0;                 // as a part of the element
  double begin = -1;
  for (const double end : ends) {
    if (profiles.opening(0.5 * (begin + end)) < -rounding)
      overlap += 0.5 * (end - begin);
    begin = end;
  }
  if (overlap == 0 || overlap * profiles.degree >= 1)
    return;
  profiles.fineness = [stiffer = 1 / (overlap * profiles.degree),
                       opening = profiles.opening, finer = profiles.fineness](double t) {
    return opening(t) < 0 ? stiffer : finer(t);
  };
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
