#include "contact/nox/SpmdVectors.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Thyra_DetachedSpmdVectorView.hpp>

namespace epafi::contact {

using bem::Vector;

Vector gathered(const SpmdSpace& space, const Thyra::VectorBase<double>& x) {
  const auto comm = space.getComm();
  const bool whole =
      comm.is_null() || comm->getSize() == 1 || space.isLocallyReplicated();
  const std::size_t begin = whole ? 0 : space.localOffset();
  Vector mine(space.dim(), 0.0);
  {
    const Thyra::ConstDetachedSpmdVectorView<double> view(Teuchos::rcpFromRef(x));
    for (Teuchos::Ordinal i = 0; i < view.subDim(); ++i)
      mine[begin + static_cast<std::size_t>(i)] = view[i];
  }
  if (whole)
    return mine;
  // One process contributes each entry, the others zero: exact, and equal on all.
  Vector all(mine.size());
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_SUM,
                     static_cast<Teuchos::Ordinal>(mine.size()), mine.data(), all.data());
  return all;
}

void scatter(const SpmdSpace& space, const Vector& values, double scale, double shift,
             Thyra::VectorBase<double>& x) {
  const auto begin =
      static_cast<std::size_t>(space.isLocallyReplicated() ? 0 : space.localOffset());
  const Thyra::DetachedSpmdVectorView<double> view(Teuchos::rcpFromRef(x));
  for (Teuchos::Ordinal i = 0; i < view.subDim(); ++i) {
    const double value = scale * values[begin + static_cast<std::size_t>(i)];
    view[i] = shift == 0 ? value : value + shift * view[i];
  }
}

}  // namespace epafi::contact
