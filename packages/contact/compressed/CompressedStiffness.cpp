#include "contact/compressed/CompressedStiffness.hpp"

#include "contact/body/Coupling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::contact {

namespace {

/// Element to which each coefficient is assigned.  A leaf shall have no more coefficients
/// than displacements coupled to them: among the elements that number displacements
/// coupled to it, the one with the largest entry, preferably within the support of its
/// function.  Tangential coefficients go to the element of their pressure.  Control
/// points, whose bounds depend on all pressures of an element, go to that element.
std::vector<int> elementsOf(const std::vector<const bem::Space*>& spaces,
                            const MultiplierSpace& multiplier,
                            const std::vector<Coupling>& couplings,
                            const std::vector<int>& bodies) {
  std::vector<int> elements(bodies.size());
  std::vector<std::vector<int>> homes(bodies.size());
  multiplier.forEachElement([&](const auto& contact) {
    for (int i = 0; i < contact.coefficients(); ++i) {
      elements[at(contact.numberOf(i))] = contact.element;
      homes[at(contact.numberOf(i))].push_back(contact.element);
    }
  });
  if (multiplier.basis().controlPoints)
    return elements;
  constexpr double rounding = 1e-6;
  Vector largest(elements.size(), 0.0);
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const bem::Space& space = *spaces[b];
    std::vector<int> elementOf(at(space.displacements()));
    for (int e = 0; e < space.mesh().size(); ++e)
      for (Index i = space.displacement(e, 0, 0);
           i < space.displacement(e, 0, 0) + 2 * space.mesh()[e].degree; ++i)
        elementOf[at(i)] = e;
    for (const bem::Entry& entry : couplings[b].trace.entries) {
      const std::size_t k = at(entry.column);
      const int e = elementOf[at(entry.row)];
      const double work =
          std::abs(entry.value) *
          (std::count(homes[k].begin(), homes[k].end(), e) > 0 ? 1 : rounding);
      if (bodies[k] == static_cast<int>(b) && work > largest[k]) {
        largest[k] = work;
        elements[k] = e;
      }
    }
  }
  multiplier.forEachElement([&](const auto& contact) {
    for (int i = 0; i <= contact.degree && contact.shears(); ++i)
      elements[at(contact.tangentialOf(i))] = elements[at(contact.normalOf(i))];
  });
  return elements;
}

/// The sparse matrices of all multipliers and bodies, and where the multipliers belong.
bem::LocalCoupling localCoupling(const std::vector<const bem::Space*>& spaces,
                                 const std::vector<bem::Lame>& lames,
                                 const MultiplierSpace& multiplier,
                                 const Opposite& opposite,
                                 const Stabilization& stabilization, bem::Units units) {
  std::vector<Coupling> couplings = makeCouplings(spaces, multiplier, opposite);
  Index further = 0;
  for (const bem::Space* space : spaces)
    further += space->displacements() + space->densities();
  bem::LocalCoupling local;
  local.bodies.resize(at(multiplier.size()));
  for (std::size_t b = 0; b < spaces.size(); ++b)
    for (const Index i : multiplier.columns(b))
      local.bodies[at(i)] = static_cast<int>(b);
  local.elements = elementsOf(spaces, multiplier, couplings, local.bodies);
  Index first = 0;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const bem::Space& space = *spaces[b];
    const Index densities = first + space.displacements();
    const Coupling own = stabilised(std::move(couplings[b]), space, multiplier, b,
                                    stabilization, lames[b], units);
    for (const bem::Entry& entry : own.withDensities(space.displacements()).entries)
      local.entries.push_back({first + entry.row, further + entry.column, entry.value});
    local.rotations.push_back(own.trace.rests);
    for (const bem::Entry& entry : own.mass)
      if (entry.row >= entry.column)
        local.entries.push_back(
            {further + entry.row, further + entry.column, -entry.value});
    const auto comply = [&](Index density, double value) {
      local.entries.push_back({densities + density, densities + density, -value});
    };
    for (std::size_t k = 0; k < own.compliance.densities.size(); ++k)
      comply(own.compliance.densities[k], own.compliance.diagonal[k]);
    for (const auto& [density, value] : own.compliance.pinned)
      comply(density, value);
    first = densities + space.densities();
  }
  return local;
}

}  // namespace

std::string whyNotCompressed(const Stabilization& stabilization) {
  if (stabilization.tractions())
    return "Discretization->Stabilization->Form must be Density, or None with the "
           "multiplier Biorthogonal";
  return "";
}

std::vector<bem::SteklovPoincare> makeCompressedStiffness(
    const std::vector<const bem::Space*>& spaces, const std::vector<bem::Lame>& lames,
    const MultiplierSpace& multiplier, const Opposite& opposite,
    const Stabilization& stabilization, bem::Units units, const bem::Processes& processes,
    const bem::Compression& options) {
  const std::string reason = whyNotCompressed(stabilization);
  if (!reason.empty())
    throw bem::InputError("the operators cannot be compressed: " + reason);
  std::vector<bem::CompressedOperators::Body> operands;
  for (std::size_t b = 0; b < spaces.size(); ++b)
    operands.push_back({*spaces[b], lames[b]});
  const auto operators = std::make_shared<const bem::CompressedOperators>(
      operands, options,
      localCoupling(spaces, lames, multiplier, opposite, stabilization, units),
      processes);
  std::vector<bem::SteklovPoincare> result;
  for (std::size_t b = 0; b < spaces.size(); ++b)
    result.emplace_back(operators, b);
  return result;
}

}  // namespace epafi::contact
