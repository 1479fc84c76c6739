#include "drivers/output/SolutionFile.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/FieldGrid.hpp"
#include "drivers/output/Hdf5Reader.hpp"
#include "drivers/output/Hdf5Writer.hpp"

namespace epafi::drivers {

namespace {

constexpr int currentFormat = 1;
constexpr long long positionColumns = 4;
constexpr long long sourceColumns = adaptivity::sourceCount;

/// A checkpoint's arrays as they stand in the file.
struct Arrays {
  std::vector<int> edge;
  std::vector<int> degree;
  std::vector<double> position;  ///< fromStart, toEnd of the start and of the end
  std::vector<double> squares;
  std::vector<double> outline;
};

Arrays arraysOf(const Level& result, const std::vector<EdgeEnds>& outline) {
  Arrays arrays;
  for (const bem::Piece& piece : result.pieces) {
    arrays.edge.push_back(piece.edge);
    arrays.degree.push_back(piece.degree);
    arrays.position.insert(
        arrays.position.end(),
        {piece.start.fromStart, piece.start.toEnd, piece.end.fromStart, piece.end.toEnd});
  }
  for (const adaptivity::Contributions& squares : result.indicators.squares)
    arrays.squares.insert(arrays.squares.end(), squares.begin(), squares.end());
  for (const EdgeEnds& ends : outline)
    arrays.outline.insert(arrays.outline.end(), ends.begin(), ends.end());
  return arrays;
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

unsigned long long checksum(const Checkpoint& checkpoint) {
  const Level& result = checkpoint.result;
  const RunRecord& run = checkpoint.run;
  const Arrays arrays = arraysOf(result, checkpoint.outline);
  const bool converged = result.status == contact::Status::Converged;
  return Checksum()
      .add(std::vector<int>{result.level, converged ? 1 : 0})
      .add(std::vector<double>{run.secondsTotal, run.secondsWall})
      .add(result.reason + run.used + run.history)
      .add(arrays.edge)
      .add(arrays.degree)
      .add(arrays.position)
      .add(arrays.squares)
      .add(arrays.outline)
      .add(result.state.multiplier)
      .add(result.state.rigid)
      .add(numbers(result.states.normal))
      .add(numbers(result.states.tangential))
      .add(result.displacement)
      .add(result.density)
      .value();
}

void writeGrid(const FieldGrid& grid, const bem::DenseAlgebra& algebra,
               Hdf5Writer& writer) {
  constexpr unsigned char vtkLine = 3;
  const std::string root = "/VTKHDF/";
  writer.attribute("/VTKHDF", "Version", std::vector<int>{1, 0});
  writer.attribute("/VTKHDF", "Type", "UnstructuredGrid");

  const long long lines = grid.element.rows;
  const auto one = [&](const char* name, long long number) {
    writer.array(root + name, shareOf(std::vector<long long>{number}, 1, algebra));
  };
  one("NumberOfPoints", grid.points.rows);
  one("NumberOfCells", lines);
  one("NumberOfConnectivityIds", grid.ends.rows);
  writer.array(root + "Points", grid.points);
  writer.array(root + "Connectivity", grid.ends);
  std::vector<long long> offsets;
  for (long long line = 0; line <= lines; ++line)
    offsets.push_back(2 * line);
  writer.array(root + "Offsets", shareOf(offsets, 1, algebra));
  const std::vector<unsigned char> types(static_cast<std::size_t>(lines), vtkLine);
  writer.array(root + "Types", shareOf(types, 1, algebra));

  writer.array(root + "PointData/displacement", grid.displacement);
  writer.array(root + "PointData/traction", grid.traction);
  writer.array(root + "PointData/lambda_n", grid.pressure);
  writer.array(root + "PointData/lambda_t", grid.shear);
  writer.array(root + "PointData/gap", grid.gap);
  writer.array(root + "PointData/contact", grid.contact);
  writer.array(root + "PointData/friction", grid.friction);
  writer.array(root + "CellData/element", grid.element);
  writer.array(root + "CellData/degree", grid.degree);
  writer.array(root + "CellData/boundary", grid.boundary);
}

void writeCheckpoint(const Checkpoint& checkpoint, const bem::DenseAlgebra& algebra,
                     Hdf5Writer& writer) {
  const Level& result = checkpoint.result;
  const Arrays arrays = arraysOf(result, checkpoint.outline);
  const bool converged = result.status == contact::Status::Converged;
  const std::string group = "/Epafi";
  const auto column = [&](const char* name, const auto& values, long long columns = 1) {
    writer.array(group + "/" + name, shareOf(values, columns, algebra));
  };
  writer.attribute(group, "format", std::vector<int>{currentFormat});
  writer.attribute(group, "level", std::vector<int>{result.level});
  writer.attribute(group, "converged", std::vector<int>{converged ? 1 : 0});
  writer.attribute(group, "seconds_total",
                   std::vector<double>{checkpoint.run.secondsTotal});
  writer.attribute(group, "seconds_wall",
                   std::vector<double>{checkpoint.run.secondsWall});
  writer.attribute(group, "checksum",
                   std::vector<unsigned long long>{checksum(checkpoint)});
  column("outline", arrays.outline, positionColumns);
  column("edge", arrays.edge);
  column("position", arrays.position, positionColumns);
  column("degree", arrays.degree);
  column("displacement", result.displacement);
  column("density", result.density);
  column("multiplier", result.state.multiplier);
  column("rigid", result.state.rigid);
  column("contact_state", numbers(result.states.normal));
  column("friction_state", numbers(result.states.tangential));
  column("indicators", arrays.squares, sourceColumns);
  writer.text(group + "/reason", result.reason);
  writer.text(group + "/used", checkpoint.run.used);
  writer.text(group + "/history", checkpoint.run.history);
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

std::vector<bem::Piece> readPieces(const Hdf5Reader& reader) {
  const auto edge = reader.array<int>("/Epafi/edge", 1);
  const auto degree = reader.array<int>("/Epafi/degree", 1);
  const auto position = rowsOf<static_cast<std::size_t>(positionColumns)>(
      reader.array<double>("/Epafi/position", positionColumns));
  if (edge.size() != degree.size() || edge.size() != position.size())
    throw bem::InputError("/Epafi: edge, degree and position are of different lengths");
  std::vector<bem::Piece> pieces;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const auto& [startFrom, startTo, endFrom, endTo] = position[i];
    pieces.push_back({edge[i], {startFrom, startTo}, {endFrom, endTo}, degree[i]});
  }
  return pieces;
}

Checkpoint readCheckpoint(const Hdf5Reader& reader) {
  const std::string group = "/Epafi";
  if (!reader.has(group))
    throw bem::InputError("has no group /Epafi: it was not written by epafi run");
  const int format = reader.attribute<int>(group, "format");
  if (format != currentFormat)
    throw bem::InputError(bem::message(
        "is of format ", format, "; this version of Epafi reads format ", currentFormat));
  Checkpoint checkpoint;
  Level& result = checkpoint.result;
  result.level = reader.attribute<int>(group, "level");
  result.status = reader.attribute<int>(group, "converged") == 1
                      ? contact::Status::Converged
                      : contact::Status::NotConverged;
  result.reason = reader.text(group + "/reason");
  result.pieces = readPieces(reader);
  result.state.multiplier = reader.array<double>(group + "/multiplier", 1);
  result.state.rigid = reader.array<double>(group + "/rigid", 1);
  result.states = {states(reader.array<int>(group + "/contact_state", 1),
                          contact::NormalState::Closed),
                   states(reader.array<int>(group + "/friction_state", 1),
                          contact::FrictionState::SlipBackward)};
  result.displacement = reader.array<double>(group + "/displacement", 1);
  result.density = reader.array<double>(group + "/density", 1);
  result.indicators.squares = rowsOf<static_cast<std::size_t>(sourceColumns)>(
      reader.array<double>(group + "/indicators", sourceColumns));
  checkpoint.outline = rowsOf<static_cast<std::size_t>(positionColumns)>(
      reader.array<double>(group + "/outline", positionColumns));
  checkpoint.run.used = reader.text(group + "/used");
  checkpoint.run.history = reader.text(group + "/history");
  checkpoint.run.secondsTotal = reader.attribute<double>(group, "seconds_total");
  checkpoint.run.secondsWall = reader.attribute<double>(group, "seconds_wall");
  if (reader.attribute<unsigned long long>(group, "checksum") != checksum(checkpoint))
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

void writeSolution(const std::string& path, const SolvedLevel& level,
                   const RunRecord& run) {
  const contact::Solved& solved = level.solved;
  const FieldGrid grid = fieldGrid(solved, level.result.density, level.algebra);
  const Checkpoint checkpoint{level.result, run, edgeEnds(solved.space.mesh().outline())};
  std::string names;
  for (const std::string& name : boundaryNames(solved.space.mesh().outline()))
    names += name + "\n";

  Hdf5Writer writer(path, level.algebra);
  writeGrid(grid, level.algebra, writer);
  writeCheckpoint(checkpoint, level.algebra, writer);
  writer.text("/Epafi/boundaries", names);
  writer.write();
}

Checkpoint readSolution(const std::string& path) {
  try {
    return readCheckpoint(Hdf5Reader(path));
  } catch (const bem::InputError& error) {
    throw bem::InputError(bem::message("'", path, "': ", error.what()));
  }
}

}  // namespace epafi::drivers
