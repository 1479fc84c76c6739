#include "contact/opposite/Opposite.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace epafi::contact {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

namespace {

/// \pre there is one
const bem::Facing& stretchAt(const std::vector<bem::Facing>& stretches, double t) {
  const auto off = [t](const bem::Facing& stretch) {
    return std::max({0.0, stretch.begin - t, t - stretch.end});
  };
  return *std::min_element(
      stretches.begin(), stretches.end(),
      [&](const bem::Facing& a, const bem::Facing& b) { return off(a) < off(b); });
}

/// Measure of a side over that of what it sees along normals, `cosine` between both: the foot of a normal
/// runs along its curve with the part of the way that is along it, which an arc draws in or out by the distance from its centre.
/// Zero where normals meet: so far away nothing comes into contact.
double stretching(const ContactElement& side, double t, const bem::Curve& other,
                  double there, double distance, double cosine, bem::Normals along) {
  constexpr double narrowest = 0.1;
  const bem::Curve& own = side.geometry().curve;
  const bool isOwn = along == bem::Normals::Own;
  const double width = 1 + (isOwn ? own : other).curvature() * distance;
  if (width < narrowest)
    return 0;
  const double ofFeet = std::abs(cosine) / width;
  const double ofLines = isOwn ? ofFeet : 1 / ofFeet;
  if (!side.mesh->outline().isAxisymmetric())
    return ofLines;
  const double radius = other.point(there).x;
  return ofLines * (radius > 0 ? own.point(t).x / radius : ofLines);
}

/// Places of a side, also beyond it, that see the point t of a curve opposite, and the distances.
std::vector<std::pair<double, double>> lookingAt(const bem::Curve& side, Vec2 shift,
                                                 const bem::Curve& other, double t,
                                                 bem::Normals along) {
  std::vector<std::pair<double, double>> result;
  const Vec2 y = other.point(t) - shift;
  if (along == bem::Normals::Own)
    for (const double foot : bem::feetOn(side, y))
      result.emplace_back(foot, dot(y - side.point(foot), side.normal(foot)));
  else if (const auto here = bem::crossing(y, other.normal(t), side))
    result.emplace_back(here->t, here->distance);
  return result;
}

/// Does the gap as drawn count as zero on a stretch of an element?
bool isClosed(const ContactElement& element, const bem::Facing& stretch) {
  const bem::Element& side = element.geometry();
  const double place =
      side.piece.start.fromStart + (1 + 0.5 * (stretch.begin + stretch.end)) * side.half;
  const auto& parts = element.condition->parts;
  return std::any_of(parts.begin(), parts.end(), [&](const Conditions::Part& part) {
    return part.closed && part.edge == side.piece.edge && part.from <= place &&
           place <= part.to;
  });
}

/// An element has nodes where what lies opposite ends, but for slivers, which take part with what is
/// next to them.  A multiplier that acts beyond would press on nothing.
void checkCovered(const ContactElement& element,
                  const std::vector<bem::Facing>& stretches) {
  constexpr double sliver =
      1e-5;  // of an edge; nodes that are closer than 1e-6 are left out
  constexpr double ofScene = 1e-11;
  const bem::Mesh& mesh = *element.mesh;
  const bem::Element& side = element.geometry();
  double uncovered = side.curve.length();
  for (const bem::Facing& stretch : stretches)
    uncovered -= side.half * (stretch.end - stretch.begin);
  const double edge = mesh.outline().edge(side.piece.edge).curve.length();
  if (!stretches.empty() && uncovered <= std::max(sliver * edge, ofScene))
    return;
  const Vec2 from = mesh.physicalPoint(element.element, -1);
  const Vec2 to = mesh.physicalPoint(element.element, 1);
  throw bem::InputError(placeOf(element), ": nothing lies opposite to ",
                        stretches.empty() ? "" : "a part of ", "the element from (",
                        from.x, ", ", from.y, ") to (", to.x, ", ", to.y,
                        ") of the side that carries the stresses");
}

}  // namespace

Opposite::Opposite(const MultiplierSpace& multiplier, double length,
                   const std::map<std::string, OppositeSide>& sides)
    : length_(length), sides_(sides), sights_(multiplier.bodies()) {
  std::map<const bem::Mesh*, std::vector<bem::Continuations>> ofEdges;
  multiplier.forEachElement([&](const ContactElement& element) {
    std::vector<Sight>& ofBody = sights_[bem::at(element.body)];
    ofBody.resize(bem::at(element.mesh->size()));
    if (element.condition->name.empty())
      return;
    const OppositeSide& side = sides_.at(element.condition->name);
    Sight& sight = ofBody[bem::at(element.element)];
    sight.side = &side;
    sight.element = &element;
    std::vector<bem::Continuations>& beyond = ofEdges[element.mesh];
    if (beyond.empty())
      beyond = bem::continuations(element.mesh->outline());
    const bem::Piece& piece = element.geometry().piece;
    sight.beyond = beyond[bem::at(piece.edge)].ofPart(piece.start, piece.end);
    sight.along = element.condition->along(
        piece.edge, 0.5 * (piece.start.fromStart + piece.end.fromStart));
    sight.stretches = facing(element.geometry().curve.moved(side.shift), side.curves,
                             side.visibility, sight.along);
    checkCovered(element, sight.stretches);
    for (const bem::Facing& stretch : sight.stretches)
      if (side.body >= 0)
        facing_[{side.body, side.elements[stretch.curve]}].emplace_back(&sight, &stretch);
  });
}

const Opposite::Sight& Opposite::sight(const ContactElement& element) const {
  static const Sight fixed;
  return sights_.empty() ? fixed
                         : sights_[bem::at(element.body)][bem::at(element.element)];
}

template <class Visit>
void Opposite::forEachFacing(int body, int element, const Visit& visit) const {
  const auto found = facing_.find({body, element});
  if (found != facing_.end())
    for (const auto& [sight, stretch] : found->second)
      visit(*sight, *stretch);
}

Opposite::Point Opposite::at(const ContactElement& element, double t) const {
  const Sight& here = sight(element);
  constexpr int forDirections = 8;
  const bem::Curve& own = element.geometry().curve;
  const Vec2 normal = own.normal(t);
  Point point;
  point.direction.unit = normal;
  point.gap = givenGap(element, t);
  point.turning = own.pointsOfTurning();
  if (here.side == nullptr)
    return point;
  const OppositeSide& side = *here.side;
  const bem::Facing& stretch = stretchAt(here.stretches, t);
  const std::size_t k = stretch.curve;
  const bem::Curve& other = side.curves.curves()[k];
  std::optional<bem::Crossing> found;
  // a normal that touches an arc meets it beside that place
  for (const double inwards : {0.0, 1e-7, 1.0}) {
    const double place = t + inwards * (0.5 * (stretch.begin + stretch.end) - t);
    const Vec2 along = inwards == 0 ? normal : own.normal(place);
    if (found = across(own.point(place) + side.shift, along, other, here.along); found)
      break;
  }
  assert(found);
  point.t = std::clamp(found->t, -1.0, 1.0);
  const Vec2 opposite = other.normal(point.t);
  point.stretching = stretching(element, t, other, point.t, found->distance,
                                dot(opposite, normal), here.along);
  point.turning = std::max(point.turning, other.pointsOfTurning());
  if (!element.ties()) {
    point.direction = directionBetween(
        shapeAt(own, normal, here.beyond, t),
        shapeAt(other, opposite,
                side.beyond.empty() ? bem::Continuations{} : side.beyond[k], point.t));
    if (!isClosed(element, stretch))
      point.gap +=
          found->distance *
          dot(here.along == bem::Normals::Own ? normal : -opposite, point.direction.unit);
    if (point.direction.unit != normal)
      point.turning = std::max(point.turning, forDirections);
  }
  if (side.body >= 0) {
    point.body = side.body;
    point.element = side.elements[k];
    point.degree = side.degrees[k];
  } else {
    point.rigid = side.rigid;
    point.arm = other.point(point.t) - side.pole;
  }
  return point;
}

Vector Opposite::breaks(const ContactElement& element) const {
  Vector result;
  for (const bem::Facing& stretch : sight(element).stretches)
    if (stretch.end < 1)
      result.push_back(stretch.end);
  return result;
}

int Opposite::degree(const ContactElement& element) const {
  const Sight& here = sight(element);
  int degree = 0;
  for (const bem::Facing& stretch : here.stretches)
    if (here.side->body >= 0)
      degree = std::max(degree, here.side->degrees[stretch.curve]);
  return degree;
}

bool Opposite::meetsDeformable(std::size_t body) const {
  return body < sights_.size() &&
         std::any_of(sights_[body].begin(), sights_[body].end(), [](const Sight& here) {
           return here.side != nullptr && here.side->body >= 0;
         });
}

std::vector<Opposite::Source> Opposite::sources(int body, int element, double t) const {
  std::vector<Source> result;
  forEachFacing(body, element, [&](const Sight& here, const bem::Facing& stretch) {
    const bem::Curve& other = here.side->curves.curves()[stretch.curve];
    const bem::Curve& own = here.element->geometry().curve;
    for (const auto& [foot, distance] :
         lookingAt(own, here.side->shift, other, t, here.along))
      if (foot >= stretch.begin - 1e-12 && foot <= stretch.end + 1e-12) {
        const double place = std::clamp(foot, -1.0, 1.0);
        result.push_back({here.element, place,
                          stretching(*here.element, foot, other, t, distance,
                                     dot(other.normal(t), own.normal(foot)), here.along),
                          at(*here.element, place).direction.unit});
      }
  });
  return result;
}

Vector Opposite::sourceBreaks(int body, int element) const {
  Vector result;
  forEachFacing(body, element, [&](const Sight& here, const bem::Facing& stretch) {
    const bem::Curve& own = here.element->geometry().curve;
    for (const double t : {stretch.begin, stretch.end})
      if (const auto hit = across(own.point(t) + here.side->shift, own.normal(t),
                                  here.side->curves.curves()[stretch.curve], here.along))
        result.push_back(std::clamp(hit->t, -1.0, 1.0));
  });
  return result;
}

std::vector<Opposite::Seen> Opposite::seen(int body, int element) const {
  std::vector<Seen> result;
  forEachFacing(body, element, [&](const Sight& here, const bem::Facing& part) {
    const Stretch all{(part.begin + part.end) / 2, (part.end - part.begin) / 2, this};
    result.push_back({here.element, all, element});
  });
  return result;
}

const bem::Rule& ruleOfForces(const ContactElement& element,
                              const Opposite::Point& middle) {
  return bem::gaussLegendre(std::max(element.degree, middle.degree) + 1 + middle.turning);
}

std::vector<Stretch> stretches(const Opposite& opposite, const ContactElement& element) {
  Vector ends = opposite.breaks(element);
  ends.push_back(1);
  std::vector<Stretch> result;
  double start = -1;
  for (const double end : ends) {
    result.push_back({(start + end) / 2, (end - start) / 2, &opposite});
    start = end;
  }
  return result;
}

double Opposite::givenGap(const ContactElement& element, double t) const {
  const bem::Function& gap = element.condition->gap;
  return gap ? gap(element.mesh->physicalPoint(element.element, t)) / length_ : 0.0;
}

Vec2 motionAt(const Motions* motions, const Opposite::Point& point) {
  if (motions == nullptr)
    return {};
  if (point.rigid >= 0)
    return motions->rigid[point.rigid].at(point.arm);
  if (point.element < 0)
    return {};
  const bem::DisplacementField& field = motions->displacements[point.body];
  const Vec2 u = field.at(point.element, point.t);
  const BodyLoadSolution inside =
      motions->inside.empty() ? nullptr : motions->inside[point.body];
  return inside ? u + inside->displacement(field.space().mesh(), point.element, point.t)
                : u;
}

double turnAt(const Motions* motions, const Opposite::Point& point) {
  if (motions == nullptr)
    return 0;
  if (point.rigid >= 0)
    return motions->rigid[bem::at(point.rigid)].turn;
  return point.element < 0 ? 0 : motions->displacements[bem::at(point.body)].turn();
}

}  // namespace epafi::contact
