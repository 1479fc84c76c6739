#include "contact/stabilization/StabilisedStiffness.hpp"

#include "bem/mesh/Surfaces.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

using bem::Element;

namespace {

/// The mean of one component of ψ on the longest element of an edge, the first of equal ones, held
/// with a part of its own diagonal in V.  That of the outer line is small, so that the change of volume
/// that it lets through is below the error: some 1e-10 of the energy of shells of 1 : 1 to 1 : 19.  With
/// 1e-4 in place of 1e-2 rounding there is 5e-9 in place of 1e-10.  Round holes, also those that end at an
/// axis, any displacement is compatible.
std::pair<Index, double> pinOn(const bem::Space& space, int edge) {
  int longest = -1;
  for (int e = 0; e < space.mesh().size(); ++e)
    if (space.mesh()[e].piece.edge == edge &&
        (longest < 0 || space.mesh()[e].half > (1 + 1e-9) * space.mesh()[longest].half))
      longest = e;
  const Element& element = space.mesh()[longest];
  const bem::Vec2 normal = element.curve.normal(0);
  const double measure = space.mesh().measure(longest, 0);
  const std::vector<int> outer = bem::surfacesOf(space.mesh()).front().elements;
  const bool isHole = std::find(outer.begin(), outer.end(), longest) == outer.end();
  return {space.density(longest, 0, std::abs(normal.x) > std::abs(normal.y) ? 0 : 1),
          (isHole ? 1 : 1e-2) * measure * measure};
}

}  // namespace

std::vector<int> stabilisedElements(const bem::Mesh& mesh, const Conditions& conditions,
                                    const Stabilization& stabilization) {
  std::vector<int> elements;
  for (int e = 0; e < mesh.size(); ++e)
    if (contactOn(mesh, e, conditions) != nullptr)
      elements.push_back(e);
  for (int e = 0; e < mesh.size() && stabilization.byDensity(); ++e)
    if (const bem::Piece& piece = mesh[e].piece;
        contactOn(mesh, e, conditions) == nullptr &&
        conditions.faces(piece.edge, piece.start.fromStart, piece.end.fromStart))
      elements.push_back(e);
  return elements;
}

bem::Space makeSpace(const bem::Mesh& mesh, const Conditions& conditions,
                     const Stabilization& stabilization) {
  std::vector<int> densities;
  for (int e = 0; e < mesh.size(); ++e)
    densities.push_back(mesh[e].degree);
  if (stabilization.byDensity() && stabilization.raised)
    for (const int e : stabilisedElements(mesh, conditions, stabilization))
      densities[at(e)] = std::min(mesh[e].degree + 1, bem::largestDegree);
  return bem::Space(mesh.withDensities(densities));
}

bem::LocalCompliance densityCompliance(const bem::Space& space,
                                       const Conditions& conditions,
                                       const Stabilization& stabilization,
                                       const bem::Lame& lame, bem::Units units) {
  bem::LocalCompliance compliance;
  if (!stabilization.byDensity())
    return compliance;
  for (const int e : stabilisedElements(space.mesh(), conditions, stabilization)) {
    const Element& element = space.mesh()[e];
    const double gamma = gammaOn(space.mesh(), e, stabilization, lame, units);
    for (int i = 0; i < element.densities; ++i)
      for (int c = 0; c < 2; ++c) {
        compliance.densities.push_back(space.density(e, i, c));
        compliance.diagonal.push_back(gamma * 2 * space.mesh().measure(e, 0) /
                                      (2 * i + 1));
      }
  }
  for (const int edge : conditions.pins)
    compliance.pinned.push_back(pinOn(space, edge));
  return compliance;
}

bem::SteklovPoincare makeStiffness(const bem::Space& space, const Conditions& conditions,
                                   const Stabilization& stabilization,
                                   const bem::Lame& lame, bem::Units units) {
  return bem::SteklovPoincare(
      bem::assembleOperators(space, lame),
      densityCompliance(space, conditions, stabilization, lame, units));
}

}  // namespace epafi::contact
