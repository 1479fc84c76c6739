#pragma once

#include "contact/problem/Flexibility.hpp"

namespace epafi::contact {

/// D as the sum of what each body makes of it, a dense matrix of the coefficients that act on the body:
/// where many bodies meet few others, memory, products and factors are linear in their number.
/// Newton's systems by FrontalFactor, a body after the other.
class BodyFlexibility final : public Flexibility::Operator {
 public:
  /// Of a body; entries symmetric.
  struct Part {
    std::vector<Index> columns;
    Matrix entries;
  };
  BodyFlexibility(Index size, std::vector<Part> parts);

  /// Are parts with these columns worth it, in place of a whole D?
  static bool isSparse(Index size, const std::vector<std::vector<Index>>& columns);

  Index size() const override { return size_; }
  Product product(const Vector& x) const override;
  Vector times(const Vector& x) const override;
  Matrix formed() const override;
  std::unique_ptr<Factor> factor(System system) const override;
  /// The motions of each body are eliminated with its contacts; combinations of all would fill the front.
  double leastHeld() const override { return 1e-6; }

 private:
  class Reduced;

  Index size_;
  std::vector<Part> parts_;
  Vector diagonal_;
  std::vector<std::size_t> owners_;  ///< of each coefficient, the first part that has it
};

}  // namespace epafi::contact
