#include "drivers/run/Warnings.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "contact/results/ContactFields.hpp"
#include "drivers/run/Path.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
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

/// How far the sides of each contact slide where it is closed, over its length in contact.
void findSliding(const contact::Solved& solved, std::map<std::string, double>& shares) {
  const contact::ContactFields fields(solved);
  std::map<std::string, double> slides;
  for (const auto& element : fields.elements()) {
    const contact::ContactPoint point = fields.at(element, 0);
    if (point.closed)
      slides[nameOf(element)] =
          std::max(slides[nameOf(element)], std::abs(point.tangential));
  }
  const auto lengths = contact::contactLengths(solved);
  for (const auto& [name, slide] : slides) {
    const double length = lengths.at(name);
    shares[name] = std::max(shares[name], length > 0 ? slide / length : 0);
  }
}

/// The largest of each contact over the level or over the steps of its path.
std::map<std::string, double> slidingOf(const SolvedLevel& level) {
  std::map<std::string, double> shares;
  for (const contact::Solved& solved : level.bodies)
    findSliding(solved, shares);
  if (level.path != nullptr)
    for (const auto& step : level.path->steps)
      for (const contact::Solved& solved : step->solved->bodies())
        findSliding(solved, shares);
  return shares;
}

/// The largest displacement on a body's boundary, in its diameters.
double largestMotion(const contact::Solved& solved, const bem::Outline& outline) {
  double largest = 0;
  for (int e = 0; e < solved.space.mesh().size(); ++e)
    for (const double t : {-1.0, 0.0, 1.0})
      largest =
          std::max(largest, norm(solved.space.displacementAt(solved.displacement, e, t)));
  return largest * solved.units.length / outline.diameter();
}

struct Extent {
  double energy = 0;
  double contact = 0;
};

/// The largest over the level or over the steps of its path.
Extent extentOf(const SolvedLevel& level) {
  const contact::Summary& summary = level.row.summary;
  Extent extent{summary.energyStrain, summary.contactLength};
  if (level.path != nullptr)
    for (const auto& step : level.path->steps) {
      extent.energy = std::max(extent.energy, step->row.energyStrain);
      for (const ContactRow& row : step->row.contacts)
        extent.contact = std::max(extent.contact, row.summary.contactLength);
    }
  return extent;
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
  for (const Body& body : scene.bodies)
    findJumps(body, warnings);
  findUnused(scene, warnings);
  return warnings;
}

std::vector<std::string> warningsOf(const Scene& scene, const SolvedLevel& level) {
  std::vector<std::string> warnings;
  const Extent extent = extentOf(level);
  if (extent.energy == 0) {
    warnings.emplace_back(
        "nothing loads the scene: no traction, force, prescribed displacement or "
        "overlap; all of it stays as it is");
    return warnings;
  }
  if (scene.hasContact() && extent.contact == 0)
    warnings.emplace_back(
        "contact never closes: nothing presses a body onto what it could meet; look at "
        "the signs of loads (tractions pull along x and y) and at the gap");
  constexpr double small = 0.1;
  for (const auto& [name, share] : slidingOf(level))
    if (share > small)
      warnings.push_back(message(
          "contact '", name, "': sliding reaches ", std::round(100 * share),
          " % of the length in contact; what meets what is looked for once, on the "
          "outlines as drawn (small sliding): stresses may belong elsewhere by as much"));
  for (std::size_t b = 0; b < level.bodies.size(); ++b) {
    const double motion = largestMotion(level.bodies[b], *scene.bodies[b].outline);
    if (motion > small)
      warnings.push_back(
          message("Bodies->", scene.bodies[b].name, ": displacements reach ",
                  std::round(100 * motion),
                  " % of the body's size; the equations are those of small displacements "
                  "and small sliding, on the outline as drawn: look at units and loads"));
  }
  return warnings;
}

}  // namespace epafi::drivers
