#pragma once

#include "contact/body/BodyInput.hpp"
#include "contact/body/ElasticBody.hpp"
#include "contact/opposite/Obstacle.hpp"

namespace epafi::contact {

/// What a ContactProblem is made of; a ContactSystem condenses several of them.
struct BodyParts {
  explicit BodyParts(const BodyInput& input);
  /// The same at another time of a path; the factor of A is shared.
  BodyParts(const BodyParts& same, const Conditions& conditions);

  const bem::Space& space;
  bem::Units units;
  Holding holding;
  MultiplierSpace multiplier;
  std::shared_ptr<const Opposite> opposite;
  std::shared_ptr<const StabilisedBody> form;
  Obstacle obstacle;
  double gamma0 = 0;
  ResidualTerms terms{};  ///< their force is part of the holding's load
  std::unique_ptr<const ElasticBody> body{};
  Problem numbers{};

  /// Size of what acts on the body, dimensionless; zero: nothing.
  double size() const;
  /// The last multiplier's is kept, which several results ask for.
  Vector push(const State& state, const Vector& met) const;

 private:
  /// The form's terms of what acts inside take the place of earlier ones.
  void setTerms();
  struct Pushed {
    Vector multiplier;
    Vector force;
  };
  mutable Pushed pushed_{};
  /// Factors A, with a smaller gamma0 where the default is too large.
  /// \throws IndefiniteStiffness if it is not the default that is.
  void factor(const BodyInput& input);
};

/// \throws bem::InputError if the multiplier does not go with the form.
std::unique_ptr<const StabilisedBody> makeStabilisedBody(
    const BodyInput& input, const MultiplierSpace& multiplier);

}  // namespace epafi::contact
