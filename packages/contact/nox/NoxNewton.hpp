#pragma once

#include "bem/base/SchemaRow.hpp"
#include "contact/newton/Newton.hpp"

#include <memory>

namespace Teuchos {
class ParameterList;
}

namespace epafi::contact {

/// Schema row of the list for NOX.
bem::SchemaRow noxRow();

/// Newton's method by NOX; the merit of its line searches is that of the smooth equation, merit().
class NoxNewton final : public Newton {
 public:
  /// \param list Direction, Line Search and Printing for every run; not modified; null: full steps,
  /// no output
  explicit NoxNewton(std::shared_ptr<const Teuchos::ParameterList> list = nullptr)
      : list_(std::move(list)) {}

  /// \throws bem::InputError for what NOX refuses in the list, or does not use of it; the
  ///   path begins with the list's name.
  NewtonRun run(const Equation& equation, const Vector& start,
                int maximumIterations) const override;

 private:
  std::shared_ptr<const Teuchos::ParameterList> list_;
};

}  // namespace epafi::contact
