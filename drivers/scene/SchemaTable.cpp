#include "adaptivity/estimate/ResidualEstimator.hpp"
#include "adaptivity/mark/Grading.hpp"
#include "adaptivity/mark/Strategy.hpp"
#include "bem/tpetra/BelosOptions.hpp"
#include "contact/coulomb/CoulombIteration.hpp"
#include "contact/law/FrictionLaw.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "contact/problem/Stabilization.hpp"
#include "contact/solve/LoadContinuation.hpp"
#include "drivers/scene/Schema.hpp"

namespace epafi::drivers {

namespace {

using bem::above;
using bem::from;
using bem::Row;
using Table = std::vector<Parameter>;

/// The names of a family: friction laws, multiplier bases, strategies.
template <class Family>
std::vector<std::string> namesOf(const Family& family) {
  std::vector<std::string> names;
  names.reserve(family.size());
  for (const auto& member : family)
    names.push_back(member.name);
  return names;
}

/// "A: what A does; B: what B does"
template <class Family>
std::string meanings(const Family& family) {
  std::string text;
  for (const auto& member : family)
    text +=
        (text.empty() ? "" : "; ") + (std::string(member.name) + ": " + member.meaning);
  return text;
}

void addBody(Table& table) {
  const std::string body = "Bodies-><body>";
  const std::string material = body + "->Material";
  const std::string geometry = body + "->Geometry";
  append(
      table,
      {
          Row("Bodies", Kind::List, "the elastic bodies; exactly one for now").required(),
          Row(body, Kind::List, "a body, under a name of your choice"),
          Row(material, Kind::List, "linear elastic, isotropic, homogeneous").required(),
          Row(material + "->Young's Modulus", Kind::Real, "Young's modulus E")
              .unit("stress")
              .range(above(0))
              .required(),
          Row(material + "->Poisson's Ratio", Kind::Real,
              "Poisson's ratio nu; 1/2 in plane strain wants Form Density")
              .unit("1")
              .range({-1, 0.5, true, false})
              .required(),
          Row(material + "->Plane State", Kind::Text,
              "no strain or no stress across the plane")
              .standard("Plane Strain")
              .allowed({"Plane Strain", "Plane Stress"}),
          Row(geometry, Kind::List, "the outline: a polygon, with holes").required(),
          Row(geometry + "->Vertices", Kind::Points,
              "corners of the outer polygon, counter-clockwise; it closes by itself")
              .unit("length"),
          Row(geometry + "->Edges", Kind::Names,
              "the boundary's name for each edge; edge i leads from vertex i to i+1"),
          Row(geometry + "->Hole <k> Vertices", Kind::Points,
              "corners of hole k = 1, 2, ..., counter-clockwise too")
              .unit("length"),
          Row(geometry + "->Hole <k> Edges", Kind::Names,
              "the boundary's name for each edge of hole k"),
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
          Row(boundary + "->Gap", Kind::Expression,
              "distance to the rigid obstacle along the outward normal")
              .unit("length")
              .standard("0")
              .only("Contact"),
          Row(boundary + "->Friction", Kind::List, "how much shear the contact carries")
              .only("Contact"),
      });
  append(table, contact::frictionRows(), boundary + "->Friction");
  append(table,
         {
             Row("Bodies-><body>->Rigid Motions", Kind::List,
                 "how a body without a clamp is held"),
             Row("Bodies-><body>->Rigid Motions->Fix", Kind::Names,
                 "motions whose mean over the boundary is zero; their reaction acts as a "
                 "uniform traction of that mode")
                 .allowed({"X", "Y", "Rotation"}),
         });
}

void addDiscretization(Table& table) {
  const std::string stabilization = "Discretization->Stabilization";
  append(table,
         {
             Row("Discretization", Kind::List, "the first mesh and the spaces on it")
                 .required(),
             Row("Discretization->Elements per Edge", Kind::Counts,
                 "equal elements on each edge of the outer polygon; or give Mesh Size")
                 .unit("1")
                 .range(from(1)),
             Row("Discretization->Hole <k> Elements per Edge", Kind::Counts,
                 "equal elements on each edge of hole k")
                 .unit("1")
                 .range(from(1)),
             Row("Discretization->Mesh Size", Kind::Real,
                 "largest element; each edge gets the smallest number of equal ones")
                 .unit("length")
                 .range(above(0)),
             Row("Discretization->Degree", Kind::Whole,
                 "polynomial degree of the displacement")
                 .unit("1")
                 .standard("1")
                 .range({1, 25}),
         });
  append(table, {contact::multiplierRow()}, "Discretization");
  append(table, {
                    Row(stabilization, Kind::List, "stabilisation of the mixed method"),
                });
  append(table, contact::stabilizationRows(), stabilization);
}

void addSolver(Table& table) {
  append(table, {Row("Solver", Kind::List, "how the nonlinear problem is solved")});
  append(table, contact::coulombRows(), "Solver");
  append(table, contact::trescaRows(), "Solver");
  append(table, contact::loadRows(), "Solver");
  append(
      table,
      {
          Row("Solver->NOX", Kind::Free, "handed to NOX; empty means Epafi's own choice"),
          Row("Solver->Linear", Kind::List, "how linear systems are solved"),
          Row("Solver->Linear->Method", Kind::Text,
              "how the single layer potential is inverted; Dense: Cholesky's factors; "
              "Belos: conjugate gradients, for each column")
              .standard("Dense")
              .allowed({"Dense", "Belos"}),
      });
  append(table, bem::belosRows(), "Solver->Linear");
}

void addStrategy(Table& table) {
  append(
      table,
      {
          Row("Adaptivity", Kind::List, "from one level to the next"),
          Row("Adaptivity->Strategy", Kind::Text, meanings(adaptivity::strategies()))
              .standard("None")
              .allowed(namesOf(adaptivity::strategies())),
          Row("Adaptivity->Marking Fraction", Kind::Real,
              "adaptive strategies refine the fewest elements that carry this part of "
              "the "
              "squared estimate")
              .unit("1")
              .standard("0.3")
              .range({0, 1, true, false}),
          Row("Adaptivity->Analyticity Threshold", Kind::Real,
              "Adaptive hp raises the degree where Legendre coefficients decay at least "
              "this fast from one degree to the next")
              .unit("1")
              .standard("0.5")
              .range({0, 1, true, true}),
      });
}

void addGrading(Table& table) {
  append(
      table,
      {
          Row("Adaptivity->Grading", Kind::List, "what Graded hp does"),
          Row("Adaptivity->Grading->Ratio", Kind::Real,
              "length of the piece that is cut off next to a singular point, relative to "
              "the element's")
              .unit("1")
              .standard("0.1")
              .range({0, 0.5, true, false}),
          Row("Adaptivity->Grading->Degree Step", Kind::Whole,
              "by how much the piece away from the singular point raises its degree")
              .unit("1")
              .standard("1")
              .range({0, 4}),
          Row("Adaptivity->Grading->Weak Point Degree", Kind::Whole,
              "next to corners and changes of boundary the degree is raised as long as "
              "it "
              "is lower and coefficients decay")
              .unit("1")
              .standard("4")
              .range(from(1)),
          Row("Adaptivity->Grading->Transitions", Kind::Text,
              "where contact or friction changes its state inside an element; " +
                  meanings(adaptivity::transitions()))
              .standard(adaptivity::transitions().front().name)
              .allowed(namesOf(adaptivity::transitions())),
          Row("Adaptivity->Grading->Reach", Kind::Real,
              "Follow moves a node to a transition that lies off it by at most this part "
              "of the length of the element the transition is in; 0: no node moves")
              .unit("1")
              .standard("1")
              .range({0, 1, false, false}),
          Row("Adaptivity->Grading->Smooth Elements", Kind::Text,
              "raise the degree away from singular points; " +
                  meanings(adaptivity::smoothElements()))
              .standard(adaptivity::smoothElements().front().name)
              .allowed(namesOf(adaptivity::smoothElements())),
      });
}

void addEstimate(Table& table) {
  append(table, adaptivity::estimatorRows(), "Adaptivity");
  append(table,
         {
             Row("Adaptivity->Target Estimate", Kind::Real,
                 "a run ends at the first level with a smaller estimate")
                 .unit("as the estimate: root of stress length^2 under Weights Energy")
                 .standard("0")
                 .range(from(0)),
             Row("Adaptivity->Maximum Levels", Kind::Whole,
                 "levels computed, the first included")
                 .unit("1")
                 .standard("6")
                 .range(from(1)),
             Row("Adaptivity->Maximum Degrees of Freedom", Kind::Whole,
                 "a level with more, displacement and contact stress together, is not "
                 "computed")
                 .unit("1")
                 .standard("4000")
                 .range(from(1)),
         });
}

void addOutput(Table& table) {
  append(
      table,
      {
          Row("Output", Kind::List, "what is written"),
          Row("Output->Fields", Kind::Flag, "write boundary.csv and the pictures' data")
              .standard("true"),
          Row("Output->Contact Samples per Element", Kind::Whole, "points in contact.csv")
              .unit("1")
              .standard("8")
              .range({1, 1000}),
          Row("Output->Interior Points", Kind::Points,
              "points inside the body for interior.csv")
              .unit("length"),
          Row("Versions", Kind::Free,
              "written into used.xml, ignored when it is read again"),
      });
}

}  // namespace

const std::vector<Parameter>& parameters() {
  static const Table table = [] {
    Table all;
    addBody(all);
    addConditions(all);
    addDiscretization(all);
    addSolver(all);
    addStrategy(all);
    addGrading(all);
    addEstimate(all);
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
