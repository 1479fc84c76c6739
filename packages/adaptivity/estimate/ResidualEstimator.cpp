#include "adaptivity/estimate/ResidualEstimator.hpp"

#include "adaptivity/estimate/EquivalentMultiplier.hpp"
#include "adaptivity/estimate/Layer.hpp"
#include "adaptivity/estimate/TurningArcs.hpp"
#include "adaptivity/estimate/Weights.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Parallel.hpp"
#include "bem/fields/BoundaryFields.hpp"

#include <algorithm>
#include <optional>

namespace epafi::adaptivity {

namespace {

using bem::Vec2;

/// p/h |u_D - u|² of prescribed components on an element, where they are interpolated, more on a
/// thin layer.
double clampSquares(const contact::Solved& solved, int e,
                    const std::vector<bem::BoundaryValue>& values, double layer) {
  const bem::Mesh& mesh = solved.space.mesh();
  const auto clamp = solved.conditions.dirichlet.find(mesh.boundary(e));
  if (clamp == solved.conditions.dirichlet.end())
    return 0;
  double square = 0;
  for (const bem::BoundaryValue& value : values) {
    const double t = value.place.t;
    const Vec2 u = solved.displacementAt(e, t);
    const bem::SurfacePoint x = mesh.physicalPoint(e, t);
    const auto error = [&](const bem::Function& given, double own) {
      return given ? given(x) / solved.units.length - own : 0;
    };
    const Vec2 missed{error(clamp->second.x, u.x), error(clamp->second.y, u.y)};
    square += value.weight * (mesh[e].degree / (2 * mesh[e].half) + layer) *
              dot(missed, missed);
  }
  return square;
}

/// h/p |α' (f - given f)|² of conducted heat on an element: derivative of the error of its
/// displacement α' ∫ f dz.
double heatSquares(const contact::Solved& solved, int e) {
  const contact::BodyLoadSolution& inside = solved.conditions.inside;
  if (!inside || inside->conducted() == nullptr)
    return 0;
  const bem::Element& element = solved.space.mesh()[e];
  return 2 * element.half / element.degree * inside->expansion() * inside->expansion() *
         inside->conducted()->missed(e);
}

class Residuals {
 public:
  /// \param turning  see turningTractions
  Residuals(const contact::Solved& solved, const bem::Lame& lame, const Weights& weights,
            const SidePlaces& places, double turning)
      : solved_(solved),
        places_(places),
        weights_(weights),
        lame_(lame),
        mesh_(solved.space.mesh()),
        amplitudes_(solved.problem.fixedReactions(solved.contactForce)),
        turning_(turning),
        known_(solved.problem.knownTraction()) {}

  /// h |mismatch|² of an element and, unless it is a contact element, h/p |f - S u|².
  Contributions squares(int e, const std::vector<bem::BoundaryValue>& values,
                        bool touching) const {
    const double h = 2 * mesh_[e].half;
    Contributions squares{};
    for (const bem::BoundaryValue& value : values)
      of(squares, Source::Density) +=
          value.weight * h * dot(value.mismatch, value.mismatch);
    const Layer layer = behind(e);
    of(squares, Source::Density) += layer.square(lame_, mesh_, e, values);
    of(squares, Source::Density) +=
        clampSquares(solved_, e, values, layer.beyondHalfPlane(lame_, sizeOf(e)).across);
    of(squares, Source::Density) += heatSquares(solved_, e);
    if (touching)
      return squares;
    const Vec2 free = Vec2{1, 1} - solved_.conditions.given(mesh_.boundary(e));
    const auto neumann = solved_.conditions.neumann.find(mesh_.boundary(e));
    const bool loaded = neumann != solved_.conditions.neumann.end();
    for (std::size_t q = 0; q < values.size(); ++q) {
      const bem::BoundaryValue& value = values[q];
      const double t = value.place.t;
      const Vec2 load = loaded ? (1 / solved_.units.stress) *
                                     neumann->second.at(mesh_.physicalPoint(e, t))
                               : Vec2{};
      Vec2 r =
          load + places_.pressed(solved_, e, q) + fixedTraction(e, t) - value.traction;
      if (solved_.conditions.inside)
        r = r - solved_.conditions.inside->traction(mesh_, e, t);
      of(squares, Source::Neumann) +=
          value.weight * h / mesh_[e].degree * (free.x * r.x * r.x + free.y * r.y * r.y);
    }
    return squares;
  }

  /// λʰ + S u minus the tractions of fixed motions, at the points of a contact element.
  std::vector<Vec2> residual(const ContactElement& contact,
                             const std::vector<bem::BoundaryValue>& values,
                             const std::vector<Vec2>& directions) const {
    const int e = contact.element;
    const contact::MultiplierSpace& multiplier = solved_.problem.multiplier();
    std::vector<Vec2> result;
    for (std::size_t q = 0; q < values.size(); ++q) {
      const bem::BoundaryValue& value = values[q];
      const double t = value.place.t;
      const auto stress = multiplier.at(solved_.state.multiplier, contact, t);
      const Vec2 across = directions[q];
      result.push_back(stress.normal * across + stress.tangential * turnLeft(across) +
                       value.traction - fixedTraction(e, t));
      if (known_)
        result.back() = result.back() + known_(e, t);
    }
    return result;
  }

  /// ∫ r e(-t) ds and ∫ r e(t) ds of such a residual.
  static AtEnds moments(const ContactElement& contact,
                        const std::vector<bem::BoundaryValue>& values,
                        const std::vector<Vec2>& residual) {
    AtEnds moments;
    for (std::size_t q = 0; q < values.size(); ++q) {
      const double t = values[q].place.t;
      const Vec2 r = values[q].weight * residual[q];
      const bem::EndValues e = bem::endValues(contact.degree, t);
      moments.start = moments.start + e.start * r;
      moments.end = moments.end + e.end * r;
    }
    return moments;
  }

  /// Further terms of a contact element, with λ̃ instead of λʰ.  residual: of λʰ;
  /// shearModulus: of both sides.
  Contributions contactSquares(const ContactElement& contact,
                               const std::vector<bem::BoundaryValue>& values,
                               const std::vector<Vec2>& residual,
                               const AtEnds& correction, KnownPlaces& places,
                               double shearModulus) const {
    const bem::Element& element = mesh_[contact.element];
    const double size = 2 * element.half / element.degree;
    ContactProfiles profiles = contactProfiles(solved_, contact, correction, places);
    const Layer layer = behind(contact.element);
    if (layer.isHeld) {  // else gaps close by a motion of both sides
      const double stiffer = 1 + size * layer.beyondHalfPlane(lame_, size).across;
      const double own = shearModulus / lame_.mu;  // of what both sides yield
      const double inSeries = stiffer / (own + (1 - own) * stiffer);
      profiles.fineness = [inSeries, finer = profiles.fineness](double t) {
        return std::max(inSeries, finer(t));
      };
    }
    if (weights_.bounds == Bounds::Sharp &&
        isOpen(solved_.state.multiplier, contact, rounding_))
      narrow(profiles);
    Contributions squares = weights_.bounds == Bounds::Sharp
                                ? sharpContactTerms(profiles, shearModulus)
                                : contactTerms(profiles);
    double& square = of(squares, Source::Contact);
    for (std::size_t q = 0; q < values.size(); ++q) {
      const Vec2 r = residual[q] + valueAt(correction, element, values[q].place.t);
      square += values[q].weight * size * dot(r, r);
    }
    return squares;
  }

  /// γ |λʰ + S u|², the term of the stabilisation, as an energy.
  double stabilisation(std::size_t contact, const std::vector<bem::BoundaryValue>& values,
                       const std::vector<Vec2>& residual) const {
    double square = 0;
    for (std::size_t q = 0; q < values.size(); ++q)
      square += values[q].weight * dot(residual[q], residual[q]);
    return solved_.problem.coupling().gamma[contact] * lame_.mu * square;
  }

 private:
  double sizeOf(int e) const { return 2 * mesh_[e].half / mesh_[e].degree; }  ///< h/p

  /// Infinitely thick under Bounds::Printed.
  Layer behind(int e) const {
    return weights_.bounds == Bounds::Sharp ? layerBehind(mesh_, solved_.conditions, e)
                                            : Layer{};
  }

  /// Σ ρ_k r_k, what holds fixed rigid motions, and what takes off moments on arcs, dimensionless.
  Vec2 fixedTraction(int e, double t) const {
    if (!solved_.conditions.isBoundary(mesh_.boundary(e)))
      return {};
    const Vec2 x = mesh_.scaledPoint(e, t);
    const Vec2 arm = x - solved_.problem.holding().modes.centroid;
    const Vec2 held =
        Vec2{amplitudes_[0], amplitudes_[1]} + amplitudes_[2] * turnLeft(arm);
    return turning_ == 0 ? held : held + turning_ * solved_.space.rotation()->at(x);
  }

  const contact::Solved& solved_;
  const SidePlaces& places_;
  const Weights& weights_;
  const bem::Lame& lame_;
  const bem::Mesh& mesh_;
  Vector amplitudes_;  ///< ρ
  double turning_;     ///< see turningTractions
  double rounding_ = 1e-9 * bem::largestEntry(solved_.state.multiplier);
  contact::BoundaryTraction known_;
};

Contributions factorsOf(const contact::Solved& solved, const bem::Lame& lame,
                        const EstimatorOptions& options) {
  Contributions factors = weightings().at(options.weights).factors(lame, solved.units);
  for (const Source source : {Source::Neumann, Source::Contact, Source::Density})
    of(factors, source) *= options.residualFactor;
  return factors;
}

void multiply(Contributions& squares, const Contributions& factors) {
  for (std::size_t i = 0; i < sourceCount; ++i)
    squares[i] *= factors[i];
}

/// Shear modulus of two bodies in series, 1 / (1/μ_A + 1/μ_B); μ_A if the opposite one is
/// rigid.
double sharedShearModulus(const contact::Solved& solved, const ContactElement& element,
                          double own) {
  const auto there = solved.problem.opposite().at(element, 0);
  if (there.element < 0 || solved.motions == nullptr)
    return own;
  const double other = solved.motions->shearModuli[static_cast<std::size_t>(there.body)];
  return own * other / (own + other);
}

using Fields = SidePlaces::Fields;

/// On this process's elements, without the further terms of contact elements.
std::vector<Contributions> squaresOf(const Residuals& residuals, const Fields& fields,
                                     const std::vector<bool>& isTouching) {
  std::vector<Contributions> squares(fields.size());
  for (std::size_t e = 0; e < fields.size(); ++e)
    if (!fields[e].empty())
      squares[e] = residuals.squares(static_cast<int>(e), fields[e], isTouching[e]);
  return squares;
}

/// Sums over the processes.
Indicators gathered(const std::vector<Contributions>& mine,
                    const bem::Processes& processes) {
  Vector all;
  for (const Contributions& squares : mine)
    all.insert(all.end(), squares.begin(), squares.end());
  all = processes.sum(std::move(all));
  Indicators indicators;
  for (auto next = all.begin(); next != all.end(); next += sourceCount) {
    Contributions squares{};
    std::copy_n(next, sourceCount, squares.begin());
    indicators.squares.push_back(squares);
  }
  return indicators;
}

/// Fields of each state on this process's elements.  The rule is divided where pressures
/// of other bodies jump, which is at the same points in all states.
std::vector<Fields> fieldsOf(const std::vector<Estimated>& states, const bem::Lame& lame,
                             const bem::Processes& processes) {
  const contact::Solved& any = states.front().solved;
  const int size = any.space.mesh().size();
  std::vector<bem::BoundaryState> sources;
  sources.reserve(states.size());
  for (const Estimated& state : states)
    sources.push_back({state.solved.displacement, state.density});
  const bem::BoundaryFields fields(any.space, lame, sources);
  std::vector<Fields> result(states.size(), Fields(size));
  const int count = processes.count();
  const bem::Index mine = (size - processes.rank() + count - 1) / count;
  constexpr double ofSource = 2e3;  // ns
  bem::parallelFor(
      {mine, ofSource * static_cast<double>(mine * size)}, [&](bem::Index k) {
        const int e = processes.rank() + bem::asInt(k) * count;
        bem::BoundaryFields::Values values = fields.on(e, any.problem.sourceBreaks(e));
        for (std::size_t s = 0; s < result.size(); ++s)
          result[s][e] = std::move(values[s]);
      });
  return result;
}

/// Not parallel: evaluates functions of the user, which may not be thread-safe.
Indicators indicatorsOf(const Estimated& state, const Fields& fields, SidePlaces& places,
                        double turning, const bem::Lame& lame,
                        const EstimatorOptions& options,
                        const bem::Processes& processes) {
  const auto& [solved, density] = state;
  const Weights& weights = weightings().at(options.weights);
  const Contributions factors = factorsOf(solved, lame, options);
  const Residuals residuals(solved, lame, weights, places, turning);
  const auto& touching = solved.problem.elements();
  const auto fieldsOf = [&](const ContactElement& element) -> const auto& {
    return fields[static_cast<std::size_t>(element.element)];
  };

  std::vector<bool> isTouching(fields.size());
  std::vector<std::vector<Vec2>> contactResiduals;
  std::vector<AtEnds> moments;
  for (const ContactElement& element : touching) {
    const auto& values = fieldsOf(element);
    isTouching[static_cast<std::size_t>(element.element)] = true;
    contactResiduals.push_back(
        residuals.residual(element, values, places.directions(contactResiduals.size())));
    moments.push_back(Residuals::moments(element, values, contactResiduals.back()));
  }
  const bool sharp = weights.bounds == Bounds::Sharp;
  // λ̃ does the same work as λʰ on this body, but not on an opposite one
  // and its functions are those of the plane
  const bem::Mesh& mesh = solved.space.mesh();
  const bool alone =
      !solved.problem.opposite().meetsDeformable(solved.problem.number()) &&
      !mesh.outline().isAxisymmetric();
  const std::vector<AtEnds> correction =
      sharp && alone ? corrections(solved, lame, factors, moments, places, processes)
                     : std::vector<AtEnds>(touching.size());

  // with Form Density the mean m of V ψ - (K + 1/2) u, which is -γ (λ + ψ), adds ∫ m²/h to
  // h |mismatch|²
  const std::vector<Vec2> means = solved.problem.coupling().meanSlacks(
      solved.state.multiplier, density,
      solved.problem.inResidual(solved.contactForce).compliance);
  std::vector<Contributions> squares = squaresOf(residuals, fields, isTouching);
  for (Contributions& square : squares)
    multiply(square, factors);
  for (std::size_t k = 0; k < touching.size(); ++k) {
    const auto& values = fieldsOf(touching[k]);
    if (values.empty())
      continue;
    bem::Lame both = lame;
    both.mu = sharedShearModulus(solved, touching[k], lame.mu);
    Contributions contact =
        residuals.contactSquares(touching[k], values, contactResiduals[k], correction[k],
                                 places.known(k), both.mu);
    const int e = touching[k].element;
    of(contact, Source::Density) +=
        dot(means[k], means[k]) * (mesh.measure(e, 0) / mesh[e].half);
    if (sharp && !solved.problem.coupling().byDensity())
      of(contact, Source::Contact) +=
          residuals.stabilisation(k, values, contactResiduals[k]);
    Contributions scales =
        both.mu == lame.mu ? factors : factorsOf(solved, both, options);
    for (const Source own : {Source::Contact, Source::Density})
      of(scales, own) = factors[static_cast<std::size_t>(own)];
    multiply(contact, scales);
    Contributions& all = squares[static_cast<std::size_t>(touching[k].element)];
    for (std::size_t i = 0; i < sourceCount; ++i)
      all[i] += contact[i];
  }
  const std::vector<int>& stabilised = solved.problem.coupling().elements;
  for (std::size_t k = touching.size(); k < stabilised.size(); ++k) {
    const int e = stabilised[k];
    if (!fields[static_cast<std::size_t>(e)].empty())
      of(squares[static_cast<std::size_t>(e)], Source::Density) +=
          factors[static_cast<std::size_t>(Source::Density)] * dot(means[k], means[k]) *
          (mesh.measure(e, 0) / mesh[e].half);
  }
  return gathered(squares, processes);
}

}  // namespace

std::vector<Indicators> estimateResiduals(const std::vector<Estimated>& states,
                                          const bem::Lame& lame,
                                          const EstimatorOptions& options,
                                          const bem::Processes& processes) {
  // fields of all states are kept: for so many numbers as eight states of a large mesh have
  constexpr std::size_t fewest = 8;
  constexpr std::size_t most = 32;
  constexpr std::size_t elements = 2048;
  const auto size = bem::at(states.front().solved.space.mesh().size());
  const std::size_t atOnce = std::clamp(fewest * elements / size, fewest, most);
  std::vector<Indicators> result;
  std::optional<SidePlaces> places;
  for (std::size_t first = 0; first < states.size(); first += atOnce) {
    const std::vector<Estimated> some(
        states.begin() + static_cast<std::ptrdiff_t>(first),
        states.begin() +
            static_cast<std::ptrdiff_t>(std::min(first + atOnce, states.size())));
    const std::vector<Fields> fields = fieldsOf(some, lame, processes);
    if (!places)
      places.emplace(some.front().solved, fields.front());
    const Vector turning = turningTractions(some);
    for (std::size_t k = 0; k < some.size(); ++k)
      result.push_back(indicatorsOf(some[k], fields[k], *places, turning[k], lame,
                                    options, processes));
  }
  return result;
}

}  // namespace epafi::adaptivity
