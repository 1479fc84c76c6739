#pragma once

#include "bem/base/Schema.hpp"
#include "bem/base/Suggestion.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace epafi::drivers {

using Parameter = bem::SchemaRow;
using bem::Kind;
using bem::textOf;

/// All parameters of a scene.  Only this table defines validation, defaults, --set and
/// `epafi parameters`; the tests use it, too.  It is made on first use, when all families
/// are complete.
const bem::SchemaRows& parameters();

}  // namespace epafi::drivers
