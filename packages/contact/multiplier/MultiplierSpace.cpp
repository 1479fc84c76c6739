#include "contact/multiplier/MultiplierSpace.hpp"

namespace epafi::contact {

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
    element.normal = normals_;
    normals_ += element.degree + 1;
    elements_.push_back(element);
  }
  size_ = normals_;
  for (ContactElement& element : elements_) {
    const FrictionLaw* law = element.condition->law;
    if (law == nullptr || *law->parameter == '\0')
      continue;
    element.tangential = size_;
    size_ += element.degree + 1;
  }
}

MultiplierSpace::Value MultiplierSpace::at(const Vector& multiplier,
                                           const ContactElement& element,
                                           double t) const {
  const Vector chi = basis_->values(element.degree, t);
  Value value;
  for (std::size_t i = 0; i < chi.size(); ++i) {
    const auto offset = static_cast<Index>(i);
    value.normal +=
        chi[i] * multiplier[static_cast<std::size_t>(element.normal + offset)];
    if (element.tangential >= 0)
      value.tangential +=
          chi[i] * multiplier[static_cast<std::size_t>(element.tangential + offset)];
  }
  return value;
}

}  // namespace epafi::contact
