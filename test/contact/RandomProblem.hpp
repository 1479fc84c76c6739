#pragma once

#include "contact/problem/Problem.hpp"

#include <random>
#include <string>

namespace epafi::test {

/// What a random contact problem should look like.
struct Recipe {
  contact::Index normals = 20;
  const char* law = "None";  ///< "None": no tangential coefficients
  double strength = 1;  ///< strengths are drawn from [0, strength], a fifth of them zero
  double softness = 1e-2;  ///< smallest eigenvalue of D over its diagonal, about
  double grading = 1;      ///< ratio of the largest to the smallest coefficient's size
  contact::Index rigidMotions = 0;
  double springs = 0;   ///< K is 10^x, x from [-springs, springs]; 0: none
  bool ties = false;    ///< loads and gaps from a few values, many of them zero
  bool bonded = false;  ///< every third tangential coefficient is of bonded sides
  /// Normal law of nine in ten normal coefficients: "Linear", "Root", "Square", "Exponential"; with
  /// one, half of the pairs of neighbouring tangential ones are elastic.
  const char* normal = "Rigid";
  double yield =
      1;  ///< φ'(1) is drawn from [0.01, 1] times this, in units of D's diagonal

  static Recipe of(const char* law, double strength, contact::Index rigidMotions = 0) {
    Recipe recipe;
    recipe.law = law;
    recipe.strength = strength;
    recipe.rigidMotions = rigidMotions;
    return recipe;
  }
};

/// Contact-like: D is a logarithmic kernel on random points plus random coupling of
/// normal and tangential coefficients; loads of both signs.  With rigid motions the load
/// can be balanced.
contact::Problem randomProblem(const Recipe& recipe, std::mt19937& random);

/// Two points of a block on a plane, on springs of flexibility one, held by Coulomb's
/// friction: free to move down and along, which the load does.
contact::Problem block(double coefficient, const contact::Vector& load);

/// A law whose fields have these values, in units of stress.
contact::PointLaw pointLaw(const std::string& law, const contact::Vector& fields);

/// By how much a coefficient of length one closes: φ'(1) = slope.
contact::PointClosing pointClosing(const std::string& law, double slope);

/// `value` times the identity: every coefficient on a spring of its own.
contact::Matrix identity(contact::Index size, double value = 1);

}  // namespace epafi::test
