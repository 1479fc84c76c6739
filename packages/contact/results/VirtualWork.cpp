#include "contact/results/VirtualWork.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

namespace epafi::contact {

namespace {

using bem::dot;
using Term = double VirtualWork::*;

void add(Term term, double work, VirtualWork& all) {
  all.*term += work;
  all.size += std::abs(work);
}

void addBody(const ContactSystem& system, const Configuration& at, std::size_t b,
             VirtualWork& all) {
  const ContactBody& body = system.body(b);
  const State& state = at.state;
  const Vector& u = at.displacements[b];
  const Vector& force = at.contactForces[b];
  const ContactBody::Results& results = at.results[b];
  add(&VirtualWork::strain, 2 * results.strainEnergy, all);
  add(&VirtualWork::stabilisation, 2 * body.stabilisationEnergy(state, u, force, results),
      all);
  add(&VirtualWork::loads, dot(body.loads().load, u), all);
  if (bem::largestEntry(body.loads().prescribed) > 0)
    add(&VirtualWork::supports, dot(results.clampForces, u), all);
  // what completed ends add to the force of λ has no part in r
  add(&VirtualWork::supports, -dot(state.multiplier, body.coupling().completion.apply(u)),
      all);
  add(&VirtualWork::means, dot(body.fixedReactions(force), body.fixedMeans()), all);
}

/// -λₜ · rₜ, rₜ since the start of the path; what sticks has not slid in the step.
void addFriction(const ContactSystem& system, const Configuration& at, VirtualWork& all) {
  constexpr double reached = 1e-9;  // of the load, as in ContactFields
  const Problem& problem = system.numbers();
  const Vector& multiplier = at.state.multiplier;
  const Vector bounds = problem.slipBounds(multiplier);
  double work = 0;
  for (std::size_t i = 0; i < multiplier.size(); ++i) {
    const double done = multiplier[i] * at.penetration[i];
    const std::size_t t = i - bem::at(problem.normals);
    if (i < bem::at(problem.normals) ||
        std::abs(multiplier[i]) + reached * problem.stress < bounds[t])
      all.unsolved += std::abs(done);
    else
      work -= done;
    if (i >= bem::at(problem.normals) && !system.slipBefore().empty())
      work -= multiplier[i] * system.slipBefore()[t];
  }
  add(&VirtualWork::friction, work, all);
}

void addRigid(const Drive& drive, const RigidMotion& motion,
              const std::array<double, 3>& contact, VirtualWork& all) {
  constexpr double rounding = 1e-14;
  const double motions[] = {motion.slide.x, motion.slide.y, motion.turn};
  for (std::size_t c = 0; c < 3; ++c) {
    const Drive::Component& one = drive.components[c];
    add(&VirtualWork::rigid,
        motions[c] * (one.free ? one.value + one.inside : -contact[c]), all);
    if (!one.free)
      continue;
    add(&VirtualWork::rigid, motions[c] * one.stiffness * (one.end - motions[c]), all);
    all.rounding += rounding * one.stiffness * std::abs(motions[c]) *
                    (std::abs(one.end) + std::abs(motions[c]));
  }
}

}  // namespace

VirtualWork virtualWork(const ContactSystem& system, const Configuration& at) {
  VirtualWork all;
  for (std::size_t b = 0; b < system.size(); ++b)
    addBody(system, at, b, all);
  const Vector& multiplier = at.state.multiplier;
  add(&VirtualWork::given, dot(multiplier, system.given()), all);
  add(&VirtualWork::surfaces,
      -dot(multiplier, system.numbers().surface.closing(multiplier)), all);
  if (const Vector& worn = system.wear().testedBefore(); !worn.empty())
    add(&VirtualWork::surfaces, -dot(multiplier, worn), all);
  addFriction(system, at, all);
  const auto forces = system.rigidForces(at.state);
  for (std::size_t k = 0; k < forces.size(); ++k)
    addRigid(system.drives()[k], at.rigid[k], forces[k], all);
  return all;
}

}  // namespace epafi::contact
