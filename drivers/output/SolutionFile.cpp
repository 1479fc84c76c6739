#include "drivers/output/SolutionFile.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/FieldGrid.hpp"
#include "drivers/output/Hdf5Reader.hpp"
#include "drivers/output/Hdf5Writer.hpp"

#include <algorithm>

namespace epafi::drivers {

namespace {

constexpr int formatOfOne = 1;      // body
constexpr int formatOfSeveral = 2;  // with /Epafi/bodies
constexpr int formatOfPath = 3;     // of one body, with the steps of a path
constexpr int formatOfAll = 4;      // several with a path, or with bodies that are rigid
constexpr std::size_t positionColumns = 4;
constexpr std::size_t sourceColumns = adaptivity::sourceCount;
const std::string group = "/Epafi";

/// A checkpoint's arrays as they stand in the file: one body after the other.
struct Arrays {
  /// How many of the others' entries belong to each body, see Count; empty: there is one.
  std::vector<int> bodies;
  std::vector<int> edge;
  std::vector<int> degree;
  std::vector<double> position;  ///< fromStart, toEnd of the start and of the end
  std::vector<double> indicators;
  std::vector<double> outline;
  std::vector<double> multiplier;
  std::vector<double> rigid;
  std::vector<int> contact;
  std::vector<int> friction;
  std::vector<double> displacement;
  std::vector<double> density;
  std::vector<double> rigidBodies;  ///< motions; since format 4
};

/// visit(name, array, columns) for each data set, in the order of the checksum.
template <class AnyArrays, class Visit>
void forEach(AnyArrays& arrays, const Visit& visit) {
  visit("edge", arrays.edge, 1);
  visit("degree", arrays.degree, 1);
  visit("position", arrays.position, positionColumns);
  visit("indicators", arrays.indicators, sourceColumns);
  visit("outline", arrays.outline, positionColumns);
  visit("multiplier", arrays.multiplier, 1);
  visit("rigid", arrays.rigid, 1);
  visit("contact_state", arrays.contact, 1);
  visit("friction_state", arrays.friction, 1);
  visit("displacement", arrays.displacement, 1);
  visit("density", arrays.density, 1);
}

/// The steps of a path: all numbers one step after the other.
struct PathArrays {
  std::vector<double> times;
  std::vector<int> iterations;  ///< Newton's and Coulomb's
  std::vector<double> multiplier;
  std::vector<double> rigid;
};

template <class AnyArrays, class Visit>
void forEachOfPath(AnyArrays& arrays, const Visit& visit) {
  visit("path_t", arrays.times, 1);
  visit("path_iterations", arrays.iterations, 2);
  visit("path_multiplier", arrays.multiplier, 1);
  visit("path_rigid", arrays.rigid, 1);
}

/// The fields of the steps that were asked for, one step after the other, in a step one body
/// after the other; a file of an earlier version, or of a path on its way, has none.
struct StepArrays {
  std::vector<double> times;
  std::vector<double> displacement;
  std::vector<double> density;
};

template <class AnyArrays, class Visit>
void forEachOfSteps(AnyArrays& arrays, const Visit& visit) {
  visit("step_t", arrays.times, 1);
  visit("step_displacement", arrays.displacement, 1);
  visit("step_density", arrays.density, 1);
}

/// A body's share of the arrays.
enum Count {
  Edges,
  Elements,
  Normals,
  Tangentials,
  Motions,
  Displacements,
  Densities,
  Counts
};

template <class T>
void append(std::vector<T>& to, const std::vector<T>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

template <class State>
std::vector<int> numbers(const std::vector<State>& states) {
  std::vector<int> result;
  result.reserve(states.size());
  for (const State state : states)
    result.push_back(static_cast<int>(state));
  return result;
}

/// And back.  \throws bem::InputError for a number that stands for none.
template <class State>
std::vector<State> states(const std::vector<int>& numbers, State last) {
  std::vector<State> result;
  result.reserve(numbers.size());
  for (const int number : numbers) {
    if (number < 0 || number > static_cast<int>(last))
      throw bem::InputError(bem::message("/Epafi: ", number, " is no state"));
    result.push_back(static_cast<State>(number));
  }
  return result;
}

/// All rows one after the other.
template <std::size_t columns>
std::vector<double> flat(const std::vector<std::array<double, columns>>& rows) {
  std::vector<double> result;
  for (const auto& row : rows)
    result.insert(result.end(), row.begin(), row.end());
  return result;
}

void append(const BodyLevel& level, Arrays& arrays) {
  for (const bem::Piece& piece : level.pieces) {
    arrays.edge.push_back(piece.edge);
    arrays.degree.push_back(piece.degree);
    arrays.position.insert(
        arrays.position.end(),
        {piece.start.fromStart, piece.start.toEnd, piece.end.fromStart, piece.end.toEnd});
  }
  append(arrays.indicators, flat(level.indicators.squares));
  append(arrays.multiplier, level.state.multiplier);
  append(arrays.rigid, level.state.rigid);
  append(arrays.contact, numbers(level.states.normal));
  append(arrays.friction, numbers(level.states.tangential));
  append(arrays.displacement, level.displacement);
  append(arrays.density, level.density);
}

Arrays arraysOf(const Level& level, const std::vector<std::vector<EdgeEnds>>& outlines) {
  Arrays arrays;
  for (std::size_t b = 0; b < level.bodies.size(); ++b) {
    const BodyLevel& body = level.bodies[b];
    append(body, arrays);
    append(arrays.outline, flat(outlines[b]));
    if (level.bodies.size() == 1)
      continue;
    for (const std::size_t count :
         {outlines[b].size(), body.pieces.size(), body.states.normal.size(),
          body.states.tangential.size(), body.state.rigid.size(),
          body.displacement.size(), body.density.size()})
      arrays.bodies.push_back(static_cast<int>(count));
  }
  for (const contact::RigidMotion& motion : level.rigid)
    append(arrays.rigidBodies, {motion.slide.x, motion.slide.y, motion.turn});
  return arrays;
}

PathArrays pathArraysOf(const Level& level) {
  PathArrays arrays;
  for (const PathPoint& point : level.path) {
    arrays.times.push_back(point.t);
    arrays.iterations.push_back(point.newtonIterations);
    arrays.iterations.push_back(point.coulombIterations);
    append(arrays.multiplier, point.state.multiplier);
    append(arrays.rigid, point.state.rigid);
  }
  return arrays;
}

StepArrays stepArraysOf(const Level& level) {
  StepArrays arrays;
  for (const StepFields& step : level.steps) {
    arrays.times.push_back(step.t);
    for (std::size_t b = 0; b < step.displacement.size(); ++b) {
      append(arrays.displacement, step.displacement[b]);
      append(arrays.density, step.density[b]);
    }
  }
  return arrays;
}

/// And back.
std::vector<PathPoint> pathOf(const PathArrays& arrays) {
  const std::size_t count = arrays.times.size();
  if (count == 0)
    return {};
  const std::size_t multipliers = arrays.multiplier.size() / count;
  const std::size_t motions = arrays.rigid.size() / count;
  if (arrays.iterations.size() != 2 * count ||
      arrays.multiplier.size() != count * multipliers ||
      arrays.rigid.size() != count * motions)
    throw bem::InputError("/Epafi: the arrays of the path are of different lengths");
  const auto part = [](const std::vector<double>& all, std::size_t k, std::size_t size) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(k * size);
    return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(size));
  };
  std::vector<PathPoint> path;
  for (std::size_t k = 0; k < count; ++k)
    path.push_back(
        {arrays.times[k],
         {part(arrays.multiplier, k, multipliers), part(arrays.rigid, k, motions)},
         arrays.iterations[2 * k],
         arrays.iterations[2 * k + 1]});
  return path;
}

/// Fowler, Noll and Vo's 64-bit hash FNV-1a of everything that a restart is made from.
class Checksum {
 public:
  template <class T>
  Checksum& add(const std::vector<T>& values) {
    return add(reinterpret_cast<const unsigned char*>(values.data()),
               values.size() * sizeof(T));
  }
  Checksum& add(const std::string& text) {
    return add(reinterpret_cast<const unsigned char*>(text.data()), text.size());
  }
  unsigned long long value() const { return value_; }

 private:
  Checksum& add(const unsigned char* bytes, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      value_ = (value_ ^ bytes[i]) * 1099511628211ULL;
    return *this;
  }

  unsigned long long value_ = 14695981039346656037ULL;
};

bool converged(const Level& level) { return level.status == contact::Status::Converged; }

bool hasPath(const Checkpoint& checkpoint) { return !checkpoint.steps.empty(); }

unsigned long long checksum(const Checkpoint& checkpoint, const Arrays& arrays,
                            const PathArrays& path, const StepArrays& steps) {
  const Level& level = checkpoint.level;
  Checksum sum;
  sum.add(std::vector<int>{level.number, converged(level) ? 1 : 0});
  sum.add(std::vector<double>{checkpoint.secondsTotal, checkpoint.secondsWall});
  sum.add(level.reason + checkpoint.used + checkpoint.history);
  sum.add(arrays.bodies).add(arrays.rigidBodies);
  if (!checkpoint.resultants.empty())  // a file of an earlier version has none
    sum.add(checkpoint.resultants);
  const auto add = [&](const char*, const auto& array, auto) { sum.add(array); };
  forEach(arrays, add);
  if (hasPath(checkpoint)) {
    sum.add(checkpoint.steps).add(std::vector<int>{level.complete ? 1 : 0});
    forEachOfPath(path, add);
    forEachOfSteps(steps, add);
  }
  return sum.value();
}

void writeGrid(const FieldGrid& grid, Hdf5Writer& writer) {
  constexpr unsigned char vtkLine = 3;
  writer.attribute("/VTKHDF", "Version", std::vector<int>{1, 0});
  writer.attribute("/VTKHDF", "Type", "UnstructuredGrid");
  const auto write = [&](const char* name, const auto& array, long long columns = 1) {
    writer.array(std::string("/VTKHDF/") + name, array, columns);
  };
  const auto count = [](const auto& array) {
    return std::vector<long long>{static_cast<long long>(array.size())};
  };
  write("NumberOfPoints", count(grid.pressure));
  write("NumberOfCells", count(grid.element));
  write("NumberOfConnectivityIds", count(grid.ends));
  write("Points", grid.points, 3);
  write("Connectivity", grid.ends);
  std::vector<long long> offsets(grid.element.size() + 1);
  for (std::size_t line = 0; line < offsets.size(); ++line)
    offsets[line] = static_cast<long long>(2 * line);
  write("Offsets", offsets);
  write("Types", std::vector<unsigned char>(grid.element.size(), vtkLine));

  write("PointData/displacement", grid.displacement, 3);
  write("PointData/traction", grid.traction, 3);
  write("PointData/lambda_n", grid.pressure);
  write("PointData/lambda_t", grid.shear);
  write("PointData/gap", grid.gap);
  write("PointData/contact", grid.contact);
  write("PointData/friction", grid.friction);
  write("CellData/element", grid.element);
  write("CellData/degree", grid.degree);
  write("CellData/boundary", grid.boundary);
  write("CellData/body", grid.body);
}

void writeCheckpoint(const Checkpoint& checkpoint, Hdf5Writer& writer) {
  const Level& level = checkpoint.level;
  const Arrays arrays = arraysOf(level, checkpoint.outlines);
  const auto number = [&](const char* name, auto value) {
    writer.attribute(group, name, std::vector<decltype(value)>{value});
  };
  const PathArrays path = pathArraysOf(level);
  const StepArrays steps = stepArraysOf(level);
  const bool several = !arrays.bodies.empty();
  const bool all = !arrays.rigidBodies.empty() || (several && hasPath(checkpoint));
  number("format", all                   ? formatOfAll
                   : hasPath(checkpoint) ? formatOfPath
                   : several             ? formatOfSeveral
                                         : formatOfOne);
  number("level", level.number);
  number("converged", converged(level) ? 1 : 0);
  number("seconds_total", checkpoint.secondsTotal);
  number("seconds_wall", checkpoint.secondsWall);
  number("checksum", checksum(checkpoint, arrays, path, steps));
  const auto write = [&](const char* name, const auto& array, long long columns) {
    writer.array(group + "/" + name, array, columns);
  };
  forEach(arrays, write);
  if (hasPath(checkpoint)) {
    number("complete", level.complete ? 1 : 0);
    forEachOfPath(path, write);
    if (!steps.times.empty())
      forEachOfSteps(steps, write);
    writer.text(group + "/steps", checkpoint.steps);
  }
  if (several)
    writer.array(group + "/bodies", arrays.bodies, Counts);
  if (!arrays.rigidBodies.empty())
    writer.array(group + "/rigid_bodies", arrays.rigidBodies, 3);
  writer.text(group + "/reason", level.reason);
  writer.text(group + "/used", checkpoint.used);
  writer.text(group + "/history", checkpoint.history);
  if (!checkpoint.resultants.empty())
    writer.text(group + "/resultants", checkpoint.resultants);
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

std::vector<bem::Piece> piecesOf(const Arrays& arrays) {
  const auto position = rowsOf<positionColumns>(arrays.position);
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

/// Takes the next numbers of an array.
template <class T>
std::vector<T> taken(const std::vector<T>& all, std::size_t count, std::size_t& next) {
  if (count > all.size() - next)
    throw bem::InputError("/Epafi: bodies does not go with the other arrays");
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(next);
  next += count;
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

/// And back: of bodies whose sizes are known.
std::vector<StepFields> stepsOf(const StepArrays& arrays, const Level& level) {
  std::vector<StepFields> steps;
  std::size_t displacement = 0;
  std::size_t density = 0;
  for (const double t : arrays.times) {
    steps.push_back({t, {}, {}});
    for (const BodyLevel& body : level.bodies) {
      steps.back().displacement.push_back(
          taken(arrays.displacement, body.displacement.size(), displacement));
      steps.back().density.push_back(taken(arrays.density, body.density.size(), density));
    }
  }
  return steps;
}

/// The arrays of each body.
std::vector<Arrays> parted(const Arrays& all) {
  if (all.bodies.empty())
    return {all};
  std::vector<Arrays> parts(all.bodies.size() / Counts);
  std::array<std::size_t, 11> next{};
  for (std::size_t b = 0; b < parts.size(); ++b) {
    std::array<std::size_t, Counts> count{};
    for (std::size_t k = 0; k < count.size(); ++k)
      count[k] = static_cast<std::size_t>(std::max(0, all.bodies[b * Counts + k]));
    Arrays& part = parts[b];
    part.edge = taken(all.edge, count[Elements], next[0]);
    part.degree = taken(all.degree, count[Elements], next[1]);
    part.position = taken(all.position, positionColumns * count[Elements], next[2]);
    part.indicators = taken(all.indicators, sourceColumns * count[Elements], next[3]);
    part.outline = taken(all.outline, positionColumns * count[Edges], next[4]);
    part.multiplier = taken(all.multiplier, count[Normals] + count[Tangentials], next[5]);
    part.rigid = taken(all.rigid, count[Motions], next[6]);
    part.contact = taken(all.contact, count[Normals], next[7]);
    part.friction = taken(all.friction, count[Tangentials], next[8]);
    part.displacement = taken(all.displacement, count[Displacements], next[9]);
    part.density = taken(all.density, count[Densities], next[10]);
  }
  return parts;
}

BodyLevel levelOf(const Arrays& arrays) {
  BodyLevel level;
  level.pieces = piecesOf(arrays);
  level.state.multiplier = arrays.multiplier;
  level.state.rigid = arrays.rigid;
  level.states = {states(arrays.contact, contact::NormalState::Closed),
                  states(arrays.friction, contact::FrictionState::SlipBackward)};
  level.displacement = arrays.displacement;
  level.density = arrays.density;
  level.indicators.squares = rowsOf<sourceColumns>(arrays.indicators);
  return level;
}

Checkpoint readCheckpoint(const Hdf5Reader& reader) {
  if (!reader.has(group))
    throw bem::InputError("has no group /Epafi: it was not written by epafi run");
  const int format = reader.attribute<int>(group, "format");
  if (format < formatOfOne || format > formatOfAll)
    throw bem::InputError(bem::message("is of format ", format,
                                       "; this version of Epafi reads formats ",
                                       formatOfOne, " to ", formatOfAll));
  Arrays arrays;
  if (reader.has(group + "/bodies"))
    arrays.bodies = reader.array<int>(group + "/bodies", Counts);
  if (reader.has(group + "/rigid_bodies"))
    arrays.rigidBodies = reader.array<double>(group + "/rigid_bodies", 3);
  const auto read = [&](const char* name, auto& array, long long columns) {
    using Number = typename std::decay_t<decltype(array)>::value_type;
    array = reader.array<Number>(group + "/" + name, columns);
  };
  forEach(arrays, read);
  Checkpoint checkpoint;
  for (const Arrays& part : parted(arrays)) {
    checkpoint.level.bodies.push_back(levelOf(part));
    checkpoint.outlines.push_back(rowsOf<positionColumns>(part.outline));
  }
  for (const auto& [x, y, turn] : rowsOf<3>(arrays.rigidBodies))
    checkpoint.level.rigid.push_back({{x, y}, turn});
  checkpoint.level.number = reader.attribute<int>(group, "level");
  checkpoint.level.status = reader.attribute<int>(group, "converged") == 1
                                ? contact::Status::Converged
                                : contact::Status::NotConverged;
  checkpoint.level.reason = reader.text(group + "/reason");
  checkpoint.used = reader.text(group + "/used");
  checkpoint.history = reader.text(group + "/history");
  if (reader.has(group + "/resultants"))
    checkpoint.resultants = reader.text(group + "/resultants");
  checkpoint.secondsTotal = reader.attribute<double>(group, "seconds_total");
  checkpoint.secondsWall = reader.attribute<double>(group, "seconds_wall");
  PathArrays path;
  StepArrays steps;
  if (reader.has(group + "/path_t")) {
    forEachOfPath(path, read);
    checkpoint.steps = reader.text(group + "/steps");
    checkpoint.level.complete = reader.attribute<int>(group, "complete") == 1;
    checkpoint.level.path = pathOf(path);
    if (reader.has(group + "/step_t"))
      forEachOfSteps(steps, read);
    checkpoint.level.steps = stepsOf(steps, checkpoint.level);
  }
  if (reader.attribute<unsigned long long>(group, "checksum") !=
      checksum(checkpoint, arrays, path, steps))
    throw bem::InputError("is damaged: its checksum is wrong");
  return checkpoint;
}

}  // namespace

std::vector<EdgeEnds> edgeEnds(const bem::Outline& outline) {
  std::vector<EdgeEnds> result;
  for (const bem::Edge& edge : outline.edges()) {
    const bem::Vec2 from = outline.physical(edge.curve.from());
    const bem::Vec2 to = outline.physical(edge.curve.to());
    result.push_back({from.x, from.y, to.x, to.y});
  }
  return result;
}

std::string solutionFile(const Scene& scene, const SolvedLevel& level,
                         const FieldGrid& grid, const std::string& used,
                         const std::string& history, const std::string& steps,
                         const std::string& resultants) {
  std::string names;
  for (const std::string& name : gridBoundaries(scene))
    names += name + "\n";
  std::vector<std::vector<EdgeEnds>> outlines;
  for (const contact::Solved& body : level.bodies)
    outlines.push_back(edgeEnds(body.space.mesh().outline()));

  Hdf5Writer writer;
  writeGrid(grid, writer);
  writeCheckpoint({level.level, used, history, steps, resultants, level.row.secondsTotal,
                   level.row.secondsWall, outlines},
                  writer);
  writer.text(group + "/boundaries", names);
  return writer.bytes();
}

Checkpoint readSolution(const std::string& path) {
  try {
    return readCheckpoint(Hdf5Reader(path));
  } catch (const bem::InputError& error) {
    throw bem::InputError(bem::message("'", path, "': ", error.what()));
  }
}

}  // namespace epafi::drivers
