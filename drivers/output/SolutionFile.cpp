#include "drivers/output/SolutionFile.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/Hdf5File.hpp"
#include "drivers/scene/Text.hpp"

#include <boost/crc.hpp>

namespace epafi::drivers {

namespace {

constexpr int format = 6;  // formats 1 to 5 were never released
const std::string group = "/Epafi";

bool converged(const Level& level) { return level.status == contact::Status::Converged; }

/// CRC-32 of everything that a restart reads.
unsigned long long checksum(const Checkpoint& checkpoint, const SolutionArrays& arrays) {
  const Level& level = checkpoint.level;
  boost::crc_32_type sum;
  const auto add = [&](const auto& values) {
    sum.process_bytes(values.data(), values.size() * sizeof values[0]);
  };
  add(std::vector<int>{level.number, converged(level) ? 1 : 0, level.complete ? 1 : 0});
  add(std::vector<double>{checkpoint.secondsTotal, checkpoint.secondsWall});
  for (const std::string& text : {level.reason, checkpoint.used, checkpoint.history,
                                  checkpoint.steps, checkpoint.bodies})
    add(text);
  for (const SolutionArray& array : arrays)
    std::visit(add, array.numbers);
  return sum.checksum();
}

void writeCheckpoint(const Checkpoint& checkpoint, Hdf5Writer& writer) {
  const Level& level = checkpoint.level;
  const SolutionArrays arrays = arraysOf(level);
  const auto number = [&](const char* name, auto value) {
    writer.attribute(group, name, std::vector<decltype(value)>{value});
  };
  number("format", format);
  number("level", level.number);
  number("converged", converged(level) ? 1 : 0);
  number("complete", level.complete ? 1 : 0);
  number("seconds_total", checkpoint.secondsTotal);
  number("seconds_wall", checkpoint.secondsWall);
  number("checksum", checksum(checkpoint, arrays));
  for (const auto& array : arrays)
    std::visit(
        [&](const auto& all) {
          writer.array(group + "/" + array.name, all, array.columns);
        },
        array.numbers);
  writer.text(group + "/reason", level.reason);
  writer.text(group + "/used", checkpoint.used);
  writer.text(group + "/history", checkpoint.history);
  writer.text(group + "/steps", checkpoint.steps);
  writer.text(group + "/resultants", checkpoint.bodies);
}

Checkpoint readCheckpoint(const Hdf5Reader& reader) {
  if (!reader.has(group))
    throw bem::InputError("has no group /Epafi: it was not written by epafi run");
  if (const int other = reader.attribute<int>(group, "format"); other != format)
    throw bem::InputError("is of format ", other, "; this version of Epafi reads format ",
                          format, "; solve the scene again");
  SolutionArrays arrays = emptyArrays();
  for (SolutionArray& array : arrays)
    std::visit(
        [&](auto& all) {
          using Number = typename std::decay_t<decltype(all)>::value_type;
          all = reader.array<Number>(group + "/" + array.name, array.columns);
        },
        array.numbers);

  Checkpoint checkpoint;
  Level& level = checkpoint.level;
  level = levelOf(arrays);
  level.number = reader.attribute<int>(group, "level");
  level.status = reader.attribute<int>(group, "converged") == 1
                     ? contact::Status::Converged
                     : contact::Status::NotConverged;
  level.complete = reader.attribute<int>(group, "complete") == 1;
  level.reason = reader.text(group + "/reason");
  checkpoint.used = reader.text(group + "/used");
  checkpoint.history = reader.text(group + "/history");
  checkpoint.steps = reader.text(group + "/steps");
  checkpoint.bodies = reader.text(group + "/resultants");
  checkpoint.secondsTotal = reader.attribute<double>(group, "seconds_total");
  checkpoint.secondsWall = reader.attribute<double>(group, "seconds_wall");
  if (reader.attribute<unsigned long long>(group, "checksum") !=
      checksum(checkpoint, arrays))
    throw bem::InputError("is damaged: its checksum is wrong");
  return checkpoint;
}

}  // namespace

std::string solutionFile(const Scene& scene, const Checkpoint& checkpoint,
                         const BoundaryLines& grid) {
  std::string names;
  for (const std::string& name : namesOfBoundaries(scene))
    names += name + "\n";
  Hdf5Writer writer;
  writeVtkHdf(grid.grid(), writer);
  writeCheckpoint(checkpoint, writer);
  writer.text(group + "/boundaries", names);
  return writer.bytes();
}

Checkpoint readSolution(const std::string& path) {
  return within("'" + path + "': ", [&] { return readCheckpoint(Hdf5Reader(path)); });
}

}  // namespace epafi::drivers
