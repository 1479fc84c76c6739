#pragma once

#include "bem/mesh/Mesh.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/problem/Problem.hpp"

#include <vector>

namespace epafi::adaptivity {

/// What happens to an element on the way to the next level.
enum class Mark { None, Bisect, RaiseDegree };

/// One mark per element.
using Marks = std::vector<Mark>;

/// Is there anything to do?
bool anyMarked(const Marks& marks);

/// A mesh together with the value that an iteration on it starts from.
struct Refined {
  bem::Mesh mesh;
  contact::State start;
};

/// The next mesh: bisected elements become two equal ones of the same degree.
///
/// Positions are halved from both ends of their edge, so that a node next to either
/// vertex keeps its digits through any number of bisections. \throws bem::InputError
/// where a degree would exceed bem::largestDegree.
bem::Mesh refine(const bem::Mesh& mesh, const Marks& marks);

/// The next mesh, and the state on the old one carried over to it.
///
/// λ restricted to a new element is a polynomial of at most its degree: it is met
/// exactly in every basis but those that share nodes, where it is met nearly.  Its
/// coefficients need not be admissible any more (Newton's first step sees to that); the
/// rigid motions stay.  An empty state stays empty.
Refined refine(const bem::Mesh& mesh, const Marks& marks,
               const contact::MultiplierSpace& multiplier,
               const contact::Conditions& conditions, const contact::State& state);

}  // namespace epafi::adaptivity
