#include "drivers/scene/OverlapCheck.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <set>

namespace epafi::drivers {

namespace {

using bem::Vec2;

/// A straight piece of an outline, in the user's coordinates.
struct Stroke {
  Vec2 from;
  Vec2 to;
  bool inContact = false;  ///< with the other body of the pair
};

std::vector<Stroke> strokes(const bem::Outline& outline,
                            const std::set<std::string>& touching) {
  constexpr int perArc = 32;
  std::vector<Stroke> result;
  for (const bem::Edge& edge : outline.edges()) {
    const int count = edge.curve.isStraight() ? 1 : perArc;
    for (int k = 0; k < count; ++k) {
      const auto place = [&](int i) {
        return outline.physical(edge.curve.point(-1 + 2.0 * i / count));
      };
      result.push_back({place(k), place(k + 1), touching.count(edge.boundary) != 0});
    }
  }
  return result;
}

/// Where two pieces cross inside both, by more than rounding.
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
  const std::string& name;
  const bem::Outline& outline;
  std::set<std::string> touching;  ///< boundaries in contact with the other of a pair
};

[[noreturn]] void refuse(const Named& a, const Named& b, Vec2 where) {
  throw bem::InputError("Bodies: '", a.name, "' and '", b.name, "' overlap at (", where.x,
                        ", ", where.y, "), away from a contact between them");
}

void checkCorners(const Named& a, const std::vector<Stroke>& ofA, const Named& b) {
  for (std::size_t k = 0; k < ofA.size(); ++k) {
    const auto ends = std::find_if(ofA.begin(), ofA.end(), [&](const Stroke& other) {
      return other.to == ofA[k].from;
    });
    const bool touches = ofA[k].inContact || (ends != ofA.end() && ends->inContact);
    if (!touches && b.outline.contains(ofA[k].from))
      refuse(a, b, ofA[k].from);
  }
}

/// Edges that coincide do not cross: what lies just inside the middle of one tells.
void checkMiddles(const Named& a, const Named& b) {
  constexpr double inside = 1e-6;
  for (const bem::Edge& edge : a.outline.edges()) {
    const bem::Curve& curve = edge.curve;
    const Vec2 where =
        a.outline.physical(curve.point(0) - inside * curve.length() * curve.normal(0));
    if (a.touching.count(edge.boundary) == 0 && b.outline.contains(where))
      refuse(a, b, where);
  }
}

void checkPair(const Named& a, const Named& b) {
  const std::vector<Stroke> ofA = strokes(a.outline, a.touching);
  const std::vector<Stroke> ofB = strokes(b.outline, b.touching);
  Vec2 where;
  for (const Stroke& one : ofA)
    for (const Stroke& other : ofB)
      if (!one.inContact && !other.inContact && cross(one, other, where))
        refuse(a, b, where);
  checkCorners(a, ofA, b);
  checkCorners(b, ofB, a);
  checkMiddles(a, b);
  checkMiddles(b, a);
}

}  // namespace

void checkOverlaps(const Scene& scene) {
  std::vector<SideOfBody> all;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    all.push_back({false, b, ""});
  for (std::size_t b = 0; b < scene.rigid.size(); ++b)
    all.push_back({true, b, ""});
  const auto same = [](const SideOfBody& a, const SideOfBody& b) {
    return a.rigid == b.rigid && a.body == b.body;
  };
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      Named a{scene.nameOf(all[i]), scene.outlineOf(all[i]), {}};
      Named b{scene.nameOf(all[j]), scene.outlineOf(all[j]), {}};
      for (const ContactPair& pair : scene.contacts) {
        if (same(pair.side, all[i]) && same(pair.met, all[j])) {
          a.touching.insert(pair.side.boundary);
          b.touching.insert(pair.met.boundary);
        } else if (same(pair.side, all[j]) && same(pair.met, all[i])) {
          b.touching.insert(pair.side.boundary);
          a.touching.insert(pair.met.boundary);
        }
      }
      checkPair(a, b);
    }
}

}  // namespace epafi::drivers
