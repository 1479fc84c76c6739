#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/moments/ElementRuns.hpp"
#include "bem/space/LocalField.hpp"

#include <vector>

namespace epafi::bem {

/// Densities and slopes of many elements in a row, seen from far away: with a_k the powers
/// of y - c over a circle's radius R about c, q = R/(x - c),
///
///   ∫ g/w = Σ q^(k+1) M_k / R,          M_k = ∫ g a_k,
///   ∫ g/conj(w) = conj Σ q^(k+1) N_k / R,   N_k = ∫ conj(g) a_k,
///   ∫ conj(g) w/conj(w)² = conj (conj(x-c) Σ (k+1) q^(k+2) M_k - Σ (k+1) q^(k+2) P_k) / R²,
///
/// P_k = ∫ g conj(y-c) a_k.  Rows of runs are cut in two down to groups that cost less one
/// by one.
class SourceGroups {
 public:
  /// `fields` by element.  Both outlive it.
  SourceGroups(const ElementRuns& runs, const std::vector<LocalField>& fields);

  struct Group {
    int first;  ///< runs, first ... last - 1
    int last;
    int children[2] = {-1, -1};
    Complex centre;
    double radius = 0;
    struct Moments {
      Complex plain[2];  ///< M of the density and of the slope
      Complex conjugate[2];
      Complex shifted[2];
    };
    std::vector<Moments> moments;  ///< none where runs are treated one by one
  };
  /// The first holds all; empty on small meshes.
  const std::vector<Group>& groups() const { return groups_; }

  /// Is a group far from a circle?
  static bool isFar(const Group& group, Complex centre, double radius) {
    return !group.moments.empty() &&
           std::abs(centre - group.centre) - radius >= separation * group.radius;
  }
  /// Its sums at a point of a circle that it is far from, to 1e-13 of the largest.
  static FieldSums at(const Group& group, Complex x);

 private:
  static constexpr double separation = 2.5;

  int divide(int first, int last);
  void addElement(int f, Group& group) const;

  const ElementRuns& runs_;
  const std::vector<LocalField>& fields_;
  std::vector<Group> groups_;
};

}  // namespace epafi::bem
