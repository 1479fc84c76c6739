#include "contact/compressed/CompressedStiffness.hpp"

#include "contact/body/Beddings.hpp"
#include "contact/body/Coupling.hpp"
#include "contact/problem/BodyFlexibility.hpp"

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

/// Adds G to the diagonal of densities, the first of which has this number.
void addCompliance(const Coupling& own, Index densities,
                   std::vector<bem::Entry>& entries) {
  const auto comply = [&](Index density, double value) {
    entries.push_back({densities + density, densities + density, -value});
  };
  for (std::size_t k = 0; k < own.compliance.densities.size(); ++k)
    comply(own.compliance.densities[k], own.compliance.diagonal[k]);
  for (const auto& [density, value] : own.compliance.pinned)
    comply(density, value);
}

/// The sparse matrices of all multipliers and bodies, and where the multipliers belong.
/// \param couplings  stabilised  \param elements  see elementsOf
bem::LocalCoupling localCoupling(const std::vector<const bem::Space*>& spaces,
                                 const std::vector<Coupling>& couplings,
                                 std::vector<int> bodies, std::vector<int> elements) {
  bem::LocalCoupling local;
  local.bodies = std::move(bodies);
  local.elements = std::move(elements);
  Index further = 0;
  for (const bem::Space* space : spaces)
    further += space->displacements() + space->densities();
  Index first = 0;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const bem::Space& space = *spaces[b];
    const Index densities = first + space.displacements();
    const Coupling& own = couplings[b];
    for (const bem::Entry& entry : own.withDensities(space.displacements()).entries)
      local.entries.push_back({first + entry.row, further + entry.column, entry.value});
    local.rotations.push_back(own.trace.rests);
    for (const bem::Entry& entry : own.mass)
      if (entry.row >= entry.column)
        local.entries.push_back(
            {further + entry.row, further + entry.column, -entry.value});
    addCompliance(own, densities, local.entries);
    first = densities + space.densities();
  }
  return local;
}

/// Is D formed by bodies, each in a tree of its own?
bool areApart(const std::vector<Coupling>& couplings, Index size, Index formedUpTo) {
  std::vector<std::vector<Index>> columns;
  std::size_t most = 0;
  for (const Coupling& own : couplings)
    most = std::max(most, columns.emplace_back(own.columns()).size());
  return couplings.size() > 1 &&
         (size <= formedUpTo || (static_cast<Index>(most) <= formedUpTo &&
                                 BodyFlexibility::isSparse(size, columns)));
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
    const bem::Compression& options, Index formedUpTo) {
  const std::string reason = whyNotCompressed(stabilization);
  if (!reason.empty())
    throw bem::InputError("the operators cannot be compressed: " + reason);
  std::vector<int> bodies(at(multiplier.size()));
  for (std::size_t b = 0; b < spaces.size(); ++b)
    for (const Index i : multiplier.columns(b))
      bodies[at(i)] = static_cast<int>(b);
  std::vector<Coupling> couplings = makeCouplings(spaces, multiplier, opposite);
  const Beddings beddings = makeBeddings(spaces, lames, multiplier, couplings);
  std::vector<int> elements = elementsOf(spaces, multiplier, couplings, bodies);
  for (std::size_t b = 0; b < spaces.size(); ++b)
    couplings[b] = stabilised(std::move(couplings[b]), *spaces[b], multiplier, b,
                              stabilization, lames[b], units);
  std::vector<bem::SteklovPoincare> result;
  if (beddings.depth > 0 || areApart(couplings, multiplier.size(), formedUpTo)) {
    for (std::size_t b = 0; b < spaces.size(); ++b) {
      if (!beddings.of[b].rows.empty()) {
        result.push_back(makeStiffness(*spaces[b], multiplier.conditions(b),
                                       stabilization, lames[b], units));
        continue;
      }
      bem::LocalCoupling local;
      addCompliance(couplings[b], spaces[b]->displacements(), local.entries);
      result.emplace_back(std::make_shared<const bem::CompressedOperators>(
          *spaces[b], lames[b], options, local, processes));
    }
    return result;
  }
  std::vector<bem::CompressedOperators::Body> operands;
  for (std::size_t b = 0; b < spaces.size(); ++b)
    operands.push_back({*spaces[b], lames[b]});
  const auto operators = std::make_shared<const bem::CompressedOperators>(
      operands, options,
      localCoupling(spaces, couplings, std::move(bodies), std::move(elements)),
      processes);
  for (std::size_t b = 0; b < spaces.size(); ++b)
    result.emplace_back(operators, b);
  return result;
}

}  // namespace epafi::contact
