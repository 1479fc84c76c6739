#include "adaptivity/singular/Transitions.hpp"

#include "adaptivity/singular/Extrapolation.hpp"
#include "adaptivity/singular/SingularPoints.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace epafi::adaptivity {

namespace {

using ContactElement = contact::MultiplierSpace::ContactElement;

/// What a coefficient's place does in one respect: it is held or moves freely.
enum class Freedom { Held, Moving, Undefined };

Freedom contactFreedom(const PointState& state) {
  return state.normal == contact::NormalState::Open ? Freedom::Moving : Freedom::Held;
}

Freedom frictionFreedom(const PointState& state) {
  if (state.friction == contact::FrictionState::None)
    return Freedom::Undefined;
  return state.friction == contact::FrictionState::Stick ? Freedom::Held
                                                         : Freedom::Moving;
}

/// How a place moves relative to what it meets.
struct Motion {
  bem::Vec2 total;
  bem::Vec2 inStep;
};

/// The two respects, and how far a held place would have moved if it were free.
struct Respect {
  Freedom (*freedom)(const PointState&);
  double (*freeMotion)(const Motion& motion, bem::Vec2 normal, double gap);
};

const Respect respects[] = {
    {contactFreedom, [](const Motion& motion, bem::Vec2 normal,
                        double gap) { return gap - dot(motion.total, normal); }},
    {frictionFreedom,
     [](const Motion& motion, bem::Vec2 normal, double /*gap*/) {
       return std::abs(cross(normal, motion.inStep));
     }},
};

/// A coefficient's place.
struct Point {
  const ContactElement* element;
  double t;
  double place;  ///< from the edge's start
  PointState state;
};

double placeAt(const bem::Mesh& mesh, int e, double t) {
  return mesh[e].piece.start.fromStart + mesh[e].half * (1 + t);
}

std::vector<Point> coefficientPlaces(const bem::Mesh& mesh,
                                     const contact::MultiplierSpace& multiplier,
                                     const contact::ContactState& states) {
  std::vector<Point> points;
  for (const ContactElement& element : multiplier.elements()) {
    const auto places = multiplier.basis().places(element.degree);
    for (int i = 0; i <= element.degree; ++i) {
      const double t = places[i];
      points.push_back({&element, t, placeAt(mesh, element.element, t),
                        pointState(multiplier, element, i, states)});
    }
  }
  return points;
}

/// The places of all coefficients, in the order of the mesh.
class Places {
 public:
  Places(const bem::Mesh& mesh, const contact::MultiplierSpace& multiplier,
         const contact::ContactState& states)
      : mesh_(mesh), points_(coefficientPlaces(mesh, multiplier, states)) {}

  std::size_t size() const { return points_.size(); }
  const Point& operator[](std::size_t k) const { return points_[k]; }
  const bem::Element& element(std::size_t k) const { return mesh_[number(k)]; }
  int number(std::size_t k) const { return points_[k].element->element; }

  /// Do places k and k + 1 follow each other on the boundary?
  bool adjacent(std::size_t k) const {
    return k + 1 < size() &&
           (number(k) == number(k + 1) || mesh_[number(k)].next == number(k + 1));
  }

  /// Does the respect change between places k and k + 1 of one edge?
  bool changes(std::size_t k, const Respect& respect) const {
    if (!adjacent(k) || element(k).piece.edge != element(k + 1).piece.edge)
      return false;
    const Freedom a = respect.freedom(points_[k].state);
    const Freedom b = respect.freedom(points_[k + 1].state);
    return a != b && a != Freedom::Undefined && b != Freedom::Undefined;
  }

  /// Does the place behind (direction 1) or before (-1) place k go on like it on its
  /// edge?
  bool goOn(std::size_t k, int direction, const Respect& respect) const {
    if (direction < 0 && k == 0)
      return false;
    const std::size_t first = direction > 0 ? k : k - 1;
    return adjacent(first) &&
           element(first).piece.edge == element(first + 1).piece.edge &&
           !changes(first, respect);
  }

  double middle(std::size_t k) const {
    return 0.5 * (points_[k].place + points_[k + 1].place);
  }

 private:
  const bem::Mesh& mesh_;
  std::vector<Point> points_;
};

/// Changes of one respect, in order, each after place k.
using Changes = std::vector<std::size_t>;

/// Cuts the changes of a respect into flickering groups.
std::vector<Changes> groups(const Places& places, const Respect& respect) {
  constexpr std::size_t mostPlaces = 3;  // of a run that may be a flicker
  std::vector<Changes> result;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!places.changes(k, respect))
      continue;
    const bool joins =
        !result.empty() && k - result.back().back() <= mostPlaces &&
        places.element(k).piece.edge == places.element(result.back().back()).piece.edge &&
        places.number(k) - places.number(result.back().back() + 1) <= 1;
    if (joins)
      result.back().push_back(k);
    else
      result.push_back({k});
  }
  return result;
}

bool movesBefore(const Places& places, const Changes& group, const Respect& respect) {
  return respect.freedom(places[group.front()].state) == Freedom::Moving;
}

/// Is group g the end of a held zone that reaches to another group, on few elements?
bool endsShortZone(const Places& places, const std::vector<Changes>& all, std::size_t g,
                   const Respect& respect) {
  constexpr int few = 2;
  const bool behind = movesBefore(places, all[g], respect);
  if (behind ? g + 1 == all.size() : g == 0)
    return false;
  const std::size_t first = (behind ? all[g] : all[g - 1]).back() + 1;
  const std::size_t last = (behind ? all[g + 1] : all[g]).front();
  return places.element(first).piece.edge == places.element(last).piece.edge &&
         places.number(last) - places.number(first) < few;
}

/// What the side that moves tells about a group's place.
class Locator {
 public:
  Locator(const bem::Space& space, const SolvedStep& step, const Places& places,
          const contact::Opposite& opposite)
      : space_(space), step_(step), places_(places), opposite_(opposite) {}

  std::optional<double> locate(const Changes& group, const Respect& respect) const {
    const std::size_t first = group.front();
    const std::size_t last = group.back() + 1;
    const bool before = movesBefore(places_, group, respect);
    const double bound = places_.middle(before ? group.front() : group.back());
    const auto zero = beginOfGrowth(
        samples(before ? first : last, before ? -1 : 1, bound, respect), bound);
    const auto& a = places_.element(first).piece;
    const auto& b = places_.element(last).piece;
    if (!zero || !(*zero > a.start.fromStart) || !(*zero < b.end.fromStart))
      return {};
    return zero;
  }

 private:
  /// Of the motion behind `bound`, where place k lies, on up to three elements.
  Samples samples(std::size_t k, int direction, double bound,
                  const Respect& respect) const {
    constexpr int perElement = 8;
    Samples result;
    for (const ContactElement* element : elementsFrom(k, direction, respect))
      for (int i = 0; i < perElement; ++i) {
        const double t = (2 * i + 1.0) / perElement - 1;
        const double place = placeAt(space_.mesh(), element->element, t);
        if (direction * (place - bound) <= 0)
          continue;
        result.places.push_back(place);
        result.values.push_back(freeMotion(*element, t, respect));
      }
    return result;
  }

  /// That of place k and the next ones with places that go on like it.
  std::vector<const ContactElement*> elementsFrom(std::size_t k, int direction,
                                                  const Respect& respect) const {
    constexpr std::size_t most = 3;
    std::vector<const ContactElement*> elements{places_[k].element};
    while (places_.goOn(k, direction, respect)) {
      k = direction > 0 ? k + 1 : k - 1;
      if (places_[k].element == elements.back())
        continue;
      if (elements.size() == most)
        break;
      elements.push_back(places_[k].element);
    }
    return elements;
  }

  double freeMotion(const ContactElement& element, double t,
                    const Respect& respect) const {
    const int e = element.element;
    const auto met = opposite_.at(element, t);
    Motion motion;
    motion.total =
        space_.displacementAt(step_.displacement, e, t) - motionAt(step_.motions, met);
    motion.inStep = motion.total;
    if (step_.displacementBefore != nullptr)
      motion.inStep =
          motion.total - (space_.displacementAt(*step_.displacementBefore, e, t) -
                          motionAt(step_.motionsBefore, met));
    return respect.freeMotion(motion, space_.mesh()[e].curve.normal(t), met.gap);
  }

  const bem::Space& space_;
  const SolvedStep& step_;
  const Places& places_;
  const contact::Opposite& opposite_;
};

/// The singular points of the conditions, and the changes of state of which not every
/// respect is among the `explained`, so many after each place.
SingularPoints unexplained(const bem::Mesh& mesh, const contact::Conditions& conditions,
                           const Places& places, const std::vector<int>& explained) {
  SingularPoints points = findSingularPoints(mesh, conditions);
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    if (!places.adjacent(k) || places[k].state == places[k + 1].state)
      continue;
    int changed = 0;
    for (const Respect& respect : respects)
      changed += places.changes(k, respect) ? 1 : 0;
    if (changed > 0 && changed == explained[k])
      continue;
    const std::size_t e = places.number(k);
    if (places.number(k) == places.number(k + 1))
      points.inside[e].push_back(0.5 * (places[k].t + places[k + 1].t));
    else
      points.nodes[mesh[places.number(k)].endNode] = Singularity::Strong;
  }
  return points;
}

}  // namespace

LocatedTransitions locateTransitions(const bem::Space& space,
                                     const contact::Conditions& conditions,
                                     const contact::MultiplierSpace& multiplier,
                                     const contact::Opposite& opposite,
                                     const SolvedStep& step) {
  const bem::Mesh& mesh = space.mesh();
  const Places places(mesh, multiplier, step.states);
  const Locator locator(space, step, places, opposite);
  LocatedTransitions result;
  std::vector<int> explained(places.size());  // changes of a respect after each place
  for (const Respect& respect : respects) {
    const std::vector<Changes> all = groups(places, respect);
    for (std::size_t g = 0; g < all.size(); ++g) {
      const bool one = all[g].size() % 2 == 1 && !endsShortZone(places, all, g, respect);
      const auto place = one ? locator.locate(all[g], respect) : std::nullopt;
      if (!place)
        continue;
      result.transitions.push_back({places.element(all[g].front()).piece.edge, *place});
      for (const std::size_t k : all[g])
        ++explained[k];
    }
  }
  result.others = unexplained(mesh, conditions, places, explained);
  return result;
}

SingularPoints placeOn(const bem::Mesh& mesh, const LocatedTransitions& located) {
  constexpr double close = 0.01;
  SingularPoints points = located.others;
  for (const Transition& transition : located.transitions)
    for (int e = 0; e < mesh.size(); ++e) {
      const bem::Element& element = mesh[e];
      const double t =
          (transition.place - element.piece.start.fromStart) / element.half - 1;
      if (element.piece.edge != transition.edge || t < -1 || t >= 1)
        continue;
      std::vector<double>& inside = points.inside[e];
      if (1 + t < 2 * close)
        points.nodes[element.startNode] = Singularity::Strong;
      else if (1 - t < 2 * close)
        points.nodes[element.endNode] = Singularity::Strong;
      else if (std::none_of(inside.begin(), inside.end(), [t](double other) {
                 return std::abs(t - other) < 2 * close;
               }))
        inside.insert(std::upper_bound(inside.begin(), inside.end(), t), t);
    }
  return points;
}

}  // namespace epafi::adaptivity
