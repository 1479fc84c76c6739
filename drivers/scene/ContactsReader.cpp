#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "bem/geometry/Continuation.hpp"
#include "bem/geometry/NormalRay.hpp"
#include "drivers/scene/Readers.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace epafi::drivers {

namespace {

using bem::InputError;

SideOfBody readSide(const std::string& text, const std::string& path,
                    const Scene& scene) {
  const auto colon = text.find(':');
  if (colon == std::string::npos)
    throw InputError(
        path, ": '", text,
        R"(' is not a side; write body:boundary, as in {"pad:bottom", "plate:top"})");
  const std::string name = text.substr(0, colon);
  std::vector<std::string> names;
  for (SideOfBody side : scene.everyBody()) {
    names.push_back(scene.nameOf(side));
    if (names.back() != name)
      continue;
    side.boundary = text.substr(colon + 1);
    checkNamed(side.boundary, path + ": '" + text + "'", scene.outlineOf(side));
    return side;
  }
  throw InputError(path, ": there is no body '", name, "'", bem::suggestion(name, names));
}

/// Returns the side that carries λ first.
std::pair<SideOfBody, SideOfBody> readBetween(const Part& part, const Scene& scene) {
  const std::string key = part.path("Between");
  const auto& between = part.list->get<Teuchos::Array<std::string>>("Between");
  if (between.size() != 2)
    throw InputError(key, ": has ", between.size(),
                     " sides; a contact is between two, body:boundary each");
  SideOfBody first = readSide(between[0], key, scene);
  SideOfBody second = readSide(between[1], key, scene);
  if (first.rigid && second.rigid)
    throw InputError(key + ": both bodies are rigid; at least one must be elastic");
  if (first == second)
    throw InputError(key, ": names '", scene.labelOf(first),
                     "' twice; where a body meets itself give the edges of either face a "
                     "name of their own");
  if (first.rigid)
    std::swap(first, second);
  return {first, second};
}

void checkFree(const SideOfBody& side, const std::string& path, const Scene& scene) {
  if (side.rigid)
    return;
  const Body& body = scene.bodies[side.body];
  const contact::Conditions& conditions = body.conditions;
  const auto contact = conditions.contact.find(side.boundary);
  if (contact != conditions.contact.end() && !contact->second.name.empty())
    throw InputError(path, "->Between: '", scene.labelOf(side),
                     "' carries the stresses of Contacts->", contact->second.name,
                     "; give its edges different names");
  if (contact != conditions.contact.end() ||
      conditions.dirichlet.count(side.boundary) != 0 ||
      conditions.neumann.count(side.boundary) != 0)
    throw InputError(path, "->Between: '", scene.labelOf(side),
                     "' has a condition under Bodies->", body.name,
                     "->Boundary Conditions->", side.boundary,
                     "; a side in contact has none");
}

void checkNotOpposite(const SideOfBody& side, const std::string& path,
                      const Scene& scene) {
  for (const ContactPair& pair : scene.contacts)
    if (pair.opposite == side)
      throw InputError(path, "->Between: '", scene.labelOf(side), "' is what Contacts->",
                       pair.name,
                       " presses on, so it cannot carry the stresses of another "
                       "contact; name the other body first");
}

/// Places on an edge that are closer than this are one: a shorter element would be one of bodies
/// drawn side by side to the digits of a drawing, and across it tractions are unbounded.
double closest(const bem::Outline& outline, int edge) {
  constexpr double ofEdge = 1e-6;
  constexpr double ofScene = 1e-12;  // coordinates round; scaled ones are of size 1
  return std::max(ofEdge * outline.edge(edge).curve.length(), ofScene);
}

/// Adds a required node on an edge, unless there is one.
void addNode(const bem::Outline& outline, int edge, double place,
             std::vector<RequiredNode>& nodes) {
  const double length = outline.edge(edge).curve.length();
  const double same = closest(outline, edge);
  if (place < same || length - place < same)
    return;
  for (const RequiredNode& node : nodes)
    if (node.edge == edge && std::abs(node.place - place) < same)
      return;
  nodes.push_back({edge, place});
}

/// Likewise where the pressure's slope is unbounded, which a mesh with a node there knows by that.
void addPeak(const bem::Outline& outline, int edge, double place, Body& body) {
  const double length = outline.edge(edge).curve.length();
  const double same = closest(outline, edge);
  if (place < same || length - place < same)
    body.peaks.push_back({edge, place < same ? 0 : length});
  else
    addNode(outline, edge, place, body.nodes);
}

/// Adds a part of an edge, or extends the last part.
void addPart(const contact::Conditions::Part& part,
             std::vector<contact::Conditions::Part>& parts) {
  if (!parts.empty() && parts.back().edge == part.edge && parts.back().to == part.from &&
      parts.back().closed == part.closed && parts.back().along == part.along)
    parts.back().to = part.to;
  else
    parts.push_back(part);
}

/// Are a stretch of an edge and the edge that it faces, as drawn, nowhere farther apart than
/// `adjust`, and parallel or concentric up to a tenth of that?
bool isClosed(const bem::Curve& own, const bem::Facing& stretch, const bem::Curve& other,
              double adjust) {
  constexpr int samples = 16;
  constexpr double inside = 1 - 1e-7;  // a normal that touches an arc meets it beside
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (int k = 0; k <= samples; ++k) {
    const double s = inside * (2.0 * k / samples - 1);
    const double t =
        0.5 * (stretch.begin + stretch.end + s * (stretch.end - stretch.begin));
    if (const auto found = bem::crossing(own.point(t), own.normal(t), other)) {
      least = std::min(least, found->distance);
      most = std::max(most, found->distance);
    }
  }
  return std::max(-least, most) <= adjust && most - least <= 0.1 * adjust;
}

/// Does the curvature jump, or press a corner, where a side stops seeing an edge and begins to see another
/// one?  The slope of the pressure is unbounded there.
bool isUneven(const bem::Outline& outline, int edge, int next) {
  const bem::Curve& arriving =
      outline.edge(next).curve;  // outlines run against each other
  const bem::Curve& leaving = outline.edge(edge).curve;
  return outline.edge(next).next == edge &&
         (bem::joinSmoothly(arriving, leaving)
              ? !bem::haveOneCurvature(arriving, leaving)
              : cross(arriving.tangent(1), leaving.tangent(-1)) > 0);
}

/// Along whose normals an edge of a side sees what is opposite: those of the other side where it begins or
/// ends at a corner that presses into that.  Its own would part there, and meet places twice as far away
/// from the corner on flanks of 45 degrees.
bem::Normals normalsFor(const bem::Outline& outline, int e,
                        const bem::Visibility& visibility, const bem::CurveTree& opposite,
                        bem::Vec2 shift) {
  constexpr double steepest = 0.17;  // cosine of the angle to what is met, 80 degrees
  constexpr double flattest = 1e-3;  // sine
  const bem::Edge& edge = outline.edge(e);
  for (const bool end : {false, true}) {
    const int beside = end ? edge.next : edge.previous;
    const bem::Curve& neighbour = outline.edge(beside).curve;
    const bem::Vec2 own = edge.curve.normal(end ? 1 : -1);
    const bem::Vec2 off = neighbour.normal(end ? -1 : 1);
    const bem::Vec2 other =
        outline.isMirror(beside) ? own - 2 * dot(own, off) * off : off;
    const auto met = bem::faced(edge.curve.moved(shift), end ? 1 : -1, opposite,
                                visibility, bem::Normals::Opposite);
    if (!met)
      continue;
    const bem::Vec2 into =
        -opposite.curves()[bem::at(met->curve)].normal(met->crossing.t);
    const double turn = end ? 1 : -1;  // outlines run to the left
    if (turn * cross(own, into) > flattest && turn * cross(into, other) > flattest &&
        dot(own, into) > steepest)
      return bem::Normals::Opposite;
  }
  return bem::Normals::Own;
}

/// The stretches of an edge and along which normals it sees what they face.
using FacedEdge = std::pair<std::vector<bem::Facing>, bem::Normals>;

FacedEdge facedBy(const bem::Outline& outline, int e, const bem::Outline& other,
                  const Scene::OppositeEdges& opposite, const bem::Visibility& visibility,
                  bem::Vec2 shift) {
  const bem::Curve side = outline.edge(e).curve.moved(shift);
  const auto along = normalsFor(outline, e, visibility, opposite.curves, shift);
  auto stretches = bem::facing(side, opposite.curves, visibility, along);
  const auto curveOf = [&](const bem::Facing& stretch) {
    return other.edge(opposite.edges[bem::at(stretch.curve)]).curve;
  };
  const auto jumps = [&](const bem::Facing& a, const bem::Facing& b) {
    return a.end != b.begin || !bem::joinSmoothly(curveOf(b), curveOf(a));
  };
  // between normals of a corner there are none
  if (along == bem::Normals::Opposite &&
      std::adjacent_find(stretches.begin(), stretches.end(), jumps) != stretches.end())
    return {bem::facing(side, opposite.curves, visibility), bem::Normals::Own};
  return {std::move(stretches), along};
}

/// Is a slot of one body wide for its length?  Nothing but the term of one side in the stabilisation
/// tells apart what acts on faces that are nearer.
bool isWide(const bem::Curve& own, double t, const bem::Curve& other) {
  constexpr double ofLength = 1e-3;
  const auto across = bem::crossing(own.point(t), own.normal(t), other);
  return across && std::abs(across->distance) > ofLength * own.length();
}

/// Adds what is uneven opposite to a place of a side, where it begins to see the edge `next`.
void addUneven(const ContactPair& pair, int edge, double place, int next, Scene& scene) {
  addPeak(*scene.bodies[pair.side.body].outline, edge, place,
          scene.bodies[pair.side.body]);
  if (pair.opposite.rigid)
    return;
  const bem::Outline& other = scene.outlineOf(pair.opposite);
  addPeak(other, next, other.edge(next).curve.length(), scene.bodies[pair.opposite.body]);
}

/// Adds the vertices of the first side at which something uneven presses, and those that press, with
/// what they press on.
void addPeaks(const ContactPair& pair, const Scene::OppositeEdges& opposite,
              const std::map<int, FacedEdge>& faced, Scene& scene) {
  const bem::Outline& own = *scene.bodies[pair.side.body].outline;
  const bem::Outline& other = scene.outlineOf(pair.opposite);
  for (const auto& [e, seen] : faced) {
    const bem::Edge& edge = own.edge(e);
    const auto next = faced.find(edge.next);
    if (next == faced.end() || seen.first.empty() || next->second.first.empty())
      continue;
    const bem::Facing& last = seen.first.back();
    const bem::Facing& first = next->second.first.front();
    if (last.end < 1 || first.begin > -1)
      continue;
    const int met = opposite.edges[bem::at(last.curve)];
    const int after = opposite.edges[bem::at(first.curve)];
    const double length = edge.curve.length();
    if (met != after && isUneven(other, met, after))
      addUneven(pair, e, length, after, scene);
    const bem::Curve& leaving = own.edge(edge.next).curve;
    if (bem::joinSmoothly(edge.curve, leaving) ||
        cross(edge.curve.tangent(1), leaving.tangent(-1)) < 0)
      continue;
    addPeak(own, e, length, scene.bodies[pair.side.body]);
    const bem::Curve& curve = opposite.curves.curves()[bem::at(last.curve)];
    const auto there = bem::across(edge.curve.point(1) + scene.shift(pair),
                                   edge.curve.normal(1), curve, seen.second);
    if (there && !pair.opposite.rigid)
      addPeak(other, met, curve.half() * (1 + std::clamp(there->t, -1.0, 1.0)),
              scene.bodies[pair.opposite.body]);
  }
}

/// The parts of the first side that face the second; adds nodes at their ends on both.
/// \param adjust  gaps as drawn up to this count as zero, scaled
std::vector<contact::Conditions::Part> meet(const ContactPair& pair, double adjust,
                                            Scene& scene) {
  const bem::Outline& own = *scene.bodies[pair.side.body].outline;
  const bem::Outline& other = scene.outlineOf(pair.opposite);
  const Scene::OppositeEdges opposite = scene.oppositeEdges(pair);
  const bem::Visibility visibility = scene.visibility(pair);
  const bem::Vec2 shift = scene.shift(pair);
  std::vector<contact::Conditions::Part> parts;
  std::map<int, FacedEdge> faced;
  for (std::size_t e = 0; e < own.edges().size(); ++e) {
    const bem::Edge& edge = own.edges()[e];
    if (edge.boundary != pair.side.boundary)
      continue;
    const double half = edge.curve.half();
    const auto [stretches, along] =
        facedBy(own, static_cast<int>(e), other, opposite, visibility, shift);
    for (std::size_t s = 0; s + 1 < stretches.size(); ++s) {
      const int after = opposite.edges[bem::at(stretches[s + 1].curve)];
      if (stretches[s].end == stretches[s + 1].begin &&
          isUneven(other, opposite.edges[bem::at(stretches[s].curve)], after))
        addUneven(pair, static_cast<int>(e), half * (1 + stretches[s].end), after, scene);
    }
    faced.emplace(static_cast<int>(e), std::pair(stretches, along));
    for (const bem::Facing& stretch : stretches) {
      const bem::Curve& met = opposite.curves.curves()[bem::at(stretch.curve)];
      addPart(
          {static_cast<int>(e), half * (1 + stretch.begin), half * (1 + stretch.end),
           adjust > 0 && isClosed(edge.curve.moved(shift), stretch, met, adjust), along},
          parts);
      if (pair.opposite.rigid)
        continue;
      // the opposite side may get a node at the ends of a stretch
      const std::size_t k = stretch.curve;
      Body& body = scene.bodies[pair.opposite.body];
      bem::Vector places;
      const double middle = 0.5 * (stretch.begin + stretch.end);
      for (const double end : {stretch.begin, stretch.end})
        // a normal that touches an arc meets it beside that place
        for (const double inwards : {0.0, 1e-7, 1.0}) {
          const double t = end + inwards * (middle - end);
          const auto there =
              bem::across(edge.curve.point(t) + shift, edge.curve.normal(t), met, along);
          if (!there)
            continue;
          places.push_back(met.half() * (1 + std::clamp(there->t, -1.0, 1.0)));
          if (inwards == 0)
            addNode(other, opposite.edges[k], places.back(), body.nodes);
          break;
        }
      if (!pair.side.isOnBodyOf(pair.opposite) ||
          isWide(edge.curve.moved(shift), middle, met))
        body.conditions.facing.push_back({opposite.edges[k],
                                          std::min(places[0], places[1]),
                                          std::max(places[0], places[1])});
    }
  }
  addPeaks(pair, opposite, faced, scene);
  for (const contact::Conditions::Part& part : parts)
    for (const double place : {part.from, part.to})
      addNode(own, part.edge, place, scene.bodies[pair.side.body].nodes);
  return parts;
}

/// Above this ratio the first stiffness is singular to rounding in units of the softer.
void checkModuli(const ContactPair& pair, const std::string& path, const Scene& scene) {
  constexpr double most = 1e14;
  if (pair.opposite.rigid)
    return;
  const Body& side = scene.bodies[pair.side.body];
  const Body& opposite = scene.bodies[pair.opposite.body];
  const double ratio = side.material.youngsModulus / opposite.material.youngsModulus;
  if (ratio > most)
    throw InputError(path, "->Between: '", side.name, "' is ", ratio,
                     " times as stiff as '", opposite.name, "', at most ", most,
                     " is possible; name the softer one first, or make '", side.name,
                     "' Rigid");
}

}  // namespace

void readContacts(Scene& scene) {
  const Part contacts = scene.root().sub("Contacts");
  std::string apart;  // the path of sides that never meet
  for (const auto& item : *contacts.list) {
    Part part = contacts.sub(item.first);
    const std::string& path = part.place.path;
    ContactPair pair{item.first, {}, {}};
    std::tie(pair.side, pair.opposite) = readBetween(part, scene);
    checkFree(pair.side, path, scene);
    checkFree(pair.opposite, path, scene);
    checkNotOpposite(pair.side, path, scene);
    checkModuli(pair, path, scene);
    part.names.onBoundary = true;
    contact::Conditions::Contact condition = readContactOfBodies(part);
    condition.name = pair.name;
    double adjust = 0;
    if (part.has("Adjust")) {
      adjust = part.list->get<double>("Adjust") / scene.units().length;
      if (condition.ties())
        throw InputError(part.path("Adjust"),
                         ": sides under the law Tied are bonded across what is drawn "
                         "between them, free of strain; remove this key");
    }
    condition.parts = meet(pair, adjust, scene);
    if (condition.parts.empty() && apart.empty())
      apart = path;
    scene.bodies[pair.side.body].conditions.contact[pair.side.boundary] =
        std::move(condition);
    scene.contacts.push_back(std::move(pair));
  }
  checkOverlaps(scene);  // bodies one in the other hide their sides from each other
  if (!apart.empty())
    throw InputError(apart,
                     ": no point of the first side finds the second one along "
                     "its outward normal; the sides never meet");
}

}  // namespace epafi::drivers
