#include "bem/base/Error.hpp"
#include "bem/mesh/Mesh.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <ostream>
#include <sstream>

namespace epafi::drivers {

namespace {

/// Where loads are integrated on an element; a rule of higher order than any that is
/// used.
std::vector<double> quadraturePoints(int degree) {
  return bem::gaussLegendre(2 * degree + 8).points;
}

/// Where gaps, bounds and prescribed displacements are sampled: also at the multiplier's
/// own places and at the ends of the element.
std::vector<double> samplingPoints(const Scene& scene) {
  std::vector<double> points = quadraturePoints(scene.degree);
  const auto places = contact::multiplierBasis(scene.multiplier).places(scene.degree);
  points.insert(points.end(), places.begin(), places.end());
  points.push_back(-1);
  points.push_back(1);
  return points;
}

void evaluate(const bem::Mesh& mesh, const std::string& boundary,
              const std::vector<bem::Function>& functions,
              const std::vector<double>& points) {
  for (int e : mesh.elementsOf(boundary))
    for (double t : points)
      for (const bem::Function& function : functions)
        if (function)
          function(mesh.physicalPoint(e, t));
}

void evaluateAll(const Scene& scene, const bem::Mesh& mesh) {
  const std::vector<double> inner = quadraturePoints(scene.degree);
  const std::vector<double> closed = samplingPoints(scene);
  for (const auto& [boundary, condition] : scene.conditions.dirichlet)
    evaluate(mesh, boundary, {condition.x, condition.y}, closed);
  for (const auto& [boundary, condition] : scene.conditions.neumann)
    evaluate(mesh, boundary, {condition.x, condition.y}, inner);
  for (const auto& [boundary, condition] : scene.conditions.contact) {
    evaluate(mesh, boundary, {condition.gap}, closed);
    evaluate(mesh, boundary, condition.friction.fields, closed);
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
       << "  strategy    " << scene.adaptivity.strategy << ", at most "
       << scene.adaptivity.maximumLevels << " levels and "
       << scene.adaptivity.maximumDegreesOfFreedom << " degrees of freedom\n"
       << "The scene is valid.\n";
  return text.str();
}

int checkCommand(const std::vector<std::string>& arguments, std::ostream& out) {
  std::string file;
  std::vector<std::string> overrides;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "--set" && i + 1 < arguments.size())
      overrides.push_back(arguments[++i]);
    else if (argument.rfind("--set=", 0) == 0)
      overrides.push_back(argument.substr(6));
    else if (argument.rfind("--", 0) == 0 || !file.empty())
      throw bem::InputError(bem::message("check: argument '", argument,
                                         "' is not understood; usage: epafi check "
                                         "SCENE.xml [--set 'A->B->Key=value']..."));
    else
      file = argument;
  }
  if (file.empty())
    throw bem::InputError(
        "check: no scene is given; usage: epafi check SCENE.xml [--set "
        "'A->B->Key=value']...");
  out << checkScene(readScene(file, overrides));
  return 0;
}

}  // namespace epafi::drivers
