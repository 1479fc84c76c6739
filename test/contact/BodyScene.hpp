#pragma once

#include "Processes.hpp"
#include "bem/compressed/CompressedOperators.hpp"
#include "contact/compressed/CompressedStiffness.hpp"
#include "contact/system/ContactSystem.hpp"

#include <string>
#include <utility>

namespace epafi::test {

/// A body on one mesh under conditions, its boundary all that it meets; what its stiffness and its
/// problem refer to.
struct BodyScene {
  struct Input {
    bem::Mesh mesh;
    bem::Material material;
    contact::Conditions conditions;
    std::string multiplier = "Gauss-Lobatto-Lagrange";
    contact::Stabilization stabilization;
  };

  contact::Conditions conditions;
  contact::Stabilization stabilization;
  bem::Lame lame;
  bem::Units units;
  bem::Space space;
  const contact::MultiplierBasis& basis;
  contact::MultiplierSpace multiplier;

  explicit BodyScene(const Input& input)
      : conditions(input.conditions),
        stabilization(input.stabilization),
        lame(input.material),
        units(input.mesh.outline().units(input.material.youngsModulus)),
        space(contact::makeSpace(input.mesh, conditions, stabilization)),
        basis(contact::multiplierBasis(input.multiplier)),
        multiplier(space.mesh(), basis, conditions) {}
  BodyScene(const BodyScene&) = delete;
  BodyScene& operator=(const BodyScene&) = delete;

  bem::SteklovPoincare dense() const {
    return contact::makeStiffness(space, conditions, stabilization, lame, units);
  }
  /// In leaves of few unknowns.
  bem::SteklovPoincare compressed() const {
    bem::Compression options;
    options.leafUnknowns = 60;
    auto all = contact::makeCompressedStiffness(
        {&space}, {lame}, multiplier, contact::Opposite(units.length), stabilization,
        units, processes(), options);
    return std::move(all.front());
  }
  contact::BodyInput input(const bem::SteklovPoincare& stiffness) const {
    return {space, stiffness, lame, units, conditions, basis, stabilization};
  }
};

}  // namespace epafi::test
