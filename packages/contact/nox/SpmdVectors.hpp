#pragma once

#include "bem/base/Matrix.hpp"

#include <Thyra_SpmdVectorSpaceBase.hpp>
#include <Thyra_VectorBase.hpp>

namespace epafi::contact {

/// A vector space in which each process has a contiguous piece (of Tpetra or of Thyra).
using SpmdSpace = Thyra::SpmdVectorSpaceBase<double>;

/// All entries, on every process.  Collective.
bem::Vector gathered(const SpmdSpace& space, const Thyra::VectorBase<double>& x);

/// x = scale values + shift x, each process its own piece; with shift = 0, x may be NaN.
void scatter(const SpmdSpace& space, const bem::Vector& values, double scale,
             double shift, Thyra::VectorBase<double>& x);

}  // namespace epafi::contact
