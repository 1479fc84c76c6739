#pragma once

#include "bem/base/Vec2.hpp"
#include "bem/fields/Interior.hpp"
#include "drivers/output/SurfaceStress.hpp"
#include "drivers/output/Table.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <array>
#include <string>
#include <vector>

namespace epafi::drivers {

/// Displacement and stress at a point inside a body, in the user's units.
struct InsideValue {
  bem::Vec2 displacement;
  double xx = 0;
  double yy = 0;
  double xy = 0;
  /// Normal to the plane: ν (σxx + σyy) - E α T, or 0 in plane stress; of solids of revolution the hoop
  /// stress.
  double zz = 0;
  double vonMises = 0;    ///< √(½ Σ (normal stress differences)² + 3 σxy²)
  double principal1 = 0;  ///< the larger principal stress in the plane
  double principal2 = 0;
  double temperature = 0;  ///< above the stress-free state [temperature]

  /// Normal stress on a plane whose normal is a unit vector.
  double along(bem::Vec2 n) const {
    return xx * n.x * n.x + yy * n.y * n.y + 2 * xy * n.x * n.y;
  }
};

/// At a point of the boundary, with body loads and heat, in the user's units.
/// \param field of the rest
InsideValue stressAt(const bem::InteriorValue& field, const bem::Material& material,
                     const bem::Units& units, const contact::BodyLoadSolution& inside,
                     const bem::Mesh& mesh, int e, double t);

/// The numbers of a value by their names in files: the scalar fields of fields.vtu, and in
/// this order the columns of fields.csv and interior.csv.  Names: nameOf.
struct InsideField {
  const char* name;
  double& (*of)(InsideValue& value);
  const char* meaning = "";  ///< see Cell
  const char* unit = "";
};
inline constexpr InsideField insideFields[] = {
    {"ux", [](InsideValue& v) -> double& { return v.displacement.x; }, "displacement",
     "length"},
    {"uy", [](InsideValue& v) -> double& { return v.displacement.y; }},
    {"sxx", [](InsideValue& v) -> double& { return v.xx; }, "stress, tension positive",
     "stress"},
    {"syy", [](InsideValue& v) -> double& { return v.yy; }},
    {"sxy", [](InsideValue& v) -> double& { return v.xy; }},
    {"von_mises", [](InsideValue& v) -> double& { return v.vonMises; },
     "von Mises stress, with `szz` or `hoop`", "stress"},
    {"szz", [](InsideValue& v) -> double& { return v.zz; },
     "stress across the plane, 0 in plane stress; `hoop` in its place, of [solids of "
     "revolution](tutorial.md#revolution): stress around the axis",
     "stress"},
    {"principal_1", [](InsideValue& v) -> double& { return v.principal1; },
     "the larger and the smaller principal stress in the plane", "stress"},
    {"principal_2", [](InsideValue& v) -> double& { return v.principal2; }},
    {"temperature", [](InsideValue& v) -> double& { return v.temperature; },
     "difference from the stress-free state; 0 if none is given", "temperature"},
};

/// The name of szz of solids of revolution.
constexpr const char* hoop = "hoop";
std::string nameOf(const InsideField& field, bool isAxisymmetric);

/// The columns of interior.csv and fields.csv at a point; without a body (null) all but x and y are empty.
Cells insideCells(bem::Vec2 x, InsideValue value, const std::string* body,
                  bool isAxisymmetric);

/// A point inside a body, in the user's coordinates.  Bodies may overlap in the
/// undeformed state, so that the point alone does not determine its body.
struct InsidePoint {
  std::size_t body = 0;  ///< index; the number of bodies if the point is outside all
  bem::Vec2 x;
};

/// The fields inside all elastic bodies on a solved level, by closed formulas that are
/// equally accurate near to and far from the boundary.          [doc/theory/operators.md]
class BodyInsides {
 public:
  /// In a step of the level.  Keeps references to the arguments.
  BodyInsides(const Scene& scene, const Level& level, const SolvedState& step);

  const Scene& scene() const { return scene_; }
  std::size_t size() const { return spaces_.size(); }
  const bem::Mesh& mesh(std::size_t b) const { return spaces_.space(b).mesh(); }

  /// At t in [-1, 1] on element e of body b, see SurfaceField.
  InsideValue atBoundary(std::size_t b, int e, double t) const;

  /// Computed in parallel, see bem::Interior.  0 outside.
  std::vector<InsideValue> at(const std::vector<InsidePoint>& points) const;
  /// A row per point, see insideCells.  `more`: further cells of each, or empty.
  void addTo(std::string& csv, const std::vector<InsidePoint>& points,
             const std::vector<InsideValue>& values,
             const std::vector<Cells>& more = {}) const;

 private:
  const Scene& scene_;
  BodySpaces spaces_;
  std::vector<SurfaceField> surfaces_;  ///< of each body
  std::vector<contact::BodyLoadSolution>
      inside_;                         ///< of each body, at the level's last time
  std::vector<bem::Interior> fields_;  ///< of each body
};

/// All bodies as triangles with the values at their corners.  At a node of the boundary
/// the value is the mean over the two elements that meet there.
struct FilledBodies {
  bool isAxisymmetric = false;
  std::vector<InsidePoint> points;
  std::vector<InsideValue> values;          ///< of each point
  std::vector<std::array<int, 3>> corners;  ///< of each triangle, counter-clockwise
};
FilledBodies fill(const BodyInsides& insides);

/// A file for ParaView (.vtu, UnstructuredGrid): the triangles with displacement, the
/// scalar fields of fieldNames() and the number of the body.
std::string vtuFile(const FilledBodies& bodies);

/// The names of the scalar fields of such a file.
std::vector<std::string> fieldNames();

}  // namespace epafi::drivers
