#pragma once

#include "bem/base/Schema.hpp"
#include "bem/base/Suggestion.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace epafi::drivers {

using Parameter = bem::SchemaRow;
using bem::Kind;
using bem::textOf;

/// All parameters of a scene: the keys of the parts, each of which has its own, and those
/// of the program.  This table alone feeds validation, defaults, --set, `epafi
/// parameters` and the tests.  Made on first use: families are complete by then.
const bem::SchemaRows& parameters();

}  // namespace epafi::drivers
