#pragma once

#include "bem/base/Material.hpp"
#include "bem/operators/Assembly.hpp"
#include "bem/space/Space.hpp"
#include "reference/QuadMoments.hpp"

#include <vector>

namespace epafi::reference {

/// A Galerkin matrix in 33 digits, and for each entry the size that its error is measured
/// by: the sum of the Frobenius norms of the element pair blocks that it collects.  (For
/// the double layer the norm has 1 in place of 1-2nu, see doubleLayerBlock.)
class QuadMatrix {
 public:
  QuadMatrix(bem::Index rows, bem::Index columns);

  bem::Index rows() const { return rows_; }
  bem::Index columns() const { return columns_; }
  const Quad& operator()(bem::Index i, bem::Index j) const { return values_[at(i, j)]; }
  const Quad& scale(bem::Index i, bem::Index j) const { return scales_[at(i, j)]; }

  void add(bem::Index i, bem::Index j, const Quad& value, const Quad& blockNorm);

 private:
  std::size_t at(bem::Index i, bem::Index j) const {
    return static_cast<std::size_t>(i * columns_ + j);
  }
  bem::Index rows_;
  bem::Index columns_;
  std::vector<Quad> values_;
  std::vector<Quad> scales_;
};

/// The twin of bem::Operators: the same three matrices in the same numbering, by plain
/// quadrature in 33 digits.  The double layer is integrated with its own kernel, not by
/// parts; the hypersingular operator is <W u, v> = <V* du/ds, dv/ds>.   [doc/theory/operators.md]
///
/// The body is what the mesh's doubles say: nodes lie exactly on their edge, at the
/// distance from its nearer end that the mesh holds.
struct QuadOperators {
  QuadMatrix singleLayer;    ///< densities x densities
  QuadMatrix doubleLayer;    ///< K + 1/2, densities x displacements
  QuadMatrix hypersingular;  ///< displacements x displacements
};

/// `tolerance` is the relative error that the quadrature rules are chosen for.
QuadOperators quadOperators(const bem::Space& space, const bem::Lame& lame,
                            double tolerance = 1e-22);

/// The same of Laplace's operators; one component.
QuadOperators quadLaplace(const bem::Space& space, double tolerance = 1e-22);

/// The largest error of an entry, relative to the norms of the element pair blocks that
/// make it up.
struct OperatorErrors {
  double singleLayer = 0;
  double doubleLayer = 0;
  double hypersingular = 0;
};

OperatorErrors operatorErrors(const bem::Operators& operators,
                              const QuadOperators& exact);

}  // namespace epafi::reference
