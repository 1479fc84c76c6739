#pragma once

#include "contact/opposite/RigidDrives.hpp"

namespace epafi::contact {

/// Size of tractions, deformations and penetrations, dimensionless: unit of the residual and of the
/// states.  Rigid motions, common or apart, add nothing to it: penetrations are those that are
/// left where the free motions α settle, as pressures of contact on springs of stiffness one in a row
/// with the compliance of the surfaces,
///
///   min over α of  Σ_i w_i Π(r_i / w_i) + ½ αᵀ K α - f · α,   r = given + G α,   w: lengths,
///
/// Π the potential of the pressure that the laws allow: z⁺ normal to a side, z along it, but at most
/// the slip bound without pressure, z the compression of the springs alone.  Shear has the size of what presses, however far that slides.
/// Zero: nothing acts.                                                [doc/theory/contact.md]
///
/// \param problem  laws, G and K
/// \param given    r of gaps, rigid parts and given motions, all but α
/// \param moved    size of the motions that `given` is a difference of
/// \param own      sum of Loads::size of the bodies
double loadSize(const Problem& problem, const Vector& given, const Vector& lengths,
                double moved, double own, const RigidDrives& drives);

/// α where the free motions settle on the same springs under all that pulls at them, q in place of f,
/// and where what has friction by its pressure does not slide: a start for Newton's method, which
/// would else hand the load from body to body, a step for each.
Vector placement(const Problem& problem, const Vector& given, const Vector& lengths);

}  // namespace epafi::contact
