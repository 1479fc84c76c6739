#pragma once

#include "contact/results/Solved.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

/// By how much λ may be wrong on a contact element, in the user's units: the sum of the sizes of
/// its two highest Legendre coefficients, for p = 1 of the highest.  Displacements hardly control
/// them.  Beside singular points, where no polynomial is close, the sum is one to two times the
/// error; elsewhere it is larger than the error.
struct Resolution {
  MultiplierSpace::Value error;  ///< of λₙ and λₜ [stress]
  double mean = 0;               ///< of λₙ [stress]

  /// Is the pressure worth more than what is doubtful of it?
  bool isResolved() const;
};
Resolution resolutionOf(const ContactFields& fields,
                        const ContactFields::Element& element);

/// The largest pressure of contacts [stress], from elements that resolve it, without arbitrary jumps.
class PeakPressure {
 public:
  /// \param pressures  ContactFields::continuous
  /// \param insideSide see insideSides
  void add(const ContactFields& fields, const Vector& pressures,
           const ContactFields::Element& element, bool insideSide);
  void add(const PeakPressure& other);

  double value() const { return told().value; }
  /// Resolution::error of its element.
  double error() const { return told().error; }
  /// Does the mean pressure of an unresolved element at an end of a side exceed value()?  The
  /// finer the mesh, the larger it is.
  bool isUnbounded() const { return atEnds_ > resolved_.value; }

 private:
  struct Largest {
    double value = 0;
    double error = 0;

    /// Elements that meet have one pressure there; the larger error counts.
    void add(const Largest& other) {
      constexpr double same = 1e-9;
      if (std::abs(other.value - value) <= same * value)
        error = std::max(error, other.error);
      else if (other.value > value)
        *this = other;
    }
  };
  /// Of unresolved elements where those have more and the pressure is bounded, or where no other
  /// has pressure.
  const Largest& told() const {
    const bool isHigher = unresolvedMean_ > resolved_.value && !isUnbounded();
    return isHigher || resolved_.value == 0 ? unresolved_ : resolved_;
  }

  Largest resolved_;
  Largest unresolved_;
  double unresolvedMean_ = 0;  ///< the largest of an element
  double atEnds_ = 0;          ///< likewise, at ends of sides
};

}  // namespace epafi::contact
