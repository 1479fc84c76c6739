#pragma once

#include "bem/base/Processes.hpp"
#include "drivers/run/BodySpaces.hpp"

namespace epafi::drivers {

/// Closed elements of a contact, on at least so many of which one sees how its pressure runs.
constexpr std::size_t fewestClosed = 4;

/// What Adaptivity->Tolerance demands of each contact: the estimate on the elements where it is
/// closed, the neighbours of these and what lies opposite, relative to the energy norm of the body in
/// it that stores less.  A heavy body's energy would hide the error of a light one's contact.  Energies
/// are what the body's tractions would store with the modulus of the softest one in contact, or a stiff
/// body would ask for more digits than its tractions have.
///
/// On a path the estimate and the norm of each body are the largest of its steps.  One entry for each
/// contact that is closed in any of them.  Collective: all processes get the numbers of the first.
std::vector<ContactEstimate> contactEstimates(const BodySpaces& spaces,
                                              const Level& level,
                                              const bem::Processes& processes);

/// Of the largest pressure of a contact, the error that ends a run with a tolerance.
constexpr double mostDoubt = 0.05;

/// Does a contact keep the tolerance, on enough elements, and is its largest pressure right to mostDoubt?
bool keeps(const ContactEstimate& contact, double tolerance);

/// The one farthest from the tolerance; null: all keep it.
const ContactEstimate* worst(const std::vector<ContactEstimate>& contacts,
                             double tolerance);

/// Squared indicators by body and element, on elements of contacts that miss the tolerance or whose
/// largest pressure is in doubt, else zero.
std::vector<bem::Vector> onlyMissing(const std::vector<ContactEstimate>& contacts,
                                     double tolerance, std::vector<bem::Vector> squares);

/// Of each body the closed elements of contacts that have too few of them.
std::vector<std::vector<int>> tooFew(const std::vector<ContactEstimate>& contacts,
                                     std::size_t bodies);

}  // namespace epafi::drivers
