#include "contact/multiplier/MultiplierSpace.hpp"

#include "bem/base/Error.hpp"
#include "contact/multiplier/SharedNodes.hpp"

#include <algorithm>

namespace epafi::contact {

namespace {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

/// Do two contact elements follow each other on one straight side?
bool continues(const bem::Mesh& mesh, const ContactElement& before,
               const ContactElement& after) {
  const bem::Element& a = mesh[before.element];
  const bem::Element& b = mesh[after.element];
  const bem::Vec2 arriving = a.curve.normal(1);
  const bem::Vec2 leaving = b.curve.normal(-1);
  return b.previous == before.element && before.boundary == after.boundary &&
         std::abs(cross(arriving, leaving)) < 1e-12 && dot(arriving, leaving) > 0;
}

}  // namespace

MultiplierSpace::MultiplierSpace(const bem::Mesh& mesh, const MultiplierBasis& basis,
                                 const Conditions& conditions)
    : basis_(&basis) {
  for (int e = 0; e < mesh.size(); ++e) {
    const auto condition = conditions.contact.find(mesh.boundary(e));
    if (condition == conditions.contact.end())
      continue;
    ContactElement element;
    element.element = e;
    element.degree = mesh[e].degree;
    element.boundary = &condition->first;
    element.condition = &condition->second;
    if (element.condition->friction)
      element.tangential = 0;
    elements_.push_back(element);
  }
  joined_.assign(elements_.size(), false);
  if (basis.sharesNodes)
    shareNodes(mesh, conditions);
  number();
  if (basis.sharesNodes)
    completeEnds(mesh, conditions, elements_);
}

void MultiplierSpace::shareNodes(const bem::Mesh& mesh, const Conditions& conditions) {
  for (std::size_t k = 1; k < elements_.size(); ++k)
    joined_[k] = continues(mesh, elements_[k - 1], elements_[k]);
  NodeDirections nodes = clampedDirections(mesh, conditions);
  const auto decide = [&](std::size_t k, Vec2 direction) {
    const bem::Element& element = mesh[elements_[k].element];
    EndCoefficients ends;
    if (!joined_[k])
      ends.first = nodes.take(element.startNode, direction);
    if (k + 1 == elements_.size() || !joined_[k + 1])
      ends.last = nodes.take(element.endNode, direction);
    if (elements_[k].degree == 1 && !ends.first && !ends.last)
      throw bem::InputError(bem::message(
          "boundary '", *elements_[k].boundary,
          "': an element of degree 1 without a free "
          "node cannot carry the multiplier '",
          basis_->name, "'; use more elements, a higher degree or another multiplier"));
    return ends;
  };
  for (std::size_t k = 0; k < elements_.size(); ++k)
    elements_[k].normalEnds = decide(k, mesh[elements_[k].element].segment().normal);
  for (std::size_t k = 0; k < elements_.size(); ++k)
    if (elements_[k].tangential >= 0)
      elements_[k].tangentialEnds =
          decide(k, turnLeft(mesh[elements_[k].element].segment().normal));
}

void MultiplierSpace::number() {
  const auto assign = [&](Index ContactElement::*first,
                          EndCoefficients ContactElement::*ends) {
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      ContactElement& element = elements_[k];
      if (element.*first < 0)
        continue;
      element.*first = joined_[k] ? size_ - 1 : size_;
      size_ = element.*first + element.offset(element.*ends, element.degree) + 1;
    }
  };
  assign(&ContactElement::normal, &ContactElement::normalEnds);
  normals_ = size_;
  assign(&ContactElement::tangential, &ContactElement::tangentialEnds);
}

Index MultiplierSpace::ContactElement::offset(EndCoefficients ends, int i) const {
  const int skipped = ends.first ? 0 : 1;
  const int last = degree - skipped - (ends.last ? 0 : 1);
  return std::clamp(i - skipped, 0, last);
}

MultiplierSpace::Value MultiplierSpace::at(const Vector& multiplier,
                                           const ContactElement& element,
                                           double t) const {
  const Vector chi = basis_->values(element.degree, t);
  const auto coefficient = [&](Index k) {
    return multiplier[static_cast<std::size_t>(k)];
  };
  Value value;
  for (int i = 0; i <= element.degree; ++i) {
    const double weight = chi[static_cast<std::size_t>(i)];
    value.normal += weight * coefficient(element.normalOf(i));
    if (element.tangential >= 0)
      value.tangential += weight * coefficient(element.tangentialOf(i));
  }
  for (const std::size_t end : {0, 1}) {
    const double weight = end == 0 ? chi.front() : chi.back();
    for (const auto& [k, factor] : element.normalCompletions[end].added)
      value.normal += weight * factor * coefficient(k);
    for (const auto& [k, factor] : element.tangentialCompletions[end].added)
      value.tangential += weight * factor * coefficient(k);
  }
  return value;
}

}  // namespace epafi::contact
