#include "contact/compressed/CompressedStiffness.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/body/Coupling.hpp"

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
      if (contact.shears())
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
    for (int i = 0; i <= contact.degree && contact.shears(); ++i)
      elements[at(contact.tangentialOf(i))] = elements[at(contact.normalOf(i))];
  return elements;
}

/// The sparse matrices of all multipliers and bodies, and where the multipliers belong.
bem::LocalCoupling localCoupling(const std::vector<ContactSide>& bodies,
                                 const std::vector<bem::Lame>& lames,
                                 const Stabilization& stabilization, bem::Units units) {
  const Numbering numbering(bodies);
  const std::vector<TraceCoupling> opposite = oppositeCouplings(bodies, numbering);
  Index further = 0;
  for (const ContactSide& body : bodies)
    further += body.space.displacements() + body.space.densities();
  bem::LocalCoupling local;
  local.elements.resize(at(numbering.size()));
  local.bodies.resize(at(numbering.size()));
  Index first = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto& [space, multiplier, opposed] = bodies[b];
    const Index densities = first + space.displacements();
    const Coupling own =
        makeCoupling(space, multiplier, opposed, stabilization, lames[b], units);
    const auto numberOf = [&, b](Index i) { return further + numbering(b, i); };
    Vector& rests = local.rotations.emplace_back(at(numbering.size()));
    for (const bem::Entry& entry : own.trace.entries)
      local.entries.push_back({first + entry.row, numberOf(entry.column), entry.value});
    for (std::size_t i = 0; space.rotation() && i < own.trace.rests.size(); ++i)
      rests[at(numbering(b, static_cast<Index>(i)))] = own.trace.rests[i];
    for (const bem::Entry& entry : opposite[b].entries)
      local.entries.push_back({first + entry.row, further + entry.column, entry.value});
    if (space.rotation() && !opposite[b].rests.empty())
      bem::axpy(1, opposite[b].rests, rests);
    for (const bem::Entry& entry : own.weights)
      local.entries.push_back({densities + own.compliance.densities[at(entry.row)],
                               numberOf(entry.column), -entry.value});
    for (const bem::Entry& entry : own.mass)
      if (entry.row >= entry.column)
        local.entries.push_back(
            {numberOf(entry.row), numberOf(entry.column), -entry.value});
    const auto comply = [&](Index density, double value) {
      local.entries.push_back({densities + density, densities + density, -value});
    };
    for (std::size_t k = 0; k < own.compliance.densities.size(); ++k)
      comply(own.compliance.densities[k], own.compliance.diagonal[k]);
    for (const auto& [density, value] : own.compliance.pinned)
      comply(density, value);
    const std::vector<int> elements = elementsOf(space, multiplier, own);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Index k = numbering(b, static_cast<Index>(i));
      local.elements[at(k)] = elements[i];
      local.bodies[at(k)] = static_cast<int>(b);
    }
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
    const std::vector<ContactSide>& bodies, const std::vector<bem::Lame>& lames,
    const Stabilization& stabilization, bem::Units units, const bem::Processes& processes,
    const bem::Compression& options) {
  const std::string reason = whyNotCompressed(stabilization);
  if (!reason.empty())
    throw bem::InputError("the operators cannot be compressed: " + reason);
  std::vector<bem::CompressedOperators::Body> operands;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    operands.push_back({bodies[b].space, lames[b]});
  const auto operators = std::make_shared<const bem::CompressedOperators>(
      operands, options, localCoupling(bodies, lames, stabilization, units), processes);
  std::vector<bem::SteklovPoincare> result;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    result.emplace_back(operators, b);
  return result;
}

}  // namespace epafi::contact
