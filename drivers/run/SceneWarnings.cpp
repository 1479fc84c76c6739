#include "drivers/run/SceneWarnings.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "bem/quadrature/Piecewise.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/scene/OverlapCheck.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace epafi::drivers {

namespace {

using bem::message;

constexpr double degree = 3.1415926535897932 / 180;

/// From the end of a segment to the start of the next one, to the left; 0 beside arcs.
double turnBehind(const bem::Outline& outline, const bem::Edge& edge) {
  const bem::Edge& next = outline.edge(edge.next);
  if (!edge.curve.isStraight() || !next.curve.isStraight() ||
      next.boundary != edge.boundary)
    return 0;
  const bem::Vec2 a = edge.curve.tangent(0);
  const bem::Vec2 b = next.curve.tangent(0);
  return std::atan2(a.x * b.y - a.y * b.x, bem::dot(a, b));
}

/// Joints of one boundary that turn by a little, all to one side.
void findPolygon(const bem::Outline& outline, const std::string& boundary,
                 const std::string& name, std::vector<std::string>& warnings) {
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
    warnings.push_back(message(name, ": ", left + right, " corners of up to ",
                               std::round(turn / degree * 10) / 10,
                               " degrees draw a curve on a side in contact; pressure "
                               "then stands on the corners.  Arcs (Geometry->Bulges) are "
                               "exact; so is a straight side with the shape in its Gap"));
}

/// Sentences of which each is said once, whatever the time of a path.
class Warnings {
 public:
  explicit Warnings(std::vector<std::string>& all) : all_(all) {}
  template <class... Parts>
  void operator()(const std::string& about, const Parts&... parts) {
    if (seen_.insert(about).second)
      all_.push_back(message(parts...));
  }

 private:
  std::vector<std::string>& all_;
  std::set<std::string> seen_;
};

/// Displacements that differ by no more than rounding, in the user's unit of length.
bool areAlike(double a, double b, double size, const Body& body) {
  return std::abs(a - b) <= 1e-6 * size + 1e-12 * body.outline->diameter();
}

/// Corners where two sides prescribe displacements that differ.
void findJumps(const Body& body, const contact::Conditions& conditions, Warnings& warn) {
  const auto& held = conditions.dirichlet;
  for (const bem::Edge& edge : body.outline->edges()) {
    const std::string& next = body.outline->edge(edge.next).boundary;
    const auto before = held.find(edge.boundary);
    const auto behind = held.find(next);
    if (before == held.end() || behind == held.end() || before == behind)
      continue;
    const bem::Vec2 corner = body.outline->physical(edge.curve.to());
    const auto differ = [&](const bem::Function& one, const bem::Function& other) {
      if (!one || !other)
        return false;
      const double a = one(corner);
      const double b = other(corner);
      return !areAlike(a, b, std::max(std::abs(a), std::abs(b)), body);
    };
    if (differ(before->second.x, behind->second.x) ||
        differ(before->second.y, behind->second.y))
      warn(message("jump ", body.name, corner.x, corner.y), "Bodies->", body.name,
           "->Boundary Conditions: '", edge.boundary, "' and '", next,
           "' prescribe different displacements of their corner (", corner.x, ", ",
           corner.y,
           "); a jump has no finite energy: stresses there grow with every level");
  }
}

/// A function need not exist where no run looks at it.
std::optional<double> valueAt(const bem::Function& function, bem::Vec2 place) {
  try {
    return function(place);
  } catch (const bem::InputError&) {
    return std::nullopt;
  }
}

/// Beside an end of a side, to where it would go on: a gap need not exist at corners.
std::optional<double> gapAtEnd(const bem::Function& gap, const Body& body,
                               const bem::Edge& side, double end) {
  constexpr double aside = 1e-9;  // of the side
  const auto gapAt = [&](double distance) {
    return valueAt(gap, body.outline->physical(side.curve.point(end * (1 - distance))));
  };
  const auto near = gapAt(aside);
  const auto farther = gapAt(2 * aside);
  if (!near || !farther)
    return std::nullopt;
  return 2 * *near - *farther;
}

/// Corners where a prescribed displacement goes through the obstacle of the side beside it, one
/// warning for each pair of boundaries.
void findPressedCorners(const Body& body, const contact::Conditions& conditions,
                        Warnings& warn) {
  constexpr double same = 1e-6;
  const auto compare = [&](const bem::Edge& given, const bem::Edge& side, double end) {
    const auto held = conditions.dirichlet.find(given.boundary);
    const auto met = conditions.contact.find(side.boundary);
    if (held == conditions.dirichlet.end() || met == conditions.contact.end() ||
        !met->second.name.empty() || met->second.friction.ties())
      return;
    // a component that is free can give way
    const auto& [x, y] = held->second;
    const bem::Vec2 n = side.curve.normal(end);
    if ((!x && std::abs(n.x) > same) || (!y && std::abs(n.y) > same))
      return;
    const bem::Vec2 corner =
        body.outline->physical(end > 0 ? side.curve.to() : side.curve.from());
    const bem::Vec2 moved{x ? x(corner) : 0, y ? y(corner) : 0};
    const double closing = dot(moved, n);
    const auto gap = gapAtEnd(met->second.gap, body, side, end);
    if (gap && closing > *gap &&
        !areAlike(closing, *gap, std::abs(moved.x) + std::abs(moved.y), body))
      warn("corner " + body.name + given.boundary + "|" + side.boundary, "Bodies->",
           body.name, "->Boundary Conditions: '", given.boundary,
           "' moves its corner with '", side.boundary, "', (", corner.x, ", ", corner.y,
           "), by ", closing, " along the normal where the gap is ", *gap,
           ": through the obstacle; such a jump has no finite energy, and stresses there "
           "grow with every level");
  };
  for (const bem::Edge& edge : body.outline->edges()) {
    const bem::Edge& next = body.outline->edge(edge.next);
    compare(edge, next, -1);
    compare(next, edge, 1);
  }
}

/// The force of a traction on some elements, and the integral of its size.
struct Force {
  bem::Vec2 sum;
  double size = 0;
};

Force forceOf(const contact::Conditions::Neumann& traction, const bem::Mesh& mesh,
              const std::vector<int>& elements, const bem::Rule& rule) {
  Force force;
  for (const int e : elements)
    for (int q = 0; q < rule.size(); ++q) {
      const bem::Vec2 x = mesh.physicalPoint(e, rule.points[q]);
      const bem::Vec2 part = rule.weights[q] * mesh[e].half *
                             mesh.outline().scaling().length * traction.at(x);
      force.sum = force.sum + part;
      force.size += norm(part);
    }
  return force;
}

/// Tractions that change between the points at which a mesh takes them on one of a boundary's edges.
void findNarrowLoad(const Body& body, const bem::Mesh& mesh, const std::string& boundary,
                    const contact::Conditions::Neumann& traction, Warnings& warn) {
  constexpr double far = 0.1;
  constexpr double points = 4096;  // of the boundary, about
  constexpr std::size_t order = 16;
  std::map<int, std::vector<int>> edges;
  double whole = 0;
  for (const int e : mesh.elementsOf(boundary)) {
    edges[mesh[e].piece.edge].push_back(e);
    whole += mesh[e].half;
  }
  std::vector<std::pair<Force, Force>> forces;
  double largest = 0;
  for (const auto& [edge, elements] : edges) {
    const double share = 0.5 * mesh.outline().edge(edge).curve.length() / whole;
    const int pieces = 1 + static_cast<int>(share * points /
                                            static_cast<double>(order * elements.size()));
    bem::Vector breaks;
    for (int k = 1; k < pieces; ++k)
      breaks.push_back(-1 + 2.0 * k / pieces);
    try {
      forces.emplace_back(
          forceOf(traction, mesh, elements, bem::gaussForGiven(body.degree)),
          forceOf(traction, mesh, elements, bem::piecewiseRule(breaks, order)));
    } catch (const bem::InputError&) {
      continue;
    }
    largest = std::max({largest, forces.back().first.size, forces.back().second.size});
  }
  for (const auto& [used, fine] : forces)
    if (norm(used.sum - fine.sum) >
        far * std::max({used.size, fine.size, 1e-6 * largest}))
      warn("load " + body.name + boundary, "Bodies->", body.name,
           "->Boundary Conditions->", boundary,
           ": the traction is narrower than its elements can see: on one edge they take "
           "a force of (",
           used.sum.x, ", ", used.sum.y, "), a finer rule finds (", fine.sum.x, ", ",
           fine.sum.y,
           "); use more elements there (Discretization), or a vertex where the load "
           "begins and one where it ends");
}

/// What a body's conditions at some time say that is probably not meant.
void findInConditions(const Body& body, const contact::Conditions& conditions,
                      Warnings& warn) {
  findJumps(body, conditions, warn);
  findPressedCorners(body, conditions, warn);
  if (conditions.neumann.empty())
    return;
  const bem::Mesh mesh = firstMesh(body);
  for (const auto& [boundary, traction] : conditions.neumann)
    findNarrowLoad(body, mesh, boundary, traction, warn);
}

/// At the end of a path, and at some times before it.
void findInConditions(const Scene& scene, Warnings& warn) {
  for (const Body& body : scene.bodies)
    findInConditions(body, body.conditions, warn);
  constexpr std::size_t most = 12;
  const std::vector<double>& times = scene.history.times;
  const std::size_t stride = times.size() / most + 1;
  for (std::size_t k = 0; k + 1 < times.size(); k += stride) {
    const std::vector<contact::Conditions> now = scene.conditionsAt(times[k]);
    for (std::size_t b = 0; b < now.size(); ++b)
      findInConditions(scene.bodies[b], now[b], warn);
  }
}

/// Adds the words of all texts of a list and its sublists.
void collectWords(const Teuchos::ParameterList& list, std::set<std::string>& words) {
  for (const auto& item : list) {
    const Teuchos::ParameterEntry& entry = item.second;
    if (entry.isList()) {
      collectWords(Teuchos::getValue<Teuchos::ParameterList>(entry), words);
      continue;
    }
    if (!entry.isType<std::string>())
      continue;
    std::string word;
    for (const char c : Teuchos::getValue<std::string>(entry) + " ")
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_')
        word += c;
      else
        words.insert(std::exchange(word, {}));
  }
}

/// What has no effect: constants that no expression knows (a misspelt one that --set made,
/// say), a path on which nothing changes, rigid bodies that nothing touches.
void findUnused(const Scene& scene, std::vector<std::string>& warnings) {
  std::set<std::string> words;
  collectWords(*scene.used, words);
  std::vector<std::string> used;
  for (const auto& [name, value] : scene.constants)
    if (words.count(name) != 0)
      used.push_back(name);
  const auto tell = [&](const std::string& what, const std::string& name) {
    const std::string near = bem::nearest(name, used);
    warnings.push_back(
        what + " is in no expression" +
        (near.empty() ? "" : "; the nearest name that is in one: '" + near + "'"));
  };
  for (const auto& [name, value] : scene.constants)
    if (words.count(name) == 0)
      tell(message("Constants->", name, " = ", value), name);
  for (const auto& [name, table] : scene.tables)
    if (words.count(name) == 0)
      tell("Tables->" + name, name);
  if (scene.history && words.count("t") == 0)
    warnings.emplace_back(
        "History: no expression uses t; all steps are under the same loads");
  for (std::size_t b = 0; b < scene.rigid.size(); ++b)
    if (std::none_of(scene.contacts.begin(), scene.contacts.end(),
                     [&](const ContactPair& pair) {
                       return pair.met.rigid && pair.met.body == b;
                     }))
      warnings.push_back("Bodies->" + scene.rigid[b].name +
                         ": is rigid, and no contact names it");
}

/// Sides that carry the multiplier and are next to rigid beside what they meet: what a pressure
/// does to them is lost in what it does to the softer body, and with it the pressure's digits where
/// the softer body's mesh does not see it.
void findStiffSides(const Scene& scene, std::vector<std::string>& warnings) {
  constexpr double large = 1e6;
  for (const ContactPair& pair : scene.contacts) {
    if (pair.met.rigid)
      continue;
    const Body& side = scene.bodies[pair.side.body];
    const Body& met = scene.bodies[pair.met.body];
    const double ratio = side.material.youngsModulus / met.material.youngsModulus;
    if (ratio > large)
      warnings.push_back(
          message("Contacts->", pair.name, "->Between: '", side.name, "' is ", ratio,
                  " times as stiff as '", met.name,
                  "', and its pressures lose as many digits; name the softer one "
                  "first, or make '",
                  side.name, "' Rigid"));
  }
}

/// A multiplier that the displacement does not hold without stabilisation.
void findUnstable(const Scene& scene, std::vector<std::string>& warnings) {
  if (scene.hasContact() &&
      scene.stabilization.form == contact::Stabilization::Form::None &&
      !contact::multiplierBasis(scene.multiplier).sharesNodes)
    warnings.push_back(
        "Discretization->Stabilization->Form = None is stable with Multiplier "
        "'Biorthogonal' only; pressures of '" +
        scene.multiplier + "' may oscillate");
}

/// Sides that are drawn into each other, or pressed by Interference, by far more than small strains
/// can take up.  Bonded ones are as they are drawn.
void findDeepOverlaps(const Scene& scene, std::vector<std::string>& warnings) {
  if (scene.contacts.empty())
    return;
  struct Deepest {
    double depth = 0;
    bem::Vec2 place;
  };
  std::map<std::string, Deepest> deepest;  // by contact
  std::vector<bem::Mesh> meshes;
  for (const Body& body : scene.bodies)
    meshes.push_back(firstMesh(body));
  const BodySpaces spaces(scene, meshes);
  for (std::size_t b = 0; b < spaces.size(); ++b)
    for (const auto& element : spaces.multiplier(b).elements())
      for (const double t : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        if (element.condition->name.empty() || element.ties())
          continue;
        const double depth =
            -spaces.opposite(b)->at(element, t).gap * scene.units().length;
        Deepest& most = deepest[element.condition->name];
        if (depth > most.depth)
          most = {depth, meshes[b].physicalPoint(element.element, t)};
      }
  for (const ContactPair& pair : scene.contacts) {
    const auto& [depth, place] = deepest[pair.name];
    if (depth > largestInterference(scene, pair))
      warnings.push_back(message(
          "Contacts->", pair.name, ": '", scene.nameOf(pair.side), ":",
          pair.side.boundary, "' lies ", depth, " deep in '", scene.nameOf(pair.met), ":",
          pair.met.boundary, "' at (", place.x, ", ", place.y,
          "), far more than an interference; strains are not small there, and the energy "
          "grows with the depth's square"));
  }
}

}  // namespace

std::vector<std::string> warningsOf(const Scene& scene) {
  std::vector<std::string> warnings;
  for (const Body& body : scene.bodies)
    for (const auto& [boundary, condition] : body.conditions.contact)
      findPolygon(*body.outline, boundary,
                  "Bodies->" + body.name + "->Geometry, '" + boundary + "'", warnings);
  std::set<std::string> seen;
  for (const ContactPair& pair : scene.contacts)
    if (seen.insert(scene.nameOf(pair.met) + ":" + pair.met.boundary).second)
      findPolygon(
          scene.outlineOf(pair.met), pair.met.boundary,
          "Bodies->" + scene.nameOf(pair.met) + "->Geometry, '" + pair.met.boundary + "'",
          warnings);
  Warnings warn(warnings);
  findInConditions(scene, warn);
  findUnused(scene, warnings);
  findStiffSides(scene, warnings);
  findUnstable(scene, warnings);
  findDeepOverlaps(scene, warnings);
  return warnings;
}

}  // namespace epafi::drivers
