#pragma once

#include "bem/space/Space.hpp"
#include "contact/conditions/Conditions.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace epafi::contact {

using bem::at;
using bem::Index;
using bem::Vector;

/// The contact that an element is in, if any.
const Conditions::Contact* contactOn(const bem::Mesh& mesh, int e,
                                     const Conditions& conditions);

/// Begins the element at a corner where the boundary goes on as the image of a roller?
bool beginsAtImage(const bem::Mesh& mesh, int e, const Conditions& conditions);

/// Along whose normals an element sees what is opposite.
bem::Normals sightOf(const bem::Mesh& mesh, int e, const Conditions& conditions);

/// The coefficients of an element in one direction, of its basis functions i = 0 ... degree.
struct Coefficients {
  /// That of one end of the element.
  struct End {
    /// Is it an unknown, not replaced by another one?
    bool isUnknown = true;
    /// The displacement is prescribed there, and its contact condition is dropped.
    bool clamped = false;
    /// Additional terms of the polynomial of the element, see completeEnds: numbers of
    /// coefficients and their weights.
    std::vector<std::pair<Index, double>> added{};
  };

  int degree = 1;
  std::array<End, 2> ends{};  ///< the first, the last
  Index first = -1;           ///< number of the first one; -1: none
  /// If the last node closes a chain of elements, the first coefficient of the chain; else -1.
  Index closing = -1;

  Index number(int i) const;
  /// Is coefficient i an unknown, not replaced by another one?
  bool isOwn(int i) const {
    return (ends[0].isUnknown || i > 0) && (ends[1].isUnknown || i < degree);
  }
  /// Is coefficient i at a clamped end, so that it has no contact condition?
  bool holdsNothing(int i) const {
    return (i == 0 && ends[0].clamped) || (i == degree && ends[1].clamped);
  }
};

/// The multiplier of all bodies: on each contact element of degree p, p + 1 normal
/// coefficients and, with friction, p + 1 tangential ones.  First the normal coefficients
/// (pressures) of all bodies, then, body by body, the normal ones of bonded sides, whose
/// sign is free, and the tangential ones.
///                                                             [P (12), (14), q = p]
///
/// With a basis that shares nodes, neighbours on a smooth side share the coefficient of
/// their common node, also around a closed line.  At the end of a side a coefficient
/// exists only if the displacement has a free component for it: clamps fix one or both,
/// and at a corner of two contact sides both normals have priority over friction.  In the
/// inequalities a missing coefficient has the value of its neighbour; at a clamp it has
/// no inequality.  In the multiplier as a function, and in reactions of clamps, it is
/// such that the degree is p - 1, see completeEnds.
class MultiplierSpace {
 public:
  struct ContactElement {
    int body = 0;
    const bem::Mesh* mesh = nullptr;  ///< of the body
    int element = 0;                  ///< of the mesh
    int degree = 1;
    const std::string* boundary = nullptr;
    const Conditions::Contact* condition = nullptr;
    Index point = 0;  ///< number of the first of its p + 1 Gauss points
    Coefficients normal{};
    Coefficients tangential{};  ///< none without friction
    /// Number in the body's list of the contact element that starts where this one ends, if any.
    std::optional<std::size_t> follower{};
    bool joinsFollower = false;  ///< shares its last node with that

    const bem::Element& geometry() const { return (*mesh)[element]; }
    /// Its coefficients in a row, normal ones first: their count, direction, basis function, number.
    int coefficients() const { return (shears() ? 2 : 1) * (degree + 1); }
    bool isTangential(int i) const { return i > degree; }
    const Coefficients& of(int i) const { return isTangential(i) ? tangential : normal; }
    int functionOf(int i) const { return i % (degree + 1); }
    Index numberOf(int i) const { return of(i).number(functionOf(i)); }
    /// Are the sides bonded, at least along the normal?
    bool ties() const { return condition->ties(); }
    /// Has it tangential coefficients?
    bool shears() const { return tangential.first >= 0; }

    /// Numbers of the coefficients of the basis functions i = 0 ... degree.
    Index normalOf(int i) const { return normal.number(i); }
    Index tangentialOf(int i) const { return tangential.number(i); }
  };

  struct Body {
    const bem::Mesh& mesh;
    const Conditions& conditions;
  };
  /// Refers to the meshes and conditions.
  /// \throws bem::InputError for an element without a coefficient of its own, if the basis
  /// shares nodes
  MultiplierSpace(const std::vector<Body>& bodies, const MultiplierBasis& basis);
  /// Of one body.
  MultiplierSpace(const bem::Mesh& mesh, const MultiplierBasis& basis,
                  const Conditions& conditions)
      : MultiplierSpace(std::vector<Body>{{mesh, conditions}}, basis) {}

  /// The same numbering with the conditions of another time of a path, by body, which differ in
  /// their functions only; refers to them.
  MultiplierSpace under(const std::vector<Conditions>& conditions) const;

  const MultiplierBasis& basis() const { return *basis_; }
  std::size_t bodies() const { return elements_.size(); }
  const bem::Mesh& mesh(std::size_t body) const { return *meshes_[body]; }
  /// Conditions of the constructor, or of under().
  const Conditions& conditions(std::size_t body) const { return *conditions_[body]; }
  /// Contact elements of a body in the order of its mesh.
  const std::vector<ContactElement>& elements(std::size_t body) const {
    return elements_[body];
  }
  /// Numbers of the coefficients of a body, ascending: its columns of the multiplier.
  const std::vector<Index>& columns(std::size_t body) const { return columns_[body]; }
  /// Number of normal coefficients that are not bonded: pressures.
  Index normals() const { return normals_; }
  Index size() const { return size_; }
  /// Number of Gauss points of all elements, p + 1 on each.
  Index points() const { return points_; }
  /// For each coefficient about the integral of its function.
  Vector lengths() const;

  /// visit(element) of all bodies.
  template <class Visit>
  void forEachElement(const Visit& visit) const {
    for (const std::vector<ContactElement>& ofBody : elements_)
      for (const ContactElement& element : ofBody)
        visit(element);
  }

  /// λₙ and λₜ (dimensionless) at a point of a contact element; λₜ = 0 without friction.
  struct Value {
    double normal = 0;
    double tangential = 0;
  };
  Value at(const Vector& multiplier, const ContactElement& element, double t) const;
  /// At t, of a quantity that is not negative: the positive part of the polynomial that interpolates
  /// its values at the Gauss points, which is never farther from it than the polynomial.
  static double throughPoints(const Vector& values, const ContactElement& element,
                              double t);

 private:
  void addBody(const Body& body);
  void shareNodes(const Body& body, std::vector<ContactElement>& elements) const;
  void number();

  const MultiplierBasis* basis_;
  std::vector<const bem::Mesh*> meshes_;               ///< by body
  std::vector<const Conditions*> conditions_;          ///< likewise
  std::vector<std::vector<ContactElement>> elements_;  ///< likewise
  std::vector<std::vector<Index>> columns_;            ///< likewise
  Index normals_ = 0;
  Index size_ = 0;
  Index points_ = 0;
};

/// Name of the contact: that of Contacts in the scene between bodies, else of its boundary.
inline const std::string& nameOf(const MultiplierSpace::ContactElement& element) {
  return element.condition->name.empty() ? *element.boundary : element.condition->name;
}

/// Where messages say that its condition is given: the path of the list, else its boundary.
inline std::string placeOf(const MultiplierSpace::ContactElement& on) {
  return on.condition->path.empty() ? "boundary '" + *on.boundary + "'"
                                    : on.condition->path;
}

}  // namespace epafi::contact
