#include "contact/solve/Stage.hpp"

namespace epafi::contact {

namespace {

const char* nameOf(Stage stage) {
  switch (stage) {
    case Stage::FullSteps:
      return "full steps";
    case Stage::FollowOffset:
      return "follow offset";
    case Stage::NearStart:
      return "near start";
    case Stage::FixedPoint:
      return "fixed point";
    default:
      return "load";
  }
}

const char* nameOf(End end) {
  switch (end) {
    case End::Converged:
      return "converged";
    case End::Iterations:
      return "unfinished";
    case End::Restless:
      return "restless";
    case End::Growth:
      return "grows";
    case End::NotFinite:
      return "not finite";
    case End::Stalled:
      return "stalled";
    case End::Singular:
      return "singular";
    case End::NoBalance:
      return "no balance";
    case End::TooLarge:
      return "too large";
    default:
      return "unsettled";
  }
}

}  // namespace

std::string told(const std::vector<StageRun>& stages) {
  std::string text;
  for (const StageRun& run : stages) {
    text += text.empty() ? "" : ", ";
    text += nameOf(run.stage);
    text += " " + std::to_string(run.steps) + " " + nameOf(run.end);
    if (!run.parts.empty())
      text += " (" + told(run.parts) + ")";
  }
  return text;
}

}  // namespace epafi::contact
