#include "contact/solve/Stage.hpp"

namespace epafi::contact {

namespace {

// As the enumerators come.
constexpr const char* stages[] = {"full steps", "follow offset", "near start",
                                  "fixed point"};
constexpr const char* ends[] = {"converged",  "unfinished", "cycling",  "grows",
                                "not finite", "stalled",    "singular", "no balance",
                                "too large",  "too long",   "unsettled"};

}  // namespace

std::string told(const std::vector<StageRun>& runs) {
  std::string text;
  for (const StageRun& run : runs) {
    text += text.empty() ? "" : ", ";
    text += stages[static_cast<int>(run.stage)];
    text += " " + std::to_string(run.steps) + " " + ends[static_cast<int>(run.end)];
    if (!run.parts.empty())
      text += " (" + told(run.parts) + ")";
  }
  return text;
}

}  // namespace epafi::contact
