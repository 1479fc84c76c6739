#pragma once

#include "contact/BodyScene.hpp"
#include "contact/Solve.hpp"
#include "contact/results/Summary.hpp"

namespace epafi::test {

/// A contact problem on one mesh, solved, with everything that its results refer to.
class SolvedScene {
 public:
  using Input = BodyScene::Input;

  explicit SolvedScene(const Input& input)
      : scene_(input),
        stiffness_(scene_.dense()),
        system_({scene_.input(stiffness_)}),
        solution_(test::solve(system_.numbers())),
        displacement_(system_.body(0).displacement(solution_.state)),
        density_(system_.body(0).density(
            solution_.state, displacement_,
            system_.body(0).contactForce(solution_.state.multiplier))) {}

  contact::Solved solved() const {
    return {scene_.space, system_.body(0), scene_.conditions,
            scene_.units, solution_.state, displacement_};
  }
  const contact::ContactSystem& system() const { return system_; }
  const bem::Lame& lame() const { return scene_.lame; }
  const bem::Vector& density() const { return density_; }

 private:
  BodyScene scene_;
  bem::SteklovPoincare stiffness_;
  contact::ContactSystem system_;
  contact::Solution solution_;
  bem::Vector displacement_;
  bem::Vector density_;
};

}  // namespace epafi::test
