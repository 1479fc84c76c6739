#include "bem/base/Error.hpp"
#include "bem/geometry/Crossing.hpp"
#include "drivers/scene/Readers.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace epafi::drivers {

namespace {

using bem::Vec2;

/// A straight piece of an outline, in the user's coordinates.
struct Stroke {
  Vec2 from;
  Vec2 to;
  bool inContact = false;  ///< with the other body of the pair
  const std::string* boundary = nullptr;
};

std::vector<Stroke> strokes(const bem::Outline& outline,
                            const std::set<std::string>& touching) {
  std::vector<Stroke> result;
  for (const bem::Edge& edge : outline.edges()) {
    const std::vector<Vec2> ends = chords(edge.curve);
    for (std::size_t k = 1; k < ends.size(); ++k)
      result.push_back({outline.physical(ends[k - 1]), outline.physical(ends[k]),
                        touching.count(edge.boundary) != 0, &edge.boundary});
  }
  return result;
}

/// Do two pieces cross inside both, by more than rounding?  `where`: the crossing.
bool cross(const Stroke& a, const Stroke& b, Vec2& where) {
  const Vec2 u = a.to - a.from;
  const Vec2 v = b.to - b.from;
  const double both = bem::cross(u, v);
  const double size = norm(u) * norm(v);
  if (!(std::abs(both) > 1e-9 * size))
    return false;
  const double s = bem::cross(b.from - a.from, v) / both;
  const double t = bem::cross(b.from - a.from, u) / both;
  constexpr double off = 1e-9;
  if (!(s > off && s < 1 - off && t > off && t < 1 - off))
    return false;
  where = a.from + s * u;
  return true;
}

struct Named {
  const SideOfBody& body;
  const std::string& name;
  const bem::Outline& outline;
  std::set<std::string> touching;  ///< boundaries in contact with the other of a pair
};

[[noreturn]] void refuse(const Named& a, const Named& b, Vec2 where,
                         const std::string& how) {
  throw bem::InputError("Bodies: '", a.name, "' and '", b.name, "' overlap at (", where.x,
                        ", ", where.y, "), away from a contact between them: ", how);
}

/// Reports a boundary of a that has no contact with b but lies inside b at `where`.
[[noreturn]] void refuse(const Named& a, const std::string& boundary, const Named& b,
                         Vec2 where) {
  refuse(a, b, where, "'" + a.name + ":" + boundary + "' reaches into '" + b.name + "'");
}

void checkCorners(const Named& a, const std::vector<Stroke>& ofA, const Named& b) {
  for (std::size_t k = 0; k < ofA.size(); ++k) {
    const auto ends = std::find_if(ofA.begin(), ofA.end(), [&](const Stroke& other) {
      return other.to == ofA[k].from;
    });
    const bool touches = ofA[k].inContact || (ends != ofA.end() && ends->inContact);
    if (!touches && b.outline.contains(ofA[k].from))
      refuse(a, *ofA[k].boundary, b, ofA[k].from);
  }
}

/// Coincident edges do not cross, so test a point just inside the middle of each edge.
void checkMiddles(const Named& a, const Named& b) {
  constexpr double inside = 1e-6;
  for (const bem::Edge& edge : a.outline.edges()) {
    const bem::Curve& curve = edge.curve;
    const Vec2 where =
        a.outline.physical(curve.point(0) - inside * curve.length() * curve.normal(0));
    if (a.touching.count(edge.boundary) == 0 && b.outline.contains(where))
      refuse(a, edge.boundary, b, where);
  }
}

/// The depth of a point inside a body and the nearest boundary; zero outside.
std::pair<double, const std::string*> depthIn(const bem::Outline& outline, Vec2 place) {
  if (!outline.contains(place))
    return {0, nullptr};
  const Vec2 x = outline.scaled(place);
  const auto nearest =
      std::min_element(outline.edges().begin(), outline.edges().end(),
                       [x](const bem::Edge& a, const bem::Edge& b) {
                         return a.curve.distance(x) < b.curve.distance(x);
                       });
  return {nearest->curve.distance(x) * outline.scaling().length, &nearest->boundary};
}

/// The boundaries beside a contact may overlap the other body by an interference at most.
void checkNeighbours(const Named& a, const Named& b, double plausible) {
  constexpr int perEdge = 16;
  double deepest = 0;
  Vec2 there;
  const std::string* side = nullptr;
  const std::string* behind = nullptr;
  for (const bem::Edge& edge : a.outline.edges())
    for (int k = 0; k <= perEdge && a.touching.count(edge.boundary) == 0; ++k) {
      const Vec2 where = a.outline.physical(edge.curve.point(-1 + 2.0 * k / perEdge));
      const auto [depth, nearest] = depthIn(b.outline, where);
      if (depth > deepest) {
        deepest = depth;
        there = where;
        side = &edge.boundary;
        behind = nearest;
      }
    }
  if (side != nullptr && behind != nullptr && deepest > plausible)
    throw bem::InputError("Bodies: '", a.name, "' and '", b.name, "' overlap by ",
                          deepest, " at (", there.x, ", ", there.y,
                          "), far more than an interference: '", a.name, ":", *side,
                          "', which is not in contact with '", b.name,
                          "', reaches into it behind '", b.name, ":", *behind, "'");
}

/// `plausible`: largest plausible interference; zero without contact between the two.
void checkPair(const Named& a, const Named& b, double plausible) {
  const std::vector<Stroke> ofA = strokes(a.outline, a.touching);
  const std::vector<Stroke> ofB = strokes(b.outline, b.touching);
  Vec2 where;
  for (const Stroke& one : ofA)
    for (const Stroke& other : ofB)
      if (!one.inContact && !other.inContact && cross(one, other, where))
        refuse(a, b, where,
               "'" + a.name + ":" + *one.boundary + "' crosses '" + b.name + ":" +
                   *other.boundary + "'");
  checkCorners(a, ofA, b);
  checkCorners(b, ofB, a);
  checkMiddles(a, b);
  checkMiddles(b, a);
  if (plausible > 0) {
    checkNeighbours(a, b, plausible);
    checkNeighbours(b, a, plausible);
  }
}

/// Twice the area over the outline's length, in the user's unit of length.
double thicknessOf(const bem::Outline& outline) {
  double area = 0;
  double length = 0;
  for (const bem::Edge& edge : outline.edges()) {
    const bem::Curve& curve = edge.curve;
    area += bem::cross(curve.from(), curve.to()) + twiceAreaBesideChord(curve);
    length += curve.length();
  }
  return area / length * outline.scaling().length;
}

}  // namespace

double largestInterference(const Scene& scene, const ContactPair& pair) {
  constexpr double share = 0.05;
  const double own = thicknessOf(scene.outlineOf(pair.side));
  return share * (pair.opposite.rigid
                      ? own
                      : std::min(own, thicknessOf(scene.outlineOf(pair.opposite))));
}

void checkOverlaps(const Scene& scene) {
  const std::vector<SideOfBody> all = scene.everyBody();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      Named a{all[i], scene.nameOf(all[i]), scene.outlineOf(all[i]), {}};
      Named b{all[j], scene.nameOf(all[j]), scene.outlineOf(all[j]), {}};
      double plausible = 0;
      for (const ContactPair& pair : scene.contacts)
        for (auto [own, other] : {std::pair(&a, &b), std::pair(&b, &a)})
          if (pair.side.isOnBodyOf(own->body) && pair.opposite.isOnBodyOf(other->body)) {
            own->touching.insert(pair.side.boundary);
            other->touching.insert(pair.opposite.boundary);
            plausible = largestInterference(scene, pair);
          }
      checkPair(a, b, plausible);
    }
}

}  // namespace epafi::drivers
