#pragma once

#include "contact/body/Coupling.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace epafi::contact {

/// The sparse rows Ĉ = [B₀, -Nᵀ] by which the multiplier acts on displacements and densities,
/// of its own body and of those that it meets, and -M: what a compressed system has of it.
struct CompressedCoupling {
  std::vector<bem::Entry> entries;  ///< unknowns x multiplier
  std::vector<bem::Entry> mass;     ///< M
  /// What Ĉ does on a body with arcs to the exact rotation less the interpolated one.
  struct Rest {
    std::shared_ptr<const bem::Rotation> rotation;
    std::size_t body;
    Index first;    ///< displacement of it
    Vector values;  ///< by multipliers
  };
  std::vector<Rest> rests;
  Index first = 0;  ///< number of the first multiplier's unknown
  Index multipliers = 0;
  Index normals = 0;  ///< those of them that come first

  using Numbers = std::function<Index(Index)>;
  /// Ĉ and M of a body's own multiplier, its unknowns from `start` on and the multiplier
  /// numbered as `numberOf` says.
  void addOwn(const bem::Space& space, const Coupling& coupling, std::size_t body,
              Index start, const Numbers& numberOf);
  /// The part of Ĉ on the displacements of one body.
  void add(const TraceCoupling& trace, std::size_t body, Index start,
           const Numbers& numberOf);

  /// x += s Ĉᵀ λ on displacements and densities.
  void addTranspose(double s, const double* multiplier, double* x) const;
  /// Ĉ x
  Vector apply(const double* x) const;
};

}  // namespace epafi::contact
