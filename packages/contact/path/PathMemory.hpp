#pragma once

#include "contact/system/ContactSystem.hpp"

#include <map>
#include <string>

namespace epafi::contact {

/// What a path has done so far on one mesh, and what its next step must know.
///
/// Energies are dimensionless.  Works are sums over the steps,
///
///   friction      Σ σₜ,i Δrₜ,i   each term >= 0: the discrete problem's own weights
///   trapezoidal   Σ ½ (λₜ,i + λₜ,i⁻) Δrₜ,i
///   outside       Σ ½ (f + f⁻)·Δu + ½ (R + R⁻)·Δu - ½ (λₙ + λₙ⁻)·Δg
///   worn          Σ ½ (λₙ + λₙ⁻)·Δw, what worn material takes
///
/// over all bodies, of loads f, clamps R and obstacles that move; a body that does not deform
/// adds what moves it times its motion.  ⁻: the step before, at first no load and no
/// displacement.                                        [doc/theory/paths.md, Energies]
///
/// Where something acts inside bodies, f and u are those of the equations, u less the particular
/// solution u_p, which moves the sides as a gap does: ½ (λ + λ⁻)·Δu_p more.
class PathMemory {
 public:
  /// The shear σₜ that slips: ± s of the step's end, which is λₜ, or ± ½ (s + min(s⁻, 3 s)).
  ///
  /// What slips does so at its bound all along, so that both are exact where bounds stay; where they
  /// change the first errs by the first order in the step, the second by the second.
  enum class Shear { AtEnd, Mean };

  /// \param atZero the problem at t = 0, for the gaps and bounds to begin with
  explicit PathMemory(const ContactSystem& atZero, Shear shear = Shear::AtEnd);

  /// Adds a solved step.  \pre the step was told slip(), defect(), largestLoad() and wear().
  void add(const ContactSystem& step, const Configuration& at);

  const Vector& slip() const { return slip_; }      ///< rₜ, see ContactSystem::Step
  const Vector& defect() const { return defect_; }  ///< likewise
  double largestLoad() const { return largestLoad_; }
  const std::vector<Wear>& wear() const { return wear_; }  ///< of each body

  /// Friction's work so far, one number per tangential coefficient, none ever falls.
  const Vector& frictionWork() const { return friction_; }
  double friction() const;
  /// How far two ways to one time on one mesh are apart.
  struct Difference {
    double work = 0;  ///< Σ |w_i - w_i'|, of friction so far
    /// Σ s_i |rₜ,i - rₜ,i'|, the work of friction in what one remembers and the other does not:
    /// of slip before a place closed, which has done none.
    double slip = 0;
    double volume = 0;  ///< Σ |∫ (w - w') χ_i|
  };
  Difference apart(const PathMemory& other) const;
  double trapezoidal() const { return trapezoidal_; }
  double outside() const { return outside_; }
  double worn() const { return ofWear_; }
  double wornVolume() const;

  /// outside - trapezoidal - worn - what is stored: zero but for steps in which contact opens or
  /// closes, and there of second order in the step.
  double imbalance(double stored) const {
    return outside_ - trapezoidal_ - ofWear_ - stored;
  }

 private:
  Shear shear_;
  Vector slip_;
  Vector defect_;
  Vector friction_;
  double trapezoidal_ = 0;
  double outside_ = 0;
  double largestLoad_ = 0;
  double ofWear_ = 0;
  std::vector<Wear> wear_;
  Vector worn_;  ///< ∫ w χ_i
  // of the step before
  Vector multiplier_;
  Vector bounds_;
  Vector
      motions_;  ///< displacements of all bodies and motions of those that do not deform
  Vector forces_;  ///< f + R, and what moves these
  Vector gap_;
  Vector jump_;  ///< of bonded sides, and what slid by
  Vector ofInside_;
};

/// Friction's work so far of each contact of a body, see nameOf; dimensionless, likewise its
/// part of frictionWork.
std::map<std::string, double> frictionWorkOfContacts(const MultiplierSpace& multiplier,
                                                     const Vector& frictionWork);

/// Friction's work per length as coefficients of the multiplier: w_i / ∫ χ_i, whose
/// polynomials have the sum of all w_i as their integral.  Dimensionless; normal
/// coefficients are zero.
Vector frictionWorkDensity(const bem::Mesh& mesh, const MultiplierSpace& multiplier,
                           const Vector& frictionWork);

}  // namespace epafi::contact
