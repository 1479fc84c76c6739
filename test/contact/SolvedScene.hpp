#pragma once

#include "contact/Solve.hpp"
#include "contact/results/Summary.hpp"
#include "contact/system/ContactSystem.hpp"

namespace epafi::test {

/// A contact problem on one mesh, solved, with everything that its results refer to.
class SolvedScene {
 public:
  struct Input {
    bem::Mesh mesh;
    bem::Material material;
    contact::Conditions conditions;
    std::string multiplier = "Gauss-Lobatto-Lagrange";
    contact::Stabilization stabilization;
  };

  explicit SolvedScene(const Input& input)
      : lame_(input.material),
        conditions_(input.conditions),
        units_{input.mesh.outline().diameter(), input.material.youngsModulus},
        space_(contact::makeSpace(input.mesh, conditions_, input.stabilization)),
        stiffness_(contact::makeStiffness(
            space_,
            contact::MultiplierSpace(
                space_.mesh(), contact::multiplierBasis(input.multiplier), conditions_),
            input.stabilization, lame_, units_)),
        system_({{space_, stiffness_, lame_, units_, conditions_,
                  contact::multiplierBasis(input.multiplier), input.stabilization}}),
        solution_(test::solve(system_.numbers())),
        displacement_(system_.body(0).displacement(solution_.state)),
        density_(system_.body(0).density(solution_.state, displacement_)) {}

  SolvedScene(const SolvedScene&) = delete;
  SolvedScene& operator=(const SolvedScene&) = delete;

  contact::Solved solved() const {
    return {space_, stiffness_,      system_.body(0), conditions_,
            units_, solution_.state, displacement_};
  }
  const contact::ContactSystem& system() const { return system_; }
  const bem::Lame& lame() const { return lame_; }
  const bem::Vector& density() const { return density_; }
  const contact::Report& report() const { return solution_.report; }

 private:
  bem::Lame lame_;
  contact::Conditions conditions_;
  bem::Units units_;
  bem::Space space_;
  bem::SteklovPoincare stiffness_;
  contact::ContactSystem system_;
  contact::Solution solution_;
  bem::Vector displacement_;
  bem::Vector density_;
};

}  // namespace epafi::test
