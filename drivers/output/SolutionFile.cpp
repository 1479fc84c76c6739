#include "drivers/output/SolutionFile.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/BoundaryVtk.hpp"
#include "drivers/output/Hdf5Reader.hpp"

namespace epafi::drivers {

namespace {

constexpr int formatOfOne = 1;      // body
constexpr int formatOfSeveral = 2;  // with /Epafi/bodies
constexpr int formatOfPath = 3;     // of one body, with the steps of a path
constexpr int formatOfAll = 4;      // several with a path, or with bodies that are rigid
const std::string group = "/Epafi";

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

unsigned long long checksum(const Checkpoint& checkpoint, const SolutionArrays& arrays) {
  const Level& level = checkpoint.level;
  Checksum sum;
  sum.add(std::vector<int>{level.number, converged(level) ? 1 : 0});
  sum.add(std::vector<double>{checkpoint.secondsTotal, checkpoint.secondsWall});
  sum.add(level.reason + checkpoint.used + checkpoint.history);
  sum.add(arrays.bodies).add(arrays.rigidBodies);
  if (!checkpoint.resultants.empty())  // a file of an earlier version has none
    sum.add(checkpoint.resultants);
  const auto add = [&](const auto& set) { sum.add(arrays.*set.array); };
  forEachDataSet(bodyDataSets, add);
  if (hasPath(checkpoint)) {
    sum.add(checkpoint.steps).add(std::vector<int>{level.complete ? 1 : 0});
    forEachDataSet(pathDataSets, add);
    forEachDataSet(stepDataSets, add);
  }
  return sum.value();
}

void writeCheckpoint(const Checkpoint& checkpoint, Hdf5Writer& writer) {
  const Level& level = checkpoint.level;
  const SolutionArrays arrays = arraysOf(level, checkpoint.outlines);
  const auto number = [&](const char* name, auto value) {
    writer.attribute(group, name, std::vector<decltype(value)>{value});
  };
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
  number("checksum", checksum(checkpoint, arrays));
  const auto write = [&](const auto& set) {
    writer.array(group + "/" + set.name, arrays.*set.array, set.columns);
  };
  forEachDataSet(bodyDataSets, write);
  if (hasPath(checkpoint)) {
    number("complete", level.complete ? 1 : 0);
    forEachDataSet(pathDataSets, write);
    if (!arrays.stepTimes.empty())
      forEachDataSet(stepDataSets, write);
    writer.text(group + "/steps", checkpoint.steps);
  }
  if (several)
    writer.array(group + "/bodies", arrays.bodies, BodyCounts);
  if (!arrays.rigidBodies.empty())
    writer.array(group + "/rigid_bodies", arrays.rigidBodies, 3);
  writer.text(group + "/reason", level.reason);
  writer.text(group + "/used", checkpoint.used);
  writer.text(group + "/history", checkpoint.history);
  if (!checkpoint.resultants.empty())
    writer.text(group + "/resultants", checkpoint.resultants);
}

Checkpoint readCheckpoint(const Hdf5Reader& reader) {
  if (!reader.has(group))
    throw bem::InputError("has no group /Epafi: it was not written by epafi run");
  const int format = reader.attribute<int>(group, "format");
  if (format < formatOfOne || format > formatOfAll)
    throw bem::InputError("is of format ", format,
                          "; this version of Epafi reads formats ", formatOfOne, " to ",
                          formatOfAll);
  SolutionArrays arrays;
  const auto read = [&](const auto& set) {
    auto& array = arrays.*set.array;
    using Number = typename std::decay_t<decltype(array)>::value_type;
    array = reader.array<Number>(group + "/" + set.name, set.columns);
  };
  if (reader.has(group + "/bodies"))
    arrays.bodies = reader.array<int>(group + "/bodies", BodyCounts);
  if (reader.has(group + "/rigid_bodies"))
    arrays.rigidBodies = reader.array<double>(group + "/rigid_bodies", 3);
  forEachDataSet(bodyDataSets, read);
  const bool path = reader.has(group + "/path_t");
  if (path)
    forEachDataSet(pathDataSets, read);
  if (path && reader.has(group + "/step_t"))
    forEachDataSet(stepDataSets, read);

  Checkpoint checkpoint;
  Level& level = checkpoint.level;
  level = levelOf(arrays);
  level.number = reader.attribute<int>(group, "level");
  level.status = reader.attribute<int>(group, "converged") == 1
                     ? contact::Status::Converged
                     : contact::Status::NotConverged;
  level.reason = reader.text(group + "/reason");
  if (path) {
    level.complete = reader.attribute<int>(group, "complete") == 1;
    checkpoint.steps = reader.text(group + "/steps");
  }
  checkpoint.used = reader.text(group + "/used");
  checkpoint.history = reader.text(group + "/history");
  if (reader.has(group + "/resultants"))
    checkpoint.resultants = reader.text(group + "/resultants");
  checkpoint.secondsTotal = reader.attribute<double>(group, "seconds_total");
  checkpoint.secondsWall = reader.attribute<double>(group, "seconds_wall");
  checkpoint.outlines = outlinesOf(arrays);
  if (reader.attribute<unsigned long long>(group, "checksum") !=
      checksum(checkpoint, arrays))
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

std::string solutionFile(const Scene& scene, Checkpoint checkpoint,
                         const BoundaryLines& grid) {
  std::string names;
  for (const std::string& name : namesOfBoundaries(scene))
    names += name + "\n";
  checkpoint.outlines.clear();
  for (const Body& body : scene.bodies)
    checkpoint.outlines.push_back(edgeEnds(*body.outline));

  Hdf5Writer writer;
  writeVtkHdf(grid, writer);
  writeCheckpoint(checkpoint, writer);
  writer.text(group + "/boundaries", names);
  return writer.bytes();
}

Checkpoint readSolution(const std::string& path) {
  try {
    return readCheckpoint(Hdf5Reader(path));
  } catch (const bem::InputError& error) {
    throw bem::InputError("'", path, "': ", error.what());
  }
}

}  // namespace epafi::drivers
