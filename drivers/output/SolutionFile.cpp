#include "drivers/output/SolutionFile.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/FieldGrid.hpp"
#include "drivers/output/Hdf5Reader.hpp"
#include "drivers/output/Hdf5Writer.hpp"

namespace epafi::drivers {

namespace {

constexpr int currentFormat = 1;
constexpr std::size_t positionColumns = 4;
constexpr std::size_t sourceColumns = adaptivity::sourceCount;
const std::string group = "/Epafi";

/// A checkpoint's arrays as they stand in the file.
struct Arrays {
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

Arrays arraysOf(const Level& level, const std::vector<EdgeEnds>& outline) {
  Arrays arrays;
  for (const bem::Piece& piece : level.pieces) {
    arrays.edge.push_back(piece.edge);
    arrays.degree.push_back(piece.degree);
    arrays.position.insert(
        arrays.position.end(),
        {piece.start.fromStart, piece.start.toEnd, piece.end.fromStart, piece.end.toEnd});
  }
  arrays.indicators = flat(level.indicators.squares);
  arrays.outline = flat(outline);
  arrays.multiplier = level.state.multiplier;
  arrays.rigid = level.state.rigid;
  arrays.contact = numbers(level.states.normal);
  arrays.friction = numbers(level.states.tangential);
  arrays.displacement = level.displacement;
  arrays.density = level.density;
  return arrays;
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

unsigned long long checksum(const Checkpoint& checkpoint, const Arrays& arrays) {
  const Level& level = checkpoint.level;
  Checksum sum;
  sum.add(std::vector<int>{level.number, converged(level) ? 1 : 0});
  sum.add(std::vector<double>{checkpoint.secondsTotal, checkpoint.secondsWall});
  sum.add(level.reason + checkpoint.used + checkpoint.history);
  forEach(arrays, [&](const char*, const auto& array, auto) { sum.add(array); });
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
}

void writeCheckpoint(const Checkpoint& checkpoint, Hdf5Writer& writer) {
  const Level& level = checkpoint.level;
  const Arrays arrays = arraysOf(level, checkpoint.outline);
  const auto number = [&](const char* name, auto value) {
    writer.attribute(group, name, std::vector<decltype(value)>{value});
  };
  number("format", currentFormat);
  number("level", level.number);
  number("converged", converged(level) ? 1 : 0);
  number("seconds_total", checkpoint.secondsTotal);
  number("seconds_wall", checkpoint.secondsWall);
  number("checksum", checksum(checkpoint, arrays));
  forEach(arrays, [&](const char* name, const auto& array, long long columns) {
    writer.array(group + "/" + name, array, columns);
  });
  writer.text(group + "/reason", level.reason);
  writer.text(group + "/used", checkpoint.used);
  writer.text(group + "/history", checkpoint.history);
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

/// The level's numbers but for its number and how it ended.
Level levelOf(const Arrays& arrays) {
  Level level;
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
  if (format != currentFormat)
    throw bem::InputError(bem::message(
        "is of format ", format, "; this version of Epafi reads format ", currentFormat));
  Arrays arrays;
  forEach(arrays, [&](const char* name, auto& array, long long columns) {
    using Number = typename std::decay_t<decltype(array)>::value_type;
    array = reader.array<Number>(group + "/" + name, columns);
  });
  Checkpoint checkpoint;
  checkpoint.level = levelOf(arrays);
  checkpoint.level.number = reader.attribute<int>(group, "level");
  checkpoint.level.status = reader.attribute<int>(group, "converged") == 1
                                ? contact::Status::Converged
                                : contact::Status::NotConverged;
  checkpoint.level.reason = reader.text(group + "/reason");
  checkpoint.used = reader.text(group + "/used");
  checkpoint.history = reader.text(group + "/history");
  checkpoint.secondsTotal = reader.attribute<double>(group, "seconds_total");
  checkpoint.secondsWall = reader.attribute<double>(group, "seconds_wall");
  checkpoint.outline = rowsOf<positionColumns>(arrays.outline);
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

std::string solutionFile(const SolvedLevel& level, const std::string& used,
                         const std::string& history) {
  const bem::Outline& outline = level.solved.space.mesh().outline();
  std::string names;
  for (const std::string& name : boundaryNames(outline))
    names += name + "\n";

  Hdf5Writer writer;
  writeGrid(fieldGrid(level.solved, level.level.density), writer);
  writeCheckpoint({level.level, used, history, level.row.secondsTotal,
                   level.row.secondsWall, edgeEnds(outline)},
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
