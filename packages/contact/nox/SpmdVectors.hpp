#pragma once

#include "bem/base/Matrix.hpp"

#include <Thyra_SpmdVectorSpaceBase.hpp>
#include <Thyra_VectorBase.hpp>

namespace epafi::contact {

/// Any space of vectors that gives each process a contiguous piece: Tpetra's, or Thyra's
/// own.
using SpmdSpace = Thyra::SpmdVectorSpaceBase<double>;

/// All entries, on every process.  Collective.
bem::Vector gathered(const SpmdSpace& space, const Thyra::VectorBase<double>& x);

/// x = scale values + shift x, each process its own piece; shift 0 overwrites whatever x
/// holds.
void scatter(const SpmdSpace& space, const bem::Vector& values, double scale,
             double shift, Thyra::VectorBase<double>& x);

}  // namespace epafi::contact
