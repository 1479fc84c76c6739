#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/run/Warnings.hpp"
#include "drivers/scene/Readers.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

namespace epafi::drivers {

namespace {

using bem::message;

constexpr double degree = 3.1415926535897932 / 180;

/// From the end of a segment to the start of the next one, to the left; 0 beside arcs.
double turnBehind(const bem::Outline& outline, const bem::Edge& edge) {
  const bem::Edge& next = outline.edge(edge.next);
  if (edge.curve.angle() != 0 || next.curve.angle() != 0 ||
      next.boundary != edge.boundary)
    return 0;
  const bem::Vec2 a = edge.curve.tangent(0);
  const bem::Vec2 b = next.curve.tangent(0);
  return std::atan2(a.x * b.y - a.y * b.x, bem::dot(a, b));
}

/// Joints of one boundary that turn by a little, all to one side.
void findPolygon(const bem::Outline& outline, const std::string& boundary,
                 const std::string& body, Warnings& warn) {
  constexpr double largest = 20 * degree;
  constexpr double smallest = 1e-6;
  constexpr int few = 3;  // joints: a chamfer has two
  int left = 0;
  int right = 0;
  double turn = 0;
  for (const bem::Edge& edge : outline.edges()) {
    const double angle = edge.boundary == boundary ? turnBehind(outline, edge) : 0;
    if (std::abs(angle) < smallest || std::abs(angle) > largest)
      continue;
    (angle > 0 ? left : right) += 1;
    turn = std::max(turn, std::abs(angle));
  }
  if (std::max(left, right) >= few && std::min(left, right) == 0)
    warn("Bodies->", body, "->Geometry, '", boundary, "': ", left + right,
         " corners of up to ", std::round(turn / degree * 10) / 10,
         " degrees draw a curve on a side in contact; pressure then stands on the "
         "corners.  Arcs (Geometry->Bulges) are exact; so is a straight side with the "
         "shape in its Gap");
}

void addWords(const std::string& text, std::set<std::string>& words) {
  std::string word;
  for (const char c : text + " ")
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_')
      word += c;
    else
      words.insert(std::exchange(word, {}));
}

/// Adds the words of all texts of a list and its sublists, and warns of keys without effect.
void collectWords(const Teuchos::ParameterList& list, const std::string& path,
                  std::set<std::string>& words, Warnings& warn) {
  for (const auto& item : list) {
    const std::string place = bem::join(path, item.first);
    if (item.second.isList())
      collectWords(Teuchos::getValue<Teuchos::ParameterList>(item.second), place, words,
                   warn);
    if (!item.second.isType<std::string>())
      continue;
    std::set<std::string> own;
    addWords(Teuchos::getValue<std::string>(item.second), own);
    if (item.first == "Sliding" && path != "Constants" && own.count("t") == 0)
      warn(place + ": does not use t; without a change nothing slides");
    if (item.first == "Cycle Jump" && own.count("1") == 0 &&
        !list.isParameter("Coefficient"))
      warn(place + ": nothing wears without Coefficient");
    words.merge(own);
  }
}

/// Adds the words of what a list has in place of numbers.
void collectConstants(const Teuchos::ParameterList& given,
                      const Teuchos::ParameterList& used, std::set<std::string>& words) {
  for (const auto& item : given)
    if (item.second.isList() && used.isSublist(item.first))
      collectConstants(given.sublist(item.first), used.sublist(item.first), words);
    else if (used.isParameter(item.first) &&
             used.getEntry(item.first).getAny(false).type() !=
                 item.second.getAny(false).type())
      addWords(message(item.second.getAny(false)), words);
}

/// What has no effect: constants that no expression knows (a misspelt one that --set made,
/// say), a path on which nothing changes, rigid bodies that nothing touches.
void findUnused(const Scene& scene, Warnings& warn) {
  std::set<std::string> words;
  collectWords(*scene.used, "", words, warn);
  collectConstants(scene.given, *scene.used, words);
  std::vector<std::string> used;
  for (const auto& [name, value] : scene.constants)
    if (words.count(name) != 0)
      used.push_back(name);
  const auto tell = [&](const std::string& what, const std::string& name) {
    warn(what + " is in no expression" + bem::meant(name, used));
  };
  for (const auto& [name, value] : scene.constants)
    if (words.count(name) == 0)
      tell(message("Constants->", name, " = ", value), name);
  for (const auto& [name, table] : scene.tables)
    if (words.count(name) == 0)
      tell("Tables->" + name, name);
  if (!scene.history && words.count("t") != 0)
    warn(
        "expressions use t, which is 1 without a History: a path in t takes "
        "History->Times");
  if (scene.history && words.count("t") == 0)
    warn("History: no expression uses t; all steps are under the same loads");
  for (std::size_t b = 0; b < scene.rigid.size(); ++b)
    if (std::none_of(scene.contacts.begin(), scene.contacts.end(),
                     [&](const ContactPair& pair) {
                       return pair.opposite.isOnBodyOf({true, b});
                     }))
      warn("Bodies->" + scene.rigid[b].name + ": is rigid, and no contact names it");
}

/// Sides that carry the multiplier and are next to rigid beside what they meet: what a pressure
/// does to them is lost in what it does to the softer body, and with it the pressure's digits where
/// the softer body's mesh does not see it.
void findStiffSides(const Scene& scene, Warnings& warn) {
  constexpr double large = 1e6;
  for (const ContactPair& pair : scene.contacts) {
    if (pair.opposite.rigid)
      continue;
    const Body& side = scene.bodies[pair.side.body];
    const Body& opposite = scene.bodies[pair.opposite.body];
    const double ratio = side.material.youngsModulus / opposite.material.youngsModulus;
    if (ratio > large)
      warn("Contacts->", pair.name, "->Between: '", side.name, "' is ", ratio,
           " times as stiff as '", opposite.name,
           "', and its pressures lose as many digits; name the softer one first, or make "
           "'",
           side.name, "' Rigid");
  }
}

/// What different units of length, or other words of the same problem, make of bodies.
void findUnlikeBodies(const Scene& scene, Warnings& warn) {
  constexpr double farLarger = 1000;
  const auto sizeOf = [](const Body& body) { return body.outline->diameter(); };
  const auto [small, large] = std::minmax_element(
      scene.bodies.begin(), scene.bodies.end(),
      [&](const Body& a, const Body& b) { return sizeOf(a) < sizeOf(b); });
  if (sizeOf(*large) > farLarger * sizeOf(*small))
    warn("Bodies: '", small->name, "' is ", std::round(sizeOf(*large) / sizeOf(*small)),
         " times smaller than '", large->name,
         "'; are both drawn in the same unit of length?");
  for (const Body& body : scene.bodies) {
    if (body.material.planeStress != scene.bodies.front().material.planeStress)
      warn("Bodies->", body.name, "->Material->Plane State: differs from that of '",
           scene.bodies.front().name,
           "'; forces are per unit of one thickness, and a thin body beside a thick one "
           "is neither");
    const std::string material = "Bodies->" + body.name + "->Material";
    if (scene.given.sublist("Bodies")
            .sublist(body.name)
            .sublist("Material")
            .isParameter("Density") &&
        body.conditions.inside == nullptr)
      warn(material,
           "->Density: acts by Gravity, Spin or Angular Acceleration under Body "
           "Loads alone, and none is given");
  }
}

/// Angles that are small in degrees, but not in radian.
void findLargeTurns(const Scene& scene, Warnings& warn) {
  constexpr double large = 0.5;
  for (const RigidBody& body : scene.rigid) {
    const RigidBody::Component& turn = body.components[2];
    const double angle = turn.free || !turn.value ? 0 : turn.value(scene.endOfPath());
    if (std::abs(angle) > large)
      warn("Bodies->", body.name, "->Motion->Rotation: is ", angle,
           "; rotations are in radian (30*pi/180 for 30 degrees), and the geometry is "
           "that of small ones");
  }
}

/// A multiplier that the displacement does not hold without stabilisation.
void findUnstable(const Scene& scene, Warnings& warn) {
  if (scene.hasContact() && !scene.stabilization.isOn() &&
      !contact::multiplierBasis(scene.multiplier).sharesNodes)
    warn(
        "Discretization->Stabilization->Form = None is stable with Multiplier "
        "'Biorthogonal' only; pressures of '" +
        scene.multiplier + "' may oscillate");
}

/// Sides that are drawn into each other, or pressed by Interference, by far more than small strains
/// can take up.  Bonded ones are as they are drawn.
void findDeepOverlaps(const Scene& scene, Warnings& warn) {
  if (scene.contacts.empty())
    return;
  std::map<std::string, std::pair<double, bem::Vec2>> deepest;  // by contact
  const BodySpaces spaces(scene, firstMeshes(scene));
  spaces.multiplier().forEachElement([&](const auto& element) {
    for (const double t : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      if (element.condition->name.empty() || element.ties())
        continue;
      const double depth = -spaces.opposite()->at(element, t).gap * scene.units().length;
      auto& most = deepest[element.condition->name];
      if (depth > most.first)
        most = {depth, element.mesh->physicalPoint(element.element, t)};
    }
  });
  for (const ContactPair& pair : scene.contacts) {
    const auto& [depth, place] = deepest[pair.name];
    if (depth > largestInterference(scene, pair))
      warn("Contacts->", pair.name, ": '", scene.labelOf(pair.side), "' lies ", depth,
           " deep in '", scene.labelOf(pair.opposite), "' at (", place.x, ", ", place.y,
           "), far more than an interference; unless a body gives way by bending or as a "
           "ring, strains "
           "are not small there, and the energy grows with the depth's square");
  }
}

/// Faces of an incompressible body that are so near each other that V hardly tells a change of its
/// volume from a pressure between them.
void findNarrowSlots(const Scene& scene, Warnings& warn) {
  constexpr double narrow = 1e-3;  // of an element; 1e-13 over the square of it is lost
  std::map<std::string, double> ratios;
  for (const ContactPair& pair : scene.contacts)
    if (const bem::Material& material = scene.bodies[pair.side.body].material;
        pair.side.isOnBodyOf(pair.opposite) && material.poissonsRatio >= 0.5 &&
        !material.planeStress)
      ratios[pair.name] = narrow;
  if (ratios.empty())
    return;
  const BodySpaces spaces(scene, firstMeshes(scene));
  spaces.multiplier().forEachElement([&](const auto& element) {
    const auto found = ratios.find(element.condition->name);
    if (found == ratios.end())
      return;
    const auto there = spaces.opposite()->at(element, 0);
    const double apart = norm(element.mesh->scaledPoint(element.element, 0) -
                              element.mesh->scaledPoint(there.element, there.t));
    found->second = std::min(found->second, apart / (2 * element.geometry().half));
  });
  for (const auto& [name, ratio] : ratios)
    if (ratio < narrow)
      warn("Contacts->", name, ": the sides are ", ratio,
           " of an element apart; in a body of Poisson's Ratio 1/2 dense operators lose "
           "the pressure's digits between them: take compressed ones (Solver->Linear->"
           "Method), a smaller Poisson's Ratio, or cut the body along the slot and tie "
           "its parts ahead of it");
}

/// Sides that come as near as Adjust says where they are not adjusted.
void findUnadjusted(const Scene& scene, Warnings& warn) {
  const Part contacts = scene.root().sub("Contacts");
  std::map<std::string, std::pair<double, bem::Vec2>> nearest;  // by contact
  for (const ContactPair& pair : scene.contacts)
    if (const Part part = contacts.sub(pair.name); part.has("Adjust"))
      nearest[pair.name].first = part.list->get<double>("Adjust");
  if (nearest.empty())
    return;
  const std::map<std::string, std::pair<double, bem::Vec2>> given = nearest;
  const BodySpaces spaces(scene, firstMeshes(scene));
  spaces.multiplier().forEachElement([&](const auto& element) {
    const auto found = nearest.find(element.condition->name);
    constexpr int samples = 8;
    for (int k = 0; k <= samples && found != nearest.end(); ++k) {
      const double t = -1 + 2.0 * k / samples;
      const bem::SurfacePoint x = element.mesh->physicalPoint(element.element, t);
      const double gap =
          std::abs(spaces.opposite()->at(element, t).gap * scene.units().length -
                   element.condition->gap(x));
      if (gap > 1e-12 * scene.units().length && gap < found->second.first)
        found->second = {gap, {x.x, x.y}};
    }
  });
  for (const auto& [name, at] : nearest)
    if (at.first < given.at(name).first)
      warn("Contacts->", name, "->Adjust: at (", at.second.x, ", ", at.second.y,
           ") the sides are drawn ", at.first,
           " apart, and are neither parallel nor concentric within ",
           given.at(name).first, " along their edges there: they stay as drawn");
}

}  // namespace

std::vector<std::string> warningsOf(const Scene& scene) {
  Warnings warn;
  for (const Body& body : scene.bodies)
    for (const auto& [boundary, condition] : body.conditions.contact)
      findPolygon(*body.outline, boundary, body.name, warn);
  std::set<std::string> seen;
  for (const ContactPair& pair : scene.contacts)
    if (seen.insert(scene.labelOf(pair.opposite)).second)
      findPolygon(scene.outlineOf(pair.opposite), pair.opposite.boundary,
                  scene.nameOf(pair.opposite), warn);
  findInConditions(scene, warn);
  findUnused(scene, warn);
  findStiffSides(scene, warn);
  findUnlikeBodies(scene, warn);
  findLargeTurns(scene, warn);
  findUnstable(scene, warn);
  findDeepOverlaps(scene, warn);
  findUnadjusted(scene, warn);
  findNarrowSlots(scene, warn);
  return warn.all();
}

}  // namespace epafi::drivers
