#include "bem/base/Error.hpp"
#include "contact/problem/Loads.hpp"
#include "contact/problem/Obstacle.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <ostream>
#include <sstream>

namespace epafi::drivers {

namespace {

/// Where contact.csv and solution.hdf look at an element.
std::vector<double> outputPlaces(const Scene& scene) {
  const int samples = scene.output.contactSamples;
  std::vector<double> places;
  for (int k = 0; k < samples; ++k)
    places.push_back(-1 + (2.0 * k + 1) / samples);
  const int lines = scene.output.fields ? 2 * (scene.degree + 1) : 0;
  for (int k = 0; k <= lines && lines > 0; ++k)
    places.push_back(-1 + 2.0 * k / lines);
  return places;
}

void evaluate(const bem::Mesh& mesh, const std::string& boundary,
              const std::vector<bem::Function>& functions,
              const std::vector<double>& places) {
  for (int e : mesh.elementsOf(boundary))
    for (double t : places)
      for (const bem::Function& function : functions)
        if (function)
          function(mesh.physicalPoint(e, t));
}

/// By what a run itself makes of the conditions, at its own points.
void evaluateAll(const Scene& scene, const bem::Mesh& mesh) {
  const bem::Space space(mesh);
  const contact::MultiplierSpace multiplier(
      space.mesh(), contact::multiplierBasis(scene.multiplier), scene.conditions);
  const bem::Units units = scene.outline->units(scene.material.youngsModulus);
  contact::makeLoads(space, scene.conditions, units);
  contact::makeObstacle(space.mesh(), multiplier,
                        contact::DistantObstacle(space.mesh(), units.length), units);
  const std::vector<double> places = outputPlaces(scene);
  for (const auto& [boundary, condition] : scene.conditions.contact) {
    evaluate(mesh, boundary, {condition.gap}, places);
    evaluate(mesh, boundary, condition.friction.fields, places);
  }
}

template <class Conditions>
std::string namesOf(const Conditions& conditions) {
  std::string names;
  for (const auto& [boundary, condition] : conditions)
    names += " " + boundary;
  return names.empty() ? " none" : names;
}

std::string fixedMotions(const contact::Conditions::Fix& fix) {
  const std::string names = std::string(fix.x ? " X" : "") + (fix.y ? " Y" : "") +
                            (fix.rotation ? " Rotation" : "");
  return names.empty() ? " none" : names;
}

}  // namespace

std::string checkScene(const Scene& scene) {
  const bem::Mesh mesh =
      bem::makeMesh(scene.outline, scene.elementsPerEdge, scene.degree);
  evaluateAll(scene, mesh);

  std::ostringstream text;
  text << scene.title << " (" << scene.file << ")\n"
       << "  body        " << scene.body << ": E = " << scene.material.youngsModulus
       << ", nu = " << scene.material.poissonsRatio
       << (scene.material.planeStress ? ", plane stress" : ", plane strain") << "\n"
       << "  outline     " << scene.outline->edges().size() << " edges, "
       << scene.outline->loops() - 1 << " holes, diameter " << scene.outline->diameter()
       << "\n"
       << "  first mesh  " << mesh.size() << " elements of degree " << scene.degree
       << "\n"
       << "  Dirichlet  " << namesOf(scene.conditions.dirichlet) << "\n"
       << "  Neumann    " << namesOf(scene.conditions.neumann) << "\n"
       << "  contact    " << namesOf(scene.conditions.contact) << "\n"
       << "  held       " << fixedMotions(scene.conditions.fix) << "\n"
       << "  strategy    " << scene.adaptivity.strategy.name << ", at most "
       << scene.adaptivity.limits.levels << " levels and "
       << scene.adaptivity.limits.degreesOfFreedom << " degrees of freedom\n"
       << "The scene is valid.\n";
  return text.str();
}

int checkCommand(const Given& given, std::ostream& out) {
  out << checkScene(readScene(given.argument, given.values("--set")));
  return 0;
}

}  // namespace epafi::drivers
