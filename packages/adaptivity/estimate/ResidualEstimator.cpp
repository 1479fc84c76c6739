#include "adaptivity/estimate/ResidualEstimator.hpp"

#include "adaptivity/estimate/ContactTerms.hpp"
#include "adaptivity/estimate/Weights.hpp"
#include "bem/assembly/BoundaryFields.hpp"
#include "contact/problem/Loads.hpp"

#include <map>

namespace epafi::adaptivity {

namespace {

using bem::Vec2;

/// The tractions Σ ρ_k r_k that hold fixed rigid motions, dimensionless.
class FixedTraction {
 public:
  explicit FixedTraction(const contact::Solved& solved)
      : mesh_(solved.space.mesh()),
        centroid_(contact::makeRigidModes(solved.space).centroid),
        amplitudes_(solved.problem.fixedReactions(solved.state)) {}

  Vec2 at(int e, double t) const {
    const Vec2 arm = mesh_.scaledPoint(e, t) - centroid_;
    return Vec2{amplitudes_[0], amplitudes_[1]} + amplitudes_[2] * turnLeft(arm);
  }

 private:
  const bem::Mesh& mesh_;
  Vec2 centroid_;
  Vector amplitudes_;
};

/// Which components a traction is given for on a side without contact: 1 or 0 each.
Vec2 givenComponents(const contact::Conditions& conditions, const std::string& boundary) {
  const auto clamp = conditions.dirichlet.find(boundary);
  if (clamp == conditions.dirichlet.end())
    return {1, 1};
  return {clamp->second.x ? 0.0 : 1.0, clamp->second.y ? 0.0 : 1.0};
}

class Residuals {
 public:
  Residuals(const contact::Solved& solved, const Vector& density, const bem::Lame& lame,
            SlipTerm slipTerm)
      : solved_(solved),
        slipTerm_(slipTerm),
        mesh_(solved.space.mesh()),
        fields_(solved.space, lame, solved.displacement, density),
        fixed_(solved) {
    for (const ContactElement& element : solved.problem.multiplier().elements())
      contact_.emplace(element.element, &element);
  }

  std::vector<bem::BoundaryValue> fields(int e) const { return fields_.on(e); }

  /// Evaluates functions of the user's, which are not safe to call from several threads.
  Contributions squares(int e, const std::vector<bem::BoundaryValue>& values) const {
    const bem::Element& element = mesh_[e];
    const double h = 2 * element.half;
    const auto contact = contact_.find(e);
    Contributions squares{};
    double& residual =
        of(squares, contact_.count(e) > 0 ? Source::Contact : Source::Neumann);
    if (contact != contact_.end()) {
      const ContactProfiles profiles = contactProfiles(solved_, *contact->second);
      squares = contactTerms(profiles, slipTerm_);
      for (const bem::BoundaryValue& value : values) {
        const double t = value.place.t;
        const Vec2 stress = profiles.pressure(t) * element.normal +
                            profiles.shear(t) * turnLeft(element.normal);
        const Vec2 r = stress + value.traction - fixed_.at(e, t);
        residual += value.weight * h / element.degree * dot(r, r);
      }
    } else {
      const Vec2 given = givenComponents(solved_.conditions, mesh_.boundary(e));
      const auto neumann = solved_.conditions.neumann.find(mesh_.boundary(e));
      const bool loaded = neumann != solved_.conditions.neumann.end();
      for (const bem::BoundaryValue& value : values) {
        const double t = value.place.t;
        const Vec2 load = loaded ? loadAt(neumann->second, e, t) : Vec2{};
        const Vec2 r = load + fixed_.at(e, t) - value.traction;
        residual += value.weight * h / element.degree *
                    (given.x * r.x * r.x + given.y * r.y * r.y);
      }
    }
    for (const bem::BoundaryValue& value : values)
      of(squares, Source::Density) +=
          value.weight * h * dot(value.mismatch, value.mismatch);
    return squares;
  }

 private:
  Vec2 loadAt(const contact::Conditions::Neumann& neumann, int e, double t) const {
    const Vec2 x = mesh_.physicalPoint(e, t);
    return (1 / solved_.units.stress) *
           Vec2{neumann.x ? neumann.x(x) : 0.0, neumann.y ? neumann.y(x) : 0.0};
  }

  const contact::Solved& solved_;
  SlipTerm slipTerm_;
  const bem::Mesh& mesh_;
  bem::BoundaryFields fields_;
  FixedTraction fixed_;
  std::map<int, const ContactElement*> contact_;
};

Contributions factorsOf(const contact::Solved& solved, const bem::Lame& lame,
                        const EstimatorOptions& options) {
  Contributions factors = weighting(options.weights).factors(lame, solved.units);
  for (const Source source : {Source::Neumann, Source::Contact, Source::Density})
    of(factors, source) *= options.residualFactor;
  return factors;
}

}  // namespace

Indicators estimateResidual(const contact::Solved& solved, const Vector& density,
                            const bem::Lame& lame, const EstimatorOptions& options) {
  const bem::DenseAlgebra& algebra = solved.stiffness.algebra();
  const Contributions factors = factorsOf(solved, lame, options);
  const Residuals residuals(solved, density, lame, weighting(options.weights).slipTerm);
  const int size = solved.space.mesh().size();

  std::vector<std::vector<bem::BoundaryValue>> fields(static_cast<std::size_t>(size));
#pragma omp parallel for schedule(dynamic, 1)
  for (int e = algebra.rank(); e < size; e += algebra.processes())
    fields[static_cast<std::size_t>(e)] = residuals.fields(e);

  Vector all(static_cast<std::size_t>(size) * sourceCount, 0.0);
  for (int e = algebra.rank(); e < size; e += algebra.processes()) {
    const Contributions squares =
        residuals.squares(e, fields[static_cast<std::size_t>(e)]);
    for (std::size_t k = 0; k < sourceCount; ++k)
      all[static_cast<std::size_t>(e) * sourceCount + k] = factors[k] * squares[k];
  }
  all = algebra.sum(std::move(all));

  Indicators indicators;
  for (std::size_t e = 0; e < static_cast<std::size_t>(size); ++e) {
    Contributions squares{};
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(e * sourceCount), sourceCount,
                squares.begin());
    indicators.squares.push_back(squares);
  }
  return indicators;
}

}  // namespace epafi::adaptivity
