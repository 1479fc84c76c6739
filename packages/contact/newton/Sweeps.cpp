#include "contact/newton/Sweeps.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>

namespace epafi::contact {

namespace {

constexpr int mostPairs = 10;

class Sweeper {
 public:
  Sweeper(const Problem& problem, Vector unknowns)
      : problem_(problem.copy()),
        x_(std::move(unknowns)),
        r_(problem_.offset),
        yields_(x_.size()),
        tangentials_(at(problem.normals)) {
    for (const bem::Entry& entry : problem_.surface.linear)
      yields_[at(entry.column)].push_back(entry);
    for (Index j = 0; j < problem.size(); ++j)
      add(j, -x_[at(j)]);
    for (Index j = 0; j < problem.rigidMotions(); ++j)
      bem::axpy(x_[at(problem.size() + j)], columnOf(problem.rigid, j), r_);
    for (std::size_t t = 0; t < problem.tangentials.size(); ++t)
      (problem.tangentials[t].isTied()
           ? tied_
           : tangentials_[at(problem.tangentials[t].normal())])
          .push_back(static_cast<Index>(t));
  }

  const Vector& unknowns() const { return x_; }

  void pairOfSweeps() {
    for (Index i = 0; i < problem_.normals; ++i)
      relaxPoint(i);
    for (const Index t : tied_)
      relax(problem_.normals + t, [](double trial) { return trial; });
    for (Index i = problem_.normals; i-- > 0;)
      relaxPoint(i);
  }

 private:
  void relaxPoint(Index i) {
    relax(i, [](double trial) { return std::max(trial, 0.0); });
    for (const Index t : tangentials_[at(i)]) {
      const double bound = problem_.tangentials[at(t)].bound(x_);
      relax(problem_.normals + t,
            [bound](double trial) { return std::clamp(trial, -bound, bound); });
    }
  }

  template <class Projection>
  void relax(Index i, const Projection& project) {
    double diagonal = problem_.flexibility.column(i)[i];
    for (const bem::Entry& entry : yields_[at(i)])
      diagonal += entry.row == i ? entry.value : 0;
    if (!(diagonal > 0))
      return;
    const double next = project(x_[at(i)] + r_[at(i)] / diagonal);
    add(i, x_[at(i)] - next);
    x_[at(i)] = next;
  }

  void add(Index j, double factor) {
    const double* column = problem_.flexibility.column(j);
    for (Index i = 0; i < problem_.size() && factor != 0; ++i)
      r_[at(i)] += factor * column[i];
    for (const bem::Entry& entry : yields_[at(j)])
      r_[at(entry.row)] += factor * entry.value;
  }

  const Problem problem_;
  Vector x_;
  Vector r_;
  std::vector<std::vector<bem::Entry>> yields_;  // by column
  std::vector<std::vector<Index>> tangentials_;  // of each normal coefficient
  std::vector<Index> tied_;
};

}  // namespace

Vector smoothed(const Equation& equation, Vector unknowns) {
  if (!equation.problem().flexibility.isFormed())
    return unknowns;
  Evaluation e = equation.at(unknowns);
  if (e.converged)
    return unknowns;
  Sweeper sweeper(equation.withTangent(e), unknowns);
  ContactStates before;
  for (int pair = 0; pair < mostPairs && e.states != before; ++pair) {
    before = e.states;
    sweeper.pairOfSweeps();
    e = equation.at(sweeper.unknowns());
  }
  return sweeper.unknowns();
}

}  // namespace epafi::contact
