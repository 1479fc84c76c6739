#include "drivers/scene/Incompressible.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>

namespace epafi::drivers {

namespace {

/// Is there neither a condition on a boundary of a body, nor a load, nor another body?
bool isFree(const Scene& scene, std::size_t b, const std::string& boundary) {
  const contact::Conditions& conditions = scene.bodies[b].conditions;
  const auto neumann = conditions.neumann.find(boundary);
  const bool met = std::any_of(
      scene.contacts.begin(), scene.contacts.end(), [&](const ContactPair& pair) {
        return !pair.met.rigid && pair.met.body == b && pair.met.boundary == boundary;
      });
  return !met && conditions.dirichlet.count(boundary) == 0 &&
         (neumann == conditions.neumann.end() ||
          (!neumann->second.x && !neumann->second.y));
}

void pinBody(std::size_t b, Scene& scene) {
  Body& body = scene.bodies[b];
  if (body.material.poissonsRatio < 0.5 || body.material.planeStress)
    return;
  const std::string path = "Bodies->" + body.name + "->Material->Poisson's Ratio";
  if (scene.stabilization.form != contact::Stabilization::Form::Density)
    throw bem::InputError(path +
                          ": is 1/2, which Discretization->Stabilization->Form = Density "
                          "allows in plane strain; other forms want less");
  const contact::Conditions& conditions = body.conditions;
  const bool fixes = conditions.fix.x || conditions.fix.y || conditions.fix.rotation;
  const std::vector<bem::Edge>& edges = body.outline->edges();
  std::vector<bool> seen(edges.size(), false);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    bool held = seen[k];
    double longest = 0;
    int pin = -1;
    for (std::size_t i = k; !seen[i]; i = static_cast<std::size_t>(edges[i].next)) {
      seen[i] = true;
      held = held || conditions.contact.count(edges[i].boundary) != 0;
      if (edges[i].curve.length() > longest && isFree(scene, b, edges[i].boundary)) {
        longest = edges[i].curve.length();
        pin = static_cast<int>(i);
      }
    }
    if (!held && (pin < 0 || fixes))
      throw bem::InputError(path +
                            ": is 1/2, which needs on every closed line of the outline a "
                            "boundary that carries contact stresses or, without Rigid "
                            "Motions->Fix, one without any condition; the line with '" +
                            edges[k].boundary + "' has none");
    if (!held)
      body.conditions.pins.push_back(pin);
  }
}

}  // namespace

void pinIncompressible(Scene& scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    pinBody(b, scene);
}

}  // namespace epafi::drivers
