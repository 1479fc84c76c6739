#include "drivers/output/VtkGrid.hpp"

#include "drivers/output/Hdf5File.hpp"
#include "drivers/output/Table.hpp"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace epafi::drivers {

namespace {

using Indices = std::vector<long long>;

/// Appends the bytes as Base64 (RFC 4648).
void addBase64(std::string bytes, std::string& text) {
  using Bits = boost::archive::iterators::transform_width<const char*, 6, 8>;
  using Letters = boost::archive::iterators::base64_from_binary<Bits>;
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  bytes.resize(bytes.size() + missing);
  text.append(Letters(bytes.data()), Letters(bytes.data() + bytes.size()));
  text.replace(text.size() - missing, missing, missing, '=');
}

template <class T>
constexpr const char* typeName() {
  if (std::is_same_v<T, double>)
    return "Float64";
  return sizeof(T) == 8 ? "Int64" : sizeof(T) == 4 ? "Int32" : "UInt8";
}

/// A data array in XML; the data begin with their number of bytes.
template <class T>
std::string dataArray(const std::string& name, const std::vector<T>& values,
                      int components = 1) {
  const std::uint64_t size = values.size() * sizeof(T);
  std::string bytes(sizeof size + size, '\0');
  std::memcpy(bytes.data(), &size, sizeof size);
  std::memcpy(bytes.data() + sizeof size, values.data(), size);
  std::string text = std::string("<DataArray type=\"") + typeName<T>() + "\" Name=\"" +
                     name + R"(" NumberOfComponents=")" + std::to_string(components) +
                     R"(" format="binary">)";
  text.reserve(text.size() + 4 * bytes.size() / 3 + 20);
  addBase64(std::move(bytes), text);
  return text + "</DataArray>\n";
}

std::size_t cellsOf(const VtkGrid& grid) {
  return grid.corners.size() / static_cast<std::size_t>(grid.cornersPerCell);
}

/// Where the corners of cells first ... last begin.
Indices offsetsOf(const VtkGrid& grid, std::size_t first) {
  Indices offsets;
  for (std::size_t cell = first; cell <= cellsOf(grid); ++cell)
    offsets.push_back(static_cast<long long>(cell) * grid.cornersPerCell);
  return offsets;
}

std::vector<unsigned char> typesOf(const VtkGrid& grid) {
  constexpr unsigned char segment = 3;  // VTK_LINE
  constexpr unsigned char triangle = 5;
  return std::vector<unsigned char>(cellsOf(grid),
                                    grid.cornersPerCell == 2 ? segment : triangle);
}

const std::string format =
    "version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n";

}  // namespace

void DataArray::add(bem::Vec2 vector) {
  auto& all = std::get<std::vector<double>>(numbers);
  all.insert(all.end(), {vector.x, vector.y, 0});
}

std::size_t DataArray::size() const {
  return std::visit([](const auto& all) { return all.size(); }, numbers);
}

void write(const std::string& group, const DataArray& array, Hdf5Writer& writer) {
  std::visit(
      [&](const auto& numbers) {
        writer.array(group + "/" + array.name, numbers,
                     static_cast<hsize_t>(array.columns));
      },
      array.numbers);
}

std::size_t VtkGrid::size() const { return points.size() / 3; }

std::string vtuText(const VtkGrid& grid) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" " +
                     format + "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
                     std::to_string(grid.size()) + "\" NumberOfCells=\"" +
                     std::to_string(cellsOf(grid)) + "\">\n<PointData " + grid.shown +
                     ">\n";
  const auto add = [&](const std::vector<DataArray>& arrays) {
    for (const DataArray& array : arrays)
      std::visit(
          [&](const auto& numbers) {
            text += dataArray(array.name, numbers, array.columns);
          },
          array.numbers);
  };
  add(grid.pointData);
  text += "</PointData>\n<CellData>\n";
  add(grid.cellData);
  text += "</CellData>\n<Points>\n";
  add({grid.points});
  text += "</Points>\n<Cells>\n" + dataArray("connectivity", grid.corners) +
          dataArray("offsets", offsetsOf(grid, 1)) + dataArray("types", typesOf(grid));
  return text + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string stepsPvd(const std::vector<double>& times, const std::string& name) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" " + format +
                     "<Collection>\n";
  for (std::size_t k = 0; k < times.size(); ++k)
    text += "<DataSet timestep=\"" + exactly(times[k]) + R"(" part="0" file=")" +
            stepFile(k + 1, name) + "\"/>\n";
  return text + "</Collection>\n</VTKFile>\n";
}

std::string stepFile(std::size_t step, const std::string& name) {
  return "steps/" + std::to_string(step) + "/" + name;
}

void writeVtkHdf(const VtkGrid& grid, Hdf5Writer& writer) {
  writer.attribute("/VTKHDF", "Version", std::vector<int>{1, 0});
  writer.attribute("/VTKHDF", "Type", "UnstructuredGrid");
  const auto count = [&](const std::string& name, std::size_t number) {
    writer.array("/VTKHDF/" + name, Indices{static_cast<long long>(number)});
  };
  count("NumberOfPoints", grid.size());
  count("NumberOfCells", cellsOf(grid));
  count("NumberOfConnectivityIds", grid.corners.size());
  write("/VTKHDF", grid.points, writer);
  writer.array("/VTKHDF/Connectivity", grid.corners);
  writer.array("/VTKHDF/Offsets", offsetsOf(grid, 0));
  writer.array("/VTKHDF/Types", typesOf(grid));
  for (const DataArray& array : grid.pointData)
    write("/VTKHDF/PointData", array, writer);
  for (const DataArray& array : grid.cellData)
    write("/VTKHDF/CellData", array, writer);
}

}  // namespace epafi::drivers
