#include "bem/base/Box.hpp"
#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/output/Inside.hpp"
#include "drivers/output/OutputFolder.hpp"
#include "drivers/output/Restart.hpp"
#include "drivers/output/SideStarts.hpp"
#include "drivers/output/Table.hpp"
#include "drivers/output/VtkGrid.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/SceneReader.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <ostream>

namespace epafi::drivers {

namespace {

using bem::Box;
using bem::InputError;
using bem::message;
using Points = std::vector<InsidePoint>;

/// The last level of a run, read from its folder, with the scene that it was solved for.
class SavedRun {
 public:
  explicit SavedRun(std::string folder)
      : folder_(std::move(folder)),
        checkpoint_(read(folder_)),
        scene_(sceneOf(checkpoint_.used, folder_ + "/used.xml", {})) {
    within("'" + fileIn(folder_) + "' ", [&] { checkLevel(checkpoint_.level, scene_); });
  }

  /// `step`: as --step gives it; empty: the last one.
  BodyInsides insides(const std::string& step) const {
    return {scene_, checkpoint_.level, stepOf(step)};
  }
  /// Times of the steps of a path.
  std::vector<double> times() const {
    stepOf("1");  // there are some
    std::vector<double> times;
    for (const SolvedState& step : checkpoint_.level.steps)
      times.push_back(step.t);
    return times;
  }

 private:
  static std::string fileIn(const std::string& folder) {
    return ownFile(folder, "solution.hdf");
  }
  static Checkpoint read(const std::string& folder) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
      throw InputError("there is no folder '", folder,
                       "'; the folder of a finished run is needed");
    return readSolution(fileIn(folder));
  }

  const SolvedState& stepOf(const std::string& text) const {
    const Level& level = checkpoint_.level;
    if (text.empty())
      return level.last();
    const int number = positiveNumber("--step", text);
    if (!scene_.history)
      throw InputError("--step: the run in '", folder_,
                       "' has no History, and no steps; leave --step out");
    if (!level.complete)
      throw InputError(
          "--step: the path in '", folder_, "' was interrupted after ", level.path.size(),
          " solved steps, and fields of its steps are kept at its end; go on with epafi "
          "run --restart, or leave --step out for the last one");
    if (static_cast<std::size_t>(number) > level.steps.size())
      throw InputError("--step ", number, ": the path in '", folder_, "' has ",
                       level.steps.size(), level.steps.size() == 1 ? " step" : " steps");
    return level.steps[static_cast<std::size_t>(number) - 1];
  }

  std::string folder_;
  Checkpoint checkpoint_;
  Scene scene_;
};

std::optional<double> trimmedNumber(const std::string& text) {
  return numberIn<double>(trimmed(text));
}

bool isInside(const InsidePoint& point, const BodyInsides& insides) {
  return point.body < insides.size();
}

Box windowOf(const std::string& text) {
  std::vector<double> ends;
  std::string_view line = text;
  for (const std::string& piece : csvCells(line))
    ends.push_back(
        trimmedNumber(piece).value_or(std::numeric_limits<double>::quiet_NaN()));
  if (ends.size() != 4 || !(ends[0] < ends[2]) || !(ends[1] < ends[3]) ||
      !std::isfinite(ends[2] - ends[0]) || !std::isfinite(ends[3] - ends[1]))
    throw InputError("--window: '", text,
                     "' is not X0,Y0,X1,Y1, two corners, the lower left one first");
  return {{ends[0], ends[1]}, {ends[2], ends[3]}};
}

Box boxOf(const BodyInsides& insides) {
  Box box;
  for (std::size_t b = 0; b < insides.size(); ++b)
    for (int e = 0; e < insides.mesh(b).size(); ++e)
      for (const double t : {-1.0, -0.5, 0.0, 0.5, 1.0})
        box.add(insides.mesh(b).physicalPoint(e, t));
  return box;
}

/// Centres of those cells that lie inside a body.
Points cellsOf(const Box& box, int nx, int ny, const BodyInsides& insides) {
  Points points;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const bem::Vec2 x{box.low.x + (i + 0.5) / nx * box.size().x,
                        box.low.y + (j + 0.5) / ny * box.size().y};
      const InsidePoint point{insides.scene().bodyAt(x), x};
      if (isInside(point, insides))
        points.push_back(point);
    }
  return points;
}

Points gridPoints(const std::string& text, const Box& box, const BodyInsides& insides) {
  const auto comma = text.find(',');
  if (comma == std::string::npos)
    throw InputError("fields: --grid: '", text, "' is not NX,NY, as 60,30");
  const int nx = positiveNumber("--grid", text.substr(0, comma));
  const int ny = positiveNumber("--grid", text.substr(comma + 1));
  constexpr double most = 1e7;  // a file of 2 GB
  if (static_cast<double>(nx) * ny > most)
    throw InputError("fields: --grid: '", text, "' are more than ", most,
                     " points; a --window shows a part more finely");
  return cellsOf(box, nx, ny, insides);
}

Points pointsOf(const std::string& file, const BodyInsides& insides) {
  const auto pairs = within("fields: --points: '" + file + "': ",
                            [&] { return pairsIn(readText(file), false); });
  if (pairs.empty())
    throw InputError("fields: --points: '", file, "' has no points");
  Points points;
  for (const auto& [x, y] : pairs)
    points.push_back({insides.scene().bodyAt(insides.scene().drawn({x, y})), {x, y}});
  return points;
}

/// Further columns of points along a boundary, and of those of all steps.
Cells alongCells(bem::Vec2 n, int element, double s) {
  return {{"n_x", n.x,
           "along a boundary (`--along`): its outward normal, at 2 (degree + 1) points "
           "in the "
           "middles of equal parts of each element",
           "1"},
          {"n_y", n.y},
          {"element", element, "likewise: the element"},
          {"s", s, "likewise: arc length as in contact.csv", "length"}};
}
Cells stepCells(std::size_t step, double t) {
  return {{"step", static_cast<long long>(step),
           "with `--step all`: rows of all steps, in this order"},
          {"t", t}};
}

/// Points with what is there, and further cells of each one's row, or of none.
struct Evaluated {
  Points points;
  std::vector<InsideValue> values;
  std::vector<Cells> more;
};

/// At a depth below a boundary, 2(p+1) points per element; points outside are left out.
Evaluated alongPoints(const std::string& where, double depth,
                      const BodyInsides& insides) {
  std::vector<std::string> known;
  Evaluated all;
  for (std::size_t b = 0; b < insides.size(); ++b) {
    const bem::Mesh& mesh = insides.mesh(b);
    const auto nameOf = [&](int e) {
      return insides.scene().bodies[b].name + ":" + mesh.boundary(e);
    };
    std::vector<char> here(bem::at(mesh.size()));  // on the boundary?
    for (int e = 0; e < mesh.size(); ++e) {
      if (std::find(known.begin(), known.end(), nameOf(e)) == known.end())
        known.push_back(nameOf(e));
      if (nameOf(e) == where)
        here[bem::at(e)] = 1;
    }
    const bem::Vector starts = startsAlong(mesh, here);
    for (int e = 0; e < mesh.size(); ++e) {
      if (here[bem::at(e)] == 0)
        continue;
      const int intervals = 2 * (mesh[e].degree + 1);
      for (int k = 0; k < intervals; ++k) {
        const double t = -1 + (2.0 * k + 1) / intervals;
        const bem::Vec2 n = mesh[e].curve.normal(t);
        const bem::Vec2 x = mesh.physicalPoint(e, t) - depth * n;
        if (depth > 0 && !mesh.outline().contains(x))
          continue;
        all.points.push_back({b, x});
        all.more.push_back(alongCells(n, e,
                                      insides.scene().units().length *
                                          (starts[bem::at(e)] + mesh[e].half * (1 + t))));
        if (depth == 0)
          all.values.push_back(insides.atBoundary(b, e, t));
      }
    }
  }
  if (std::find(known.begin(), known.end(), where) == known.end())
    throw InputError("fields: --along: there is no '", where, "'",
                     bem::suggestion(where, known));
  if (all.points.empty())
    throw InputError("fields: --depth ", depth,
                     ": no point at this depth lies inside the body");
  if (depth > 0)
    all.values = insides.at(all.points);
  return all;
}

Evaluated chosenPoints(const Given& given, const BodyInsides& insides) {
  const int ways = static_cast<int>(given.has("--grid")) +
                   static_cast<int>(given.has("--points")) +
                   static_cast<int>(given.has("--along"));
  if (ways > 1)
    throw InputError("fields: give one of --grid, --points and --along");
  if (given.has("--along") != given.has("--depth"))
    throw InputError("fields: --along BODY:BOUNDARY and --depth D belong together");
  if (given.has("--window") && (given.has("--points") || given.has("--along")))
    throw InputError("fields: --window belongs to --grid");
  if (!given.has("--along")) {
    Points points =
        given.has("--points")
            ? pointsOf(given.value("--points"), insides)
            : gridPoints(given.value("--grid", "60,60"),
                         given.has("--window") ? windowOf(given.value("--window"))
                                               : boxOf(insides),
                         insides);
    std::vector<InsideValue> values = insides.at(points);
    return {std::move(points), std::move(values), {}};
  }
  const auto depth = trimmedNumber(given.value("--depth"));
  if (!depth || !(*depth >= 0))
    throw InputError("fields: --depth: '", given.value("--depth"),
                     "' is not a length >= 0");
  return alongPoints(given.value("--along"), *depth, insides);
}

void write(const std::string& file, const std::string& text) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  if (!stream)
    throw InputError("fields: '", file, "' cannot be written: ", std::strerror(errno));
}

/// Writes a file and prints the summary to `out`; "-" writes the text to `out`.
void deliver(const std::string& file, const std::string& text, const std::string& summary,
             std::ostream& out) {
  if (file == "-") {
    out << text;
    return;
  }
  write(file, text);
  out << summary;
}

std::string summary(const std::string& file, const Points& points,
                    const std::vector<InsideValue>& values, const BodyInsides& insides) {
  const auto largest = std::max_element(
      values.begin(), values.end(),
      [](const InsideValue& a, const InsideValue& b) { return a.vonMises < b.vonMises; });
  const bem::Vec2 x = points[largest - values.begin()].x;
  const auto outside =
      std::count_if(points.begin(), points.end(),
                    [&](const InsidePoint& p) { return !isInside(p, insides); });
  return message(
      "fields  ", file, ": ", points.size(), " points, largest von Mises stress ",
      largest->vonMises, " at (", x.x, ", ", x.y, ")",
      outside > 0 ? message("; ", outside, " outside of the bodies, rows empty") : "",
      "\n");
}

/// What is not asked for elsewhere is written into the run's folder.
std::string outputOf(const Given& given, const std::string& name) {
  return given.has("--output") ? given.value("--output") : ownFile(given.argument, name);
}

/// steps/<k>/fields.vtu of all steps and fields.pvd.
void writeSeries(const std::string& folder, std::ostream& out) {
  const SavedRun run(folder);
  const std::vector<double> times = run.times();
  for (std::size_t k = 1; k <= times.size(); ++k) {
    const std::string file = ownFile(folder, stepFile(k, "fields.vtu"));
    std::filesystem::create_directories(std::filesystem::path(file).parent_path());
    write(file, vtuFile(fill(run.insides(std::to_string(k)))));
  }
  write(ownFile(folder, "fields.pvd"), stepsPvd(times, "fields.vtu"));
  out << "fields  " << folder << "/fields.pvd: " << times.size() << " steps\n";
}

/// Rows at one step, or at each with its number and time.
void writeTable(const Given& given, const std::string& step, std::ostream& out) {
  const SavedRun run(given.argument);
  const std::string file = outputOf(given, "fields.csv");
  std::string csv;
  std::string told;
  const auto add = [&](const std::string& name, const Cells& at) {
    const BodyInsides insides = run.insides(name);
    auto [points, values, more] = chosenPoints(given, insides);
    if (points.empty())
      throw given.has("--window")
          ? InputError("fields: --window: '", given.value("--window"),
                       "' shows nothing of the bodies; take another --window, or a finer "
                       "--grid")
          : InputError(
                "fields: --grid: none of its points lies inside a body; take more");
    more.resize(points.size());
    for (Cells& cells : more)
      append(cells, at);
    insides.addTo(csv, points, values, more);
    told += message(at.empty() ? "" : "step " + name + "  ",
                    summary(file, points, values, insides));
  };
  if (step == "all") {
    const std::vector<double> times = run.times();
    for (std::size_t k = 0; k < times.size(); ++k)
      add(std::to_string(k + 1), stepCells(k + 1, times[k]));
  } else {
    add(step, {});
  }
  deliver(file, csv, told, out);
}

}  // namespace

Cells columnsOfFields() {
  Cells cells = insideCells({}, {}, nullptr, false);
  append(cells, alongCells({}, 0, 0));
  append(cells, stepCells(0, 0));
  return cells;
}

int fieldsCommand(const Given& given, std::ostream& out) {
  const std::string& folder = given.argument;
  const std::string step = given.value("--step", "");
  const bool all = step == "all" && given.has("--vtk");
  if (all && given.has("--output"))
    throw InputError("fields: --step all writes --vtk files into DIR, without --output");
  if (given.has("--vtk"))
    for (const char* other : {"--grid", "--points", "--along", "--depth", "--window"})
      if (given.has(other))
        throw InputError("fields: --vtk covers the whole inside; ", other,
                         " belongs to the csv");
  const std::string extension =
      std::filesystem::path(given.value("--output")).extension().string();
  if (extension == (given.has("--vtk") ? ".csv" : ".vtu"))
    throw InputError("fields: --output: '", given.value("--output"), "': ",
                     given.has("--vtk")
                         ? "--vtk writes no csv; leave it out, or name a .vtu"
                         : "a .vtu needs --vtk; without it a csv is written");
  if (all) {
    writeSeries(folder, out);
    return 0;
  }
  if (!given.has("--vtk")) {
    writeTable(given, step, out);
    return 0;
  }
  const SavedRun run(folder);
  const BodyInsides insides = run.insides(step);
  const std::string file = outputOf(given, "fields.vtu");
  const FilledBodies filled = fill(insides);
  deliver(file, vtuFile(filled), summary(file, filled.points, filled.values, insides),
          out);
  return 0;
}

}  // namespace epafi::drivers
