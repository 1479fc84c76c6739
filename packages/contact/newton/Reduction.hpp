#pragma once

#include "contact/equation/Equation.hpp"

#include <vector>

namespace epafi::contact {

/// The linear system J d = b of a Newton step without the coefficients whose change is known
/// from their own rows (open, slipping):
///
///   known      d_i = b_i + f_i d_j,   j: the pressure that the bound of i follows
///   inactive   Σ_j D_ij d_j - Σ_j G_ij α_j = b_i / c_i
///   balance    Σ_i G_ij d_i = b_j
///
/// Rigid motions, measured in units in which each has size one, are split into the
/// combinations that the inactive rows hold and those that they do not.
///
/// Refers to what it is made from.
struct Reduction {
  Reduction(const Equation& equation, const LinearRows& at);

  const Equation& equation;
  const LinearRows& e;
  const Problem& problem;
  Index n;  ///< coefficients
  Index k;  ///< rigid motions

  std::vector<Index> inactive;  ///< the coefficients that are solved for
  std::vector<Index> position;  ///< where a coefficient stands in `inactive`, or -1
  struct Followed {
    Index normal = 0;
    double factor = 0;
  };
  std::vector<Followed> followed;  ///< f of the known changes, 0: of none
  bool symmetric = true;           ///< does no bound follow an unknown pressure?

  Vector scale;        ///< 1/sqrt of the reduced diagonal
  Vector motionScale;  ///< gives each rigid motion size one
  Matrix held;         ///< orthonormal combinations of scaled motions that the rows hold
  Matrix loose;        ///< ... and that they do not
  Matrix border;       ///< Ĝ = scale G_I motionScale held

  Index count() const { return static_cast<Index>(inactive.size()); }
  bool isKnown(Index i) const { return position[at(i)] < 0; }

  /// visit(i, j, f_i) of the known changes that follow unknown ones.
  template <class Visit>
  void forEachFollower(const Visit& visit) const {
    for (Index i = problem.normals; i < n; ++i) {
      const auto& [normal, factor] = followed[at(i)];
      if (factor != 0 && !isKnown(normal))
        visit(i, normal, factor);
    }
  }

  /// G_i in the scaled held combination j, without the row's own scale.
  double heldEntry(Index i, Index j) const;

  /// The changes that do not depend on the inactive ones; zero elsewhere.
  Vector knownChanges(const Vector& b) const;
  /// d += what follows the inactive changes in it.
  void follow(Vector& d) const;
  /// What is left of the balance of each scaled motion after the known changes.
  Vector balance(const Vector& b, const Vector& known) const;
  /// The right sides of the inactive rows.
  Vector rightSides(const Vector& b) const;
  /// Appends α to d, from the sizes of the held combinations.
  void appendMotions(const double* sizes, Vector& d) const;

 private:
  void chooseInactive();
  void splitMotions();
  double weight(Index i) const { return equation.weights()[at(i)]; }
};

}  // namespace epafi::contact
