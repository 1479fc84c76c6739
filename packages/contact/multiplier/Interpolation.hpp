#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"

namespace epafi::contact {

/// Factor of E_kj = χ_j(t_k): E⁻¹ values are the coefficients of the polynomial with these values
/// at `places`, q + 1 distinct ones for the basis of degree q.
/// \throws bem::NumericalError if the functions are linearly dependent
bem::LuFactor interpolation(const MultiplierBasis& basis, const bem::Vector& places);

}  // namespace epafi::contact
