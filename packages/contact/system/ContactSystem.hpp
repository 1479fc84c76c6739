#pragma once

#include "contact/opposite/RigidDrives.hpp"
#include "contact/opposite/TraceCoupling.hpp"
#include "contact/system/ContactBody.hpp"
#include "contact/system/LoadResponses.hpp"
#include "contact/system/Wear.hpp"

namespace epafi::contact {

/// What a state of a system means for its bodies, dimensionless.
struct Configuration {
  State state;                ///< of all
  std::vector<State> bodies;  ///< own multipliers and motions of those that deform
  std::vector<Vector> oppositeForces;  ///< what presses on each, see ContactBody
  std::vector<Vector> displacements;   ///< likewise all unknowns
  std::vector<RigidMotion> rigid;      ///< of those that do not
  /// r of numbers() by the displacements in place of D, which has not the digits of what bends
  /// slender bodies: C u - M λ - g.
  Vector penetration;
  /// Where it was corrected: what is left in it of conditions that hold, over the displacement.
  double defect = 0;
};

/// The contact problem of all bodies of a scene, condensed onto all multipliers together:
///
///   λ = (λₙ of body 0, of body 1, ..., λₜ of body 0, of body 1, ...),
///   D = Σ_b C_b A_b⁺ C_bᵀ + M,   C_b = (own coupling of b, - mortar traces of what meets b)
///
/// Bodies that do not deform are a part of the offset where their motion is given; where a
/// force is, their motion is one more column of G, and the force its balance.
///
/// Bodies count in one length and one stress.                  [doc/theory/contact.md]
class ContactSystem {
 public:
  /// \pre All inputs have the same units; their opposites' points
  ///   number the bodies as they come here.
  /// \throws see ContactBody, and bem::InputError for a multiplier that shares nodes where
  ///   contact with another body meets a clamp or another contact side.
  explicit ContactSystem(const std::vector<BodyInput>& bodies,
                         const std::vector<Drive>& rigid = {});

  /// What a step of a path changes.
  struct Step {
    const std::vector<Conditions>& conditions;  ///< of now; must outlive the system
    std::vector<Drive> rigid{};                 ///< of now
    Vector slipBefore{};     ///< rₜ at the end of the step before, see slipSoFar
    Vector defectBefore{};   ///< of the step before, see defect
    double largestLoad = 0;  ///< loadSize() of the steps before, the largest
    std::vector<LoadResponses>
        responses{};                 ///< of the step before; none: nothing is known
    std::vector<Wear> wearBefore{};  ///< of each body likewise; none: nothing wore
  };
  /// The same bodies on the same meshes at another time: conditions of the same kinds on the
  /// same boundaries, the same motions free, friction that remembers.  Shares factors, D and
  /// couplings, so that a step costs one solution with the factors.         [doc/theory/paths.md]
  ContactSystem under(const Step& step) const { return {*this, step}; }

  /// By coefficient: about the integral of its function.
  Vector lengths() const;
  /// rₜ from the path's beginning on, and what r by displacements is more than r by D, which
  /// the offset of the next step has in it, so that what stands still costs no step: both are what
  /// the next step is told.
  Vector slipSoFar(const Configuration& at) const;
  Vector defect(const Configuration& at) const;
  /// What this step was told; empty: nothing.
  const Vector& slipBefore() const { return slipBefore_; }
  /// What is known of each body's loads, this step's included: what the next step is told.
  const std::vector<LoadResponses>& responses() const { return responses_; }

  /// Size of tractions, prescribed displacements, penetrations and forces, dimensionless;
  /// zero without load.
  double loadSize() const;

  std::size_t size() const { return bodies_->size(); }
  const ContactBody& body(std::size_t b) const { return (*bodies_)[b]; }

  /// What the nonlinear solver sees, and g per normal coefficient, dimensionless: the part -g of
  /// the offset that does not come from loads.
  const Problem& numbers() const { return numbers_; }
  const Vector& gap() const { return gap_; }
  /// The jump that bonded sides are given, and what slides by, one number per coefficient.
  const Vector& jump() const { return jump_; }

  /// What is given of r where something acts inside, by coefficients: the displacement u_p of the
  /// sides and what t_p adds through the stabilisation; empty: nothing does.
  const Vector& ofInside() const { return ofInside_; }

  /// Does this step wear by a slip that is part of the solution?  First it wears as if the sides
  /// slid by as much as what slides by.
  bool wearsBySlip() const;
  /// Lets the step wear by the slips of a configuration.  Returns how much that changes what it
  /// wears there, relative to that.
  double wearBy(const Configuration& at);
  const StepWear& wear() const { return wear_; }

  /// The state of all from each body's own, where an empty vector stays empty, and back with
  /// everything that follows from it, where it is zero.  `rigid`: motions of bodies that do not deform; empty:
  /// they begin where they are.
  State joined(const std::vector<State>& states,
               const std::vector<RigidMotion>& rigid = {}) const;
  Configuration configuration(State state) const;
  const Numbering& numbering() const { return numbering_; }

  /// How many bodies do not deform, how they are moved now, which of their motions are free
  /// (behind those of bodies that deform), and what contact does to each: forces in x and
  /// y, and the moment about the reference point.
  const std::vector<Drive>& drives() const { return rigid_.drives(); }
  std::vector<std::array<double, 3>> rigidForces(const State& state) const {
    return rigid_.forces(state.multiplier);
  }
  /// What the springs of such bodies store.
  double energyOfSprings(const State& state) const {
    return rigid_.energyOfSprings(state.multiplier);
  }

  /// ½ <W u, u> + ½ <V ψ, ψ> of all bodies, and with what the stabilisation adds, see
  /// ContactBody.
  double strainEnergy(const Configuration& at) const;
  double storedEnergy(const Configuration& at) const;

 private:
  ContactSystem(const ContactSystem& atZero, const Step& step);
  static std::shared_ptr<std::vector<ContactBody>> bodiesOf(
      const std::vector<BodyInput>& inputs);
  std::shared_ptr<std::vector<ContactBody>> bodiesUnder(
      const std::vector<Conditions>& conditions) const;
  std::vector<ContactSide> sides() const;

  bool isFormed() const { return body(0).form()->isFormed(); }
  /// C_b u
  Vector apply(std::size_t b, const Vector& u) const {
    return onAllMultipliers(numbering_, b, body(b).form()->apply(u), (*opposite_)[b], u);
  }
  /// C_bᵀ and M, on all multipliers.
  Matrix transposed(std::size_t b) const;
  Matrix multiplierMass() const;
  /// D and G.
  void condense(Index formedUpTo);
  Flexibility compressed(Index formedUpTo) const;
  /// What loads make of d₀ = Σ_b C_b u_b and q = (R_bᵀ f_b)_b, and all else that is given.
  void respond();
  /// Gaps, jumps, given motions and forces of bodies that do not deform, bounds and scales.
  void finish();
  /// What is given of r: all that does not come from elastic bodies or free motions.
  void addGiven(Vector& r) const;
  void setScale(double load);
  Vector penetration(const Configuration& at) const;

  std::shared_ptr<std::vector<ContactBody>> bodies_;
  Numbering numbering_;
  std::shared_ptr<const std::vector<TraceCoupling>> opposite_;
  RigidDrives rigid_;
  StepWear wear_;
  Problem numbers_{};
  Vector gap_{};
  Vector jump_{};
  Vector ofInside_{};
  Vector slipBefore_{};
  Vector defectBefore_{};
  std::vector<LoadResponses> responses_{};
};

}  // namespace epafi::contact
