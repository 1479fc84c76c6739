#include "contact/compressed/CompressedStiffness.hpp"

#include "contact/body/Coupling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::contact {

namespace {

/// Calls visit(coefficient, mesh element) for the coefficients of the contact elements of a body.
template <class Visit>
void forEachHome(const MultiplierSpace& multiplier, std::size_t body,
                 const Visit& visit) {
  for (const MultiplierSpace::ContactElement& contact : multiplier.elements(body))
    for (int i = 0; i <= contact.degree; ++i) {
      visit(at(contact.normalOf(i)), contact.element);
      if (contact.shears())
        visit(at(contact.tangentialOf(i)), contact.element);
    }
}

/// Elements to which the coefficients of a body are assigned.  A leaf shall have no more coefficients
/// than displacements coupled to them: among the elements that number displacements
/// coupled to it, the one with the largest entry, preferably within the support of its
/// function.  Tangential coefficients go to the element of their pressure.  Control
/// points, whose bounds depend on all pressures of an element, go to that element.
void assignElements(const bem::Space& space, const MultiplierSpace& multiplier,
                    std::size_t body, const Coupling& coupling,
                    std::vector<int>& elements) {
  if (multiplier.basis().controlPoints) {
    forEachHome(multiplier, body, [&](std::size_t k, int e) { elements[k] = e; });
    return;
  }
  std::vector<int> elementOf(at(space.displacements()));
  for (int e = 0; e < space.mesh().size(); ++e)
    for (Index i = space.displacement(e, 0, 0);
         i < space.displacement(e, 0, 0) + 2 * space.mesh()[e].degree; ++i)
      elementOf[at(i)] = e;
  std::vector<std::vector<int>> homes(elements.size());
  forEachHome(multiplier, body, [&](std::size_t k, int e) { homes[k].push_back(e); });
  constexpr double rounding = 1e-6;
  Vector largest(elements.size(), 0.0);
  for (const bem::Entry& entry : coupling.trace.entries) {
    const int e = elementOf[at(entry.row)];
    const std::vector<int>& own = homes[at(entry.column)];
    if (own.empty())  // on another body
      continue;
    const double work = std::abs(entry.value) *
                        (std::count(own.begin(), own.end(), e) > 0 ? 1 : rounding);
    if (work > largest[at(entry.column)]) {
      largest[at(entry.column)] = work;
      elements[at(entry.column)] = e;
    }
  }
  for (const MultiplierSpace::ContactElement& contact : multiplier.elements(body))
    for (int i = 0; i <= contact.degree && contact.shears(); ++i)
      elements[at(contact.tangentialOf(i))] = elements[at(contact.normalOf(i))];
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
  local.elements.resize(at(multiplier.size()));
  local.bodies.resize(at(multiplier.size()));
  Index first = 0;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const bem::Space& space = *spaces[b];
    const Index densities = first + space.displacements();
    const Coupling own = stabilised(std::move(couplings[b]), space, multiplier, b,
                                    stabilization, lames[b], units);
    for (const bem::Entry& entry : own.trace.entries)
      local.entries.push_back({first + entry.row, further + entry.column, entry.value});
    local.rotations.push_back(space.rotation() ? own.trace.rests
                                               : Vector(at(multiplier.size())));
    for (const bem::Entry& entry : own.weights)
      local.entries.push_back({densities + own.compliance.densities[at(entry.row)],
                               further + entry.column, -entry.value});
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
    assignElements(space, multiplier, b, own, local.elements);
    for (const Index i : multiplier.columns(b))
      local.bodies[at(i)] = static_cast<int>(b);
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
