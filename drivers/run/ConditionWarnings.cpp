#include "bem/quadrature/Piecewise.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/run/Warnings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace epafi::drivers {

namespace {

using bem::message;

/// Displacements that differ by no more than rounding, in the user's unit of length.
bool areAlike(double a, double b, double size, const Body& body) {
  return std::abs(a - b) <= 1e-6 * size + 1e-12 * body.outline->diameter();
}

bem::SurfacePoint pointOf(const Body& body, const bem::Edge& edge, double t) {
  const bem::Vec2 x = body.outline->physical(edge.curve.point(t));
  return {x.x, x.y, edge.curve.normal(t)};
}

/// Calls at(edge, next, corner) for each corner of a body, in the user's coordinates.
template <class At>
void forEachCorner(const Body& body, const At& at) {
  const bem::Outline& outline = *body.outline;
  for (const bem::Edge& edge : outline.edges())
    at(edge, outline.edge(edge.next), outline.physical(edge.curve.to()));
}

/// What a side prescribes at a point: components along orthonormal directions.
std::vector<std::pair<bem::Vec2, double>> heldAt(const contact::Conditions& conditions,
                                                 const std::string& boundary,
                                                 const bem::SurfacePoint& x) {
  std::vector<std::pair<bem::Vec2, double>> held;
  const auto contact = conditions.contact.find(boundary);
  if (contact != conditions.contact.end() && contact->second.isSupport)
    held.emplace_back(x.normal, contact->second.gap(x));
  const auto given = conditions.dirichlet.find(boundary);
  if (given != conditions.dirichlet.end() && given->second.x)
    held.emplace_back(bem::Vec2{1, 0}, given->second.x(x));
  if (given != conditions.dirichlet.end() && given->second.y)
    held.emplace_back(bem::Vec2{0, 1}, given->second.y(x));
  return held;
}

/// Corners where two sides prescribe displacements that differ.
void findJumps(const Body& body, const contact::Conditions& conditions, Warnings& warn) {
  constexpr double same = 1e-12;
  forEachCorner(body, [&](const bem::Edge& edge, const bem::Edge& next,
                          bem::Vec2 corner) {
    if (edge.boundary == next.boundary)
      return;
    auto one = heldAt(conditions, edge.boundary, pointOf(body, edge, 1));
    auto other = heldAt(conditions, next.boundary, pointOf(body, next, -1));
    if (one.size() < other.size())
      std::swap(one, other);
    const auto differs = [&](const auto& held) {
      double value = 0;
      double square = 0;  // 1: the other side knows this component
      for (const auto& [along, given] : one) {
        const double share = dot(along, held.first);
        value += share * given;
        square += share * share;
      }
      return square > 1 - same &&
             !areAlike(value, held.second,
                       std::max(std::abs(value), std::abs(held.second)), body);
    };
    if (std::any_of(other.begin(), other.end(), differs))
      warn.once(message("jump ", body.name, corner.x, corner.y), "Bodies->", body.name,
                "->Boundary Conditions: '", edge.boundary, "' and '", next.boundary,
                "' prescribe different displacements of their corner (", corner.x, ", ",
                corner.y,
                "); a jump has no finite energy: stresses there grow with every level");
  });
}

/// A function need not exist where no run looks at it.
std::optional<double> valueAt(const bem::Function& function,
                              const bem::SurfacePoint& place) {
  try {
    return function(place);
  } catch (const bem::InputError&) {
    return std::nullopt;
  }
}

/// Contacts with friction at a line of symmetry whose other surface slides along there: its mirror
/// image slides against it.
void findSlidingAcross(const Body& body, const contact::Conditions& conditions,
                       Warnings& warn) {
  const auto compare = [&](const bem::Edge& line, const bem::Edge& side, double end) {
    const auto contact = conditions.contact.find(side.boundary);
    if (conditions.isBoundary(line.boundary) || contact == conditions.contact.end() ||
        !contact->second.sliding || contact->second.friction.law == nullptr)
      return;
    const std::optional<double> slid =
        valueAt(contact->second.sliding, pointOf(body, side, end));
    if (slid && !areAlike(*slid, 0, 0, body))
      warn.once(
          "slid " + contact->second.path, contact->second.path, ": Sliding is ", *slid,
          " on the line of symmetry, where the mirror image slides the other way: it "
          "jumps there; let it be zero on the line, or draw the whole");
  };
  forEachCorner(body, [&](const bem::Edge& edge, const bem::Edge& next, bem::Vec2) {
    compare(edge, next, -1);
    compare(next, edge, 1);
  });
}

/// The half of an interval with the larger difference, and again of that.
template <class F>
std::pair<double, double> steepest(double low, double high, const F& at) {
  constexpr int halvings = 40;
  for (int halved = 0; halved < halvings; ++halved) {
    const double middle = (low + high) / 2;
    const double value = at(middle);
    (std::abs(value - at(low)) > std::abs(at(high) - value) ? high : low) = middle;
  }
  return {low, high};
}

/// A jump of what is prescribed on a boundary: on an edge, between samples whose difference departs
/// most from those beside it, or beside these, where it is steepest; a continuous function leaves
/// nothing of it.  Or where two edges meet, whose normals differ, unless it is `alongNormals`.
void findJump(const Body& body, const std::string& path, const std::string& boundary,
              const bem::Function& given, const char* consequence, Warnings& warn,
              bool alongNormals = false) {
  constexpr int samples = 400;
  constexpr double share = 0.2;
  constexpr double rounding = 1e-6;  // of what areAlike compares with
  if (!given)
    return;
  const auto on = [&](const bem::Edge& edge, double t) {
    return valueAt(given, pointOf(body, edge, t)).value_or(std::nan(""));
  };
  const auto tell = [&](double jump, double size, bem::Vec2 x) {
    if (std::isfinite(jump) && !areAlike(jump, 0, size, body))
      warn.once("jump " + path, path, ": jumps by ", jump, " at (", x.x, ", ", x.y, "); ",
                consequence, "; let it rise over some length");
  };
  double largest = 0;
  for (const bem::Edge& edge : body.outline->edges()) {
    if (edge.boundary != boundary)
      continue;
    const auto at = [&](double t) { return on(edge, t); };
    const auto place = [](int k) { return -1 + 2.0 * k / samples; };
    const auto step = [&](int k) { return at(place(k + 1)) - at(place(k)); };
    double excess = 0;
    double size = 0;
    int farthest = 1;
    for (int k = 1; k + 1 < samples; ++k) {
      size = std::max(size, std::abs(at(place(k))));
      if (const double here = std::abs(2 * step(k) - step(k - 1) - step(k + 1));
          here > excess) {
        excess = here;
        farthest = k;
      }
    }
    largest = std::max(largest, size);
    for (const int k : {farthest - 1, farthest, farthest + 1}) {
      const auto [low, high] = steepest(place(k), place(k + 1), at);
      const double before = at(low);
      const double jump = at(high) - before;
      if (std::abs(jump) > share * excess)
        tell(jump, std::max(std::abs(before), rounding * size), pointOf(body, edge, low));
    }
  }
  forEachCorner(body,
                [&](const bem::Edge& edge, const bem::Edge& next, bem::Vec2 corner) {
                  if (edge.boundary == boundary && next.boundary == boundary &&
                      (!alongNormals || bem::joinSmoothly(edge.curve, next.curve)))
                    tell(on(next, -1) - on(edge, 1), largest, corner);
                });
}

/// Beside an end of a side, to where it would go on: a gap need not exist at corners.
std::optional<double> gapAtEnd(const bem::Function& gap, const Body& body,
                               const bem::Edge& side, double end) {
  constexpr double aside = 1e-9;  // of the side
  const auto gapAt = [&](double distance) {
    return valueAt(gap, pointOf(body, side, end * (1 - distance)));
  };
  const auto near = gapAt(aside);
  const auto farther = gapAt(2 * aside);
  if (!near || !farther)
    return std::nullopt;
  return 2 * *near - *farther;
}

/// Corners where a prescribed displacement goes through the obstacle of the side beside it, one
/// warning for each pair of boundaries.
void findPressedCorners(const Body& body, const contact::Conditions& conditions,
                        Warnings& warn) {
  constexpr double same = 1e-6;
  const auto compare = [&](const bem::Edge& given, const bem::Edge& side, double end,
                           bem::Vec2 corner) {
    const auto held = conditions.dirichlet.find(given.boundary);
    const auto contact = conditions.contact.find(side.boundary);
    if (held == conditions.dirichlet.end() || contact == conditions.contact.end() ||
        !contact->second.name.empty() || contact->second.ties())
      return;
    // a component that is free can give way
    const auto& [x, y] = held->second;
    const bem::Vec2 n = side.curve.normal(end);
    if ((!x && std::abs(n.x) > same) || (!y && std::abs(n.y) > same))
      return;
    const bem::SurfacePoint there = pointOf(body, given, -end);
    const bem::Vec2 moved{x ? x(there) : 0, y ? y(there) : 0};
    const double closing = dot(moved, n);
    const auto gap = gapAtEnd(contact->second.gap, body, side, end);
    if (gap && closing > *gap &&
        !areAlike(closing, *gap, std::abs(moved.x) + std::abs(moved.y), body))
      warn.once(
          "corner " + body.name + given.boundary + "|" + side.boundary, "Bodies->",
          body.name, "->Boundary Conditions: '", given.boundary,
          "' moves its corner with '", side.boundary, "', (", corner.x, ", ", corner.y,
          "), by ", closing, " along the normal where the gap is ", *gap,
          ": through the obstacle; such a jump has no finite energy, and stresses there "
          "grow with every level");
  };
  forEachCorner(body,
                [&](const bem::Edge& edge, const bem::Edge& next, bem::Vec2 corner) {
                  compare(edge, next, -1, corner);
                  compare(next, edge, 1, corner);
                });
}

/// The force of a traction on some elements, and the integral of its size.
struct Force {
  bem::Vec2 sum;
  double size = 0;
};

Force forceOf(const contact::Conditions::Neumann& traction, const bem::Mesh& mesh,
              const std::vector<int>& elements, const bem::Rule& rule) {
  Force force;
  for (const int e : elements)
    for (int q = 0; q < rule.size(); ++q) {
      const bem::SurfacePoint x = mesh.physicalPoint(e, rule.points[q]);
      const bem::Vec2 part = rule.weights[q] * mesh.measure(e, rule.points[q]) *
                             mesh.outline().units(1).measure() * traction.at(x);
      force.sum = force.sum + part;
      force.size += norm(part);
    }
  return force;
}

/// Tractions that change between the points at which a mesh takes them on one of a boundary's edges.
void findNarrowLoad(const Body& body, const bem::Mesh& mesh, const std::string& boundary,
                    const contact::Conditions::Neumann& traction, Warnings& warn) {
  constexpr double far = 0.1;
  constexpr double points = 4096;  // of the boundary, about
  constexpr std::size_t order = 16;
  std::map<int, std::vector<int>> edges;
  double whole = 0;
  for (const int e : mesh.elementsOf(boundary)) {
    edges[mesh[e].piece.edge].push_back(e);
    whole += mesh[e].half;
  }
  std::vector<std::pair<Force, Force>> forces;
  double largest = 0;
  for (const auto& [edge, elements] : edges) {
    const double share = 0.5 * mesh.outline().edge(edge).curve.length() / whole;
    const int pieces = 1 + static_cast<int>(share * points /
                                            static_cast<double>(order * elements.size()));
    bem::Vector breaks;
    for (int k = 1; k < pieces; ++k)
      breaks.push_back(-1 + 2.0 * k / pieces);
    try {
      forces.emplace_back(
          forceOf(traction, mesh, elements, bem::gaussForGiven(body.degree)),
          forceOf(traction, mesh, elements, bem::piecewiseRule(breaks, order)));
    } catch (const bem::InputError&) {
      continue;
    }
    largest = std::max({largest, forces.back().first.size, forces.back().second.size});
  }
  for (const auto& [used, fine] : forces)
    if (norm(used.sum - fine.sum) >
        far * std::max({used.size, fine.size, 1e-6 * largest}))
      warn.once(
          "load " + body.name + boundary, "Bodies->", body.name,
          "->Boundary Conditions->", boundary,
          ": the traction is narrower than its elements can see: on one edge they take a "
          "force of (",
          used.sum.x, ", ", used.sum.y, "), a finer rule finds (", fine.sum.x, ", ",
          fine.sum.y,
          "); use more elements there (Discretization), or a vertex where the load "
          "begins and one where it ends");
}

/// Coefficients of friction that no surface has, and obstacles deep in a body.
void findImplausible(const Body& body, const contact::Conditions& conditions,
                     Warnings& warn) {
  constexpr double most = 3;
  constexpr double deepest = 0.02;  // of the body
  for (const bem::Edge& edge : body.outline->edges()) {
    const auto found = conditions.contact.find(edge.boundary);
    if (found == conditions.contact.end())
      continue;
    const contact::Conditions::Contact& contact = found->second;
    const bem::SurfacePoint middle = pointOf(body, edge, 0);
    if (contact.friction && contact.friction.law->dependsOnPressure() &&
        !contact.friction.law->knowsPlace()) {
      const auto shear = valueAt(
          [&](const bem::SurfacePoint& x) {
            return contact.friction.at(x, 1).slope(1e-12);
          },
          middle);
      if (shear && *shear > most)
        warn.once("friction " + contact.path, contact.path,
                  "->Friction->Coefficient: is ", *shear,
                  ": shear may be so many times the pressure; surfaces have 0.1 to 1, "
                  "and 30 % is 0.3");
    }
    const auto gap = valueAt(contact.gap, middle);
    if (contact.name.empty() && !contact.ties() && gap &&
        *gap < -deepest * body.outline->diameter())
      warn.once("gap " + contact.path, contact.path, "->Gap: is ", *gap, " at (",
                middle.x, ", ", middle.y,
                "): the obstacle stands deep in the body, where strains are not small; a "
                "gap > 0 is a distance");
  }
}

/// What a body's conditions at some time say that is probably not meant.
void findInConditions(const Body& body, const contact::Conditions& conditions,
                      Warnings& warn) {
  const char* const consequence =
      "a jump has no finite energy, between edges neither: stresses there grow with "
      "every "
      "level";
  for (const auto& [boundary, given] : conditions.dirichlet)
    for (const auto& [axis, along] : {std::pair("->Displacement X", &given.x),
                                      std::pair("->Displacement Y", &given.y)})
      findJump(body,
               message("Bodies->", body.name, "->Boundary Conditions->", boundary, axis),
               boundary, *along, consequence, warn);
  for (const auto& [boundary, contact] : conditions.contact)
    if (contact.isSupport)
      findJump(body, contact.path, boundary, contact.gap, consequence, warn, true);
  if (conditions.heat)
    for (const auto& [boundary, given] : conditions.heat->temperatures)
      findJump(
          body, message(conditions.heat->path, "->", boundary, "->Temperature"), boundary,
          given,
          "a temperature does not jump, between edges neither: heat flows there grow "
          "with every level",
          warn);
  findJumps(body, conditions, warn);
  findSlidingAcross(body, conditions, warn);
  findPressedCorners(body, conditions, warn);
  findImplausible(body, conditions, warn);
  if (conditions.neumann.empty())
    return;
  const bem::Mesh mesh = firstMesh(body);
  for (const auto& [boundary, traction] : conditions.neumann)
    findNarrowLoad(body, mesh, boundary, traction, warn);
}

}  // namespace

void findInConditions(const Scene& scene, Warnings& warn) {
  for (const Body& body : scene.bodies)
    findInConditions(body, body.conditions, warn);
  constexpr std::size_t most = 12;
  const std::vector<double>& times = scene.history.times;
  const std::size_t stride = times.size() / most + 1;
  for (std::size_t k = 0; k + 1 < times.size(); k += stride) {
    const std::vector<contact::Conditions> now = scene.conditionsAt(times[k]);
    for (std::size_t b = 0; b < now.size(); ++b)
      findInConditions(scene.bodies[b], now[b], warn);
  }
}

}  // namespace epafi::drivers
