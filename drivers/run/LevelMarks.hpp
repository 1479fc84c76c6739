#pragma once

#include "adaptivity/mark/Strategy.hpp"
#include "bem/base/Processes.hpp"
#include "drivers/run/BodySpaces.hpp"

namespace epafi::drivers {

const adaptivity::Strategy& strategyOf(const Scene& scene);

/// What becomes of each element behind a level, by body.  The elements that carry most of the estimate
/// are chosen among those of all bodies; where Graded hp cuts one side of a contact, the other follows.
/// \param ofContacts  only elements of contacts that miss Adaptivity->Tolerance, or have too few of them
std::vector<adaptivity::Marks> marksOf(const BodySpaces& spaces, const Level& level,
                                       bool ofContacts, const bem::Processes& processes);

}  // namespace epafi::drivers
