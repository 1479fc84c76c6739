#include "contact/problem/Flexibility.hpp"

#include <algorithm>

namespace epafi::contact {

Flexibility::Flexibility(std::shared_ptr<const Operator> form)
    : operator_(std::move(form)), entries_(operator_->entries()) {}

const Vector& Flexibility::responses(Index normals) const {
  const std::lock_guard lock(found_->mutex);
  Vector& responses = found_->responses[normals];
  if (!responses.empty())
    return responses;
  Vector found;  // product() may throw
  for (const bool normal : {true, false}) {
    Vector kind(at(size()), normal ? 0.0 : 1.0);
    std::fill_n(kind.begin(), normals, normal ? 1.0 : 0.0);
    const Vector all = product(kind).magnitude;
    found.insert(found.end(), normal ? all.begin() : all.begin() + normals,
                 normal ? all.begin() + normals : all.end());
  }
  return responses = std::move(found);
}

}  // namespace epafi::contact
