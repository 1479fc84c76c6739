#include "contact/law/FrictionLaw.hpp"
#include "contact/law/NormalLaw.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "contact/nox/NoxNewton.hpp"
#include "drivers/scene/BodyLoadsReader.hpp"
#include "drivers/scene/Readers.hpp"
#include "drivers/scene/SceneFile.hpp"

namespace epafi::drivers {

namespace {

using bem::above;
using bem::from;
using bem::Row;
using Table = std::vector<Parameter>;

/// Adds a list and its keys.
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
              .defaultValue("false"),
          Row("Young's Modulus", Kind::Real, "stress", above(0),
              "Young's modulus E; every body has one unless it is Rigid"),
          Row("Poisson's Ratio", Kind::Real, "1", {-1, 0.5, true, false},
              "Poisson's ratio nu; every body has one unless it is Rigid; 1/2 in plane "
              "strain "
              "needs Form Density"),
          Row("Plane State", Kind::Text, "no strain or no stress across the plane")
              .defaultValue("Plane Strain")
              .allowed({"Plane Strain", "Plane Stress"}),
          Row("Density", Kind::Real, "mass / volume", from(0),
              "mass density, of bodies on which Body Loads act"),
          Row("Thermal Expansion", Kind::Real, "1 / temperature",
              "coefficient of linear thermal expansion, of bodies with a Temperature"),
          Row("Conductivity", Kind::Real, "power / length / temperature", above(0),
              "of heat; only Heat Flux under Thermal Conditions depends on it")
              .defaultValue("1"),
      });
  add(table,
      Row(geometry, Kind::List, "the outline: a polygon of segments and arcs, with holes")
          .required(),
      {
          Row("Vertices", Kind::Points, "length",
              "corners of the outer polygon, counter-clockwise; it closes by itself"),
          Row("Edges", Kind::Names,
              "the boundary's name for each edge; edge i leads from vertex i to i+1"),
          Row("Bulges", Kind::Reals, "1", {-10, 10},
              "tan(angle/4) of the circular arc from vertex i to i+1, one for each edge: "
              "0 straight, 1 half a circle, > 0 curved outwards (to the right of the "
              "chord); two vertices are enough with arcs"),
          Row("Hole <k> Vertices", Kind::Points, "length",
              "corners of hole k = 1, 2, ..., counter-clockwise too"),
          Row("Hole <k> Edges", Kind::Names,
              "the boundary's name for each edge of hole k"),
          Row("Hole <k> Bulges", Kind::Reals, "1", {-10, 10},
              "the same for hole k: > 0 away from its middle"),
          Row("File", Kind::Text,
              "instead of vertices and edges: a Gmsh mesh (.msh, format 4.1), whose "
              "physical curves name the boundaries, or a drawing (.dxf), whose layers "
              "do; relative to the scene"),
          Row("Scale", Kind::Real, "1", bem::above(0),
              "factor on the file's coordinates, 25.4 from inches to millimetres"),
          Row("Boundaries", Kind::Names,
              "of a file of several bodies the boundaries, layers of a drawing or "
              "physical "
              "curves of a mesh, that are this body's; without it all of the file's"),
          Row("Surface", Kind::Text,
              "of a mesh of several bodies the physical surface that is this body"),
      });
  add(table,
      Row("Geometry", Kind::List, "what the outlines of all bodies have in common"),
      {
          Row("Type", Kind::Text,
              "Axisymmetric: bodies are solids of revolution without torsion, x is the "
              "radius and y the axis, in expressions r and z, too; edges on x = 0 are "
              "the axis by "
              "themselves, named 'axis'; forces, energies and volumes are those of the "
              "whole revolution, "
              "[force] for stress length^2, [energy] for stress length^3")
              .defaultValue("Plane")
              .allowed({"Plane", "Axisymmetric"}),
          Row("Symmetry", Kind::Text,
              "the scene is drawn as one half of what is symmetric about the line x = 0 "
              "(X: mirrored along x) or y = 0 (Y); edges on the line named 'symmetry' or "
              "'any', else those without a condition, are rollers")
              .defaultValue("None")
              .allowed({"None", "X", "Y"}),
      });
}

/// The keys that all contacts have.
Table surfaceRows() {
  Table rows = {
      Row("Sliding", Kind::Expression, "length",
          "tangential motion of the other surface along t of the side that carries the "
          "stresses (n turned anticlockwise), counted from t = 0; geometry stays")};
  add(rows, Row("Wear", Kind::List, "how fast the sides wear"),
      {
          Row("Coefficient", Kind::Expression, "1/stress",
              "depth worn = coefficient times pressure times slip, >= 0; without it "
              "nothing wears"),
          Row("Cycle Jump", Kind::Expression, "1",
              "how many times each step of the path happens for what wears, >= 1, in t "
              "and constants")
              .defaultValue("1"),
      });
  add(rows, Row("Friction", Kind::List, "how much shear the contact carries"),
      contact::frictionRows());
  add(rows, Row("Normal", Kind::List, "how far the surfaces yield to the pressure"),
      contact::normalRows());
  return rows;
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
      });
  const auto only = [&](const char* type, Table rows) {
    for (Parameter& row : rows)
      if (row.parent().empty())
        row.only = {type};
    append(table, rows, boundary);
  };
  only("Dirichlet",
       {
           Row("Displacement X", Kind::Expression, "length",
               "prescribed displacement; without it the component is free (a roller)"),
           Row("Displacement Y", Kind::Expression, "length",
               "prescribed displacement; without it the component is free (a roller)"),
           Row("Displacement Normal", Kind::Expression, "length",
               "in place of X and Y: prescribed displacement along the outward normal of "
               "edges of any direction, straight or curved; the tangent is free, or "
               "loaded "
               "by Traction or Force, what of them is normal goes into the support"),
       });
  only("Neumann",
       {
           Row("Traction X", Kind::Expression, "stress",
               "traction on the body; without it zero"),
           Row("Traction Y", Kind::Expression, "stress",
               "traction on the body; without it zero"),
           Row("Force X", Kind::Expression, "stress length",
               "instead of Traction X: the uniform traction that makes this force on the "
               "whole boundary, per unit of thickness; in t and constants"),
           Row("Force Y", Kind::Expression, "stress length",
               "instead of Traction Y: the uniform traction that makes this force along "
               "y"),
           Row("Pressure", Kind::Expression, "stress",
               "added to it: on the body, against the outward normal"),
           Row("Moment", Kind::Expression, "stress length^2",
               "added to it: the traction, linear in place, that turns the boundary "
               "about its centroid, > 0 anticlockwise, per unit of thickness; in t and "
               "constants"),
       });
  only("Dirichlet",
       {
           Row("Traction X", Kind::Expression, "stress", "where Displacement X is free"),
           Row("Traction Y", Kind::Expression, "stress", "where Displacement Y is free"),
           Row("Force X", Kind::Expression, "stress length",
               "where Displacement X is free"),
           Row("Force Y", Kind::Expression, "stress length",
               "where Displacement Y is free"),
       });
  only("Contact", {
                      Row("Gap", Kind::Expression, "length",
                          "distance to the rigid obstacle along the outward normal")
                          .defaultValue("0"),
                  });
  only("Contact", surfaceRows());
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
  append(table, {Row(thermal, Kind::List,
                     "steady conduction of heat inside the body, one sublist per "
                     "boundary, contacts among them; one without is insulated, and so "
                     "are contacts from what they meet")});
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
          Row("Displacement X", Kind::Expression, "length",
              "prescribed, without x and y; without it and Force X none"),
          Row("Displacement Y", Kind::Expression, "length",
              "prescribed along y, without x and y; without it and Force Y none"),
          Row("Rotation", Kind::Expression, "radian",
              "prescribed, counter-clockwise about the reference point; small: places "
              "move by its tangent"),
          Row("Force X", Kind::Expression, "stress length",
              "instead of Displacement X: the motion is free, under this force"),
          Row("Force Y", Kind::Expression, "stress length",
              "instead of Displacement Y: the motion is free, under this force"),
          Row("Moment", Kind::Expression, "stress length^2",
              "instead of Rotation: the body turns freely about the reference point, "
              "under this"),
          Row("Stiffness X", Kind::Real, "stress", above(0),
              "the motion is free, by a spring of this stiffness whose other end has "
              "Displacement X; Force X acts, too"),
          Row("Stiffness Y", Kind::Real, "stress", above(0),
              "of a spring along y whose other end has Displacement Y"),
          Row("Stiffness Rotation", Kind::Real, "stress length^2", above(0),
              "of a spring against rotation, moment per radian, whose other end has "
              "Rotation"),
          Row("Reference Point", Kind::Reals, "length",
              "where forces act and what rotations turn about; without it the outline's "
              "centroid"),
      });
  append(table, {Row("Contacts", Kind::List, "contact between bodies")});
  add(table, Row(contact, Kind::List, "a contact, under a name of your choice"),
      {
          Row("Between", Kind::Names,
              "two sides, body:boundary, of two bodies or of one that meets itself; the "
              "first one carries the contact stresses, or the elastic one if the other "
              "is "
              "rigid")
              .required(),
          Row("Interference", Kind::Expression, "length",
              "overlap along the first side's outward normal, in addition to that of the "
              "outlines as drawn; alone where Law is Tied")
              .defaultValue("0"),
          Row("Adjust", Kind::Real, "length", above(0),
              "gaps and overlaps of the outlines as drawn up to this count as zero where "
              "the sides are parallel or concentric along a whole pair of edges; "
              "elsewhere "
              "a warning tells of them"),
      });
  append(table, surfaceRows(), contact);
}

void addSettings(Table& table) {
  add(table,
      Row("History", Kind::List,
          "the path of the loads, solved step by step; friction remembers.  Without it "
          "one load, t = 1"),
      historyRows());
  add(table, Row("Discretization", Kind::List, "the first mesh and the spaces on it"),
      meshRows("1"));
  append(table, {contact::multiplierRow()}, "Discretization");
  add(table,
      Row("Discretization->Stabilization", Kind::List,
          "stabilisation of the mixed method"),
      bem::rowsOf<contact::Stabilization>());
  add(table, Row("Solver", Kind::List, "how the nonlinear problem is solved"),
      bem::rowsOf<SolverOptions>());
  append(table, {contact::noxRow()}, "Solver");
  add(table, Row("Solver->Linear", Kind::List, "how linear systems are solved"),
      bem::rowsOf<LinearOptions>());
  add(table, Row("Adaptivity", Kind::List, "from one level to the next"),
      bem::rowsOf<AdaptivityOptions>());
  add(table, Row("Output", Kind::List, "what is written"), bem::rowsOf<OutputOptions>());
  append(
      table,
      {Row("Output->Units", Kind::List,
           "names of the scene's units, for labels of pictures and reports; nothing is "
           "converted"),
       Row("Output->Units->Length", Kind::Text, "as mm"),
       Row("Output->Units->Stress", Kind::Text, "as MPa")});
  append(table, {Row("Versions", Kind::Free,
                     "written into used.xml, ignored when it is read again")});
}

}  // namespace

const bem::SchemaRows& parameters() {
  static const Table table = [] {
    Table all = {
        Row("Constants", Kind::List, "numbers that all expressions know by name"),
        Row("Constants-><constant>", Kind::Expression,
            "a number, or an expression in constants that stand before it, and tables"),
        Row("Tables", Kind::List,
            "functions of one variable through points, such as measured profiles; "
            "expressions know them by name: Gap = profile(x) + 0.1")};
    add(all, Row("Tables-><table>", Kind::List, "one function"), tableRows());
    addBody(all);
    addConditions(all);
    addSeveralBodies(all);
    addSettings(all);
    return all;
  }();
  return table;
}

}  // namespace epafi::drivers
