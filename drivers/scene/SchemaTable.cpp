#include "adaptivity/estimate/ResidualEstimator.hpp"
#include "adaptivity/mark/Strategy.hpp"
#include "contact/coulomb/CoulombIteration.hpp"
#include "contact/law/FrictionLaw.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "contact/nox/NoxNewton.hpp"
#include "contact/solve/LoadContinuation.hpp"
#include "contact/stabilization/Stabilization.hpp"
#include "drivers/scene/History.hpp"
#include "drivers/scene/Interpolant.hpp"
#include "drivers/scene/LinearMethod.hpp"
#include "drivers/scene/MeshReader.hpp"
#include "drivers/scene/OutputOptions.hpp"
#include "drivers/scene/RunLimits.hpp"
#include "drivers/scene/Schema.hpp"

namespace epafi::drivers {

namespace {

using bem::above;
using bem::from;
using bem::Row;
using Table = std::vector<Parameter>;

void addBody(Table& table) {
  const std::string body = "Bodies-><body>";
  const std::string material = body + "->Material";
  const std::string geometry = body + "->Geometry";
  append(table,
         {
             Row("Bodies", Kind::List, "one body or several").required(),
             Row(body, Kind::List, "a body, under a name of your choice"),
             Row(material, Kind::List, "linear elastic, isotropic, homogeneous; or rigid")
                 .required(),
             Row(material + "->Rigid", Kind::Flag,
                 "an outline without elasticity, of which nothing else is said but "
                 "Geometry and Motion")
                 .standard("false"),
             Row(material + "->Young's Modulus", Kind::Real,
                 "Young's modulus E; every body has one unless it is Rigid")
                 .unit("stress")
                 .range(above(0)),
             Row(material + "->Poisson's Ratio", Kind::Real,
                 "Poisson's ratio nu, likewise; 1/2 in plane strain wants Form Density")
                 .unit("1")
                 .range({-1, 0.5, true, false}),
             Row(material + "->Plane State", Kind::Text,
                 "no strain or no stress across the plane")
                 .standard("Plane Strain")
                 .allowed({"Plane Strain", "Plane Stress"}),
             Row(geometry, Kind::List,
                 "the outline: a polygon of segments and arcs, with holes")
                 .required(),
             Row(geometry + "->Vertices", Kind::Points,
                 "corners of the outer polygon, counter-clockwise; it closes by itself")
                 .unit("length"),
             Row(geometry + "->Edges", Kind::Names,
                 "the boundary's name for each edge; edge i leads from vertex i to i+1"),
             Row(geometry + "->Bulges", Kind::Reals,
                 "tan(angle/4) of the circular arc from vertex i to i+1, one for each "
                 "edge: 0 straight, 1 half a circle, > 0 curved outwards (to the right "
                 "of the chord); two vertices are enough with arcs")
                 .unit("1")
                 .range({-10, 10, false, false}),
             Row(geometry + "->Hole <k> Vertices", Kind::Points,
                 "corners of hole k = 1, 2, ..., counter-clockwise too")
                 .unit("length"),
             Row(geometry + "->Hole <k> Edges", Kind::Names,
                 "the boundary's name for each edge of hole k"),
             Row(geometry + "->Hole <k> Bulges", Kind::Reals,
                 "the same for hole k: > 0 away from its middle")
                 .unit("1")
                 .range({-10, 10, false, false}),
             Row(geometry + "->File", Kind::Text,
                 "instead of vertices and edges: a Gmsh mesh (.msh, ASCII 2.2 or 4.1), "
                 "relative to the scene; its physical curves name the boundaries"),
         });
}

void addConditions(Table& table) {
  const std::string conditions = "Bodies-><body>->Boundary Conditions";
  const std::string boundary = conditions + "-><boundary>";
  append(
      table,
      {
          Row(conditions, Kind::List,
              "one sublist per boundary; an edge without one is free"),
          Row(boundary, Kind::List, "what happens on the edges of this name"),
          Row(boundary + "->Type", Kind::Text, "kind of condition")
              .allowed({"Dirichlet", "Neumann", "Contact"})
              .required(),
          Row(boundary + "->Displacement X", Kind::Expression,
              "prescribed displacement; without it the component is free (a roller)")
              .unit("length")
              .only("Dirichlet"),
          Row(boundary + "->Displacement Y", Kind::Expression,
              "prescribed displacement; without it the component is free (a roller)")
              .unit("length")
              .only("Dirichlet"),
          Row(boundary + "->Traction X", Kind::Expression,
              "traction on the body; without it zero")
              .unit("stress")
              .only("Neumann"),
          Row(boundary + "->Traction Y", Kind::Expression,
              "traction on the body; without it zero")
              .unit("stress")
              .only("Neumann"),
          Row(boundary + "->Force X", Kind::Expression,
              "instead of Traction X: the uniform traction that makes this force on the "
              "whole boundary, per unit of thickness; in t and constants")
              .unit("stress length")
              .only("Neumann"),
          Row(boundary + "->Force Y", Kind::Expression, "instead of Traction Y, likewise")
              .unit("stress length")
              .only("Neumann"),
          Row(boundary + "->Gap", Kind::Expression,
              "distance to the rigid obstacle along the outward normal")
              .unit("length")
              .standard("0")
              .only("Contact"),
          Row(boundary + "->Friction", Kind::List, "how much shear the contact carries")
              .only("Contact"),
      });
  append(table, contact::frictionRows(), boundary + "->Friction");
  append(table, {
                    Row("Bodies-><body>->Rigid Motions", Kind::List,
                        "how a body without a clamp is held"),
                    Row("Bodies-><body>->Rigid Motions->Fix", Kind::Names,
                        "motions whose mean over the boundary is zero; their reaction "
                        "acts as a uniform traction of that mode")
                        .allowed({"X", "Y", "Rotation"}),
                });
}

void addSeveralBodies(Table& table) {
  const std::string mesh = "Bodies-><body>->Mesh";
  const std::string motion = "Bodies-><body>->Motion";
  const std::string contact = "Contacts-><contact>";
  append(table,
         {Row(mesh, Kind::List, "the body's own first mesh, before Discretization")});
  append(table, meshRows(), mesh);
  append(
      table,
      {
          Row(motion, Kind::List, "of a rigid body; without it the body is held"),
          Row(motion + "->Displacement X", Kind::Expression,
              "prescribed, without x and y; without it and Force X none")
              .unit("length"),
          Row(motion + "->Displacement Y", Kind::Expression, "likewise").unit("length"),
          Row(motion + "->Rotation", Kind::Expression,
              "prescribed, counter-clockwise about the reference point; small: places "
              "move by its tangent")
              .unit("radian"),
          Row(motion + "->Force X", Kind::Expression,
              "instead of Displacement X: the motion is free, under this force")
              .unit("stress length"),
          Row(motion + "->Force Y", Kind::Expression, "likewise").unit("stress length"),
          Row(motion + "->Moment", Kind::Expression,
              "instead of Rotation: about the reference point, likewise")
              .unit("stress length^2"),
          Row(motion + "->Reference Point", Kind::Reals,
              "where forces act and what rotations turn about; without it the outline's "
              "centroid")
              .unit("length"),
          Row("Contacts", Kind::List, "contact between bodies"),
          Row(contact, Kind::List, "a contact, under a name of your choice"),
          Row(contact + "->Between", Kind::Names,
              "two sides, body:boundary; the first one carries the contact stresses, or "
              "the elastic one if the other is rigid")
              .required(),
          Row(contact + "->Interference", Kind::Expression,
              "overlap along the first side's outward normal, in addition to that of the "
              "outlines as drawn; alone where Law is Tied")
              .unit("length")
              .standard("0"),
          Row(contact + "->Friction", Kind::List, "how much shear the contact carries"),
      });
  append(table, contact::frictionRows(), contact + "->Friction");
}

void addHistory(Table& table) {
  append(table, {Row("History", Kind::List,
                     "the path of the loads, solved step by step; friction remembers.  "
                     "Without it one load, t = 1")});
  append(table, historyRows(), "History");
}

void addDiscretization(Table& table) {
  const std::string stabilization = "Discretization->Stabilization";
  append(table, {Row("Discretization", Kind::List, "the first mesh and the spaces on it")
                     .required()});
  append(table, meshRows("1"), "Discretization");
  append(table, {contact::multiplierRow()}, "Discretization");
  append(table, {Row(stabilization, Kind::List, "stabilisation of the mixed method")});
  append(table, contact::stabilizationRows(), stabilization);
}

void addSolver(Table& table) {
  append(table, {Row("Solver", Kind::List, "how the nonlinear problem is solved")});
  append(table, contact::coulombRows(), "Solver");
  append(table, contact::trescaRows(), "Solver");
  append(table, contact::loadRows(), "Solver");
  append(table, {contact::noxRow()}, "Solver");
  append(table, {Row("Solver->Linear", Kind::List, "how linear systems are solved")});
  append(table, linearRows(), "Solver->Linear");
}

void addAdaptivity(Table& table) {
  append(table, {Row("Adaptivity", Kind::List, "from one level to the next")});
  append(table, adaptivity::strategyRows(), "Adaptivity");
  append(table, adaptivity::estimatorRows(), "Adaptivity");
  append(table, limitRows(), "Adaptivity");
}

void addOutput(Table& table) {
  append(table, {Row("Output", Kind::List, "what is written")});
  append(table, outputRows(), "Output");
  append(table, {Row("Versions", Kind::Free,
                     "written into used.xml, ignored when it is read again")});
}

}  // namespace

const std::vector<Parameter>& parameters() {
  static const Table table = [] {
    Table all;
    append(
        all,
        {Row("Constants", Kind::List, "numbers that all expressions know by name"),
         Row("Constants-><constant>", Kind::Expression,
             "a number, or an expression in constants that stand before it, and tables"),
         Row("Tables", Kind::List,
             "functions of one variable through points, such as measured profiles; "
             "expressions know them by name: Gap = profile(x) + 0.1"),
         Row("Tables-><table>", Kind::List, "one function")});
    append(all, tableRows(), "Tables-><table>");
    addBody(all);
    addConditions(all);
    addSeveralBodies(all);
    addHistory(all);
    addDiscretization(all);
    addSolver(all);
    addAdaptivity(all);
    addOutput(all);
    return all;
  }();
  return table;
}

const Parameter& declared(const std::string& path) {
  return bem::declared(parameters(), path);
}

Teuchos::ParameterList complete(const Teuchos::ParameterList& given,
                                const std::string& title) {
  return bem::complete(parameters(), given, title);
}

}  // namespace epafi::drivers
