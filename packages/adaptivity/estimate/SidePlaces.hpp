#pragma once

#include "bem/fields/BoundaryFields.hpp"
#include "contact/results/ContactPlace.hpp"

#include <deque>
#include <unordered_map>
#include <vector>

namespace epafi::adaptivity {

/// Points of a contact element and what lies opposite to them, without the gap that is given, which
/// may follow time: the same in all states of a level, most of which ask for the same points.
class KnownPlaces {
 public:
  using Element = contact::MultiplierSpace::ContactElement;

  explicit KnownPlaces(const Element& element);
  KnownPlaces(const KnownPlaces&) = delete;
  KnownPlaces& operator=(const KnownPlaces&) = delete;

  /// The same as contact::ContactPlace{solved, element, t} for that element of a state.
  contact::ContactPlace at(const contact::Solved& solved, const Element& element,
                           double t);

 private:
  struct Place {
    bem::SurfacePoint point;
    contact::Opposite::Point opposite;
  };

  contact::Conditions::Contact condition_;
  Element element_;  ///< under that condition, which gives no gap
  std::unordered_map<double, Place> known_;
};

/// Of a body at the points of the fields on its elements, the same in all states of a level.
class SidePlaces {
 public:
  using Fields = std::vector<std::vector<bem::BoundaryValue>>;

  /// Refers to the multiplier's elements that press on it.
  /// \param fields  by element, of any state
  SidePlaces(const contact::Solved& any, const Fields& fields);

  /// The directions of contact on a contact element.
  const std::vector<bem::Vec2>& directions(std::size_t contact) const {
    return directions_[contact];
  }
  KnownPlaces& known(std::size_t contact) { return known_[contact]; }
  /// Traction by the multipliers of other bodies at a point of an element that carries none.
  bem::Vec2 pressed(const contact::Solved& solved, int element, std::size_t point) const {
    return solved.problem.foreignTraction(solved.state.multiplier,
                                          sources_[bem::at(element)][point]);
  }

 private:
  std::vector<std::vector<bem::Vec2>> directions_;
  std::deque<KnownPlaces> known_;
  /// By element and point.
  std::vector<std::vector<std::vector<contact::Opposite::Source>>> sources_;
};

}  // namespace epafi::adaptivity
