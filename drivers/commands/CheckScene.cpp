#include "bem/base/Error.hpp"
#include "contact/body/Loads.hpp"
#include "contact/opposite/Obstacle.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/output/Table.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/run/LevelPlan.hpp"
#include "drivers/run/NextLevel.hpp"
#include "drivers/run/UnheldMotions.hpp"
#include "drivers/run/Warnings.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/SceneReader.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <ostream>
#include <sstream>

namespace epafi::drivers {

namespace {

/// Points t of an element at which contact.csv and solution.hdf evaluate functions.
std::vector<double> outputPlaces(const Scene& scene, int degree) {
  const int samples = scene.output.contactSamples;
  std::vector<double> places(bem::at(samples));
  for (int k = 0; k < samples; ++k)
    places[bem::at(k)] = -1 + (2.0 * k + 1) / samples;
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

/// Makes loads, obstacle and balance at a time as a run does, at the same points.
void evaluateAt(const Scene& scene, const BodySpaces& spaces,
                const std::vector<contact::Conditions>& conditions, double t) {
  const bem::Units units = scene.units();
  scene.drivesAt(t);
  for (std::size_t b = 0; b < spaces.size(); ++b)
    contact::makeLoads(spaces.space(b), conditions[b], units);
  contact::makeObstacle(spaces.multiplier().under(conditions), spaces.opposite(), units);
  try {
    checkUnheld(spaces, conditions, t);
  } catch (const bem::InputError& error) {  // a warning may explain it
    std::string words = error.what();
    for (const std::string& warning : warningsOf(scene))
      words += "\nwarning: " + warning;
    throw bem::InputError(words);
  }
}

/// Throws what a run would throw on the first mesh, at all times of a path (from 0 on).
void evaluateAll(const Scene& scene) {
  const BodySpaces spaces(scene, firstLevel(scene));
  aboveCap(0, spaces.levelRow(), scene);
  if (scene.history)
    evaluateAt(scene, spaces, spaces.conditionsAt(0), 0);
  std::vector<contact::Conditions> last;
  for (const double t : scene.history.times) {
    last = spaces.conditionsAt(t);
    evaluateAt(scene, spaces, last, t);
  }
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const bem::Mesh& mesh = spaces.space(b).mesh();
    const std::vector<double> places = outputPlaces(scene, scene.bodies[b].degree);
    for (const auto& [boundary, condition] : last[b].contact) {
      evaluate(mesh, boundary, {condition.gap}, places);
      evaluate(mesh, boundary, condition.friction.fields, places);
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

/// "left bottom ramp (normal)"
std::string heldOf(const contact::Conditions& conditions) {
  std::string names = conditions.dirichlet.empty() ? "" : namesOf(conditions.dirichlet);
  for (const auto& [boundary, condition] : conditions.contact)
    if (condition.isSupport)
      names += " " + boundary + " (normal)";
  return names.empty() ? " none" : names;
}

/// "base (friction), top (bonded)"
std::string contactsOf(const contact::Conditions& conditions) {
  std::string names;
  for (const auto& [boundary, condition] : conditions.contact)
    if (!condition.isSupport)
      names += (names.empty() ? " " : ", ") + boundary +
               (condition.ties()     ? " (bonded)"
                : condition.friction ? " (friction)"
                                     : " (no friction)");
  return names.empty() ? " none" : names;
}

/// "X moved, Y under a force, Rotation by a spring"
std::string motionsOf(const RigidBody& body) {
  std::string text;
  const char* names[] = {"X ", ", Y ", ", Rotation "};
  for (std::size_t k = 0; k < body.components.size(); ++k)
    text += names[k] + std::string(body.components[k].stiffness > 0 ? "by a spring"
                                   : body.components[k].free        ? "under a force"
                                   : body.components[k].value       ? "moved"
                                                                    : "held");
  return text;
}

std::string fixedMotions(const contact::Conditions::Fix& fix) {
  const std::string names = std::string(fix.x ? " X" : "") + (fix.y ? " Y" : "") +
                            (fix.rotation ? " Rotation" : "");
  return names.empty() ? " none" : names;
}

/// Condition, traction and gap at a point x of a boundary; if x is not `inside`, it may
/// be a corner, where loads and gaps need not exist.
std::vector<Value> conditionAt(const contact::Conditions& conditions,
                               const std::string& boundary, const bem::SurfacePoint& x,
                               bool inside) {
  const auto value = [&](const bem::Function& f) {
    return inside ? Value(f ? f(x) : 0.0) : Value("");
  };
  const auto contact = conditions.contact.find(boundary);
  const bool isSupport = contact != conditions.contact.end() && contact->second.isSupport;
  if (contact != conditions.contact.end() && !isSupport)
    return {"Contact", "", "",
            contact->second.name.empty() ? value(contact->second.gap) : Value("")};
  if (!conditions.isBoundary(boundary))
    return {boundary == Symmetry::boundary ? "symmetry" : "axis", "", "", ""};
  const auto load = conditions.neumann.find(boundary);
  const bool held = isSupport || conditions.dirichlet.count(boundary) != 0;
  if (load != conditions.neumann.end())
    return {held ? "Dirichlet" : "Neumann", value(load->second.x), value(load->second.y),
            ""};
  return {held ? "Dirichlet" : "free", "", "", ""};
}

/// The contacts that a boundary belongs to, on either side: "joint, seat".
std::string contactOf(const Scene& scene, const SideOfBody& side) {
  std::string names;
  for (const ContactPair& pair : scene.contacts)
    if (pair.side == side || pair.opposite == side)
      names += (names.empty() ? "" : ", ") + pair.name;
  return names;
}

/// What acts on a body as a whole, as it is written: "Gravity Y = -9810; Fix = {X}".
std::string wholesOf(const Scene& scene, const std::string& body) {
  const Teuchos::ParameterList& all = scene.given;
  const Teuchos::ParameterList& own = all.sublist("Bodies").sublist(body);
  std::ostringstream text;
  for (const char* name : {"Body Loads", "Motion", "Rigid Motions"}) {
    const bool isForAll = name == std::string("Body Loads") && !own.isSublist(name);
    const Teuchos::ParameterList& from = isForAll ? all : own;
    if (!from.isSublist(name))
      continue;
    for (const auto& item : from.sublist(name)) {
      if (item.first == "Reference Point")
        continue;
      text << (text.tellp() > 0 ? "; " : "") << item.first << " = ";
      item.second.leftshift(text, false);
    }
  }
  return text.str();
}

/// The csv for drawScene: points along the first meshes with conditions, loads and gaps.
std::string sceneCsv(const Scene& scene) {
  std::string csv;
  const BodySpaces spaces(scene, firstLevel(scene));
  const auto row = [&](bem::Vec2 x, bem::Vec2 n, const std::string& body,
                       const std::string& boundary, int element,
                       const std::vector<Value>& there, const std::string& contact) {
    addRow({{"x", x.x},
            {"y", x.y},
            {"nx", n.x},
            {"ny", n.y},
            {"body", body},
            {"boundary", boundary},
            {"element", element},
            {"condition", there[0]},
            {"tx", there[1]},
            {"ty", there[2]},
            {"gap", there[3]},
            {"contact_name", contact}},
           csv);
  };
  constexpr int lines = 4;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const bem::Mesh& mesh = spaces.space(b).mesh();
    for (int e = 0; e < mesh.size(); ++e)
      for (int k = 0; k <= lines; ++k) {
        const std::string& boundary = mesh.boundary(e);
        const double t = -1 + 2.0 * k / lines;
        const bem::SurfacePoint x = mesh.physicalPoint(e, t);
        row(x, mesh[e].curve.normal(t), scene.bodies[b].name, boundary, e,
            conditionAt(scene.bodies[b].conditions, boundary, x, k > 0 && k < lines),
            contactOf(scene, {false, b, boundary}));
      }
  }
  for (std::size_t b = 0; b < scene.rigid.size(); ++b)
    for (std::size_t e = 0; e < scene.rigid[b].outline->edges().size(); ++e)
      for (int k = 0; k <= 4 * lines; ++k) {
        const RigidBody& body = scene.rigid[b];
        const bem::Edge& edge = body.outline->edges()[e];
        const double t = -1 + 2.0 * k / (4 * lines);
        row(body.outline->physical(edge.curve.point(t)), edge.curve.normal(t), body.name,
            edge.boundary, static_cast<int>(e), {"rigid", "", "", ""},
            contactOf(scene, {true, b, edge.boundary}));
      }
  for (const SideOfBody& body : scene.everyBody())
    if (const std::string text = wholesOf(scene, scene.nameOf(body)); !text.empty())
      row({}, {}, scene.nameOf(body), "", -1, {"note", "", "", ""}, text);
  return csv;
}

}  // namespace

std::string checkScene(const Scene& scene) {
  naming(scene.file, [&] { evaluateAll(scene); });
  std::ostringstream text;
  text << scene.title << " (" << scene.file << ")\n";
  for (const Body& body : scene.bodies) {
    const bem::Mesh mesh = firstMesh(body);
    const bool raised =
        std::any_of(mesh.elements().begin(), mesh.elements().end(),
                    [&](const bem::Element& e) { return e.degree > body.degree; });
    text << "  body        " << body.name << ": E = " << body.material.youngsModulus
         << ", nu = " << body.material.poissonsRatio
         << (scene.isAxisymmetric        ? ", axisymmetric"
             : body.material.planeStress ? ", plane stress"
                                         : ", plane strain")
         << "\n"
         << "  outline     " << counted(body.outline->edges().size(), "edge", "edges")
         << ", " << counted(body.outline->loops() - 1, "hole", "holes") << ", diameter "
         << body.outline->diameter() << "\n"
         << "  first mesh  " << mesh.size() << " elements of degree " << body.degree
         << (raised ? ", 2 on wide arcs\n" : "\n") << "  Dirichlet  "
         << heldOf(body.conditions) << "\n"
         << "  Neumann    " << namesOf(body.conditions.neumann) << "\n"
         << "  contact    " << contactsOf(body.conditions) << "\n"
         << "  held       " << fixedMotions(body.conditions.fix) << "\n";
    if (body.conditions.heat)
      text << "  warm       " << namesOf(body.conditions.heat->temperatures) << "\n"
           << "  heat flux  " << namesOf(body.conditions.heat->flows) << "\n";
  }
  if (scene.symmetry)
    text << "  symmetry    about " << scene.symmetry.line() << ", one half is drawn\n";
  for (const RigidBody& body : scene.rigid)
    text << "  rigid       " << body.name << ": " << motionsOf(body) << "\n";
  for (const ContactPair& pair : scene.contacts)
    text << "  between     " << pair.name << ": " << scene.labelOf(pair.side) << " on "
         << scene.labelOf(pair.opposite) << "\n";
  if (scene.history)
    text << "  path        " << counted(scene.history.times.size(), "step", "steps")
         << " up to t = " << scene.endOfPath() << "\n";
  text << "  strategy    " << scene.adaptivity.strategy.name << ", at most "
       << counted(static_cast<std::size_t>(scene.adaptivity.limits.levels), "level",
                  "levels")
       << " and " << capOf(scene) << " degrees of freedom";
  if (const auto& tolerance = scene.adaptivity.limits.tolerance)
    text << ", to " << 100 * *tolerance << " %";
  text << "\n"
       << "The scene is valid.\n";
  for (const std::string& warning : warningsOf(scene))
    text << "warning: " << warning << "\n";
  return text.str();
}

int checkCommand(const Given& given, std::ostream& out) {
  const std::string format = given.value("--format", "xml");
  const auto print = [&](const Teuchos::ParameterList& list, const std::string& title) {
    out << (format == "json" ? toJson : format == "yaml" ? toYaml : toXml)(list, title);
    return 0;
  };
  const bool complete = given.has("--used") || given.has("--numbers");
  if (given.has("--format") && !complete) {
    const std::string& file = given.argument;
    const RawScene raw = naming(file, [&] { return rawScene(readText(file), file); });
    return print(raw.list, raw.title);
  }
  const Scene scene = readScene(given.argument, given.values("--set"));
  if (complete)
    return print(given.has("--used") ? usedList(scene) : numbersOf(scene), scene.title);
  out << checkScene(scene);
  return given.has("--plot")
             ? drawScene(sceneCsv(scene), scene.title, given.value("--plot"))
             : 0;
}

}  // namespace epafi::drivers
