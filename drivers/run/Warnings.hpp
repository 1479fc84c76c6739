#pragma once

#include "bem/base/Error.hpp"
#include "drivers/run/SolvedStep.hpp"

#include <set>
#include <string>
#include <vector>

namespace epafi::drivers {

/// Sentences for the user, in their order.
class Warnings {
 public:
  /// Adds a sentence, joined from parts.
  template <class... Parts>
  void operator()(const Parts&... parts) {
    all_.push_back(bem::message(parts...));
  }
  /// The same, unless one about the same was added.
  template <class... Parts>
  void once(const std::string& about, const Parts&... parts) {
    if (told_.insert(about).second)
      (*this)(parts...);
  }
  std::vector<std::string> all() const { return all_; }

 private:
  std::vector<std::string> all_;
  std::set<std::string> told_;
};

/// What is probably not meant in a scene, a sentence each: what has no effect, conditions as below,
/// sizes or states that do not go together, angles in degrees, bodies drawn deep into each other, straight edges that draw a curve on a side in contact.  A polygon
/// meets an obstacle at its corners: 64 edges around a cylinder give 1.6 times Hertz' contact length.
std::vector<std::string> warningsOf(const Scene& scene);

/// Adds what boundary conditions say that is probably not meant, at the end of a path and at some
/// times before it, each sentence once: displacements or temperatures that jump, at a
/// corner or on a side, displacements that go through an obstacle at a corner, loads narrower than
/// their elements can see, friction that no surface has, obstacles deep in a body.
void findInConditions(const Scene& scene, Warnings& warn);

/// Adds ends of sides at which contact presses though the outline goes on smoothly there, and what is
/// opposite has no corner.
void findCutSides(const SolvedLevel& level, Warnings& warn);

/// What is probably not meant in a solved level, a sentence each: nothing is loaded, or by less
/// than numbers can tell, contact never closes, sliding beyond a tenth of the length in contact,
/// displacements beyond a tenth of a body: conditions on the undeformed outline mean little
/// there.  What rounding has taken: bodies out of balance, conditions of contact that the
/// displacements do not meet.
std::vector<std::string> warningsOf(const SolvedLevel& level);

}  // namespace epafi::drivers
