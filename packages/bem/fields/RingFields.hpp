#pragma once

#include "bem/base/Material.hpp"
#include "bem/space/LocalField.hpp"

#include <vector>

namespace epafi::bem {

/// Both integral equations on the elements of solids of revolution as Legendre series in t, for
/// some states (u, ψ): the traction W u + (K' + 1/2) ψ and what V ψ - (K + 1/2) u is.
///
/// They have the products of these with Legendre polynomials on the element, four more than the
/// densities have, and with as many bubbles: Galerkin entries, so that nothing singular is
/// evaluated at points.  What polynomials leave of the logarithms at nodes is lost.
class RingFields {
 public:
  struct Series {
    LegendreSeries<Complex> traction{};
    LegendreSeries<Complex> mismatch{};  ///< not its derivative
  };

  /// \param fields  elements x states, states contiguous
  RingFields(const Mesh& mesh, const Lame& lame, const std::vector<LocalField>& fields,
             std::size_t states);

  int terms(int element) const;
  const Series& of(int element, std::size_t state) const {
    return series_[static_cast<std::size_t>(element) * states_ + state];
  }

 private:
  Mesh mesh_;
  std::size_t states_;
  std::vector<Series> series_;
};

}  // namespace epafi::bem
