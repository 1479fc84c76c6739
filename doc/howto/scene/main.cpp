// How hard may a block be pressed onto a cylinder until their contact is 2 wide?  An application
// solves a scene again and again, without files in between.
//
//   press        prints, for each trial, the load and the width of contact, then x and the pressure

#include "contact/results/Solved.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/process/Threads.hpp"
#include "drivers/run/Levels.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <cmath>
#include <cstdio>
#include <vector>

namespace {

namespace contact = epafi::contact;
namespace drivers = epafi::drivers;

struct Answer {
  double load = 0;
  double width = 0;
  std::vector<contact::ContactPoint> points;
};

/// The finest level of the scene under a load.
Answer answerUnder(double load, const drivers::Ranks& ranks) {
  const drivers::Scene scene =
      drivers::readScene(SCENE, {"Constants->load=" + std::to_string(load)});
  Answer answer;
  drivers::PhaseTimer timer;
  const drivers::Outcome outcome =
      drivers::solveLevels(scene, ranks, timer, [&](const drivers::SolvedLevel& level) {
        // the level refers to meshes and spaces that end with this call: take what is wanted
        const contact::ContactFields fields(level.last().bodies[0]);
        answer = {load, level.row.summary.contactLength, {}};
        for (const auto& element : fields.elements())
          answer.points.push_back(fields.at(element, 0));
      });
  if (outcome.status != contact::Status::Converged)
    throw epafi::bem::NumericalError(outcome.reason);
  return answer;
}

int run(const drivers::Ranks& ranks) {
  constexpr double wanted = 2;
  // Hertz on a half-space has width² ~ load
  Answer trial = answerUnder(0.1, ranks);
  for (int k = 0; k < 6 && std::abs(trial.width - wanted) > 1e-4 * wanted; ++k) {
    if (ranks.isFirst())
      std::printf("%.10f %.10f\n", trial.load, trial.width);
    trial = answerUnder(trial.load * std::pow(wanted / trial.width, 2), ranks);
  }
  if (ranks.isFirst()) {
    std::printf("%.10f %.10f\n", trial.load, trial.width);
    for (const contact::ContactPoint& point : trial.points)
      std::printf("%.10f %.10f\n", point.place.x, point.pressure);
  }
  return std::abs(trial.width - wanted) < 1e-4 * wanted ? 0 : 1;
}

}  // namespace

int main() {
  drivers::tuneBlas();
  const drivers::Ranks ranks;  // starts MPI under mpirun
  int code = 0;
  const auto failure = ranks.attempt([&] { code = run(ranks); });
  if (!failure)
    return code;
  if (ranks.isFirst())
    drivers::tell(*failure);
  return failure->code;
}
