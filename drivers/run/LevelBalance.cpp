#include "drivers/run/LevelBalance.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

using bem::message;
using contact::Imbalance;
using contact::Resultant;

std::string pairOf(const Resultant& force) {
  return message("(", force.x, ", ", force.y, ")");
}

/// "on Bodies->disc (0, 31.4), on Bodies->block (0, -19.9)", the largest first, at most six.
std::string contactForces(const SolvedStep& step) {
  constexpr std::size_t shown = 6;
  const Scene& scene = step.spaces.scene();
  std::vector<std::pair<std::string, Resultant>> forces;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    forces.emplace_back(scene.bodies[b].name, step.summaries()[b].contact);
  for (std::size_t k = 0; k < scene.rigid.size(); ++k)
    forces.emplace_back(scene.rigid[k].name, step.row.rigid[k].second.contact);
  const auto size = [](const Resultant& force) { return std::hypot(force.x, force.y); };
  std::stable_sort(forces.begin(), forces.end(), [&](const auto& a, const auto& b) {
    return size(a.second) > size(b.second);
  });
  std::string text;
  for (std::size_t k = 0; k < std::min(forces.size(), shown); ++k)
    text += message(k == 0 ? "" : ", ", "on Bodies->", forces[k].first, " ",
                    pairOf(forces[k].second));
  return forces.size() > shown ? text + " and others" : text;
}

std::string told(const Imbalance& imbalance, const SolvedStep& step) {
  const std::string rest =
      message(", where the largest force is ", imbalance.largest, ", rounding may leave ",
              imbalance.rounding, " and the solver ", imbalance.unsolved);
  if (!imbalance.body)
    return message(
        "contact forces on all bodies do not add up to zero: ", pairOf(imbalance.missing),
        " is missing", rest, ": ", contactForces(step));
  return message("Bodies->", nameOf(imbalance, step.spaces.scene()),
                 " is not in balance: a force of ", pairOf(imbalance.missing),
                 " and a moment of ", imbalance.missing.moment,
                 " about its middle are missing", rest);
}

std::string told(const contact::VirtualWork& work, double energy) {
  const std::pair<const char*, double> terms[] = {
      {" by loads, ", work.loads},
      {" by supports, ", work.supports},
      {" by what Fix holds, ", work.means},
      {" on gaps and jumps, ", work.given},
      {" on what surfaces yield and wear, ", work.surfaces},
      {" on slip, ", work.friction},
      {" by what moves and holds rigid bodies, ", work.rigid}};
  std::string text = "twice the energies are not the work of what acts: ";
  for (const auto& [name, value] : terms)
    if (value != 0)
      text += message(energy * value, name);
  return text + message("but ", energy * work.strain, " of strain and ",
                        energy * work.stabilisation, " of the stabilisation; ",
                        energy * work.missing(), " is missing, where rounding may leave ",
                        energy * work.rounding, " and the solver ",
                        energy * work.unsolved);
}

}  // namespace

const std::string& nameOf(const Imbalance& imbalance, const Scene& scene) {
  const std::size_t b = imbalance.body.value();
  return b < scene.bodies.size() ? scene.bodies[b].name
                                 : scene.rigid[b - scene.bodies.size()].name;
}

contact::Balance balanceOf(const Scene& scene) {
  bem::Vector compressibilities;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    compressibilities.push_back(1 - 2 * scene.lame(b).nu);
  return contact::Balance(std::move(compressibilities));
}

void checkBalance(contact::Balance& balance, const Run& run, SolvedStep& step,
                  SolvedLevel& level) {
  step.imbalances = balance.of(*step.system, step.at, step.bodies, step.summaries(),
                               level.row.report.tolerance);
  const auto broken = std::find_if(step.imbalances.begin(), step.imbalances.end(),
                                   [](const Imbalance& one) { return one.isBroken(); });
  const contact::VirtualWork work = balance.workOf(
      *step.system, step.at, step.motions.shearModuli, level.row.report.tolerance);
  const bool isBalanced = broken == step.imbalances.end();
  if (!run.processes.agreed(!isBalanced || work.isBroken()))
    return;
  level.unbalanced = message(
      "level ", level.level.number,
      step.row.step > 0 ? message(", step ", step.row.step) : "", ": ",
      // what rank 0 says is told
      !isBalanced       ? told(*broken, step)
      : work.isBroken() ? told(work, step.spaces.scene().energy())
                        : "",
      ".  Nothing of this level can be relied on: look at what lies opposite to "
      "sides in contact, at units and loads, and at bodies slender by more than "
      "1 : 1000",
      level.row.isCompressed()
          ? "; dense operators (Solver->Linear->Method = Dense) keep more digits of "
            "such bodies and of nearly incompressible ones"
          : "");
  level.row.report.status = contact::Status::NotConverged;
  level.level.reason = level.unbalanced;
}

}  // namespace epafi::drivers
