#pragma once

#include "contact/opposite/RigidDrives.hpp"
#include "contact/system/ContactBody.hpp"
#include "contact/system/LoadResponses.hpp"
#include "contact/system/LoadSize.hpp"
#include "contact/system/Wear.hpp"

namespace epafi::contact {

/// A state of a system with the displacements that follow from it, dimensionless.
struct Configuration {
  State state;
  std::vector<Vector> contactForces;  ///< on each elastic body, see ContactBody
  std::vector<Vector> displacements;  ///< of each elastic body, all unknowns
  std::vector<RigidMotion> rigid;     ///< of each rigid body
  /// Of each elastic body; empty until they are asked for, see placed().
  std::vector<ContactBody::Results> results;
  /// r of numbers() from the displacements, C u - M λ - g, since rounding errors of D dominate r
  /// on slender bodies.
  Vector penetration;
  /// Sums over the bodies' results.
  double strainEnergy() const;
  double storedEnergy() const;
  /// Set by corrected(): largest violation of the conditions r = 0, over the displacement.
  double defect = 0;
};

/// What a step of a path knows of the steps before it; at first nothing.
struct StepMemory {
  Vector slip{};           ///< rₜ, see ContactSystem::slipSoFar; empty: zero
  Vector defect{};         ///< see ContactSystem::defect
  double largestLoad = 0;  ///< largest loadSize() of all steps
  std::vector<LoadResponses> responses{};  ///< by body; empty: none known
  Wear wear{};                             ///< empty: no wear so far
};

/// The contact problem of all bodies of a scene, condensed onto the multiplier, see
/// MultiplierSpace:
///
///   D = Σ_b C_b A_b⁺ C_bᵀ + M,   C_b = (own coupling of b, mortar coupling of other sides with b)
///
/// A given motion of a rigid body adds to the offset d₀; a motion that is free under a force adds
/// a column to G, and the force is an entry of q.
///
/// All bodies use the same units of length and stress.         [doc/theory/contact.md]
class ContactSystem {
 public:
  /// \param opposite  what lies opposite to the contact sides of all bodies, numbered in this order;
  ///   null: obstacles at the gap of the conditions
  /// \pre all inputs have the same units and multiplier basis
  /// \throws see ContactBody, and bem::InputError for a multiplier that shares nodes where
  ///   contact with another body meets a clamp or another contact side.
  explicit ContactSystem(const std::vector<BodyInput>& bodies,
                         const std::vector<Drive>& rigid = {},
                         std::shared_ptr<const Opposite> opposite = {});

  /// The same bodies on the same meshes at another time, after the steps that `memory` knows.  Kinds of
  /// conditions on boundaries and free motions stay the same; friction uses the slip so far.  Shares
  /// factors, D and couplings, so that a step costs one solution with the factors.
  ///                                                               [doc/theory/paths.md]
  /// \param conditions  of each body, must outlive the system
  ContactSystem under(const std::vector<Conditions>& conditions,
                      const std::vector<Drive>& drives = {},
                      const StepMemory& memory = {}) const {
    return {*this, conditions, drives, memory};
  }

  /// Data for the next step: rₜ since the start of the path; and r from the displacements minus r
  /// from D, which is added to the offset, so that a step without change needs no iteration.
  Vector slipSoFar(const Configuration& at) const;
  Vector defect(const Configuration& at) const;
  /// Adds it to the offset.
  void takeDefect(const Configuration& at);
  /// StepMemory::slip of this step.
  const Vector& slipBefore() const { return slipBefore_; }
  /// Responses to loads of each body, with those of this step, for the next step.
  const std::vector<LoadResponses>& responses() const { return responses_; }

  /// See LoadSize.
  double loadSize() const;

  /// Most beddings on top of each other, see Beddings.
  int depth() const { return depth_; }

  std::size_t size() const { return bodies_->size(); }
  const ContactBody& body(std::size_t b) const { return (*bodies_)[b]; }
  const MultiplierSpace& multiplier() const { return obstacle_->multiplier; }

  /// The problem for the nonlinear solver, D without feet of beddings; and g per normal coefficient, which the offset
  /// contains as -g.  Dimensionless.
  const Problem& numbers() const { return numbers_; }
  const Vector& gap() const { return obstacle_->gap; }
  /// The prescribed part of r, one number per coefficient: -g, less the jumps of bonded sides and
  /// the prescribed sliding, and with body loads what their displacement u_p of the sides and,
  /// through the stabilisation, their traction t_p add.  Without wear and rigid bodies.
  const Vector& given() const { return given_; }

  /// Does the wear of this step depend on slips of its solution?  Until wearBy is called it is
  /// computed with the prescribed sliding only.
  bool wearsBySlip() const;
  /// Computes the wear with the slips of a configuration.  Returns the relative change of the
  /// worn depth under its pressure.  `response`: see StepWear::setSlips
  double wearBy(const Configuration& at, bem::Matrix response = {});
  const StepWear& wear() const { return wear_; }

  /// What wearBy takes next is what a state has, without a share of what it was before: of a step's
  /// last state it is then the same in a run that has read it.
  void forgetIterations() { wear_.forgetIterations(); }

  /// Where nothing else is known: no pressure, and free motions where their loads place them, see
  /// placement().
  State start() const;
  /// A state whose α of rigid bodies are those of their motions; empty: α = 0 for the free ones.  A state
  /// without motions stays one, if there are none.
  State with(const std::vector<RigidMotion>& motions, State state) const;
  /// The configuration of a state; empty vectors in it mean zero.
  Configuration configuration(State state) const {
    return withResults(placed(std::move(state)));
  }
  /// The same without results, on the way to a solution, and what is left to do for them.
  Configuration placed(State state) const;
  Configuration withResults(Configuration placed) const;

  /// Motions or forces of the rigid bodies at this time.
  const std::vector<Drive>& drives() const { return rigid_.drives(); }
  /// Contact forces on each rigid body in x and y, and the moment about its reference point.
  std::vector<std::array<double, 3>> rigidForces(const State& state) const {
    return rigid_.forces(state.multiplier);
  }
  /// See RigidDrives.
  double lever(std::size_t rigid) const { return rigid_.lever(rigid); }
  /// Energy stored by the springs of rigid bodies.
  double energyOfSprings(const State& state) const {
    return rigid_.energyOfSprings(state.multiplier);
  }

 private:
  ContactSystem(const ContactSystem& atZero, const std::vector<Conditions>& conditions,
                const std::vector<Drive>& drives, const StepMemory& memory);
  Index elasticMotions() const { return numbers().rigidMotions() - rigid_.freeMotions(); }

  /// What makes D: of the columns r_k, s_k of each body, see condense.
  using Columns = std::vector<std::vector<Vector>>;
  using MakeFlexibility =
      std::function<Flexibility(const Columns& motions, const Columns& reactions)>;
  /// Makes the bodies.
  MakeFlexibility addBodies(const std::vector<BodyInput>& inputs);
  /// Computes D and G.
  void condense(const MakeFlexibility& makeFlexibility);
  /// s_k of the reactions of a body, see condense.  `motions`: C r of those that it allows
  std::vector<Vector> reactionColumns(std::size_t b,
                                      const std::vector<Vector>& motions) const;
  /// Sets d₀ = Σ_b C_b u_b and q = (R_bᵀ f_b)_b by the loads, then calls finish().
  void respond();
  /// Adds gaps, jumps, given motions and forces of rigid bodies, bounds and scales.
  void finish();
  /// Adds the prescribed part of r: all but that of elastic bodies and free motions.
  void addGiven(Vector& r) const;
  /// r of bodies that do not deform and free motions that are zero.
  Vector givenToRigid() const;
  void setScale(double load);
  /// r of these bodies by their displacements, with all that is given.
  Vector penetration(const Configuration& at,
                     const std::vector<std::size_t>& bodies) const;

  std::shared_ptr<const Obstacle> obstacle_;
  std::shared_ptr<std::vector<ContactBody>> bodies_;
  std::vector<std::size_t> order_{};  ///< see Beddings
  int depth_ = 0;
  RigidDrives rigid_;
  StepWear wear_;
  Problem numbers_{};
  Vector given_{};
  Vector slipBefore_{};
  Vector defectBefore_{};
  std::vector<LoadResponses> responses_{};
};

}  // namespace epafi::contact
