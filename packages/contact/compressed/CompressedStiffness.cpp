#include "contact/compressed/CompressedStiffness.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/opposite/TraceCoupling.hpp"
#include "contact/problem/Numbering.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

namespace {

/// Calls visit(coefficient, mesh element) for the coefficients of all contact elements.
template <class Visit>
void forEachHome(const MultiplierSpace& multiplier, const Visit& visit) {
  for (const MultiplierSpace::ContactElement& contact : multiplier.elements())
    for (int i = 0; i <= contact.degree; ++i) {
      visit(at(contact.normalOf(i)), contact.element);
      if (contact.tangential >= 0)
        visit(at(contact.tangentialOf(i)), contact.element);
    }
}

/// Element to which each coefficient is assigned.  A leaf shall have no more coefficients
/// than displacements coupled to them: among the elements that number displacements
/// coupled to it, the one with the largest entry, preferably within the support of its
/// function.  Tangential coefficients go to the element of their pressure.  Control
/// points, whose bounds depend on all pressures of an element, go to that element.
std::vector<int> elementsOf(const bem::Space& space, const MultiplierSpace& multiplier,
                            const Coupling& coupling) {
  std::vector<int> elements(at(multiplier.size()), 0);
  if (multiplier.basis().controlPoints) {
    forEachHome(multiplier, [&](std::size_t k, int e) { elements[k] = e; });
    return elements;
  }
  std::vector<int> elementOf(at(space.displacements()));
  for (int e = 0; e < space.mesh().size(); ++e)
    for (Index i = space.displacement(e, 0, 0);
         i < space.displacement(e, 0, 0) + 2 * space.mesh()[e].degree; ++i)
      elementOf[at(i)] = e;
  std::vector<std::vector<int>> homes(elements.size());
  forEachHome(multiplier, [&](std::size_t k, int e) { homes[k].push_back(e); });
  constexpr double rounding = 1e-6;
  Vector largest(elements.size(), 0.0);
  for (const bem::Entry& entry : coupling.trace.entries) {
    const int e = elementOf[at(entry.row)];
    const std::vector<int>& own = homes[at(entry.column)];
    const double work = std::abs(entry.value) *
                        (std::count(own.begin(), own.end(), e) > 0 ? 1 : rounding);
    if (work > largest[at(entry.column)]) {
      largest[at(entry.column)] = work;
      elements[at(entry.column)] = e;
    }
  }
  for (const MultiplierSpace::ContactElement& contact : multiplier.elements())
    for (int i = 0; i <= contact.degree && contact.tangential >= 0; ++i)
      elements[at(contact.tangentialOf(i))] = elements[at(contact.normalOf(i))];
  return elements;
}

Numbering numberingOf(const std::vector<CompressedInput>& bodies) {
  std::vector<Numbering::Count> counts;
  counts.reserve(bodies.size());
  for (const CompressedInput& body : bodies)
    counts.push_back({body.multiplier.normals(), body.multiplier.size()});
  return Numbering(counts);
}

}  // namespace

std::string whyNotCompressed(const Stabilization& stabilization) {
  if (stabilization.tractions())
    return "Discretization->Stabilization->Form must be Density, or None with the "
           "multiplier Biorthogonal";
  return "";
}

CompressedCoupling makeCompressedCoupling(const std::vector<CompressedInput>& bodies,
                                          const Stabilization& stabilization,
                                          bem::Units units) {
  const Numbering numbering = numberingOf(bodies);
  CompressedCoupling result;
  result.multipliers = numbering.size();
  result.normals = numbering.normals();
  std::vector<Index> starts;
  for (const CompressedInput& body : bodies) {
    starts.push_back(result.first);
    result.first += body.space.displacements() + body.space.densities();
  }
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    const auto& [space, multiplier, lame, opposite] = bodies[a];
    const auto numberOf = [&](Index i) { return numbering(a, i); };
    result.addOwn(space, makeCoupling(space, multiplier, stabilization, lame, units), a,
                  starts[a], numberOf);
    if (opposite == nullptr)
      continue;
    for (const int b : opposite->bodies())
      result.add(
          mortarCoupling(space.mesh(), multiplier, *opposite, bodies[at(b)].space, b),
          at(b), starts[at(b)], numberOf);
  }
  return result;
}

std::vector<bem::SteklovPoincare> makeCompressedStiffness(
    const std::vector<CompressedInput>& bodies, const Stabilization& stabilization,
    bem::Units units, const bem::Processes& processes, const bem::Compression& options) {
  const std::string reason = whyNotCompressed(stabilization);
  if (!reason.empty())
    throw bem::InputError("the operators cannot be compressed: " + reason);
  const CompressedCoupling coupling =
      makeCompressedCoupling(bodies, stabilization, units);
  bem::LocalCoupling local;
  for (const bem::Entry& entry : coupling.entries)
    local.entries.push_back({entry.row, coupling.first + entry.column, entry.value});
  for (const bem::Entry& entry : coupling.mass)
    if (entry.row >= entry.column)
      local.entries.push_back(
          {coupling.first + entry.row, coupling.first + entry.column, -entry.value});
  const Numbering numbering = numberingOf(bodies);
  local.rotations.assign(bodies.size(), Vector(at(coupling.multipliers)));
  for (const CompressedCoupling::Rest& rest : coupling.rests)
    bem::axpy(1, rest.values, local.rotations[rest.body]);
  local.elements.resize(at(coupling.multipliers));
  local.bodies.resize(at(coupling.multipliers));
  std::vector<bem::CompressedOperators::Body> operands;
  Index first = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto& [space, multiplier, lame, opposite] = bodies[b];
    operands.push_back({space, lame});
    const Coupling own = makeCoupling(space, multiplier, stabilization, lame, units);
    const std::vector<int> elements = elementsOf(space, multiplier, own);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Index k = numbering(b, static_cast<Index>(i));
      local.elements[at(k)] = elements[i];
      local.bodies[at(k)] = static_cast<int>(b);
    }
    first += space.displacements();
    const auto comply = [&](Index density, double value) {
      local.entries.push_back({first + density, first + density, -value});
    };
    for (std::size_t k = 0; k < own.compliance.densities.size(); ++k)
      comply(own.compliance.densities[k], own.compliance.diagonal[k]);
    for (const auto& [density, value] : own.compliance.pinned)
      comply(density, value);
    first += space.densities();
  }
  const auto operators = std::make_shared<const bem::CompressedOperators>(
      operands, options, local, processes);
  std::vector<bem::SteklovPoincare> result;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    result.emplace_back(operators, b);
  return result;
}

}  // namespace epafi::contact
