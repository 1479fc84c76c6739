#include "drivers/output/SolutionArrays.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>

namespace epafi::drivers {

namespace {

template <class T>
void append(std::vector<T>& to, const std::vector<T>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// All rows one after the other.
template <std::size_t columns>
void append(std::vector<double>& to,
            const std::vector<std::array<double, columns>>& rows) {
  for (const auto& row : rows)
    to.insert(to.end(), row.begin(), row.end());
}

template <class State>
void appendStates(std::vector<int>& to, const std::vector<State>& states) {
  std::transform(states.begin(), states.end(), std::back_inserter(to),
                 [](State state) { return static_cast<int>(state); });
}

/// And back.
template <class State>
std::vector<State> states(const std::vector<int>& numbers, State last) {
  std::vector<State> result;
  for (const int number : numbers) {
    if (number < 0 || number > static_cast<int>(last))
      throw bem::InputError("/Epafi: ", number, " is no state");
    result.push_back(static_cast<State>(number));
  }
  return result;
}

/// Rows of `columns` numbers each.
template <std::size_t columns>
std::vector<std::array<double, columns>> rowsOf(const std::vector<double>& numbers) {
  std::vector<std::array<double, columns>> rows(numbers.size() / columns);
  for (std::size_t i = 0; i < rows.size(); ++i)
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(i * columns), columns,
                rows[i].begin());
  return rows;
}

/// Takes the next numbers of an array.
template <class T>
std::vector<T> taken(const std::vector<T>& all, std::size_t count, std::size_t& next) {
  if (count > all.size() - next)
    throw bem::InputError("/Epafi: bodies does not go with the other arrays");
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(next);
  next += count;
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

void append(const BodyLevel& level, SolutionArrays& arrays) {
  for (const bem::Piece& piece : level.pieces) {
    arrays.edge.push_back(piece.edge);
    arrays.degree.push_back(piece.degree);
    append(arrays.position, {piece.start.fromStart, piece.start.toEnd,
                             piece.end.fromStart, piece.end.toEnd});
  }
  append(arrays.indicators, level.indicators.squares);
  append(arrays.multiplier, level.state.multiplier);
  append(arrays.rigid, level.state.rigid);
  appendStates(arrays.contact, level.states.normal);
  appendStates(arrays.friction, level.states.tangential);
  append(arrays.displacement, level.displacement);
  append(arrays.density, level.density);
  for (const std::size_t count :
       {level.pieces.size(), level.states.normal.size(), level.states.tangential.size(),
        level.state.rigid.size(), level.displacement.size(), level.density.size()})
    arrays.bodies.push_back(static_cast<int>(count));
}

std::vector<bem::Piece> piecesOf(const SolutionArrays& arrays) {
  const auto position = rowsOf<4>(arrays.position);
  const std::size_t count = arrays.edge.size();
  if (count != arrays.degree.size() || count != position.size())
    throw bem::InputError("/Epafi: edge, degree and position are of different lengths");
  std::vector<bem::Piece> pieces;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [startFrom, startTo, endFrom, endTo] = position[i];
    pieces.push_back(
        {arrays.edge[i], {startFrom, startTo}, {endFrom, endTo}, arrays.degree[i]});
  }
  return pieces;
}

/// The arrays of each body.
std::vector<SolutionArrays> parted(const SolutionArrays& all) {
  std::vector<SolutionArrays> parts(all.bodies.size() / BodyCounts);
  const auto part = [&](const auto& set) {
    std::size_t next = 0;
    for (std::size_t b = 0; b < parts.size(); ++b) {
      std::size_t size = 0;
      for (int count = set.first; count <= set.last; ++count)
        size += static_cast<std::size_t>(set.columns) *
                static_cast<std::size_t>(std::max(
                    0, all.bodies[b * BodyCounts + static_cast<std::size_t>(count)]));
      parts[b].*set.array = taken(all.*set.array, size, next);
    }
  };
  std::apply([&](const auto&... set) { (part(set), ...); }, bodyDataSets);
  return parts;
}

contact::ContactState contactStateOf(const std::vector<int>& contact,
                                     const std::vector<int>& friction) {
  return {states(contact, contact::NormalState::Closed),
          states(friction, contact::FrictionState::SlipBackward)};
}

/// Motions of bodies without elasticity, and back.
void appendMotions(std::vector<double>& to,
                   const std::vector<contact::RigidMotion>& motions) {
  for (const contact::RigidMotion& motion : motions)
    append(to, {motion.slide.x, motion.slide.y, motion.turn});
}

std::vector<contact::RigidMotion> motionsOf(const std::vector<double>& numbers) {
  std::vector<contact::RigidMotion> motions;
  for (const auto& [x, y, turn] : rowsOf<3>(numbers))
    motions.push_back({{x, y}, turn});
  return motions;
}

BodyLevel bodyOf(const SolutionArrays& arrays) {
  return {piecesOf(arrays),
          {arrays.multiplier, arrays.rigid},
          contactStateOf(arrays.contact, arrays.friction),
          arrays.displacement,
          arrays.density,
          {rowsOf<adaptivity::sourceCount>(arrays.indicators)}};
}

std::vector<PathPoint> pathOf(const SolutionArrays& arrays) {
  const std::size_t count = arrays.pathTimes.size();
  if (count == 0)
    return {};
  const std::size_t multipliers = arrays.pathMultiplier.size() / count;
  const std::size_t motions = arrays.pathRigid.size() / count;
  if (arrays.pathIterations.size() != 2 * count ||
      arrays.pathMultiplier.size() != count * multipliers ||
      arrays.pathRigid.size() != count * motions || arrays.pathErrors.size() != count)
    throw bem::InputError("/Epafi: the arrays of the path are of different lengths");
  std::vector<PathPoint> path;
  std::size_t multiplier = 0;
  std::size_t rigid = 0;
  for (std::size_t k = 0; k < count; ++k)
    path.push_back({arrays.pathTimes[k],
                    {taken(arrays.pathMultiplier, multipliers, multiplier),
                     taken(arrays.pathRigid, motions, rigid)},
                    arrays.pathIterations[2 * k],
                    arrays.pathIterations[2 * k + 1],
                    arrays.pathErrors[k]});
  return path;
}

/// Of bodies whose sizes are known, rigid ones included.
std::vector<StepFields> stepsOf(const SolutionArrays& arrays,
                                const std::vector<BodyLevel>& bodies) {
  std::vector<StepFields> steps;
  std::size_t displacement = 0;
  std::size_t density = 0;
  std::size_t contact = 0;
  std::size_t friction = 0;
  std::size_t motion = 0;
  for (const double t : arrays.stepTimes) {
    steps.push_back({t, {}, {}});
    for (const BodyLevel& body : bodies) {
      steps.back().displacement.push_back(
          taken(arrays.stepDisplacement, body.displacement.size(), displacement));
      steps.back().density.push_back(
          taken(arrays.stepDensity, body.density.size(), density));
      steps.back().states.push_back(contactStateOf(
          taken(arrays.stepContact, body.states.normal.size(), contact),
          taken(arrays.stepFriction, body.states.tangential.size(), friction)));
    }
    steps.back().rigid =
        motionsOf(taken(arrays.stepRigidBodies, arrays.rigidBodies.size(), motion));
  }
  return steps;
}

}  // namespace

SolutionArrays arraysOf(const Level& level) {
  SolutionArrays arrays;
  for (const BodyLevel& body : level.bodies)
    append(body, arrays);
  appendMotions(arrays.rigidBodies, level.rigid);
  for (const PathPoint& point : level.path) {
    arrays.pathTimes.push_back(point.t);
    append(arrays.pathIterations, {point.newtonIterations, point.coulombIterations});
    append(arrays.pathMultiplier, point.state.multiplier);
    append(arrays.pathRigid, point.state.rigid);
    arrays.pathErrors.push_back(point.workError);
  }
  for (const StepFields& step : level.steps) {
    arrays.stepTimes.push_back(step.t);
    for (std::size_t b = 0; b < step.displacement.size(); ++b) {
      append(arrays.stepDisplacement, step.displacement[b]);
      append(arrays.stepDensity, step.density[b]);
      appendStates(arrays.stepContact, step.states[b].normal);
      appendStates(arrays.stepFriction, step.states[b].tangential);
    }
    appendMotions(arrays.stepRigidBodies, step.rigid);
  }
  return arrays;
}

Level levelOf(const SolutionArrays& arrays) {
  Level level;
  for (const SolutionArrays& part : parted(arrays))
    level.bodies.push_back(bodyOf(part));
  level.rigid = motionsOf(arrays.rigidBodies);
  level.path = pathOf(arrays);
  level.steps = stepsOf(arrays, level.bodies);
  return level;
}

}  // namespace epafi::drivers
