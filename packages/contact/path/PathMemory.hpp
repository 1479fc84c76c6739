#pragma once

#include "contact/system/ContactSystem.hpp"

#include <map>
#include <string>

namespace epafi::contact {

/// History of a path on one mesh: works so far, and data for the next step.
///
/// Energies are dimensionless.  Works are sums over the steps,
///
///   friction      Σ σₜ,i Δrₜ,i   each term >= 0: the discrete problem's own weights
///   trapezoidal   Σ ½ (λₜ,i + λₜ,i⁻) Δrₜ,i
///   outside       Σ ½ (f + f⁻)·Δu + ½ (R + R⁻)·Δu - ½ (λₙ + λₙ⁻)·Δg
///   worn          Σ ½ (λₙ + λₙ⁻)·Δw, by the worn depth w
///
/// over all bodies, for loads f, reactions R and moving obstacles; a rigid body adds its driving
/// force times its motion.  ⁻: previous step, initially zero load and displacement.
///                                                      [doc/theory/paths.md, Energies]
///
/// With body loads, u excludes the particular solution u_p, which acts like a gap and adds
/// ½ (λ + λ⁻)·Δu_p.
class PathMemory {
 public:
  /// Shear σₜ of the friction work: AtEnd ± s at the end of the step, which is λₜ; Mean
  /// ± ½ (s + min(s⁻, 3 s)).  Since |λₜ| equals the bound during slip, both are exact for constant
  /// bounds; for others the error is of first and of second order in the step.
  enum class Shear { AtEnd, Mean };

  /// \param atZero the problem at t = 0, for the gaps and bounds to begin with
  explicit PathMemory(const ContactSystem& atZero, Shear shear = Shear::AtEnd);

  /// Adds a solved step.  \pre it was made with forStep()
  void add(const ContactSystem& step, const Configuration& at);

  /// What the next step has to know; the defect without what r is where contact is closed.
  const StepMemory& forStep() const { return memory_; }
  const Wear& wear() const { return memory_.wear; }

  /// Friction work so far, nondecreasing, one number per tangential coefficient.
  const Vector& frictionWork() const { return friction_; }
  double friction() const;
  /// Difference of two paths with the same mesh and time.
  struct Difference {
    double work = 0;  ///< Σ |w_i - w_i'|, of friction so far
    /// Σ s_i |rₜ,i - rₜ,i'|: the difference of the stored slips as friction work, including slip of
    /// open points, which has done no work.
    double slip = 0;
    double volume = 0;  ///< Σ |∫ (w - w') χ_i|
  };
  Difference apart(const PathMemory& other) const;
  double trapezoidal() const { return trapezoidal_; }
  double outside() const { return outside_; }
  double worn() const { return ofWear_; }
  double wornVolume() const;

  /// outside - trapezoidal - worn - stored: zero except for steps in which contact opens or
  /// closes; then of second order in the step.
  double imbalance(double stored) const {
    return outside_ - trapezoidal_ - ofWear_ - stored;
  }

 private:
  Shear shear_;
  StepMemory memory_;
  Vector friction_;
  double trapezoidal_ = 0;
  double outside_ = 0;
  double ofWear_ = 0;
  Vector worn_;  ///< ∫ w χ_i
  // of the previous step
  Vector multiplier_;
  Vector bounds_;
  Vector
      motions_;  ///< displacements of all bodies and motions of those that do not deform
  Vector forces_;  ///< f + R, and driving forces of rigid bodies
  Vector given_;   ///< see ContactSystem::given
};

/// Friction work of each contact of a body, by name (see nameOf), from frictionWork of all; both
/// dimensionless.
std::map<std::string, double> frictionWorkOfContacts(const ContactBody& body,
                                                     const Vector& frictionWork);

/// Friction's work per length as coefficients of the multiplier: w_i / ∫ χ_i, whose
/// polynomials have the sum of all w_i as their integral.  Dimensionless; normal
/// coefficients are zero.
Vector frictionWorkDensity(const MultiplierSpace& multiplier, const Vector& frictionWork);

}  // namespace epafi::contact
