#include "drivers/run/SolvedBodies.hpp"

#include "contact/equation/ContactState.hpp"

#include <numeric>

namespace epafi::drivers {

namespace {

/// A body's own part of the states of all coefficients.
contact::ContactState ofBody(const contact::Numbering& numbering, std::size_t b,
                             const contact::ContactState& all) {
  contact::ContactState own;
  for (bem::Index i = 0; i < numbering.sizeOf(b); ++i) {
    const bem::Index k = numbering(b, i);
    if (k < numbering.normals())
      own.normal.push_back(all.normal[k]);
    else
      own.tangential.push_back(all.tangential[k - numbering.normals()]);
  }
  return own;
}

std::vector<bem::Piece> piecesOf(const bem::Mesh& mesh) {
  std::vector<bem::Piece> pieces;
  for (const bem::Element& element : mesh.elements())
    pieces.push_back(element.piece);
  return pieces;
}

}  // namespace

SolvedBodies::SolvedBodies(const Ground& ground, const contact::ContactSystem& system,
                           const std::vector<contact::Conditions>& conditions,
                           contact::Configuration at, const Placement* before,
                           std::vector<contact::Wear> wear)
    : ground_(ground),
      system_(system),
      at_(std::move(at)),
      placement_(ground.spaces, at_.displacements, at_.rigid, &conditions),
      wear_(std::move(wear)) {
  placement_.states = at_.bodies;
  const std::size_t count = system.size();
  bodies_.reserve(count);  // pressed refers to all of them
  for (std::size_t b = 0; b < count; ++b) {
    const bem::Vector& u = placement_.displacements[b];
    densities_.push_back(system.body(b).density(at_.bodies[b], u));
    bodies_.push_back({ground.spaces.space(b),
                       ground.stiffness[b],
                       system.body(b),
                       conditions[b],
                       ground.scene.units(),
                       at_.bodies[b],
                       u,
                       at_.oppositeForces[b],
                       {},
                       &placement_.motions});
    if (!wear_.empty())
      bodies_[b].wear = &wear_[b];
    if (before != nullptr) {
      bodies_[b].displacementBefore = &before->motions.displacements[b];
      bodies_[b].motionsBefore = &before->motions;
      if (before->conditions != nullptr) {
        bodies_[b].stateBefore = &before->states[b];
        bodies_[b].conditionsBefore = &(*before->conditions)[b];
      }
    }
  }
  for (std::size_t b = 0; b < count; ++b)
    bodies_[b].pressed = contact::ForeignPressure(b, bodies_);
}

std::vector<contact::ContactState> SolvedBodies::states() const {
  const contact::ContactState all =
      contact::classify(system_.numbers(), at_.state, at_.penetration);
  std::vector<contact::ContactState> result;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    result.push_back(ofBody(system_.numbering(), b, all));
  return result;
}

Level SolvedBodies::level(int number) const {
  Level level;
  level.number = number;
  level.rigid = at_.rigid;
  std::vector<contact::ContactState> kinds = states();
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    level.bodies.push_back({piecesOf(bodies_[b].space.mesh()), at_.bodies[b],
                            std::move(kinds[b]), placement_.displacements[b],
                            densities_[b]});
  return level;
}

double SolvedBodies::frictionWork() const {
  const bem::Vector work =
      contact::frictionWork(system_.numbers(), at_.state, at_.penetration);
  return ground_.scene.energy() * std::accumulate(work.begin(), work.end(), 0.0);
}

double SolvedBodies::interfaceEnergy() const {
  return ground_.scene.energy() * system_.numbers().surface.energy(at_.state.multiplier);
}

std::vector<RigidRow> SolvedBodies::rigidRows() const {
  const bem::Units units = ground_.scene.units();
  const double force = units.stress * units.length;
  const auto forces = system_.rigidForces(at_.state);
  std::vector<RigidRow> rows;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const RigidBody& body = ground_.scene.rigid[k];
    RigidRow row{body.name, body.pole, at_.rigid[k], {}, {}, {}, {}};
    row.motion.slide = units.length * row.motion.slide;
    const double scales[] = {force, force, force * units.length};
    constexpr double contact::Resultant::*members[] = {
        &contact::Resultant::x, &contact::Resultant::y, &contact::Resultant::moment};
    for (std::size_t c = 0; c < 3; ++c) {
      const contact::Drive::Component& drive = system_.drives()[k].components[c];
      row.contact.*members[c] = scales[c] * forces[k][c];
      row.inside.*members[c] = scales[c] * drive.inside;
      const double load = drive.free ? drive.value : 0;
      row.load.*members[c] = scales[c] * load;
      if (!drive.free || drive.stiffness > 0)
        row.reaction.*members[c] = -scales[c] * (forces[k][c] + drive.inside + load);
    }
    rows.push_back(wholeOf(ground_.scene.symmetry, *body.outline, std::move(row)));
  }
  return rows;
}

}  // namespace epafi::drivers
