#include "bem/geometry/Curve.hpp"
#include "contact/results/Solved.hpp"
#include "drivers/run/Path.hpp"
#include "drivers/run/Warnings.hpp"

#include <algorithm>

namespace epafi::drivers {

namespace {

using bem::Vec2;

/// A vertex at which a side of a contact ends.
struct End {
  Vec2 place;     ///< in the user's coordinates
  bool isSmooth;  ///< goes the outline on smoothly, without contact?
  SideOfBody side;
  std::string next;  ///< boundary of the edge beyond
};

/// Does a boundary belong to a contact?
bool touches(const Scene& scene, const SideOfBody& boundary) {
  return std::any_of(scene.contacts.begin(), scene.contacts.end(),
                     [&](const ContactPair& pair) {
                       return pair.side == boundary || pair.opposite == boundary;
                     });
}

/// Where a side may end: all vertices of its edges but those between two of its own.
std::vector<End> endsOf(const Scene& scene, const SideOfBody& side) {
  std::vector<End> ends;
  const bem::Outline& outline = scene.outlineOf(side);
  const auto add = [&](const bem::Edge& own, const bem::Edge& beyond, bool isBehind) {
    if (beyond.boundary == side.boundary)
      return;
    const bem::Edge& first = isBehind ? own : beyond;
    const bem::Edge& second = isBehind ? beyond : own;
    const bool goesOn = joinSmoothly(first.curve, second.curve) &&
                        !touches(scene, {side.rigid, side.body, beyond.boundary});
    ends.push_back({second.start, goesOn, side, beyond.boundary});
  };
  for (const bem::Edge& edge : outline.edges())
    if (edge.boundary == side.boundary) {
      add(edge, outline.edge(edge.next), true);
      add(edge, outline.edge(edge.previous), false);
    }
  return ends;
}

/// The place opposite to a point of contact, in the user's coordinates.
Vec2 placeOf(const contact::Opposite::Point& there, const ContactPair& pair,
             const SolvedStep& step) {
  if (there.element >= 0)
    return step.bodies[there.body].space.mesh().physicalPoint(there.element, there.t);
  const Scene& scene = step.spaces.scene();
  return scene.rigid[pair.opposite.body].pole + scene.units().length * there.arm;
}

}  // namespace

void findCutSides(const SolvedLevel& level, Warnings& warn) {
  constexpr double same = 1e-6;
  const Scene& scene = level.last().spaces.scene();
  for (const ContactPair& pair : scene.contacts) {
    const std::vector<End> own = endsOf(scene, pair.side);
    const std::vector<End> others = endsOf(scene, pair.opposite);
    const double near = same * scene.outlineOf(pair.side).diameter();
    const auto endAt = [&](const std::vector<End>& ends, Vec2 place) {
      const auto end = std::find_if(ends.begin(), ends.end(), [&](const End& e) {
        return norm(e.place - place) < near;
      });
      return end == ends.end() ? nullptr : &*end;
    };
    const auto look = [&](const End* end, const End* other) {
      if (end != nullptr && end->isSmooth && (other == nullptr || other->isSmooth))
        warn.once(pair.name + end->next, "contact '", pair.name,
                  "' presses at an end of its side ", scene.labelOf(end->side), ", (",
                  end->place.x, ", ", end->place.y,
                  "), where the outline goes on smoothly: nothing is in contact "
                  "beyond; give the edge '",
                  end->next, "' the name '", end->side.boundary,
                  "', too, if contact goes on there");
    };
    for (const auto& step : level.steps) {
      if (!step->row.converged)
        continue;
      const contact::Solved& solved = step->bodies[pair.side.body];
      const contact::ContactFields fields(solved);
      for (const auto& element : fields.elements()) {
        if (element.condition->name != pair.name || element.condition->ties())
          continue;
        for (const double t : {-1.0, 1.0}) {
          const contact::ContactPoint point = fields.at(element, t);
          if (!point.closed)
            continue;
          const End* here = endAt(own, point.place);
          const End* there = endAt(
              others, placeOf(solved.problem.opposite().at(element, t), pair, *step));
          look(here, there);
          look(there, here);
        }
      }
    }
  }
}

}  // namespace epafi::drivers
