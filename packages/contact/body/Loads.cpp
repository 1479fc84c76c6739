#include "contact/body/Loads.hpp"

#include "bem/algebra/LeastSquares.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace epafi::contact {

using bem::Element;
using bem::Function;
using bem::Vec2;

namespace {

void checkBoundaries(const bem::Mesh& mesh, const Conditions& conditions) {
  std::set<std::string> known;
  for (const bem::Edge& edge : mesh.outline().edges())
    known.insert(edge.boundary);
  std::set<std::string> seen;
  const auto check = [&](const auto& family) {
    for (const auto& [name, condition] : family) {
      if (known.count(name) == 0)
        throw bem::InputError("a condition on '", name,
                              "', which is no boundary of the outline");
      if (!seen.insert(name).second)
        throw bem::InputError("two conditions on boundary '", name, "'");
    }
  };
  check(conditions.neumann);
  for (const auto& [name, contact] : conditions.contact)
    if (contact.isSupport)
      seen.erase(name);  // which takes the normal and leaves the tangent
  check(conditions.contact);
  for (const auto& [name, dirichlet] : conditions.dirichlet) {
    const auto load = conditions.neumann.find(name);
    const bool pulls = load != conditions.neumann.end() &&
                       !(load->second.x && dirichlet.x) &&
                       !(load->second.y && dirichlet.y);
    if (pulls)
      seen.erase(name);  // one component each
  }
  check(conditions.dirichlet);
}

/// Adds ∫ traction · φ_j ds of an element, the traction a function of the place t on it.  Returns
/// what the rest of the rotation adds, see bem::Rotation.
template <class Traction>
double addTraction(const bem::Space& space, int e, const bem::Rule& rule,
                   const Traction& tractionAt, double* load) {
  const Element& element = space.mesh()[e];
  std::array<double, bem::largestDegree + 1> phi{};
  double rest = 0;
  for (int q = 0; q < rule.size(); ++q) {
    const double share = rule.weights[q] * space.mesh().measure(e, rule.points[q]);
    const Vec2 traction = tractionAt(rule.points[q], share);
    bem::DisplacementBasis::values(element.degree, rule.points[q], phi.data());
    for (int k = 0; k <= element.degree; ++k) {
      const double weight = share * phi[k];
      load[space.displacement(e, k, 0)] += weight * traction.x;
      load[space.displacement(e, k, 1)] += weight * traction.y;
    }
    rest += share * dot(traction, space.rotationRest(e, rule.points[q]));
  }
  return rest;
}

/// Displacements, each with the values of the three rigid motions there.
struct Samples {
  std::vector<Vector> motions = std::vector<Vector>(3);
  Vector values;

  void add(const std::array<double, 3>& there, double value) {
    for (std::size_t k = 0; k < 3; ++k)
      motions[k].push_back(there[k]);
    values.push_back(value);
  }
};

/// A rigid motion, by the amplitudes of those of the samples, and what is left of them.
struct RigidPart {
  Vector amplitudes;
  double largestRest = 0;  ///< zero where it is rounding
};

/// The rigid motion next to the samples, by least squares; motions that they do not know are zero.
RigidPart rigidPartOf(const Samples& samples) {
  constexpr double dependent = 1e-10;
  constexpr double rounding = 1e-13;
  RigidPart part{bem::leastSquares(samples.motions, samples.values, dependent).x};
  double size = 0;
  for (std::size_t i = 0; i < samples.values.size(); ++i) {
    double rest = samples.values[i];
    for (int k = 0; k < 3; ++k) {
      const double moved = part.amplitudes[k] * samples.motions[k][i];
      rest -= moved;
      size = std::max(size, std::abs(moved));
    }
    part.largestRest = std::max(part.largestRest, std::abs(rest));
  }
  if (part.largestRest <= rounding * size)
    part.largestRest = 0;
  return part;
}

/// What acts inside leaves -t_p to the boundary, on all of it: where a clamp holds, too, whose
/// reaction is that of the whole stress.
void addInside(const bem::Space& space, const ParticularSolution& inside, Loads& loads) {
  const bem::Mesh& mesh = space.mesh();
  loads.given = loads.load;
  loads.inside.traction.assign(loads.load.size(), 0.0);
  double rest = 0;
  Samples samples;
  for (int e = 0; e < mesh.size(); ++e)
    rest += addTraction(
        space, e, bem::gaussForGiven(mesh[e].degree),
        [&](double t, double) {
          const Vec2 traction = inside.traction(mesh, e, t);
          loads.largestTraction = std::max(loads.largestTraction, norm(traction));
          const Vec2 u = inside.displacement(mesh, e, t);
          const Vec2 x = mesh.scaledPoint(e, t);
          samples.add({1, 0, -x.y}, u.x);
          samples.add({0, 1, x.x}, u.y);
          return traction;
        },
        loads.inside.traction.data());
  loads.inside.largestDeformation = rigidPartOf(samples).largestRest;
  if (space.rotation() != nullptr)
    space.rotation()->complete(rest, loads.inside.traction);
  bem::axpy(-1, loads.inside.traction, loads.load);
}

void addDirichlet(const bem::Space& space, const std::string& name,
                  const Conditions::Dirichlet& dirichlet, const BodyLoadSolution& inside,
                  bem::Units units, Loads& loads) {
  const bem::Mesh& mesh = space.mesh();
  const std::vector<int> elements = mesh.elementsOf(name);
  for (const int component : {0, 1}) {
    const Function& f = component == 0 ? dirichlet.x : dirichlet.y;
    if (!f)
      continue;
    const Vector given = space.interpolatePlaces(elements, [&](int e, double t) {
      double value = f(mesh.physicalPoint(e, t)) / units.length;
      if (inside) {
        const Vec2 known = inside->displacement(mesh, e, t);
        value -= component == 0 ? known.x : known.y;
      }
      return component == 0 ? Vec2{value, 0} : Vec2{0, value};
    });
    for (const int e : elements)
      for (int k = 0; k <= mesh[e].degree; ++k) {
        const Index unknown = space.displacement(e, k, component);
        loads.prescribed[unknown] = given[unknown];
      }
  }
}

/// Splits the prescribed displacement, which is zero elsewhere, and lets the whole body go with its
/// rigid part: what is left to the operators is no difference of large forces.
void addRigidPart(const bem::Space& space, const std::vector<char>& held, Loads& loads) {
  if (!(bem::largestEntry(loads.prescribed) > 0))
    return;
  const Matrix motions = space.rigidMotions();
  Samples samples;
  for (Index j = 0; j < motions.rows(); ++j)
    if (held[at(j)] != 0)
      samples.add({motions(j, 0), motions(j, 1), motions(j, 2)}, loads.prescribed[at(j)]);
  const RigidPart part = rigidPartOf(samples);
  loads.largestDeformation = part.largestRest;
  loads.rigidPart.assign(loads.prescribed.size(), 0.0);
  for (int k = 0; k < 3; ++k)
    bem::axpy(part.amplitudes[at(k)], columnOf(motions, k), loads.rigidPart);
  for (std::size_t j = 0; j < held.size(); ++j)
    if (held[j] == 0)
      loads.prescribed[j] = loads.rigidPart[j];
}

/// Moves nodes that nothing holds along the normal, so that the prescribed displacement keeps the
/// volume: V at ν = 1/2 would answer a change with pressures as large as one over the part of it
/// that a pin adds, and the displacement that loads cause would have to take them away.
void keepVolume(const bem::Space& space, const std::vector<char>& held, Loads& loads) {
  const bem::Mesh& mesh = space.mesh();
  Vector volume(loads.prescribed.size(), 0.0);  // ∫ φ_j · n ds
  Vector lengths(volume.size(), 0.0);           // ∫ φ_j ds of the nodes' functions
  double rest = 0;
  for (int e = 0; e < mesh.size(); ++e) {
    rest += addTraction(
        space, e, bem::gaussForGiven(mesh[e].degree),
        [&](double t, double) { return mesh[e].curve.normal(t); }, volume.data());
    for (const int k : {0, 1})
      for (const int c : {0, 1})
        lengths[space.displacement(e, k, c)] += mesh.measure(e, 0);
  }
  if (space.rotation() != nullptr)
    space.rotation()->complete(rest, volume);
  Vector outward(volume.size(), 0.0);
  for (std::size_t i = 0; i < volume.size(); ++i)
    if (lengths[i] > 0 && held[i] == 0)
      outward[i] = volume[i] / lengths[i];
  if (const double gained = bem::dot(volume, outward); gained > 0)
    bem::axpy(-bem::dot(volume, loads.prescribed) / gained, outward, loads.prescribed);
}

}  // namespace

Loads makeLoads(const bem::Space& space, const Conditions& conditions, bem::Units units) {
  checkBoundaries(space.mesh(), conditions);
  const std::size_t size = space.displacements();
  const BodyLoadSolution& inside = conditions.inside;
  Loads loads;
  loads.load.assign(size, 0.0);
  loads.prescribed.assign(size, 0.0);
  double rest = 0;
  for (int e = 0; e < space.mesh().size(); ++e) {
    const auto neumann = conditions.neumann.find(space.mesh().boundary(e));
    if (neumann == conditions.neumann.end())
      continue;
    const auto tractionAt = [&, &given = neumann->second](double t, double weight) {
      const Vec2 traction =
          (1 / units.stress) * given.at(space.mesh().physicalPoint(e, t));
      loads.largestTraction = std::max(loads.largestTraction, norm(traction));
      if (inside)
        loads.inside.work +=
            weight * dot(traction, inside->displacement(space.mesh(), e, t));
      return traction;
    };
    rest += addTraction(space, e, bem::gaussForGiven(space.mesh()[e].degree), tractionAt,
                        loads.load.data());
  }
  if (space.rotation() != nullptr)
    space.rotation()->complete(rest, loads.load);
  if (inside)
    addInside(space, *inside, loads);
  for (const auto& [name, dirichlet] : conditions.dirichlet)
    addDirichlet(space, name, dirichlet, inside, units, loads);
  const std::vector<char> held = prescribed(space, conditions);
  addRigidPart(space, held, loads);
  if (!conditions.pins.empty() && loads.largestDeformation > 0)
    keepVolume(space, held, loads);
  return loads;
}

std::vector<char> prescribed(const bem::Space& space, const Conditions& conditions) {
  std::vector<char> result(space.displacements(), 0);
  for (int e = 0; e < space.mesh().size(); ++e) {
    const Vec2 given = conditions.given(space.mesh().boundary(e));
    for (int k = 0; k <= space.mesh()[e].degree; ++k)
      for (const int c : {0, 1})
        if ((c == 0 ? given.x : given.y) != 0)
          result[space.displacement(e, k, c)] = 1;
  }
  return result;
}

RigidModes makeRigidModes(const bem::Space& space, const Conditions& conditions) {
  const bem::Mesh& mesh = space.mesh();
  RigidModes modes;
  double length = 0;
  for (int e = 0; e < mesh.size(); ++e) {
    const Element& element = mesh[e];
    if (!conditions.isBoundary(mesh.boundary(e)))
      continue;
    modes.centroid = modes.centroid + 2 * element.half * element.curve.centroid();
    length += 2 * element.half;
  }
  modes.centroid = (1 / length) * modes.centroid;
  if (mesh.outline().isAxisymmetric())
    modes.centroid.x = 0;

  modes.motions = space.rigidMotions();
  for (Index j = 0; j < space.displacements(); ++j)  // move the pole to the centroid
    modes.motions(j, 2) +=
        modes.centroid.y * modes.motions(j, 0) - modes.centroid.x * modes.motions(j, 1);

  modes.functionals = Matrix(space.displacements(), 3);
  double rest[3] = {};  // of the rotation, see bem::Rotation
  for (int e = 0; e < mesh.size(); ++e) {
    if (!conditions.isBoundary(mesh.boundary(e)))
      continue;
    const bem::Rule& rule =
        bem::gaussLegendre(mesh[e].degree + std::max(2, mesh[e].curve.pointsOfTurning()));
    for (Index k = 0; k < 3; ++k)
      rest[k] += addTraction(
          space, e, rule,
          [&](double t, double) { return modes.at(k, mesh.scaledPoint(e, t)); },
          modes.functionals.column(k));
  }
  if (space.rotation() != nullptr)
    for (Index k = 0; k < 3; ++k)
      for (Index j = 0; j < space.displacements(); ++j)
        modes.functionals(j, k) += rest[k] * space.rotation()->functional()[j];
  return modes;
}

Vector meansOf(const Conditions& conditions, const bem::Mesh& mesh, Vec2 centroid) {
  const BodyLoadSolution& inside = conditions.inside;
  if (!inside)
    return {};
  Vector means(3, 0.0);
  for (int e = 0; e < mesh.size(); ++e) {
    if (!conditions.isBoundary(mesh.boundary(e)))
      continue;
    const bem::Rule& rule = bem::gaussForGiven(mesh[e].degree);
    for (int q = 0; q < rule.size(); ++q) {
      const Vec2 u = rule.weights[q] * mesh.measure(e, rule.points[q]) *
                     inside->displacement(mesh, e, rule.points[q]);
      means[0] += u.x;
      means[1] += u.y;
      means[2] += cross(mesh.scaledPoint(e, rule.points[q]) - centroid, u);
    }
  }
  return means;
}

}  // namespace epafi::contact
