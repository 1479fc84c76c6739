#pragma once

#include "contact/body/Coupling.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace epafi::contact {

/// Sparse coupling of the multiplier with displacements and densities, Ĉ = [B₀, -Nᵀ], of
/// its own body and of opposite bodies, and the matrix M: its rows in the compressed
/// system.
struct CompressedCoupling {
  std::vector<bem::Entry> entries;  ///< unknowns x multiplier
  std::vector<bem::Entry> mass;     ///< M
  /// Coupling with bem::Rotation of a body with arcs: exact minus interpolated rotation.
  struct Rest {
    std::shared_ptr<const bem::Rotation> rotation;
    std::size_t body;
    Index first;    ///< number of the body's first displacement
    Vector values;  ///< one per coefficient
  };
  std::vector<Rest> rests;
  Index first = 0;  ///< number of the unknown of the first coefficient
  Index multipliers = 0;
  Index normals = 0;  ///< number of pressure coefficients, which come first

  using Numbers = std::function<Index(Index)>;
  /// Adds Ĉ and M of a body and its own multiplier.
  /// \param start number of the body's first unknown
  /// \param numberOf maps a coefficient of the body to that of all bodies
  void addOwn(const bem::Space& space, const Coupling& coupling, std::size_t body,
              Index start, const Numbers& numberOf);
  /// Adds a Rest; \p rotation null: no arcs.  \param work one per coefficient of numberOf
  void addRests(const std::shared_ptr<const bem::Rotation>& rotation, std::size_t body,
                Index start, const Vector& work, const Numbers& numberOf);

  /// x += s Ĉᵀ λ, x: all unknowns
  void push(double s, const double* multiplier, double* x) const;
  /// Ĉ x
  Vector pull(const double* x) const;
};

}  // namespace epafi::contact
