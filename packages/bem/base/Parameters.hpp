#pragma once

#include "bem/base/SchemaRow.hpp"

#include <Teuchos_ParameterEntryValidator.hpp>
#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

#include <string>
#include <vector>

namespace epafi::bem {

using Validator = Teuchos::RCP<const Teuchos::ParameterEntryValidator>;

/// Validators of a number, or of each entry of an array of numbers; int and double.
Validator within(const Interval& interval);
Validator atLeast(double low);
Validator greaterThan(double low);
Validator inRange(double low, double high);     ///< low <= value <= high
Validator inInterior(double low, double high);  ///< low < value < high

/// One of the listed strings, or an array of them.
Validator oneOf(std::vector<std::string> names);

/// Fewest insertions, deletions, replacements and swaps of neighbours that turn one word
/// into the other; upper and lower case count as equal half. [Damerau64]
double editDistance(const std::string& a, const std::string& b);

/// The candidate with the smallest editDistance; empty if there is none.
std::string nearest(const std::string& name, const std::vector<std::string>& candidates);

/// "'A', 'B' or 'C'"
std::string quotedList(const std::vector<std::string>& names);

/// "; did you mean 'X'? known: 'X', 'Y'", for the end of a message about an unknown name.
std::string suggestion(const std::string& name,
                       const std::vector<std::string>& candidates);

/// Checks a list strictly against a valid one and fills in the defaults, all levels.
///
/// `path` stands before each key in messages: A->B->Key.
/// \throws InputError for an unknown name (the nearest known one is named), a wrong type
///   or a value that the validator refuses.
void validate(Teuchos::ParameterList& list, const Teuchos::ParameterList& valid,
              const std::string& path = "");

}  // namespace epafi::bem
