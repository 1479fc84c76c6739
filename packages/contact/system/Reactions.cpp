// What Fix holds, in the residual of the stabilisation of a body.
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/system/ContactBody.hpp"

#include <algorithm>
#include <tuple>

namespace epafi::contact {

using bem::axpy;
using bem::dot;

namespace {

/// all += s more, both of which may be empty.
void add(double s, const Loads::InResidual& more, Loads::InResidual& all) {
  for (const auto part : {&Loads::InResidual::weights, &Loads::InResidual::force,
                          &Loads::InResidual::terms, &Loads::InResidual::means,
                          &Loads::InResidual::density, &Loads::InResidual::compliance})
    if (!(more.*part).empty()) {
      (all.*part).resize((more.*part).size());
      axpy(s, more.*part, all.*part);
    }
}

/// What densities have of <γ (t + ψ - Σ ρ r), r>.
void completeMeans(const Coupling& coupling,
                   const std::vector<ContactBody::Reaction>& reactions,
                   Loads::InResidual& of) {
  for (std::size_t k = 0; k < reactions.size(); ++k) {
    const Vector& tested = reactions[k].residual.compliance;
    of.means[k] -= dot(tested, of.density);
    for (const auto& [i, value] : coupling.compliance.pinned)
      of.means[k] -= tested[at(i)] * of.compliance[at(i)] / value;
  }
}

}  // namespace

Loads::InResidual ContactBody::residualOf(const BoundaryTraction& traction) const {
  Loads::InResidual result =
      tractionMoments(multiplier(), number_, coupling(), traction, fixedTractions());
  if (coupling().hasCompliance()) {
    result.compliance = coupling().complianceOf(*space_, result.weights, traction);
    std::tie(result.density, result.force) = elastic_->answerTo(result.compliance);
    result.density = bem::times(-1, std::move(result.density));
    coupling().subtractWeighted(coupling().ofDensities(result.density), result.terms);
    if (reactions_ != nullptr)
      completeMeans(coupling(), reactions(), result);
  } else if (!coupling().weights.empty()) {
    result.force = elastic_->forcesOf(result.weights);
  }
  return result;
}

BoundaryTraction ContactBody::knownTraction() const {
  const Conditions& all = conditions();
  const auto pulls = [&all](const std::string& boundary) {
    const auto contact = all.contact.find(boundary);
    return contact != all.contact.end() && contact->second.isSupport;
  };
  const auto isPinned = [&all](int edge) {
    return std::find(all.pins.begin(), all.pins.end(), edge) != all.pins.end();
  };
  if (all.inside == nullptr && (all.pins.empty() || all.neumann.empty()) &&
      std::none_of(all.neumann.begin(), all.neumann.end(),
                   [&](const auto& given) { return pulls(given.first); }))
    return {};
  return [this, &all, pulls, isPinned](int e, double t) {
    const bem::Mesh& mesh = space_->mesh();
    bem::Vec2 known = all.inside ? all.inside->traction(mesh, e, t) : bem::Vec2{};
    const auto given = all.neumann.find(mesh.boundary(e));
    if (given != all.neumann.end() &&
        (pulls(given->first) || isPinned(mesh[e].piece.edge)))
      known = known - (1 / units_.stress) * given->second.at(mesh.physicalPoint(e, t));
    return known;
  };
}

std::vector<BoundaryTraction> ContactBody::fixedTractions() const {
  std::vector<BoundaryTraction> tractions;
  for (Index k = 0; k < holding().fixed(); ++k)
    tractions.emplace_back([this, k](int e, double t) {
      return holding().scales[at(k)] *
             holding().modes.at(holding().fixedModes[at(k)],
                                space_->mesh().scaledPoint(e, t));
    });
  return tractions;
}

std::vector<ContactBody::Reaction> ContactBody::makeReactions() const {
  std::vector<Reaction> reactions;
  if (coupling().weights.empty() && !coupling().hasCompliance())
    return reactions;
  for (const BoundaryTraction& fixed : fixedTractions()) {
    Loads::InResidual residual =
        residualOf([&](int e, double t) { return -fixed(e, t); });
    // rigid motions have no traction, whatever rounds
    for (Index k = 0; k < 3; ++k) {
      const Vector r = columnOf(holding().modes.motions, k);
      const Vector functional = columnOf(holding().modes.functionals, k);
      if (const double unit = dot(r, functional);
          unit != 0)  // else no motion of the body
        axpy(-dot(r, residual.force) / unit, functional, residual.force);
    }
    Vector displacement = elastic_->solve(residual.force);
    reactions.push_back({std::move(residual), std::move(displacement)});
  }
  for (Reaction& reaction : reactions)
    if (coupling().hasCompliance())
      completeMeans(coupling(), reactions, reaction.residual);
  return reactions;
}

Loads::InResidual ContactBody::reactionsTo(const Vector& force) const {
  Loads::InResidual all;
  for (std::size_t k = 0; k < reactions().size(); ++k)
    add(-dot(columnOf(holding().allowed, static_cast<Index>(k)), force),
        reactions()[k].residual, all);
  return all;
}

Loads::InResidual ContactBody::inResidual(const Vector& contactForce) const {
  Vector force = load_;
  if (!contactForce.empty())
    axpy(-1, contactForce, force);
  Loads::InResidual all = reactionsTo(force);
  add(1, loads_.residual, all);
  return all;
}

}  // namespace epafi::contact
