#include "adaptivity/estimate/ResidualEstimator.hpp"
#include "adaptivity/mark/Strategy.hpp"
#include "contact/law/FrictionLaw.hpp"
#include "contact/law/NormalLaw.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "contact/nox/NoxNewton.hpp"
#include "contact/solve/CoulombIteration.hpp"
#include "contact/stabilization/Stabilization.hpp"
#include "drivers/scene/BodyLoadsReader.hpp"
#include "drivers/scene/History.hpp"
#include "drivers/scene/Interpolant.hpp"
#include "drivers/scene/LinearMethod.hpp"
#include "drivers/scene/MeshReader.hpp"
#include "drivers/scene/RunOptions.hpp"
#include "drivers/scene/Schema.hpp"

namespace epafi::drivers {

namespace {

using bem::above;
using bem::from;
using bem::Row;
using Table = std::vector<Parameter>;

/// A list and its keys.
void add(Table& table, const Parameter& list, const Table& keys) {
  append(table, {list});
  append(table, keys, list.path);
}

void addBody(Table& table) {
  const std::string body = "Bodies-><body>";
  const std::string material = body + "->Material";
  const std::string geometry = body + "->Geometry";
  append(table, {
                    Row("Bodies", Kind::List, "one body or several").required(),
                    Row(body, Kind::List, "a body, under a name of your choice"),
                });
  add(table,
      Row(material, Kind::List, "linear elastic, isotropic, homogeneous; or rigid")
          .required(),
      {
          Row("Rigid", Kind::Flag,
              "an outline without elasticity, of which nothing else is said but Geometry "
              "and Motion")
              .standard("false"),
          Row("Young's Modulus", Kind::Real,
              "Young's modulus E; every body has one unless it is Rigid")
              .unit("stress")
              .range(above(0)),
          Row("Poisson's Ratio", Kind::Real,
              "Poisson's ratio nu, likewise; 1/2 in plane strain wants Form Density")
              .unit("1")
              .range({-1, 0.5, true, false}),
          Row("Plane State", Kind::Text, "no strain or no stress across the plane")
              .standard("Plane Strain")
              .allowed({"Plane Strain", "Plane Stress"}),
          Row("Density", Kind::Real, "mass density, of bodies on which Body Loads act")
              .unit("mass / volume")
              .range(from(0)),
          Row("Thermal Expansion", Kind::Real,
              "coefficient of linear thermal expansion, of bodies with a Temperature")
              .unit("1 / temperature"),
          Row("Conductivity", Kind::Real,
              "of heat; only Heat Flux under Thermal Conditions depends on it")
              .unit("power / length / temperature")
              .standard("1")
              .range(above(0)),
      });
  add(table,
      Row(geometry, Kind::List, "the outline: a polygon of segments and arcs, with holes")
          .required(),
      {
          Row("Vertices", Kind::Points,
              "corners of the outer polygon, counter-clockwise; it closes by itself")
              .unit("length"),
          Row("Edges", Kind::Names,
              "the boundary's name for each edge; edge i leads from vertex i to i+1"),
          Row("Bulges", Kind::Reals,
              "tan(angle/4) of the circular arc from vertex i to i+1, one for each edge: "
              "0 straight, 1 half a circle, > 0 curved outwards (to the right of the "
              "chord); two vertices are enough with arcs")
              .unit("1")
              .range({-10, 10, false, false}),
          Row("Hole <k> Vertices", Kind::Points,
              "corners of hole k = 1, 2, ..., counter-clockwise too")
              .unit("length"),
          Row("Hole <k> Edges", Kind::Names,
              "the boundary's name for each edge of hole k"),
          Row("Hole <k> Bulges", Kind::Reals,
              "the same for hole k: > 0 away from its middle")
              .unit("1")
              .range({-10, 10, false, false}),
          Row("File", Kind::Text,
              "instead of vertices and edges: a Gmsh mesh (.msh, format 4.1), whose "
              "physical "
              "curves name the boundaries, or a drawing (.dxf), whose layers do; "
              "relative "
              "to the scene"),
      });
  add(table,
      Row("Geometry", Kind::List, "what the outlines of all bodies have in common"),
      {
          Row("Symmetry", Kind::Text,
              "the scene is drawn as one half of what is symmetric about the line x = 0 "
              "(X: mirrored along x) or y = 0 (Y); edges on the line are rollers by "
              "themselves")
              .standard("None")
              .allowed({"None", "X", "Y"}),
      });
}

/// What all contacts have; `only`: under these types of their list, none: whatever there is.
void addSurface(Table& table, const std::string& contact,
                const std::vector<std::string>& only) {
  const auto addLaw = [&](const char* name, const char* meaning, const Table& rows) {
    Parameter list = Row(contact + name, Kind::List, meaning);
    list.only = only;
    add(table, list, rows);
  };
  Parameter sliding =
      Row(contact + "->Sliding", Kind::Expression,
          "tangential motion of the other surface along t of the side that carries the "
          "stresses (n turned anticlockwise), counted from t = 0; geometry stays")
          .unit("length");
  sliding.only = only;
  append(table, {sliding});
  Parameter wear = Row(contact + "->Wear", Kind::List, "how fast the sides wear");
  wear.only = only;
  add(table, wear,
      {
          Row("Coefficient", Kind::Expression,
              "depth worn = coefficient times pressure times slip, >= 0; without it "
              "nothing wears")
              .unit("1/stress"),
          Row("Cycle Jump", Kind::Expression,
              "how many times each step of the path happens for what wears, >= 1, in t "
              "and constants")
              .unit("1")
              .standard("1"),
      });
  addLaw("->Friction", "how much shear the contact carries", contact::frictionRows());
  addLaw("->Normal", "how far the surfaces yield to the pressure", contact::normalRows());
}

void addConditions(Table& table) {
  const std::string conditions = "Bodies-><body>->Boundary Conditions";
  const std::string boundary = conditions + "-><boundary>";
  append(table, {Row(conditions, Kind::List,
                     "one sublist per boundary; an edge without one is free")});
  add(table, Row(boundary, Kind::List, "what happens on the edges of this name"),
      {
          Row("Type", Kind::Text, "kind of condition")
              .allowed({"Dirichlet", "Neumann", "Contact"})
              .required(),
          Row("Displacement X", Kind::Expression,
              "prescribed displacement; without it the component is free (a roller)")
              .unit("length")
              .only("Dirichlet"),
          Row("Displacement Y", Kind::Expression,
              "prescribed displacement; without it the component is free (a roller)")
              .unit("length")
              .only("Dirichlet"),
          Row("Traction X", Kind::Expression, "traction on the body; without it zero")
              .unit("stress")
              .only("Neumann"),
          Row("Traction Y", Kind::Expression, "traction on the body; without it zero")
              .unit("stress")
              .only("Neumann"),
          Row("Force X", Kind::Expression,
              "instead of Traction X: the uniform traction that makes this force on the "
              "whole boundary, per unit of thickness; in t and constants")
              .unit("stress length")
              .only("Neumann"),
          Row("Force Y", Kind::Expression, "instead of Traction Y, likewise")
              .unit("stress length")
              .only("Neumann"),
          Row("Moment", Kind::Expression,
              "added to it: the traction, linear in place, that turns the boundary about "
              "its centroid, > 0 anticlockwise, per unit of thickness; in t and "
              "constants")
              .unit("stress length^2")
              .only("Neumann"),
          Row("Traction X", Kind::Expression, "where Displacement X is free")
              .unit("stress")
              .only("Dirichlet"),
          Row("Traction Y", Kind::Expression, "where Displacement Y is free")
              .unit("stress")
              .only("Dirichlet"),
          Row("Force X", Kind::Expression, "where Displacement X is free")
              .unit("stress length")
              .only("Dirichlet"),
          Row("Force Y", Kind::Expression, "where Displacement Y is free")
              .unit("stress length")
              .only("Dirichlet"),
          Row("Gap", Kind::Expression,
              "distance to the rigid obstacle along the outward normal")
              .unit("length")
              .standard("0")
              .only("Contact"),
      });
  addSurface(table, boundary, {"Contact"});
  add(table,
      Row("Bodies-><body>->Rigid Motions", Kind::List,
          "how a body without a clamp is held"),
      {
          Row("Fix", Kind::Names,
              "motions whose mean over the boundary is zero; their reaction acts as a "
              "uniform traction of that mode")
              .allowed({"X", "Y", "Rotation"}),
      });
  add(table,
      Row("Bodies-><body>->Body Loads", Kind::List,
          "what acts inside the body, its own in place of the list at the root"),
      bodyLoadsRows());
  const std::string thermal = "Bodies-><body>->Thermal Conditions";
  append(table,
         {Row(thermal, Kind::List,
              "steady conduction of heat inside the body, one sublist per boundary, "
              "contacts among them; one without is insulated, and so are contacts "
              "from what they meet")});
  add(table, Row(thermal + "-><boundary>", Kind::List, "heat on the edges of this name"),
      thermalRows());
  add(table,
      Row("Body Loads", Kind::List,
          "what acts inside every body that has no such list of its own"),
      bodyLoadsRows());
}

void addSeveralBodies(Table& table) {
  const std::string mesh = "Bodies-><body>->Mesh";
  const std::string motion = "Bodies-><body>->Motion";
  const std::string contact = "Contacts-><contact>";
  add(table, Row(mesh, Kind::List, "the body's own first mesh, before Discretization"),
      meshRows());
  add(table, Row(motion, Kind::List, "of a rigid body; without it the body is held"),
      {
          Row("Displacement X", Kind::Expression,
              "prescribed, without x and y; without it and Force X none")
              .unit("length"),
          Row("Displacement Y", Kind::Expression, "likewise").unit("length"),
          Row("Rotation", Kind::Expression,
              "prescribed, counter-clockwise about the reference point; small: places "
              "move by its tangent")
              .unit("radian"),
          Row("Force X", Kind::Expression,
              "instead of Displacement X: the motion is free, under this force")
              .unit("stress length"),
          Row("Force Y", Kind::Expression, "likewise").unit("stress length"),
          Row("Moment", Kind::Expression,
              "instead of Rotation: about the reference point, likewise")
              .unit("stress length^2"),
          Row("Stiffness X", Kind::Real,
              "the motion is free, by a spring of this stiffness whose other end has "
              "Displacement X; Force X acts, too")
              .unit("stress")
              .range(above(0)),
          Row("Stiffness Y", Kind::Real, "likewise").unit("stress").range(above(0)),
          Row("Stiffness Rotation", Kind::Real,
              "likewise of Rotation and Moment, per radian")
              .unit("stress length^2")
              .range(above(0)),
          Row("Reference Point", Kind::Reals,
              "where forces act and what rotations turn about; without it the outline's "
              "centroid")
              .unit("length"),
      });
  append(table, {Row("Contacts", Kind::List, "contact between bodies")});
  add(table, Row(contact, Kind::List, "a contact, under a name of your choice"),
      {
          Row("Between", Kind::Names,
              "two sides, body:boundary; the first one carries the contact stresses, or "
              "the elastic one if the other is rigid")
              .required(),
          Row("Interference", Kind::Expression,
              "overlap along the first side's outward normal, in addition to that of the "
              "outlines as drawn; alone where Law is Tied")
              .unit("length")
              .standard("0"),
      });
  addSurface(table, contact, {});
}

void addHistory(Table& table) {
  add(table,
      Row("History", Kind::List,
          "the path of the loads, solved step by step; friction remembers.  Without it "
          "one load, t = 1"),
      historyRows());
}

void addDiscretization(Table& table) {
  const std::string stabilization = "Discretization->Stabilization";
  add(table,
      Row("Discretization", Kind::List, "the first mesh and the spaces on it").required(),
      meshRows("1"));
  append(table, {contact::multiplierRow()}, "Discretization");
  add(table, Row(stabilization, Kind::List, "stabilisation of the mixed method"),
      contact::stabilizationRows());
}

void addSolver(Table& table) {
  add(table, Row("Solver", Kind::List, "how the nonlinear problem is solved"),
      contact::coulombRows());
  append(table, contact::contactSolverRows(), "Solver");
  append(table, {contact::noxRow()}, "Solver");
  add(table, Row("Solver->Linear", Kind::List, "how linear systems are solved"),
      linearRows());
}

void addAdaptivity(Table& table) {
  add(table, Row("Adaptivity", Kind::List, "from one level to the next"),
      adaptivity::strategyRows());
  append(table, adaptivity::estimatorRows(), "Adaptivity");
  append(table, limitRows(), "Adaptivity");
}

void addOutput(Table& table) {
  add(table, Row("Output", Kind::List, "what is written"), outputRows());
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

}  // namespace epafi::drivers
