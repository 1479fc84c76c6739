#include "drivers/scene/Images.hpp"

#include "bem/base/Error.hpp"

#include <cmath>

namespace epafi::drivers {

namespace {

using bem::Outline;
using bem::Vec2;
using contact::Conditions;

/// An end of an edge, in the user's coordinates.
struct End {
  const Outline* outline;
  int edge;
  double t;  ///< -1 or 1

  const bem::Edge& of() const { return outline->edge(edge); }
  Vec2 place() const { return outline->physical(of().curve.point(t)); }
  Vec2 tangent() const { return of().curve.tangent(t); }
  Vec2 normal() const { return of().curve.normal(t); }
  /// At the part `inwards` of the edge from this end.
  double at(const bem::Function& of, double inwards = 0) const {
    const bem::Curve& curve = this->of().curve;
    const double s = t * (1 - 2 * inwards);
    const Vec2 point = outline->physical(curve.point(s));
    return of({point.x, point.y, curve.normal(s)});
  }
};

/// A roller and the side that meets it.
struct Corner {
  End roller;
  End side;
  int number;  ///< the edge that begins there
};

bool areParallel(Vec2 a, Vec2 b) { return std::abs(cross(a, b)) < bem::smoothAngle / 2; }

/// What holds a straight edge along its normal alone, as a function of the place; empty: nothing.
bem::Function heldBy(const Conditions& conditions, const End& end) {
  if (!end.of().curve.isStraight() || !conditions.isBoundary(end.of().boundary))
    return {};
  const auto contact = conditions.contact.find(end.of().boundary);
  if (contact != conditions.contact.end())
    return contact->second.isSupport ? contact->second.gap : bem::Function{};
  const auto found = conditions.dirichlet.find(end.of().boundary);
  if (found == conditions.dirichlet.end() || (found->second.x && found->second.y))
    return {};
  const bool isX = static_cast<bool>(found->second.x);
  return areParallel(end.normal(), isX ? Vec2{1, 0} : Vec2{0, 1})
             ? (isX ? found->second.x : found->second.y)
             : bem::Function{};
}

/// Has a load no part along an edge, up to rounding?
bool hasNoShear(const Conditions::Neumann& load, const End& end) {
  const Vec2 place = end.place();
  const Vec2 traction = load.at({place.x, place.y, end.normal()});
  return std::abs(dot(traction, end.tangent())) <= 1e-12 * norm(traction);
}

/// Moves a roller as a whole, without a load along it?
bool isMirror(const Conditions& conditions, const End& roller) {
  const bem::Function held = heldBy(conditions, roller);
  // the images of solids of revolution lie beyond planes across the axis
  if (!held ||
      (roller.outline->isAxisymmetric() && !areParallel(roller.normal(), {0, 1})))
    return false;
  for (const double inwards : {0.5, 1.0})
    if (roller.at(held, inwards) != roller.at(held))
      return false;
  const auto load = conditions.neumann.find(roller.of().boundary);
  return load == conditions.neumann.end() || hasNoShear(load->second, roller);
}

/// Has a gap a slope where it meets its image?
bool hasKink(const bem::Function& gap, const End& side) {
  constexpr double step = 1e-3;
  const double here = side.at(gap);
  const double near = side.at(gap, step) - here;
  const double far = side.at(gap, 2 * step) - here;
  return std::abs(4 * near - far) > 0.01 * std::abs(near) + 1e-13 * std::abs(here);
}

class Images {
 public:
  Images(const Scene& scene, const std::vector<Conditions>& conditions)
      : scene_(scene), conditions_(conditions) {}

  std::set<int> of(std::size_t body) const {
    std::set<int> found;
    for (const Corner& corner : corners(body))
      if (goesOn(body, corner))
        found.insert(corner.number);
    return found;
  }

 private:
  /// Right angles of a roller and something else.
  std::vector<Corner> corners(std::size_t body) const {
    const Outline& outline = *scene_.bodies[body].outline;
    std::vector<Corner> found;
    for (std::size_t e = 0; e < outline.edges().size(); ++e) {
      const int number = static_cast<int>(e);
      const End leaving{&outline, number, -1};
      const End arriving{&outline, outline.edge(number).previous, 1};
      if (!areParallel(leaving.tangent(), arriving.normal()))
        continue;
      for (const auto& [roller, side] :
           {std::pair{leaving, arriving}, {arriving, leaving}})
        if (isMirror(conditions_[body], roller) && !heldBy(conditions_[body], side))
          found.push_back({roller, side, number});
    }
    return found;
  }

  bool goesOn(std::size_t body, const Corner& corner) const {
    const Conditions& conditions = conditions_[body];
    const End& side = corner.side;
    const std::string& boundary = side.of().boundary;
    if (conditions.dirichlet.count(boundary) > 0)
      return false;
    const auto load = conditions.neumann.find(boundary);
    if (load != conditions.neumann.end())
      return hasNoShear(load->second, side);
    const auto obstacle = conditions.contact.find(boundary);
    if (obstacle != conditions.contact.end() && obstacle->second.name.empty())
      return isFitting(obstacle->second, body, corner.roller) &&
             !hasKink(obstacle->second.gap, side);
    for (const ContactPair& pair : scene_.contacts)
      for (const bool first : {true, false}) {
        const SideOfBody& own = first ? pair.side : pair.opposite;
        if (own.rigid || own.body != body || own.boundary != boundary)
          continue;
        const Conditions::Contact& contact =
            conditions_[pair.side.body].contact.at(pair.side.boundary);
        const SideOfBody& other = first ? pair.opposite : pair.side;
        if (!isFitting(contact, body, corner.roller) ||
            !(other.rigid ? isEven(other, corner) : meets(other, corner, contact)))
          return false;
      }
    return true;
  }

  /// The image slides the other way.
  bool isFitting(const Conditions::Contact& contact, std::size_t body,
                 const End& roller) const {
    return !(contact.friction || contact.sliding || contact.ties()) ||
           (!contact.sliding && roller.at(heldBy(conditions_[body], roller)) == 0);
  }

  bool isBeside(const End& roller, Vec2 place) const {
    constexpr double apart = 1e-6;
    return std::abs(dot(place - roller.place(), roller.normal())) <
           apart * scene_.units().length;
  }

  /// Ends the opposite side at a roller on the same line?
  bool meets(const SideOfBody& other, const Corner& corner,
             const Conditions::Contact& contact) const {
    for (const Corner& each : corners(other.body))
      if (each.side.of().boundary == other.boundary &&
          isBeside(corner.roller, each.side.place()) &&
          areParallel(each.roller.normal(), corner.roller.normal()) &&
          isFitting(contact, other.body, each.roller))
        return true;
    return false;
  }

  /// Is a rigid body opposite that neither turns nor moves across the line level there?
  bool isEven(const SideOfBody& other, const Corner& corner) const {
    const RigidBody& body = scene_.rigid[other.body];
    const Vec2 across = corner.roller.normal();
    const std::size_t axis = std::abs(across.x) > std::abs(across.y) ? 0 : 1;
    if (!areParallel(across, axis == 0 ? Vec2{1, 0} : Vec2{0, 1}))
      return false;
    for (const std::size_t c : {axis, std::size_t{2}}) {
      const RigidBody::Component& component = body.components[c];
      if (component.free)
        return false;
      for (const double t : scene_.history.times)
        if (component.value && component.value(t) != 0)
          return false;
    }
    bool isFound = false;
    for (std::size_t e = 0; e < body.outline->edges().size(); ++e) {
      const bem::Curve& curve = body.outline->edges()[e].curve;
      if (body.outline->edges()[e].boundary != other.boundary)
        continue;
      for (const double t : meeting(*body.outline, curve, corner.roller)) {
        isFound = true;
        if (!areParallel(curve.tangent(t), across))
          return false;
      }
    }
    return isFound;
  }

  /// Where a curve meets the line of a roller: its ends, or a place between them.
  std::vector<double> meeting(const Outline& outline, const bem::Curve& curve,
                              const End& roller) const {
    std::vector<double> found;
    const auto distance = [&](double t) {
      return dot(outline.physical(curve.point(t)) - roller.place(), roller.normal());
    };
    for (const double t : {-1.0, 1.0})
      if (isBeside(roller, outline.physical(curve.point(t))))
        found.push_back(t);
    if (!found.empty() || distance(-1) * distance(1) > 0)
      return found;
    double from = -1;
    double to = 1;
    while (to - from > 1e-12) {
      const double middle = 0.5 * (from + to);
      (distance(from) * distance(middle) > 0 ? from : to) = middle;
    }
    return {from};
  }

  const Scene& scene_;
  const std::vector<Conditions>& conditions_;
};

/// Functions that are no number at an end are told of where they count.
std::set<int> imagesOrNone(const Images& images, std::size_t body) {
  try {
    return images.of(body);
  } catch (const bem::InputError&) {
    return {};
  }
}

}  // namespace

std::vector<std::set<int>> imageCorners(const Scene& scene) {
  std::vector<std::set<int>> common;
  for (const double t : scene.history.times) {
    const std::vector<Conditions> conditions = scene.conditionsAt(t);
    const Images images(scene, conditions);
    const bool isFirst = common.empty();
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const std::set<int> now = imagesOrNone(images, b);
      if (isFirst)
        common.push_back(now);
      else
        for (auto k = common[b].begin(); k != common[b].end();)
          k = now.count(*k) > 0 ? std::next(k) : common[b].erase(k);
    }
  }
  return common;
}

}  // namespace epafi::drivers
