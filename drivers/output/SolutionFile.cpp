#include "drivers/output/SolutionFile.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/BoundaryLines.hpp"
#include "drivers/output/Hdf5File.hpp"
#include "drivers/process/Versions.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <map>
#include <string_view>
#include <type_traits>

namespace epafi::drivers {

namespace {

constexpr int format = 10;
const std::string group = "/Epafi";
const std::string columnsOf = "_columns";  ///< of a table: behind its name

/// The numbers of a level in the order of the checksum: body by body, the multiplier as solvers number
/// it; for a path step by step, within a step likewise.
using Arrays = std::vector<DataArray>;

constexpr const char* apart = "/Epafi: bodies does not go with the other arrays";

/// Copies the values that it visits from a level to arrays, or back.
class Archive {
 public:
  enum class To { File, Level };
  Archive(Arrays& arrays, To to) : arrays_(arrays), to_(to) {
    for (const DataArray& array : arrays)
      most_ += array.size();
    left_ = most_;
  }
  /// Has every number been read into the level?
  bool tookAll() const { return left_ == 0; }

  /// Numbers of one type, one after the other.
  template <class T, class... More>
  void operator()(const char* name, T& value, More&... more) {
    take(name, &value, 1);
    (take(name, &more, 1), ...);
  }
  void operator()(const char* name, bem::Vector& values) {
    take(name, values.data(), values.size());
  }
  void operator()(const char* name, std::vector<contact::RigidMotion>& motions) {
    for (auto& [slide, turn] : motions)
      (*this)(name, slide.x, slide.y, turn);
  }
  /// States of pressures and of shears, in arrays of their own.
  void operator()(const char* pressures, const char* shears,
                  contact::ContactStates& states) {
    using contact::ContactState;
    for (ContactState& state : states) {
      const bool presses = isOfPressure(state);
      const auto first = presses ? ContactState::Open : ContactState::Frictionless;
      const auto last = presses ? ContactState::Closed : ContactState::SlipBackward;
      int number = static_cast<int>(state) - static_cast<int>(first);
      (*this)(presses ? pressures : shears, number);
      if (number < 0 || number > static_cast<int>(last) - static_cast<int>(first))
        throw bem::InputError("/Epafi: ", number, " is not a state");
      state = static_cast<ContactState>(static_cast<int>(first) + number);
    }
  }

  /// Writes the sizes of vectors, or resizes the vectors to the stored sizes.
  template <class... T>
  void sizes(const char* name, std::vector<T>&... all) {
    const auto size = [&](auto& vector) {
      auto number = static_cast<int>(vector.size());
      (*this)(name, number);
      resize(static_cast<std::size_t>(number), vector);
    };
    (size(all), ...);
  }
  /// Resizes vectors of a level that is read; does nothing when writing.
  template <class... T>
  void resize(std::size_t size, std::vector<T>&... vectors) const {
    if (to_ == To::File)
      return;
    if (size > most_)
      throw bem::InputError(apart);
    (vectors.resize(size), ...);
  }
  /// Gives the states of a level that is read as many pressures and shears as others have.
  void resizeLike(const contact::ContactStates& others,
                  contact::ContactStates& states) const {
    if (to_ == To::Level)
      states = others;
  }
  /// Rows of an array, divided by `parts`.
  std::size_t rows(const char* name, std::size_t parts = 1) {
    const DataArray& array = named(name);
    return array.size() / static_cast<std::size_t>(array.columns) / parts;
  }

 private:
  DataArray& named(std::string_view name) {
    return *std::find_if(arrays_.begin(), arrays_.end(),
                         [&](const DataArray& array) { return array.name == name; });
  }

  template <class T>
  void take(const char* name, T* first, std::size_t count) {
    auto& numbers = std::get<std::vector<T>>(named(name).numbers);
    if (to_ == To::File) {
      numbers.insert(numbers.end(), first, first + count);
      return;
    }
    std::size_t& taken = taken_[name];
    if (count > numbers.size() - taken)
      throw bem::InputError(apart);
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(taken), count, first);
    taken += count;
    left_ -= count;
  }

  Arrays& arrays_;
  To to_;
  std::size_t most_ = 0;  ///< all numbers; no size in a file may be larger
  std::size_t left_ = 0;  ///< numbers not read yet
  std::map<std::string_view, std::size_t> taken_;  ///< numbers read, by array
};

/// A body's mesh and the last fields on it.
void visit(Archive& archive, Level& level, std::size_t b) {
  SolvedState& last = level.steps.back();
  std::vector<bem::Piece>& pieces = level.meshes[b];
  adaptivity::Indicators& indicators = level.indicators[b];
  archive.sizes("bodies", pieces, last.displacement[b], last.density[b]);
  archive.resize(pieces.size(), indicators.squares);
  for (bem::Piece& piece : pieces) {
    archive("edge", piece.edge);
    archive("degree", piece.degree);
    archive("position", piece.start.fromStart, piece.start.toEnd, piece.end.fromStart,
            piece.end.toEnd);
  }
  for (adaptivity::Contributions& squares : indicators.squares)
    for (double& square : squares)
      archive("indicators", square);
  archive("displacement", last.displacement[b]);
  archive("density", last.density[b]);
}

void visit(Archive& archive, SolvedState& point, std::size_t points) {
  archive.resize(archive.rows("path_multiplier", points), point.state.multiplier);
  archive.resize(archive.rows("path_rigid", points), point.state.rigid);
  archive("path_t", point.t);
  archive("path_iterations", point.newtonIterations, point.coulombIterations);
  archive("path_multiplier", point.state.multiplier);
  archive("path_rigid", point.state.rigid);
  archive("path_errors", point.workError, point.volumeError);
}

/// \param like a step on the same meshes
void visit(Archive& archive, SolvedState& step, const SolvedState& like) {
  const std::size_t bodies = like.displacement.size();
  archive("step_t", step.t);
  archive.resize(bodies, step.displacement, step.density);
  archive.resize(like.rigid.size(), step.rigid);
  for (std::size_t b = 0; b < bodies; ++b) {
    archive.resize(like.displacement[b].size(), step.displacement[b]);
    archive.resize(like.density[b].size(), step.density[b]);
    archive("step_displacement", step.displacement[b]);
    archive("step_density", step.density[b]);
  }
  archive.resizeLike(like.states, step.states);
  archive("step_contact_state", "step_friction_state", step.states);
  archive("step_rigid_bodies", step.rigid);
}

/// Of a path at its end all steps, else the last one as the state of the bodies.
void visit(Archive& archive, Level& level) {
  const std::size_t bodies = archive.rows("bodies");
  archive.resize(std::max<std::size_t>(archive.rows("step_t"), 1), level.steps);
  SolvedState& last = level.steps.back();
  archive.resize(bodies, level.meshes, level.indicators, last.displacement, last.density);
  for (std::size_t b = 0; b < level.meshes.size(); ++b)
    visit(archive, level, b);
  auto& [multiplier, rigid] = last.state;
  contact::ContactStates states(archive.rows("contact_state"),
                                contact::ContactState::Open);
  states.resize(states.size() + archive.rows("friction_state"),
                contact::ContactState::Frictionless);
  archive.resize(archive.rows("multiplier"), multiplier);
  archive.resize(archive.rows("rigid"), rigid);
  archive.resizeLike(states, last.states);
  archive("multiplier", multiplier);
  archive("rigid", rigid);
  archive("contact_state", "friction_state", last.states);
  archive.resize(archive.rows("rigid_bodies"), last.rigid);
  archive("rigid_bodies", last.rigid);
  archive.resize(archive.rows("path_t"), level.path);
  for (SolvedState& point : level.path)
    visit(archive, point, level.path.size());
  if (archive.rows("step_t") > 0 || (level.complete && level.onPath()))
    for (SolvedState& step : level.steps)
      visit(archive, step, last);
  else if (last.t == 0 && !level.path.empty())
    last.t = level.path.back().t;
}

/// All of them, empty.
Arrays emptyArrays() {
  const std::vector<double> real;
  const std::vector<int> whole;
  return {{"edge", whole},
          {"degree", whole},
          {"position", real, 4},
          {"indicators", real, adaptivity::sourceCount},
          {"multiplier", real},
          {"rigid", real},
          {"contact_state", whole},
          {"friction_state", whole},
          {"displacement", real},
          {"density", real},
          {"bodies", whole, 3},
          {"rigid_bodies", real, 3},
          {"path_t", real},
          {"path_iterations", whole, 2},
          {"path_multiplier", real},
          {"path_rigid", real},
          {"path_errors", real, 2},
          {"step_t", real},
          {"step_displacement", real},
          {"step_density", real},
          {"step_contact_state", whole},
          {"step_friction_state", whole},
          {"step_rigid_bodies", real, 3}};
}

Arrays arraysOf(Level level) {
  Arrays arrays = emptyArrays();
  Archive archive(arrays, Archive::To::File);
  visit(archive, level);
  return arrays;
}

/// The inverse of arraysOf.
/// \throws bem::InputError if the sizes do not match, or for an unknown state.
Level levelOf(Arrays arrays) {
  Level level;
  Archive archive(arrays, Archive::To::Level);
  visit(archive, level);
  if (!archive.tookAll())
    throw bem::InputError(apart);
  for (const SolvedState& point : level.path)
    for (SolvedState& step : level.steps)
      if (point.t == step.t)
        step.state = point.state;
  return level;
}

/// Calls number(name, value), text(name, value) and table(name, value) for what there is beside the
/// arrays, in the order of the checksum.
template <class Number, class Text, class OfTable>
void visit(Checkpoint& checkpoint, const Number& number, const Text& text,
           const OfTable& table) {
  Level& level = checkpoint.level;
  int converged = level.status == contact::Status::Converged ? 1 : 0;
  int complete = level.complete ? 1 : 0;
  number("level", level.number);
  number("converged", converged);
  number("complete", complete);
  number("seconds_total", checkpoint.secondsTotal);
  number("seconds_wall", checkpoint.secondsWall);
  text("reason", level.reason);
  text("used", checkpoint.used);
  table("history", checkpoint.history);
  table("steps", checkpoint.steps);
  table("resultants", checkpoint.bodies);
  level.status =
      converged == 1 ? contact::Status::Converged : contact::Status::NotConverged;
  level.complete = complete == 1;
}

/// CRC-32 of everything that a restart reads.
unsigned long long checksum(Checkpoint& checkpoint, const Arrays& arrays) {
  boost::crc_32_type sum;
  const auto add = [&](const auto& values) {
    sum.process_bytes(values.data(), values.size() * sizeof values[0]);
  };
  visit(
      checkpoint, [&](const char*, auto value) { add(std::array{value}); },
      [&](const char*, const std::string& value) { add(value); },
      [&](const char*, const Table& value) {
        const auto [columns, numbers] = value.packed();
        add(columns);
        add(numbers);
      });
  for (const DataArray& array : arrays)
    std::visit(add, array.numbers);
  return sum.checksum();
}

void writeCheckpoint(Checkpoint checkpoint, Hdf5Writer& writer) {
  const Arrays arrays = arraysOf(checkpoint.level);
  const auto number = [&](const char* name, auto value) {
    writer.attribute(group, name, std::vector<decltype(value)>{value});
  };
  number("format", format);
  number("checksum", checksum(checkpoint, arrays));
  const auto text = [&](const std::string& name, const std::string& value) {
    writer.text(group + "/" + name, value);
  };
  visit(checkpoint, number, text, [&](const std::string& name, const Table& value) {
    const auto [columns, numbers] = value.packed();
    text(name + columnsOf, columns);
    writer.array(group + "/" + name, numbers, std::max<hsize_t>(value.columns(), 1));
  });
  for (const DataArray& array : arrays)
    write(group, array, writer);
}

Checkpoint readCheckpoint(const Hdf5Reader& reader) {
  if (!reader.has(group))
    throw bem::InputError("has no group /Epafi: it was not written by epafi run");
  if (const int other = reader.attribute<int>(group, "format"); other != format)
    throw bem::InputError("is of format ", other, ", of another version; Epafi ",
                          versions().epafi, " reads format ", format,
                          "; solve the scene again");
  Arrays arrays = emptyArrays();
  for (DataArray& array : arrays)
    std::visit(
        [&](auto& all) {
          using Number = typename std::decay_t<decltype(all)>::value_type;
          all = reader.array<Number>(group + "/" + array.name,
                                     static_cast<hsize_t>(array.columns));
        },
        array.numbers);
  Checkpoint checkpoint;
  checkpoint.level = levelOf(arrays);
  visit(
      checkpoint,
      [&](const char* name, auto& value) {
        value = reader.attribute<std::decay_t<decltype(value)>>(group, name);
      },
      [&](const char* name, std::string& value) {
        value = reader.text(group + "/" + name);
      },
      [&](const std::string& name, Table& value) {
        value = Table::unpacked(
            reader.text(group + "/" + name + columnsOf), [&](std::size_t columns) {
              return reader.array<double>(group + "/" + name, columns);
            });
      });
  if (reader.attribute<unsigned long long>(group, "checksum") !=
      checksum(checkpoint, arrays))
    throw bem::InputError("is damaged: its checksum is wrong");
  return checkpoint;
}

}  // namespace

std::string solutionFile(const Scene& scene, const Checkpoint& checkpoint,
                         const VtkGrid& grid) {
  std::string names;
  for (const std::string& name : namesOfBoundaries(scene))
    names += name + "\n";
  Hdf5Writer writer;
  writeVtkHdf(grid, writer);
  writeCheckpoint(checkpoint, writer);
  writer.text(group + "/boundaries", names);
  return writer.bytes();
}

Checkpoint readSolution(const std::string& path) {
  return within("'" + path + "': ", [&] { return readCheckpoint(Hdf5Reader(path)); });
}

}  // namespace epafi::drivers
