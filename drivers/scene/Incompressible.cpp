#include "drivers/scene/Incompressible.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <utility>

namespace epafi::drivers {

using bem::InputError;

namespace {

/// Is the traction on a boundary of a body known: no displacement, and no contact as opposite side?
bool isKnown(const Scene& scene, std::size_t b, const std::string& boundary) {
  const bool isOpposite = std::any_of(
      scene.contacts.begin(), scene.contacts.end(), [&](const ContactPair& pair) {
        return pair.opposite == SideOfBody{false, b, boundary};
      });
  return !isOpposite && scene.bodies[b].conditions.dirichlet.count(boundary) == 0;
}

/// The edges of each closed line of an outline; of a solid of revolution each closed surface by itself,
/// which end on the axis.
std::vector<std::vector<int>> closedLines(const bem::Outline& outline) {
  const std::vector<bem::Edge>& edges = outline.edges();
  std::vector<std::vector<int>> lines;
  std::vector<bool> seen(edges.size(), false);
  const auto follow = [&](std::size_t first) {
    std::vector<int> line;
    for (std::size_t i = first; !seen[i] && !outline.isAxis(static_cast<int>(i));
         i = static_cast<std::size_t>(edges[i].next)) {
      seen[i] = true;
      line.push_back(static_cast<int>(i));
    }
    if (!line.empty())
      lines.push_back(line);
  };
  for (std::size_t k = 0; k < edges.size(); ++k)
    if (outline.isAxis(static_cast<int>(k)))
      follow(static_cast<std::size_t>(edges[k].next));
  for (std::size_t k = 0; k < edges.size(); ++k)
    follow(k);
  return lines;
}

}  // namespace

void pinIncompressible(std::size_t b, Scene& scene) {
  Body& body = scene.bodies[b];
  if (body.material.poissonsRatio < 0.5 || body.material.planeStress)
    return;
  const std::string path = "Bodies->" + body.name + "->Material->Poisson's Ratio";
  if (!scene.stabilization.byDensity())
    throw InputError(path +
                     ": is 1/2, which Discretization->Stabilization->Form = Density "
                     "allows in plane strain; other forms want less");
  const contact::Conditions& conditions = body.conditions;
  const std::vector<bem::Edge>& edges = body.outline->edges();
  for (const std::vector<int>& line : closedLines(*body.outline)) {
    bool held = false;
    std::pair<bool, double> best{};  // without load, and long
    int pin = -1;
    for (const int i : line) {
      const bem::Edge& edge = edges[static_cast<std::size_t>(i)];
      held = held || conditions.contact.count(edge.boundary) != 0 ||
             std::any_of(conditions.facing.begin(), conditions.facing.end(),
                         [i](const auto& part) { return part.edge == i; });
      const std::pair<bool, double> own{conditions.neumann.count(edge.boundary) == 0,
                                        edge.curve.length() / (1 + 1e-9)};
      if (own > best && isKnown(scene, b, edge.boundary)) {
        best = {own.first, edge.curve.length()};
        pin = i;
      }
    }
    if (!held && pin < 0)
      throw InputError(
          path + ": is 1/2, which needs on every closed " +
          (scene.isAxisymmetric ? "surface of the body" : "line of the outline") +
          " a boundary that carries contact stresses or one without a given "
          "displacement; the one with '" +
          edges[static_cast<std::size_t>(line.front())].boundary + "' has none");
    if (!held)
      body.conditions.pins.push_back(pin);
  }
}

}  // namespace epafi::drivers
