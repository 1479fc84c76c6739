#include "bem/base/Error.hpp"
#include "contact/problem/Loads.hpp"
#include "contact/problem/Obstacle.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/run/NextLevel.hpp"
#include "drivers/run/Warnings.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <ostream>
#include <sstream>

namespace epafi::drivers {

namespace {

/// Where contact.csv and solution.hdf look at an element.
std::vector<double> outputPlaces(const Scene& scene, int degree) {
  const int samples = scene.output.contactSamples;
  std::vector<double> places;
  for (int k = 0; k < samples; ++k)
    places.push_back(-1 + (2.0 * k + 1) / samples);
  const int lines = scene.output.fields ? 2 * (degree + 1) : 0;
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
void evaluateAll(const Scene& scene) {
  const std::vector<bem::Mesh> meshes = firstLevel(scene).meshes;
  const BodySpaces spaces(scene, meshes);
  const bem::Units units = scene.units();
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    const contact::Conditions& conditions = scene.bodies[b].conditions;
    contact::makeLoads(spaces.space(b), conditions, units);
    contact::makeObstacle(spaces.space(b).mesh(), spaces.multiplier(b),
                          *spaces.opposite(b), units);
    const std::vector<double> places = outputPlaces(scene, scene.bodies[b].degree);
    for (const auto& [boundary, condition] : conditions.contact) {
      evaluate(meshes[b], boundary, {condition.gap}, places);
      evaluate(meshes[b], boundary, condition.friction.fields, places);
    }
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
  evaluateAll(scene);
  std::ostringstream text;
  text << scene.title << " (" << scene.file << ")\n";
  for (const Body& body : scene.bodies) {
    const bem::Mesh mesh = firstMesh(body);
    text << "  body        " << body.name << ": E = " << body.material.youngsModulus
         << ", nu = " << body.material.poissonsRatio
         << (body.material.planeStress ? ", plane stress" : ", plane strain") << "\n"
         << "  outline     " << body.outline->edges().size() << " edges, "
         << body.outline->loops() - 1 << " holes, diameter " << body.outline->diameter()
         << "\n"
         << "  first mesh  " << mesh.size() << " elements of degree " << body.degree
         << "\n"
         << "  Dirichlet  " << namesOf(body.conditions.dirichlet) << "\n"
         << "  Neumann    " << namesOf(body.conditions.neumann) << "\n"
         << "  contact    " << namesOf(body.conditions.contact) << "\n"
         << "  held       " << fixedMotions(body.conditions.fix) << "\n";
  }
  text << "  strategy    " << scene.adaptivity.strategy.name << ", at most "
       << scene.adaptivity.limits.levels << " levels and "
       << scene.adaptivity.limits.degreesOfFreedom << " degrees of freedom\n"
       << "The scene is valid.\n";
  for (const std::string& warning : warningsOf(scene))
    text << "warning: " << warning << "\n";
  return text.str();
}

int checkCommand(const Given& given, std::ostream& out) {
  out << checkScene(readScene(given.argument, given.values("--set")));
  return 0;
}

}  // namespace epafi::drivers
