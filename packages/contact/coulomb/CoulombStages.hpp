#pragma once

#include "contact/coulomb/CoulombIteration.hpp"

namespace epafi::contact {

/// A course of Newton's method on Coulomb's problem, every step of which updates the bound,
/// and the stages that its plans share.
class CoulombCourse : public NewtonCourse {
 public:
  CoulombCourse(const Problem& problem, const State& start, const Tresca& tresca,
                Equation::Bound bound, CoulombOptions options)
      : NewtonCourse(problem, start, tresca, bound), options_(std::move(options)) {}

  const CoulombOptions& options() const { return options_; }

  bool isCoupled() const { return problem().boundsAreCoupled(); }
  static bool always(const CoulombCourse&) { return true; }

  /// What follows where Newton's steps fail.
  /// A first try of each, of `brief` steps: where one jams another often needs few.
  static constexpr int brief = 30;
  static void updates(CoulombCourse& course, Stage stage);
  static void updateBriefly(CoulombCourse& course, Stage stage);

 private:
  void update(Stage stage, int most);

  CoulombOptions options_;
};

}  // namespace epafi::contact
