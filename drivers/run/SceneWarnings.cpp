#include "drivers/run/SceneWarnings.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "bem/quadrature/Piecewise.hpp"
#include "drivers/run/BodySpaces.hpp"

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

/// Corners where two sides prescribe displacements that differ.
void findJumps(const Body& body, std::vector<std::string>& warnings) {
  const auto& held = body.conditions.dirichlet;
  for (const bem::Edge& edge : body.outline->edges()) {
    const std::string& next = body.outline->edge(edge.next).boundary;
    const auto before = held.find(edge.boundary);
    const auto behind = held.find(next);
    if (before == held.end() || behind == held.end() || before == behind)
      continue;
    const bem::Vec2 corner = body.outline->physical(edge.curve.to());
    const auto differ = [&](const bem::Function& one, const bem::Function& other) {
      constexpr double same = 1e-9;
      if (!one || !other)
        return false;
      const double a = one(corner);
      const double b = other(corner);
      return std::abs(a - b) > same * std::max(std::abs(a), std::abs(b));
    };
    if (differ(before->second.x, behind->second.x) ||
        differ(before->second.y, behind->second.y))
      warnings.push_back(message(
          "Bodies->", body.name, "->Boundary Conditions: '", edge.boundary, "' and '",
          next, "' prescribe different displacements of their corner (", corner.x, ", ",
          corner.y,
          "); a jump has no finite energy: stresses there grow with every level"));
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

/// Corners where a prescribed displacement goes through the obstacle of the side beside it, one
/// warning for each pair of boundaries.
void findPressedCorners(const Body& body, std::vector<std::string>& warnings) {
  constexpr double same = 1e-6;
  constexpr double beside = 1 - 1e-9;  // of a side's end, where its gap is looked at
  std::set<std::pair<std::string, std::string>> seen;
  const auto compare = [&](const bem::Edge& given, const bem::Edge& side, double t) {
    const auto held = body.conditions.dirichlet.find(given.boundary);
    const auto met = body.conditions.contact.find(side.boundary);
    if (held == body.conditions.dirichlet.end() || met == body.conditions.contact.end() ||
        !met->second.name.empty() || met->second.friction.ties())
      return;
    // a component that is free can give way
    const auto& [x, y] = held->second;
    const bem::Vec2 n = side.curve.normal(t);
    if ((!x && std::abs(n.x) > same) || (!y && std::abs(n.y) > same))
      return;
    const bem::Vec2 corner =
        body.outline->physical(t > 0 ? side.curve.to() : side.curve.from());
    const double closing = (x ? x(corner) * n.x : 0) + (y ? y(corner) * n.y : 0);
    const auto gap =
        valueAt(met->second.gap, body.outline->physical(side.curve.point(t)));
    if (gap && closing > *gap + same * std::max(std::abs(closing), std::abs(*gap)) &&
        seen.emplace(given.boundary, side.boundary).second)
      warnings.push_back(message(
          "Bodies->", body.name, "->Boundary Conditions: '", given.boundary,
          "' moves its corner with '", side.boundary, "', (", corner.x, ", ", corner.y,
          "), by ", closing, " along the normal where the gap is ", *gap,
          ": through the obstacle; such a jump has no finite energy, and stresses there "
          "grow with every level"));
  };
  for (const bem::Edge& edge : body.outline->edges()) {
    const bem::Edge& next = body.outline->edge(edge.next);
    compare(edge, next, -beside);
    compare(next, edge, beside);
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

/// Tractions that change between the points at which the first mesh takes them, one warning a
/// boundary.
void findNarrowLoads(const Body& body, std::vector<std::string>& warnings) {
  constexpr double far = 0.1;
  constexpr std::size_t points = 4096;  // of an edge, about
  constexpr std::size_t order = 16;
  if (body.conditions.neumann.empty())
    return;
  const bem::Mesh mesh = firstMesh(body);
  std::map<int, std::vector<int>> edges;
  for (int e = 0; e < mesh.size(); ++e)
    edges[mesh[e].piece.edge].push_back(e);
  std::set<std::string> seen;
  for (const auto& [edge, elements] : edges) {
    const auto load = body.conditions.neumann.find(mesh.boundary(elements.front()));
    if (load == body.conditions.neumann.end() || seen.count(load->first) > 0)
      continue;
    const auto pieces = static_cast<int>(points / order / elements.size()) + 2;
    bem::Vector breaks;
    for (int k = 1; k < pieces; ++k)
      breaks.push_back(-1 + 2.0 * k / pieces);
    Force used;
    Force fine;
    try {
      used = forceOf(load->second, mesh, elements, bem::gaussForGiven(body.degree));
      fine = forceOf(load->second, mesh, elements, bem::piecewiseRule(breaks, order));
    } catch (const bem::InputError&) {
      continue;
    }
    if (norm(used.sum - fine.sum) <= far * std::max(used.size, fine.size))
      continue;
    seen.insert(load->first);
    warnings.push_back(message(
        "Bodies->", body.name, "->Boundary Conditions->", load->first,
        ": the traction is narrower than its elements can see: on one edge they take a "
        "force of (",
        used.sum.x, ", ", used.sum.y, "), a finer rule finds (", fine.sum.x, ", ",
        fine.sum.y,
        "); use more elements there (Discretization), or a vertex where the load begins "
        "and one where it ends"));
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

}  // namespace

std::vector<std::string> warningsOf(const Scene& scene) {
  std::vector<std::string> warnings;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    for (const auto& [boundary, condition] : scene.bodies[b].conditions.contact)
      findPolygon(*scene.bodies[b].outline, boundary,
                  "Bodies->" + scene.bodies[b].name + "->Geometry, '" + boundary + "'",
                  warnings);
  std::set<std::string> seen;
  for (const ContactPair& pair : scene.contacts)
    if (seen.insert(scene.nameOf(pair.met) + ":" + pair.met.boundary).second)
      findPolygon(
          scene.outlineOf(pair.met), pair.met.boundary,
          "Bodies->" + scene.nameOf(pair.met) + "->Geometry, '" + pair.met.boundary + "'",
          warnings);
  for (const Body& body : scene.bodies) {
    findJumps(body, warnings);
    findPressedCorners(body, warnings);
    findNarrowLoads(body, warnings);
  }
  findUnused(scene, warnings);
  return warnings;
}

}  // namespace epafi::drivers
